// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Options for points that move; see track_options.h.

#include "track_options.h"

#include "error.h"
#include "exact_number.h"
#include "quantity.h"
#include "row_reader.h"

#include <optional>
#include <sstream>

namespace near_pairs {
namespace {

// The seconds of an option, which need no unit.
Exact_number read_time(const po::variables_map& map, const std::string& option)
{
  const std::string text = map[option].as<std::string>();
  const std::optional<Quantity> time = parse_quantity(std::string(trimmed(text)));
  const auto unit = time ? seconds_in(time->unit.empty() ? "s" : time->unit) : std::nullopt;
  if(!unit || is_negative(time->value))
    throw Error("--" + option + ": '" + text + "' is no time, such as 90s, 12min or 1.5h");
  return time->value * *unit;
}

// Refuses what is for points that stand still, or for other files than tables. `name` is the option
// by which points move.
void check_tracks(const po::variables_map& map, const std::string& name, const Options& options)
{
  for(const char* option : {"closest", "overlap", "solids", "components", "explain"})
    if(!map[option].defaulted())
      throw Error(std::string("--") + option + " is for points that stand still, and not for --"
                  + name);
  for(const char* option : {"periodic", "memory", "points"})
    if(map.count(option))
      throw Error(std::string("--") + option + " is for points that stand still, and not for --"
                  + name);
  for(const std::string& file : options.files)
    if(!is_table(file, options))
      throw Error("--" + name + " is for tables, such as .csv files, and not for " + file);
  if(extension(options.pairs) == ".geojson")
    throw Error("--pairs: pairs of tracks are a table, so name it .csv");
}

} // namespace

void read_track_options(const po::variables_map& map, Options& options)
{
  const bool has_times = map.count("time") != 0, has_velocity = map.count("velocity") != 0;
  for(const char* of_tracks : {"track", "max-gap"})
    if(map.count(of_tracks) && !has_times)
      throw Error(std::string("--") + of_tracks + " is for the tracks of --time");
  if(map.count("until") != map.count("velocity"))
    throw Error("--velocity and --until go together");
  if(!has_times && !has_velocity)
    return;
  if(has_times && has_velocity)
    throw Error("--time is for places at many times, and --velocity for places at one");
  const std::string option = has_times ? "time" : "velocity";
  if(are_all_empty(map[option].as<Texts>()))
    throw Error("--" + option + " names no column");
  if(has_times && map.count("id"))
    throw Error("--id names points, and --track names the tracks of --time");
  if(has_velocity && options.decimal)
    throw Error("--decimal is for coordinates in the file; --velocity computes others");
  check_tracks(map, option, options);
  if(map.count("max-gap"))
    options.max_gap = read_time(map, "max-gap");
  if(has_velocity) {
    options.until = read_time(map, "until");
    options.until_text = trimmed(map["until"].as<std::string>());
  }
}

void read_track_reading(const po::variables_map& map, std::size_t file, Read_options& reading)
{
  reading.time = text_for_file(map, "time", file);
  if(map.count("time")) {
    if(reading.time.empty())
      throw Error("--time names no column of file " + std::to_string(file + 1));
    reading.id = text_for_file(map, "track", file);
  }
  reading.velocity = split_at_commas(text_for_file(map, "velocity", file));
  if(reading.velocity.size() == 1 || reading.velocity.size() > 3)
    throw Error("--velocity needs the columns of a speed, a course and perhaps a climb");
  const Texts altitude = split_at_commas(text_for_file(map, "altitude", file));
  if(reading.velocity.size() == 3 && reading.geographic && altitude.empty())
    throw Error("--velocity names a climb, and --geographic has no height without --altitude");
  if(altitude.empty())
    return;
  const auto unit = altitude.front().empty() ? std::nullopt
                    : altitude.size() == 1 ? meters_in("m")
                    : altitude.size() == 2 ? meters_in(altitude[1]) : std::nullopt;
  if(!unit)
    throw Error("--altitude needs a column, and perhaps m, km, nmi, mi or ft behind a comma");
  reading.altitude = altitude.front();
  reading.altitude_unit = to_double(*unit);
}

void add_track_options(po::options_description& all)
{
  po::options_description tracks = group("Points that move");
  tracks.add_options()
    ("time", po::value<Texts>()->value_name("COLUMN"),
     "times of the places that the rows tell (1)")
    ("track", po::value<Texts>()->value_name("COLUMN"),
     "names what moves (default: id, or else the file) (1)")
    ("max-gap", po::value<std::string>()->value_name("TIME"),
     "no motion between places further apart in time")
    ("velocity", po::value<Texts>()->value_name("A,B[,C]"),
     "columns of speed, course and climb, in place of times")
    ("until", po::value<std::string>()->value_name("TIME"),
     "how far to look ahead, as 90s, 12min or 1.5h")
    ("altitude", po::value<Texts>()->value_name("A[,UNIT]"),
     "column of heights above the sphere, in m or UNIT (1)");
  all.add(tracks);
}

std::string track_help_text()
{
  const char* const notes
    = "\n(1) Once, or once for each file.\n"
      "\n"
      "Times are numbers, which are seconds; hh:mm or hh:mm:ss; or dates by ISO 8601,\n"
      "as 2018-08-01T05:00:00.5+02:00, also with a blank for the T. They are read\n"
      "without rounding. Those of closest approaches have 16 digits, clocks and dates\n"
      "have milliseconds, and both have more where the file has more.\n"
      "Rows may be in any order. From one place of a track to the next one, the point\n"
      "moves straight and at one speed. A pause that is longer than --max-gap parts a\n"
      "track, which is still one: a pair of tracks is reported once.\n"
      "\n"
      "With --velocity, each row is a point that moves from now on. Its course is in\n"
      "degrees, clockwise from north. With --geographic, its speed is in knots, along a\n"
      "great circle, and its climb in feet per minute; otherwise both are in units of\n"
      "the coordinates per second, y is north, and z is up. A point without a speed or\n"
      "a course stands still. So does a ship, which is --geographic without --altitude,\n"
      "if it says that it does not know one: 102.3 or 102.2 knots, 360 or 511 degrees.\n"
      "\n"
      "With --geographic, straight motion is along a chord of the sphere. The chord of\n"
      "an arc of c meters is up to c^2/(8R) below it, R = 6371008.8: 8 m if c = 20 km.\n"
      "Points that stand still may have an --altitude, too.\n";
  po::options_description visible(columns_of_help, columns_of_descriptions);
  add_track_options(visible);
  std::ostringstream text;
  text << "near_pairs --time COLUMN [--track COLUMN] [options] TABLE [TABLE]\n"
          "near_pairs --velocity SPEED,COURSE[,CLIMB] --until TIME [options] TABLE [TABLE]\n"
          "reports every pair of points that move and come within a distance of each other,\n"
          "with the time and the distance of their closest approach.\n"
       << visible << notes;
  return text.str();
}

} // namespace near_pairs
