// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of tracks; see track_pairs.h.

#include "track_pairs.h"

#include "error.h"
#include "outputs.h"
#include "row_reader.h"
#include "search_tracks.h"
#include "standard_streams.h"
#include "summary.h"
#include "text.h"
#include "track_picture.h"
#include "tracks.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

namespace near_pairs {
namespace {

// Writes positions, ids if a file has some, coordinates at the time of the closest approach if they
// are wanted, this time, and the distance.
class Approach_table
{
public:
  Approach_table(std::ostream& out, const Tracks& tracks, bool with_coordinates)
    : out_(out), tracks_(tracks), with_coordinates_(with_coordinates),
      has_ids_(std::any_of(tracks.tracks.begin(), tracks.tracks.end(),
                           [](const Track& track) { return !track.id.empty(); }))
  {
    out_.precision(10);
    out_ << "i,j," << (has_ids_ ? "id_i,id_j," : "");
    if(with_coordinates_) {
      write_names(tracks_.scene.names.front(), "_i");
      write_names(tracks_.scene.names.back(), "_j");
    }
    out_ << (tracks_.are_looked_ahead ? "seconds" : "time") << ",distance\n";
  }

  void add(const Approach& pair)
  {
    out_ << tracks_.position(pair.i) << ',' << tracks_.position(pair.j) << ',';
    if(has_ids_)
      out_ << csv_field(tracks_.tracks[pair.i].id) << ',' << csv_field(tracks_.tracks[pair.j].id)
           << ',';
    for(const std::size_t track : {pair.i, pair.j})
      if(with_coordinates_)
        write_place(tracks_.place_at(track, pair.rounded_tick()));
    out_ << tracks_.time_text(pair.tick, pair.part) << ',' << pair.distance << '\n';
  }

private:
  void write_names(const std::array<std::string, 3>& names, const char* suffix)
  {
    for(int axis = 0; axis < tracks_.scene.columns(); ++axis)
      out_ << csv_field(names[axis] + suffix) << ',';
  }

  void write_place(const std::array<double, 3>& place)
  {
    const Scene& scene = tracks_.scene;
    for(int axis = 0; axis < scene.columns(); ++axis)
      out_ << shortest_text(scene.is_geographic ? degrees_of(place)[axis] : place[axis]) << ',';
  }

  std::ostream& out_;
  const Tracks& tracks_;
  const bool with_coordinates_, has_ids_;
};

void write_table(Output_file& file, const Tracks& tracks, const Track_result& result,
                 const Options& options)
{
  Approach_table table(file.stream(), tracks, options.coordinates);
  for(const Approach& pair : result.pairs) {
    table.add(pair);
    file.check(); // a full disk
  }
}

void print_tracks(std::ostream& out, const Tracks& tracks)
{
  const std::size_t all = tracks.tracks.size();
  print_name(out, tracks.are_looked_ahead ? "points" : "tracks") << tracks.first_size;
  if(tracks.scene.first_size)
    out << " and " << all - tracks.first_size;
  if(!tracks.are_looked_ahead)
    out << ", of " << plural(tracks.fixes, "row");
  out << '\n';
  print_guessed(out, tracks.scene.guessed);
}

void print_closest(std::ostream& out, const Tracks& tracks, const Track_result& result)
{
  const auto closest = std::min_element(
    result.pairs.begin(), result.pairs.end(),
    [](const Approach& a, const Approach& b) { return a.distance < b.distance; });
  if(closest == result.pairs.end())
    return;
  const auto name_of = [&](std::size_t track) {
    const std::string& id = tracks.tracks[track].id;
    return id.empty() ? std::to_string(tracks.position(track)) : one_line(id);
  };
  const std::string& unit = tracks.scene.unit;
  print_name(out, "closest") << name_of(closest->i) << " and " << name_of(closest->j) << ", "
    << std::setprecision(10) << closest->distance << (unit.empty() ? "" : " ") << unit
    << (tracks.are_looked_ahead ? ", after " : ", at ")
    << tracks.time_text(closest->tick, closest->part)
    << (tracks.are_looked_ahead ? " s\n" : "\n");
}

void print_summary(std::ostream& out, const Tracks& tracks, const Track_result& result,
                   const Options& options, double seconds)
{
  print_tracks(out, tracks);
  if(tracks.are_looked_ahead)
    print_name(out, "standing") << plural(tracks.standing, "point")
                                << " without a speed or a course\n";
  if(options.skip_missing) {
    print_name(out, "skipped") << tracks.scene.skipped.front();
    if(tracks.scene.first_size)
      out << " and " << tracks.scene.skipped.back();
    out << " rows\n";
  }
  print_name(out, "pairs") << result.pairs.size() << '\n';
  print_closest(out, tracks, result);
  if(!options.open)
    print_name(out, "on boundary") << result.on_boundary << '\n';
  print_name(out, "distance") << distance_in_words(options, tracks.scene.unit) << '\n';
  if(tracks.are_looked_ahead)
    print_name(out, "until") << options.until_text << '\n';
  print_kernel(out, options);
  print_name(out, "arithmetic") << result.tier << '\n';
  print_costs(out, seconds, ", with closest approaches");
}

// What the user may want to be told. A straight leg lies below the arc on the sphere, which matters
// if it is long.
void print_hints(const Tracks& tracks, const Track_result& result, const Options& options)
{
  const double noticeable = 0.01;
  const double leg = tracks.longest_leg(), depth = leg * leg / (8 * earth_radius);
  if(tracks.scene.is_geographic && depth > noticeable * reach_of(options))
    std::cerr << "near_pairs: hint: motion is straight between fixes: the longest leg, of "
              << std::llround(leg) << " m, is up to " << std::llround(depth)
              << " m below the surface\n";
  if(!tracks.are_looked_ahead && tracks.fixes > 1 && tracks.fixes == tracks.tracks.size())
    std::cerr << "near_pairs: hint: no two rows are of one track; --track names the column that "
                 "tells what moves\n";
  if(tracks.scene.has_degrees && !options.decimal)
    std::cerr << "near_pairs: hint: degrees are taken as numbers in the plane; --geographic puts "
                 "them on a sphere and measures meters\n";
  if(result.has_moved_ties)
    std::cerr << "near_pairs: hint: pairs " << (options.open ? "within" : "beyond")
              << " the distance may be at it but for rounding of decimals to doubles; --decimal "
                 "takes decimals exactly\n";
}

} // namespace

void run_tracks(const Options& options)
{
  const Tracks tracks = read_tracks(options);
  catch_signals();
  const std::unique_ptr<Output_file> table_file = open_output(options.pairs, options.files);
  const std::unique_ptr<Output_file> picture_file = open_output(options.picture, options.files);
  const auto start = std::chrono::steady_clock::now();
  const Track_result result = search_tracks(tracks, options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if(table_file)
    write_table(*table_file, tracks, result, options);
  if(picture_file)
    draw_tracks(picture_file->stream(), tracks, result.pairs, options);
  for(Output_file* file : {picture_file.get(), table_file.get()})
    if(file)
      file->commit();
  std::ostream& out = options.pairs == "-" || options.picture == "-" ? std::cerr : std::cout;
  print_summary(out, tracks, result, options, seconds.count());
  finish(out, "the summary");
  print_hints(tracks, result, options);
}

} // namespace near_pairs
