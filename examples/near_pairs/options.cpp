// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The command line; see options.h.

#include "options.h"

#include "decimal.h"
#include "error.h"
#include "row_reader.h"

#include <CGAL/Thick_intersection_d/version.h>
#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

namespace near_pairs {
namespace {

namespace po = boost::program_options;

void add_scene_options(po::options_description& all, Options& options)
{
  po::options_description scene("What is near");
  scene.add_options()
    ("distance", po::value<std::string>()->value_name("TEXT"),
     "report pairs at most this far apart; a decimal or a quotient (0.1, 1e-3, 1/3), taken "
     "exactly; with --geographic also with m, km, nmi, mi or ft behind it")
    ("squared-distance", po::value<std::string>()->value_name("TEXT"),
     "the same, given by its square")
    ("open", po::bool_switch(&options.open), "report strictly closer pairs only")
    ("closest", po::bool_switch(&options.closest),
     "report the closest pair and its exact squared distance, in place of all pairs within one");
  po::options_description points("How the file is read");
  points.add_options()
    ("dimension", po::value<int>(&options.dimension)->value_name("2|3"),
     "use this many coordinates (default: all that the file has)")
    ("format", po::value<std::string>(&options.format)->value_name("NAME"),
     "csv (any table), xyz, off, ply, obj, pdb or tsp (default: by the name of the file)")
    ("separator", po::value<std::string>()->value_name("CHAR"),
     "of the columns of a table: a character, or tab or blanks (default: found)")
    ("no-header", po::bool_switch(&options.no_header),
     "the first row of a table is a point (default: if it has numbers for coordinates)")
    ("columns", po::value<std::string>()->value_name("A,B[,C]"),
     "columns of the coordinates, by name or by number from 1 (default: x,y[,z], else lat* and "
     "lon*); with --geographic latitude,longitude")
    ("id", po::value<std::string>(&options.id)->value_name("COLUMN"),
     "column of the names of points (default: id)")
    ("geographic", po::bool_switch(&options.geographic),
     "latitude and longitude in degrees are put on a sphere of radius 6371008.8 m; the distance is "
     "the straight chord in meters")
    ("decimal", po::bool_switch(&options.decimal),
     "take decimal coordinates exactly, as integers at one power of ten for the file, instead of "
     "rounding each to a double");
  all.add(scene).add(points);
}

void add_search_options(po::options_description& all, Options& options)
{
  po::options_description search("How the pairs are searched");
  search.add_options()
    ("kernel", po::value<std::string>(&options.kernel)->value_name("NAME"),
     "epick (default), or exact: the CGAL kernel of the points")
    ("parallel", po::bool_switch(&options.parallel), "use all cores");
  po::options_description output("What is written");
  output.add_options()
    ("pairs", po::value<std::string>(&options.pairs)->value_name("FILE"),
     "CSV of the pairs; - for the standard output")
    ("picture", po::value<std::string>(&options.picture)->value_name("FILE.svg"),
     "drawing of the scene and its pairs; - for the standard output")
    ("explain", po::bool_switch(&options.explain),
     "print what the search found out about the scene")
    ("progress", po::bool_switch(&options.progress), "show a percentage on the standard error")
    ("help", po::bool_switch(&options.help), "print this text")
    ("version", po::bool_switch(&options.version),
     "print the version of this program, which is that of the package, and the version of CGAL");
  all.add(search).add(output);
}

// Spellings are exact and long, so that "-1" is a number and never an option.
po::variables_map parse(int argc, const char* const* argv, const po::options_description& visible)
{
  using namespace po::command_line_style;
  po::options_description all;
  all.add(visible).add_options()("file", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("file", -1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional)
              .style(allow_long | long_allow_adjacent | long_allow_next).run(), map);
  po::notify(map);
  return map;
}

void read_files(const po::variables_map& map, Options& options)
{
  if(map.count("file"))
    options.files = map["file"].as<std::vector<std::string>>();
  if(options.files.empty() || options.files.size() > 2)
    throw Error("give one or two input files (--help lists the options)");
  if(options.files.size() == 2 && options.closest)
    throw Error("--closest is for one file");
  if(options.files == std::vector<std::string>{"-", "-"})
    throw Error("the standard input can be read only once");
}

struct Unit
{
  const char* name;
  const char* meters;
};

const Unit units[] = {{"m", "1"}, {"km", "1000"}, {"nmi", "1852"}, {"mi", "1609.344"},
                      {"ft", "0.3048"}};

// Reads a number with letters behind it as a length, and separates the two. Returns its meters, or
// nothing if there is no number.
std::optional<CGAL::Exact_rational> parse_with_unit(Options& options)
{
  const std::string text = options.distance_text;
  const auto is_letter = [](unsigned char byte) { return std::isalpha(byte) != 0; };
  const auto end = std::find_if_not(text.rbegin(), text.rend(), is_letter).base();
  const std::string number(trimmed(text.substr(0, end - text.begin())));
  const auto value = parse_exact(number);
  if(!value)
    return std::nullopt;
  options.distance_text = number;
  options.distance_unit.assign(end, text.end());
  for(const Unit& unit : units)
    if(options.distance_unit == unit.name) {
      if(!options.geographic)
        throw Error("--distance: '" + text + "' has a unit, which is for --geographic");
      return CGAL::Exact_rational(*value * *parse_exact(unit.meters));
    }
  throw Error("--distance: '" + text + "': the unit is none of m, km, nmi, mi and ft");
}

void read_distance(const po::variables_map& map, Options& options)
{
  if(map.count("distance") + map.count("squared-distance") + options.closest != 1)
    throw Error("give one of --distance, --squared-distance and --closest");
  if(options.closest) {
    if(options.open || options.explain || options.progress)
      throw Error("--open, --explain and --progress are for the pairs within a distance");
    return;
  }
  options.squared = map.count("squared-distance") != 0;
  const std::string name = options.squared ? "squared-distance" : "distance";
  const std::string text = map[name].as<std::string>();
  options.distance_text = trimmed(text);
  auto distance = parse_exact(options.distance_text);
  if(!distance && !options.squared)
    distance = parse_with_unit(options);
  if(!distance)
    throw Error("--" + name + ": '" + text + "' is no number");
  if(*distance < 0)
    throw Error("--" + name + ": " + options.distance_text + " is negative");
  options.distance = *distance;
}

void read_columns(const po::variables_map& map, Options& options)
{
  if(!map.count("columns"))
    return;
  std::istringstream list(map["columns"].as<std::string>());
  for(std::string name; std::getline(list, name, ','); )
    options.columns.emplace_back(trimmed(name));
  const std::size_t most = options.geographic ? 2 : 3;
  if(options.columns.size() < 2 || options.columns.size() > most)
    throw Error(options.geographic ? "--columns needs two names with --geographic"
                                   : "--columns needs two or three names");
  const int given = static_cast<int>(options.columns.size());
  if(!options.geographic && options.dimension != 0 && options.dimension != given)
    throw Error("--columns and --dimension disagree");
}

void check_choices(const po::variables_map& map, const Options& options)
{
  if(options.kernel != "epick" && options.kernel != "exact")
    throw Error("--kernel: '" + options.kernel + "' is neither epick nor exact");
  if(map.count("dimension") && options.dimension != 2 && options.dimension != 3)
    throw Error("--dimension: 2 or 3");
  if(options.geographic && options.dimension == 2)
    throw Error("--geographic is always in dimension 3");
  if(options.geographic && options.decimal)
    throw Error("--decimal is for coordinates in the file; those of --geographic are computed");
#ifndef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    throw Error("--parallel: this program was built without TBB");
#endif
}

// A name of a format is an extension, with or without its point.
void read_format(Options& options)
{
  std::string& format = options.format;
  format.erase(0, format.find_first_not_of('.'));
  std::transform(format.begin(), format.end(), format.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
}

void read_separator(const po::variables_map& map, Options& options)
{
  if(!map.count("separator"))
    return;
  const std::string text = map["separator"].as<std::string>();
  options.separator = text == "tab" || text == "\\t" ? '\t'
                      : text == "blanks" ? ' ' : text.size() == 1 ? text.front() : '"';
  if(options.separator == '"' || options.separator == '\n')
    throw Error("--separator: '" + text + "' is no single character, and neither tab nor blanks");
}

void check_outputs(const po::variables_map& map, const Options& options)
{
  if((map.count("pairs") && options.pairs.empty()) ||
     (map.count("picture") && options.picture.empty()))
    throw Error("empty name of an output file");
  if(!options.pairs.empty() && options.pairs == options.picture)
    throw Error("--pairs and --picture name the same file");
  const std::string format = extension(options.picture);
  if(!format.empty() && format != ".svg")
    throw Error("--picture: the picture is an SVG file, so name it .svg (rsvg-convert makes a "
                + format + " file of it)");
}

// Boost's messages in one line each are good enough for what it finds by itself.
Options parse_and_check(int argc, const char* const* argv)
{
  Options options;
  po::options_description visible;
  add_scene_options(visible, options);
  add_search_options(visible, options);
  const po::variables_map map = parse(argc, argv, visible);
  if(options.help || options.version)
    return options;
  read_files(map, options);
  read_distance(map, options);
  read_format(options);
  read_separator(map, options);
  check_choices(map, options);
  check_outputs(map, options);
  read_columns(map, options);
  return options;
}

} // namespace

Options parse_options(int argc, const char* const* argv)
{
  try {
    return parse_and_check(argc, argv);
  }
  catch(const po::error& error) {
    throw Error(error.what());
  }
}

std::string help_text()
{
  Options ignored;
  po::options_description visible;
  add_scene_options(visible, ignored);
  add_search_options(visible, ignored);
  std::ostringstream text;
  text << "near_pairs [options] FILE [FILE]\n"
          "reports every pair of points of FILE, or with one point of each FILE, within a\n"
          "distance, or the closest pair. FILE is a table (.csv, .tsv, .txt), .xyz, .off, .ply,\n"
          ".obj, .pdb or .tsp, also .gz, or - for the standard input.\n"
       << visible << "\nExit status: 0, or 2 with one line on the standard error; "
          "a broken pipe ends the\nprogram by its signal.\n";
  return text.str();
}

std::string version_text()
{
  return "near_pairs " CGAL_THICK_INTERSECTION_D_VERSION ", with CGAL " CGAL_VERSION_STR "\n";
}

} // namespace near_pairs
