// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// near_pairs: reports every pair of points of a file that are within a distance of each other, or
// the closest pair. Reads the options and the file, searches, writes the outputs, and prints a
// summary.

#include "cell.h"
#include "error.h"
#include "exact_number.h"
#include "external.h"
#include "feature_pairs.h"
#include "groups.h"
#include "hints.h"
#include "options.h"
#include "outputs.h"
#include "picture.h"
#include "point_file.h"
#include "row_reader.h"
#include "search.h"
#include "standard_streams.h"
#include "summary.h"
#include "tables.h"
#include "text.h"
#include "track_pairs.h"
#include "tracks.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>

namespace near_pairs {
namespace {

Search_result search(const Scene& scene, const Options& options, const Pair_sink& sink,
                     const Pair_sink& lost)
{
  if(scene.cell)
    return search_periodic(scene, options, sink, lost);
  if(options.kernel == "exact")
    return search_exact(scene, options, sink, lost);
  return search_epick(scene, options, sink, lost);
}

Closest_result find_closest(const Scene& scene, const Options& options)
{
  if(scene.cell)
    return closest_periodic(scene, options);
  if(options.kernel == "exact")
    return closest_exact(scene, options);
  return closest_epick(scene, options);
}

void print_points(std::ostream& out, const Scene& scene)
{
  print_name(out, "points");
  if(scene.first_size)
    out << *scene.first_size << " and ";
  out << scene.size() - scene.first_size.value_or(0) << '\n';
  print_guessed(out, scene.guessed);
  print_frames(out, scene.frames);
  const auto is_none = [](std::size_t rows) { return rows == 0; };
  if(scene.rows.empty() && std::all_of(scene.skipped.begin(), scene.skipped.end(), is_none))
    return;
  print_name(out, "skipped") << scene.skipped.front();
  if(scene.first_size)
    out << " and " << scene.skipped.back();
  out << " rows\n";
}

void print_cell(std::ostream& out, const Scene& scene)
{
  if(scene.cell)
    print_name(out, "cell") << cell_in_words(*scene.cell) << '\n';
}

void print_summary(std::ostream& out, const Scene& scene, const Options& options,
                   const Search_result& result)
{
  print_points(out, scene);
  print_name(out, "pairs") << result.pairs << '\n';
  if(scene.cell)
    print_name(out, "crossing") << result.crossing << ", the boundary of the cell\n";
  if(!options.open)
    print_name(out, "on boundary") << result.on_boundary << '\n';
  print_name(out, "distance") << distance_in_words(options, scene.unit) << '\n';
  print_cell(out, scene);
  print_kernel(out, options);
  if(!result.tier.empty())
    print_name(out, "arithmetic") << result.tier << '\n';
  print_costs(out, result.seconds, ", with its outputs");
}

void print_summary(std::ostream& out, const Scene& scene, const Options& options,
                   const Closest_result& result)
{
  const auto [i, j] = result.pair;
  print_points(out, scene);
  print_name(out, "closest pair") << scene.position(i) << ' ' << scene.position(j);
  if(!scene.ids.empty())
    out << ", " << one_line(readable(scene.ids[i])) << " and "
        << one_line(readable(scene.ids[j]));
  out << '\n';
  if(scene.cell) {
    print_name(out, "offset");
    for(int k = 0; k < scene.dimension; ++k)
      out << (k == 0 ? "" : " ") << result.offset[k];
    out << '\n';
  }
  print_name(out, "squared") << exact_text(result.squared_distance) << ", exactly\n";
  out << std::setprecision(10);
  print_name(out, "distance") << scene.distance(i, j, result.offset)
                              << (scene.unit.empty() ? "" : " ") << scene.unit << ", rounded\n";
  print_cell(out, scene);
  print_kernel(out, options);
  print_costs(out, result.seconds, "");
}

// The options of a search for the pairs at the distance of the closest one.
Options options_at(const Exact_number& squared_distance, Options options)
{
  options.squared = true;
  options.distance = squared_distance;
  options.distance_text = exact_text(squared_distance);
  return options;
}

// The outputs besides the summary. Their files are opened before the search, so that an error does
// not come after it.
class Outputs
{
public:
  Outputs(const Options& options, const Scene& scene)
    : options_(options), scene_(scene), pairs_file_(open_output(options.pairs, options.files)),
      points_file_(open_output(options.points, options.files)),
      picture_file_(open_output(options.picture, options.files))
  {
    check_map(options.pairs, scene);
    check_map(options.points, scene);
  }

  // `drawn` has the distance that the picture is about.
  void begin(const Options& drawn)
  {
    if(pairs_file_)
      pairs_ = make_pair_writer(options_.pairs, pairs_file_->stream(), scene_,
                                options_.coordinates);
    if(picture_file_)
      picture_.emplace(scene_, drawn, distance_in_words(drawn, scene_.unit));
    if(points_file_ || options_.components)
      groups_.emplace(scene_.size());
  }

