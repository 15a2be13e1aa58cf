// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that move, by our search and by what else there is: times, and how many pairs differ.

#include "counted.h"
#include "goal.h"
#include "print.h"
#include "table.h"

#include "laboratory/object_questions.h"
#include "laboratory/track_families.h"
#include "methods/track_methods.h"

#include <string>
#include <vector>

namespace thick_benchmark {
namespace {

// ---- times --------------------------------------------------------------------------------------

struct Line
{
  Counted_times times;
  std::string differences; // pairs that are missing, and that are too many
  Goal goal;               // for the time over ours
};

// We may take 2.5 times as long as the search of the boxes, and are to be 20 times as fast as
// PostGIS, which takes too long to be run again.
std::vector<Line> lines_of(const Track_scene& scene, const Settings& settings)
{
  const Pair_list ours = tracks_ours().prepare(scene)();
  const auto differences = [&](const Pair_list& others) {
    return std::to_string(count_missing(ours, others)) + ", "
           + std::to_string(count_missing(others, ours));
  };
  std::vector<Counted> ways;
  std::vector<std::string> differing;
  const auto add = [&](const Track_method& method) {
    const auto run = method.prepare(scene);
    ways.push_back({method.name, [run] { return run().pairs.size(); }});
    differing.push_back(differences(run()));
  };
  add(tracks_ours());
  const auto boxes = boxes_of_legs();
  ways.push_back({boxes.name, [run = boxes.prepare(scene)] { return std::size_t(run().pairs); }});
  differing.push_back("");
  add(tracks_by_sweep());
  add(tracks_by_minutes());
  const std::vector<Counted_times> times = time_in_turns(ways, settings.is_quick ? 1 : 5);
  std::vector<Line> lines;
  for(std::size_t k = 0; k < times.size(); ++k)
    lines.push_back({times[k], differing[k], k == 1 ? at_least(1 / 2.5) : Goal()});
  if(settings.has_postgis) {
    const auto [found, seconds] = tracks_by_postgis(scene);
    const double ms = 1000 * seconds;
    const Counted_times its_times
      = {"PostGIS", found.pairs.size(), ms, ms, ms / times[0].median};
    lines.push_back({its_times, differences(found), at_least(20)});
  }
  return lines;
}

void print_lines(const Track_scene& scene, const Settings& settings)
{
  const std::string name = std::to_string(scene.dimension) + "D " + scene.name;
  if(name.find(settings.only) == std::string::npos)
    return;
  for(const Line& line : lines_of(scene, settings)) {
    const Counted_times& times = line.times;
    print_line(name, times.name, scene.leg_count(), times.count, line.differences,
               digits(times.median), figure(times.over_first), target_of(line.goal),
               verdict(times.over_first, line.goal));
  }
}

void print_all_times(const Settings& settings)
{
  const std::size_t n = settings.is_quick ? 3000 : 300000;
  print_head({"scene", "method", ">legs", ">pairs", "missing, extra", ">ms", ">time / ours",
              ">target", "verdict"});
  for(const int dimension : {2, 3}) {
    print_lines(short_legs(dimension, n, true), settings);
    print_lines(short_legs(dimension, n, false), settings);
    print_lines(standing(dimension, n), settings);
    print_lines(crossing_legs(dimension, n / 30), settings);
  }
  print_lines(one_long_track(n / 3), settings);
  if(!settings.data.empty())
    print_lines(aircraft(settings.data + "/aircraft_ch_2018-08-01_am.csv"), settings);
}

// ---- wrong pairs --------------------------------------------------------------------------------

Track_scene scene_of(const lab::Object_set& set)
{
  Track_scene scene = {set.kind.name + ", " + set.family, set.kind.dimension, {},
                       2 * set.radius(0)};
  const auto dimension = static_cast<std::size_t>(scene.dimension);
  for(std::size_t i = 0; i < set.size(); ++i) {
    scene.tracks.emplace_back();
    for(std::size_t end = 0; end < 2; ++end) {
      Place_at_time fix = {set.times[2 * i + end], {}};
      for(std::size_t axis = 0; axis < dimension; ++axis)
        fix.place[axis] = set.object(i)[dimension * end + axis];
      scene.tracks.back().push_back(fix);
    }
  }
  return scene;
}

Pair_list right_pairs(const lab::Object_set& set)
{
  const lab::Object_questions questions = lab::questions_about(set);
  Pair_list right;
  for(std::size_t k = 0; k < questions.pairs.size(); ++k)
    if(questions.answers[k] != 0)
      right(questions.pairs[k].first, questions.pairs[k].second);
  return right;
}

void print_wrong_pairs(const lab::Object_set& set, const Settings& settings)
{
  const Track_scene scene = scene_of(set);
  const Pair_list right = right_pairs(set);
  const auto print = [&](const std::string& method, const Pair_list& found) {
    print_line(scene.name, method, scene.leg_count(), right.pairs.size(),
               count_missing(right, found), count_missing(found, right));
  };
  for(const Track_method& method : {tracks_ours(), tracks_by_sweep()})
    print(method.name, method.prepare(scene)());
  if(settings.has_postgis)
    print("PostGIS", tracks_by_postgis(scene).found);
}

} // namespace

void print_table(const Settings& settings)
{
  print_all_times(settings);
  std::cout << "\nWrong pairs of the families of the laboratory.\n\n";
  print_head({"scene", "method", ">legs", ">pairs", ">missing", ">extra"});
  for(const lab::Kind& kind : lab::moving_kinds())
    for(const lab::Object_set& set : lab::track_families(kind))
      print_wrong_pairs(set, settings);
}

} // namespace thick_benchmark
