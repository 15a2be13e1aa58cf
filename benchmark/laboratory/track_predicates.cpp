// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that move, by the formula that one would write down, in doubles and exactly, and by ours.

#include "predicate_columns.h"

#include "methods/leg_forms.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/closest_approach.h>
#include <CGAL/fixed_radius_near_tracks.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace lab {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using CGAL::Exact_rational;

bool knows_moving(const Kind& kind) { return kind.meaning == Meaning::MOVING; }

double bound_of(const Object_questions& questions) { return 2 * questions.objects.radius(0); }

// ---- the formula --------------------------------------------------------------------------------

template <class Number, std::size_t N>
Answers ask_form_d(const Object_questions& questions, double milliseconds)
{
  std::vector<thick_benchmark::Plain_leg<Number, N>> legs(questions.objects.size());
  for(std::size_t i = 0; i < legs.size(); ++i)
    for(std::size_t end = 0; end < 2; ++end) {
      legs[i].times[end] = Number(questions.objects.times[2 * i + end]);
      for(std::size_t axis = 0; axis < N; ++axis)
        legs[i].ends[end][axis] = Number(questions.objects.object(i)[N * end + axis]);
    }
  const Number bound(bound_of(questions));
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    return thick_benchmark::come_within(legs[i], legs[j], bound);
  });
}

template <class Number>
Answers ask_form(const Object_questions& questions, double milliseconds)
{
  return questions.objects.kind.dimension == 2 ? ask_form_d<Number, 2>(questions, milliseconds)
                                               : ask_form_d<Number, 3>(questions, milliseconds);
}

// ---- ours ---------------------------------------------------------------------------------------

// Tracks of two fixes, or of one if they are at the same time.
template <class Kernel, class Maker>
auto tracks_of(Maker, const Object_set& set)
{
  using Time = typename Kernel::FT;
  using Point = decltype(Maker::template point<Kernel>(set.object(0), 0));
  std::vector<std::vector<std::pair<Time, Point>>> tracks(set.size());
  for(std::size_t i = 0; i < set.size(); ++i)
    for(std::size_t end = 0; end < 2; ++end)
      if(end == 0 || set.times[2 * i] < set.times[2 * i + 1])
        tracks[i].emplace_back(Time(set.times[2 * i + end]),
                               Maker::template point<Kernel>(set.object(i), end));
  return tracks;
}

template <class Kernel>
Answers search_tracks(const Object_questions& questions, double milliseconds)
{
  return with_segments_maker(questions.objects.kind, [&](auto maker) {
    const auto tracks = tracks_of<Kernel>(maker, questions.objects);
    return answers_of_search(questions, milliseconds, [&] {
      Pairs pairs;
      CGAL::fixed_radius_near_tracks(
        tracks, CGAL::within_distance(bound_of(questions)),
        [&](std::size_t i, std::size_t j) { pairs.push_back(std::minmax(i, j)); });
      return test_support::sorted(std::move(pairs));
    });
  });
}

Answers ask_closest_approach(const Object_questions& questions, double milliseconds)
{
  return with_segments_maker(questions.objects.kind, [&](auto maker) {
    const auto tracks = tracks_of<Epick>(maker, questions.objects);
    const Exact_rational bound(bound_of(questions)), square(bound * bound);
    return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
      const auto approach = CGAL::closest_approach(tracks[i], tracks[j]);
      return approach && approach->squared_distance <= square;
    });
  });
}

} // namespace

Predicate_columns track_predicates()
{
  return {
    {"formula, double", "form", knows_moving, ask_form<double>},
    {"formula, long double", "form", knows_moving, ask_form<long double>},
    {"formula, rational", "kernel", knows_moving, ask_form<Exact_rational>},
    {"ours, closest_approach", "ours", knows_moving, ask_closest_approach},
    {"ours, search", "ours", knows_moving, search_tracks<Epick>},
    {"ours, EPECK", "ours", knows_moving, search_tracks<Epeck>},
    {"ours, rational", "ours", knows_moving,
     search_tracks<CGAL::Simple_cartesian<Exact_rational>>},
  };
}

} // namespace lab