  void add_pair(std::size_t i, std::size_t j, const Offset& offset)
  {
    if(pairs_) {
      pairs_->add(i, j, offset);
      pairs_file_->check(); // a full disk ends the search
    }
    if(picture_)
      picture_->add_pair(i, j, offset);
    if(groups_)
      groups_->add_pair(i, j);
  }

  void finish()
  {
    if(groups_)
      groups_->finish();
    if(picture_ && options_.components)
      picture_->color_by(*groups_);
    if(picture_)
      picture_->write(picture_file_->stream());
    if(points_file_)
      write_points(options_.points, points_file_->stream(), scene_, *groups_,
                   options_.coordinates);
    if(pairs_)
      pairs_->finish();
    for(const auto& file : {picture_file_.get(), points_file_.get(), pairs_file_.get()})
      if(file)
        file->commit();
  }

  void print_components(std::ostream& out) const
  {
    if(groups_)
      print_name(out, "components") << groups_->number_of_components() << ", the largest of "
                                    << plural(groups_->points_of_largest(), "point") << '\n';
  }

  // The summary makes way if an output is written to the standard output.
  std::ostream& summary() const
  {
    const bool is_taken
      = options_.pairs == "-" || options_.points == "-" || options_.picture == "-";
    return is_taken ? std::cerr : std::cout;
  }

private:
  const Options& options_;
  const Scene& scene_;
  std::unique_ptr<Output_file> pairs_file_, points_file_, picture_file_;
  std::unique_ptr<Pair_writer> pairs_;
  std::optional<Picture> picture_;
  std::optional<Groups> groups_;
};

void run_closest(const Options& options, const Scene& scene, Outputs& outputs)
{
  const Closest_result closest = find_closest(scene, options);
  const Options found = options_at(closest.squared_distance, options);
  outputs.begin(found);
  outputs.add_pair(closest.pair.first, closest.pair.second, closest.offset);
  outputs.finish();
  std::ostream& out = outputs.summary();
  print_summary(out, scene, options, closest);
  outputs.print_components(out);
  finish(out, "the summary");
  print_hints(std::cerr, scene, found, 0, 0);
}

// The search gives points of the plane a third coordinate of 0, which is not in the user's file.
std::string profile_in_dimension_of(const Scene& scene, std::string profile)
{
  const auto replace = [&](const std::string& part, const std::string& by) {
    const std::size_t at = profile.find(part);
    if(at != std::string::npos)
      profile.replace(at, part.size(), by);
  };
  if(scene.dimension == 2) {
    replace(" in dimension 3\n", " in dimension 2\n");
    replace("axis 2      [0, 0]\n", "");
  }
  return profile;
}

void run_search(const Options& options, const Scene& scene, Outputs& outputs)
{
  outputs.begin(options);
  Tie_watch ties(scene, options);
  const auto add_pair = [&](std::size_t i, std::size_t j, const Offset& offset) {
    ties.add_found(i, j, offset);
    outputs.add_pair(i, j, offset);
  };
  const auto add_lost = [&](std::size_t i, std::size_t j, const Offset& offset) {
    ties.add_lost(i, j, offset);
  };
  const Search_result result = search(scene, options, add_pair, add_lost);
  outputs.finish();
  std::ostream& out = outputs.summary();
  if(options.explain)
    out << profile_in_dimension_of(scene, result.profile) << '\n';
  print_summary(out, scene, options, result);
  outputs.print_components(out);
  finish(out, "the summary");
  print_hints(std::cerr, scene, options, ties.found(result.on_boundary), ties.lost());
}

void run(const Options& options)
{
  const Scene scene = read_scene(options);
  catch_signals();
  Outputs outputs(options, scene);
  if(options.closest)
    run_closest(options, scene, outputs);
  else
    run_search(options, scene, outputs);
}

} // namespace
} // namespace near_pairs

int main(int argc, char** argv)
{
  try {
    near_pairs::keep_closed_streams_closed();
    const near_pairs::Options options = near_pairs::parse_options(argc, argv);
    if(options.help)
      near_pairs::finish(std::cout << near_pairs::help_text(), "the help");
    else if(options.help_tracks)
      near_pairs::finish(std::cout << near_pairs::track_help_text(), "the help");
    else if(options.version)
      near_pairs::finish(std::cout << near_pairs::version_text(), "the version");
    else if(near_pairs::have_tracks(options))
      near_pairs::run_tracks(options);
    else if(near_pairs::have_features(options))
      near_pairs::run_features(options);
    else if(options.memory != 0)
      near_pairs::run_external(options);
    else
      near_pairs::run(options);
    return 0;
  }
  catch(const std::bad_alloc&) {
    return near_pairs::end_with_error("there is not enough memory");
  }
  catch(const std::exception& error) {
    return near_pairs::end_with_error(error.what());
  }
}
