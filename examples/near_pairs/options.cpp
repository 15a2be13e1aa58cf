// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The command line; see options.h.

#include "options.h"

#include "command_line.h"
#include "decimal.h"
#include "error.h"
#include "exact_number.h"
#include "feature.h"
#include "outputs.h"
#include "quantity.h"
#include "row_reader.h"
#include "track_options.h"

#include <CGAL/Thick_intersection_d/version.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

namespace near_pairs {
namespace {

void add_scene_options(po::options_description& all, Options& options)
{
  po::options_description scene = group("What is near");
  scene.add_options()
    ("distance", po::value<std::string>()->value_name("R"),
     "pairs at most R apart, as 0.1, 1/3 or 500m, exactly")
    ("squared-distance", po::value<std::string>()->value_name("R2"),
     "the same, given by its square")
    ("open", po::bool_switch(&options.open), "strictly closer pairs only")
    ("closest", po::bool_switch(&options.closest),
     "the closest pair and its exact squared distance")
    ("overlap", po::bool_switch(&options.overlap),
     "polygons with a common point inside, not on borders")
    ("solids", po::bool_switch(&options.solids),
     "solids in any number of .obj, .off, .ply, .stl files")
    ("periodic", po::value<std::string>()->value_name("A,B[,C]"),
     "in a box of these sides, which repeats (3)");
  all.add(scene);
}

void add_reading_options(po::options_description& all, Options& options)
{
  po::options_description points = group("How a file is read");
  points.add_options()
    ("format", po::value<std::string>(&options.format)->value_name("NAME"),
     "csv xyz off ply obj pdb cif tsp bin wkt geojson stl")
    ("separator", po::value<std::string>()->value_name("CHAR"),
     "of a table; also tab, blanks (default: found)")
    ("no-header", po::bool_switch(&options.no_header), "the first row of a table is a point")
    ("columns", po::value<Texts>()->value_name("A,B[,C]"),
     "names or numbers (default: x,y[,z] or lat,lon) (1)")
    ("id", po::value<Texts>()->value_name("COLUMN"),
     "names the points (default: id) (1)")
    ("comma-numbers", po::bool_switch(&options.comma_numbers),
     "numbers in a table have a comma, as 3,14")
    ("skip-missing", po::bool_switch(&options.skip_missing),
     "leave out points without coordinates: empty, NA, 91 N")
    ("frame", po::value<Texts>()->value_name("N"),
     "frame or model to read (default: 1, the first) (1)")
    ("dimension", po::value<int>(&options.dimension)->value_name("2|3"),
     "use so many coordinates (default: all)")
    ("geographic", po::bool_switch(&options.geographic),
     "degrees on a sphere; R is straight: m, km, nmi, mi, ft")
    ("decimal", po::bool_switch(&options.decimal),
     "take decimals exactly, not as doubles (2)");
  all.add(points);
}

void add_search_options(po::options_description& all, Options& options)
{
  po::options_description search = group("How the pairs are searched");
  search.add_options()
    ("kernel", po::value<std::string>(&options.kernel)->value_name("NAME"),
     "of CGAL's points: epick (default) or exact")
    ("parallel", po::bool_switch(&options.parallel), "use all cores")
    ("memory", po::value<std::string>()->value_name("SIZE"),
     "limit, as 200M or 1G; for counts and --pairs only")
    ("scratch", po::value<std::string>(&options.scratch)->value_name("DIR"),
     "for points that do not fit (default: $TMPDIR)");
  po::options_description output = group("What is written (FILE may be -)");
  output.add_options()
    ("pairs", po::value<std::string>(&options.pairs)->value_name("FILE"),
     "the pairs, as .csv or .geojson")
    ("points", po::value<std::string>(&options.points)->value_name("FILE"),
     "the points, with neighbors and component")
    ("coordinates", po::bool_switch(&options.coordinates),
     "write coordinates into these tables, but no --altitude")
    ("picture", po::value<std::string>(&options.picture)->value_name("FILE"),
     "drawing of the points and pairs, as .svg")
    ("components", po::bool_switch(&options.components),
     "count connected components, and color them")
    ("explain", po::bool_switch(&options.explain), "print what the search found out")
    ("progress", po::bool_switch(&options.progress),
     "show a percentage, but not of --closest of two files")
    ("help", po::bool_switch(&options.help),
     "print this text; --help-tracks: motion, --altitude")
    ("version", po::bool_switch(&options.version), "print the versions of program and CGAL");
  all.add(search).add(output);
}

// Spellings are exact and long, so that "-1" is a number and never an option.
po::variables_map parse(int argc, const char* const* argv, const po::options_description& visible)
{
  using namespace po::command_line_style;
  po::options_description all;
  all.add(visible).add_options()("file", po::value<std::vector<std::string>>())
    ("help-tracks", po::bool_switch());
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
  if(options.files.empty() || (options.files.size() > 2 && !options.solids))
    throw Error("give one or two input files, or more with --solids (--help lists the options)");
  if(std::count(options.files.begin(), options.files.end(), "-") > 1)
    throw Error("the standard input can be read only once");
}

// Reads a number with letters behind it as a length, and separates the two. Returns its meters, or
// nothing if there is no number.
std::optional<Exact_number> parse_with_unit(Options& options)
{
  const std::string text = options.distance_text;
  const std::optional<Quantity> length = parse_quantity(text);
  if(!length)
    return std::nullopt;
  const std::optional<Exact_number> meters = meters_in(length->unit);
  if(!meters)
    throw Error("--distance: '" + text + "': the unit is none of m, km, nmi, mi and ft");
  if(!options.geographic)
    throw Error("--distance: '" + text + "' has a unit, which is for --geographic");
  options.distance_text = length->number;
  options.distance_unit = length->unit;
  return length->value * *meters;
}

void read_distance(const po::variables_map& map, Options& options)
{
  if(map.count("distance") + map.count("squared-distance") + options.closest + options.overlap != 1)
    throw Error("give one of --distance, --squared-distance, --closest and --overlap");
  if(options.closest || options.overlap) {
    if(options.open || options.explain)
      throw Error("--open and --explain are for the pairs within a distance");
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
  if(is_negative(*distance))
    throw Error("--" + name + ": " + options.distance_text + " is negative");
  options.distance = *distance;
}

// Splits the names of columns of coordinates.
Texts parse_columns(const std::string& text, const Options& options)
{
  const Texts columns = split_at_commas(text);
  const std::size_t most = options.geographic ? 2 : 3;
  if(columns.size() < 2 || columns.size() > most)
    throw Error(options.geographic ? "--columns needs two names with --geographic"
                                   : "--columns needs two or three names");
  const int given = static_cast<int>(columns.size());
  if(!options.geographic && options.dimension != 0 && options.dimension != given)
    throw Error("--columns and --dimension disagree");
  return columns;
}

// The number of the frame of file `file`. It is for the files that may have frames.
std::size_t frame_for_file(const po::variables_map& map, const Options& options, std::size_t file)
{
  const auto may = [&](const std::string& name) { return has_frames(name, options); };
  if(map.count("frame") && std::none_of(options.files.begin(), options.files.end(), may))
    throw Error("--frame is for .xyz, .pdb and .cif files");
  const std::string text = text_for_file(map, "frame", file);
  if(text.empty() || !may(options.files[file]))
    return 1;
  const auto number = parse_count(text);
  if(!number || *number == 0)
    throw Error("--frame: '" + text + "' is no number of a frame, the first of which is 1");
  return *number;
}

// Meshes are no tables, and have one frame.
void check_solids(const po::variables_map& map, const Options& options)
{
  for(const char* option : {"columns", "id", "frame"})
    if(map.count(option) && options.solids)
      throw Error(std::string("--") + option + " is for points, and --solids has none");
}

// The options of tables are for the tables among the files, and --skip-missing is for files with
// rows. If there are none, the readers refuse them.
void read_readings(const po::variables_map& map, Options& options)
{
  for(const char* option : {"columns", "id", "frame", "altitude", "time", "track", "velocity"})
    if(map.count(option) && map[option].as<Texts>().size() > options.files.size())
      throw Error(std::string("--") + option + " is given once, or once for each file");
  for(const char* option : {"columns", "id", "frame", "altitude", "track"})
    if(map.count(option) && are_all_empty(map[option].as<Texts>()))
      throw Error(std::string("--") + option + " is empty: leave it out");
  for(const char* option : {"format", "scratch"})
    if(map.count(option) && map[option].as<std::string>().empty())
      throw Error(std::string("--") + option + " is empty: leave it out");
  const auto is_one = [&](const std::string& file) { return is_table(file, options); };
  const bool has_table = std::any_of(options.files.begin(), options.files.end(), is_one);
  const auto has_rows = [&](const std::string& file) {
    return !has_features(file, options) && format_of(file, options) != "bin";
  };
  const bool may_skip = std::any_of(options.files.begin(), options.files.end(), has_rows);
  for(std::size_t file = 0; file < options.files.size(); ++file) {
    Read_options reading = options;
    reading.id = text_for_file(map, "id", file);
    reading.frame = frame_for_file(map, options, file);
    read_track_reading(map, file, reading);
    const std::string columns = text_for_file(map, "columns", file);
    if(!columns.empty())
      reading.columns = parse_columns(columns, options);
    const std::string id = reading.id;
    if(has_table && !is_one(options.files[file]))
      reading.take_no_table();
    if(has_features(options.files[file], options))
      reading.id = id; // a property
    reading.may_skip_missing = options.memory == 0 && has_rows(options.files[file]);
    if(may_skip)
      reading.skip_missing = options.skip_missing && has_rows(options.files[file]);
    options.readings.push_back(reading);
  }
}

void check_overlap(const Options& options)
{
  for(const std::string& file : options.files)
    if(options.overlap && (options.solids || !has_features(file, options)))
      throw Error("--overlap is for the polygons of WKT and GeoJSON, and not for " + file);
}

void read_periodic(const po::variables_map& map, Options& options)
{
  if(!map.count("periodic"))
    return;
  const std::string text = map["periodic"].as<std::string>();
  options.is_periodic = true;
  if(text != "file")
    options.cell = parse_cell(text);
  if(options.geographic)
    throw Error("--periodic is for the plane and space, and --geographic for a sphere");
  if(options.kernel == "exact")
    throw Error("--periodic has no --kernel exact: it takes doubles, or decimals of 53 bits, and "
                "their images are exact");
  if(extension(options.pairs) == ".geojson" || extension(options.points) == ".geojson")
    throw Error("--periodic writes tables as .csv: a map does not repeat");
  if(options.files.size() == 2 && (options.closest || options.explain))
    throw Error("--periodic has no --closest and --explain of two files");
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
  if(map.count("altitude") && !options.geographic)
    throw Error("--altitude is for --geographic; --columns takes a third coordinate");
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

// Equal for the names of one file, which need not exist.
std::string canonical_name(const std::string& name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path path = target_of(fs::absolute(name, error));
  return error ? name : path.string();
}

// Refuses names that promise a format that no table is written in.
void check_table(const std::string& option, const std::string& name)
{
  const std::set<std::string> formats = {"", ".csv", ".geojson"};
  if(!formats.count(extension(name)))
    throw Error("--" + option + ": a table is a CSV file, and a map a GeoJSON file, so name it "
                ".csv or .geojson");
}

void read_outputs(const po::variables_map& map, Options& options)
{
  std::set<std::string> names;
  const std::pair<const char*, std::string*> outputs[]
    = {{"pairs", &options.pairs}, {"points", &options.points}, {"picture", &options.picture}};
  for(const auto& [option, name] : outputs)
    if(map.count(option)) {
      if(name->empty())
        throw Error("empty name of an output file");
      if(*name == "/dev/stdout")
        *name = "-";
      if(!names.insert(*name == "-" ? *name : canonical_name(*name)).second)
        throw Error("two outputs have the name " + *name);
    }
  check_table("pairs", options.pairs);
  check_table("points", options.points);
  if(options.coordinates && options.pairs.empty() && options.points.empty())
    throw Error("--coordinates is for --pairs and --points");
  const std::string format = extension(options.picture);
  if(!format.empty() && format != ".svg")
    throw Error("--picture: the picture is an SVG file, so name it .svg (rsvg-convert makes a "
                + format + " file of it)");
}

// Reads bytes, with or without one of the letters K, M and G behind them.
std::size_t parse_size(const std::string& text)
{
  const std::string letters = "KMG";
  const std::size_t letter = text.empty() ? std::string::npos : letters.find(text.back());
  const bool has_letter = letter != std::string::npos;
  const auto count = parse_count(text.substr(0, text.size() - has_letter));
  const std::size_t unit = has_letter ? std::size_t(1) << 10 * (letter + 1) : 1;
  if(!count || *count == 0 || *count > std::numeric_limits<std::size_t>::max() / unit)
    throw Error("--memory: '" + text + "' is no size, such as 200M or 1G");
  return *count * unit;
}

void read_memory(const po::variables_map& map, Options& options)
{
  if(!map.count("memory")) {
    if(map.count("scratch"))
      throw Error("--scratch is for --memory");
    return;
  }
  options.memory = parse_size(map["memory"].as<std::string>());
  if(options.files.size() != 1 || options.files.front() == "-")
    throw Error("--memory is for one file, and the standard input is kept in memory");
  if(is_cif(format_of(options.files.front(), options)))
    throw Error("--memory reads no .cif file, which is kept in memory as a whole");
  if(options.kernel == "exact" || options.decimal)
    throw Error("--memory holds coordinates as doubles");
  if(extension(options.pairs) == ".geojson")
    throw Error("--memory writes pairs as .csv");
  for(const char* name : {"points", "picture", "id", "periodic"})
    if(map.count(name))
      throw Error(std::string("--memory has no --") + name + ": not all points are there at once");
  if(options.closest || options.coordinates || options.components || options.explain)
    throw Error("--memory has no --closest, --coordinates, --components and --explain");
  if(options.skip_missing)
    throw Error("--memory has no --skip-missing: it numbers the points as they come");
}

// Boost's messages in one line each are good enough for what it finds by itself.
Options parse_and_check(int argc, const char* const* argv)
{
  Options options;
  po::options_description visible(columns_of_help, columns_of_descriptions);
  add_scene_options(visible, options);
  add_reading_options(visible, options);
  add_track_options(visible);
  add_search_options(visible, options);
  const po::variables_map map = parse(argc, argv, visible);
  options.help_tracks = map["help-tracks"].as<bool>();
  if(options.help || options.help_tracks || options.version)
    return options;
  read_files(map, options);
  read_distance(map, options);
  read_format(options);
  read_separator(map, options);
  check_choices(map, options);
  read_outputs(map, options);
  read_periodic(map, options);
  read_memory(map, options);
  read_track_options(map, options);
  check_solids(map, options);
  read_readings(map, options);
  check_overlap(options);
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
  const char* const notes
    = "\n(1) Once, or once for each file. (2) 0.1 is a tenth, not the double beside it.\n"
      "(3) Or vectors of four or nine numbers; or file: the cell of .xyz, .pdb or .cif\n";
  Options ignored;
  po::options_description visible(columns_of_help, columns_of_descriptions);
  add_scene_options(visible, ignored);
  add_reading_options(visible, ignored);
  add_search_options(visible, ignored);
  std::ostringstream text;
  text << "near_pairs [options] FILE [FILE]    (--solids: FILE...)\n"
          "reports every pair of points of FILE, or between two files, within a distance.\n"
          "FILE is a table (.csv), .xyz, .off, .ply, .obj, .pdb, .cif, .tsp, also .gz or -,\n"
          "or three doubles per point, least byte first (.bin). Points, lines and polygons\n"
          "of .wkt and .geojson are near if some of their points are: --distance 0 to meet.\n"
       << visible << notes << "Exit status: 0, or 2 with one line on the standard error.\n";
  return text.str();
}

std::string version_text()
{
  return "near_pairs " CGAL_THICK_INTERSECTION_D_VERSION ", with CGAL " CGAL_VERSION_STR "\n";
}

} // namespace near_pairs
