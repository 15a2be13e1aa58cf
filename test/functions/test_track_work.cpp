// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the search of tracks: the pairs of legs that it looks at and compares are counted
// where nearly all boxes meet, as legs cross the whole scene, are of one track, or are of a known
// pair; bytes where there are many fixes and pairs; and how many tracks there are at most.

#include "support/counting_allocator.h"
#include "support/point_generators.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/fixed_radius_near_tracks.h>

#include <cmath>

using namespace test_support;

namespace {

using Point = Epick::Point_2;
using Track = std::vector<std::pair<double, Point>>;
using Tracks = std::vector<Track>;
using Legs = internal::Track_legs<std::pair<double, Point>>;
using Boxes = internal::Are_tracks_near<Legs>;

// Counts what the box route asks.
struct Counted : Boxes
{
  using Boxes::Boxes;

  bool is_wanted(std::size_t i, std::size_t j) const
  {
    ++looks;
    return Boxes::is_wanted(i, j);
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    ++tests;
    return Boxes::do_intersect(i, j);
  }

  mutable double looks = 0, tests = 0;
};

// What the search looks at and compares at most, for each leg, and of how many stretches it is.
struct Limits
{
  double looks, tests, stretches = 16;
};

// Searches as fixed_radius_near_tracks() does. Returns the number of pairs.
double check_work(const std::string& name, const Tracks& tracks, double bound, const Limits& limits)
{
  const internal::Threads one;
  Legs legs;
  legs.add_tracks(tracks);
  const auto n = static_cast<double>(legs.size());
  internal::cut_legs(legs, bound);
  const Counted boxes(legs, CGAL::within_distance(bound), CGAL::Arithmetic_tier::INT64, nullptr,
                      one);
  double pairs = 0;
  const auto take = [&](std::size_t, std::size_t) { ++pairs; };
  internal::Unwatched_progress progress;
  internal::report_meeting_boxes(boxes, internal::One_set(), take, progress, one);
  const auto stretches = static_cast<double>(legs.size());
  BOOST_TEST_MESSAGE(name << ", n = " << n << ": pairs " << pairs / n << " n, looks "
                          << boxes.looks / n << " n, tests " << boxes.tests / n << " n, stretches "
                          << stretches / n << " n");
  BOOST_CHECK_MESSAGE(boxes.looks <= limits.looks * n, name << ": looks " << boxes.looks);
  BOOST_CHECK_MESSAGE(boxes.tests <= limits.tests * n, name << ": tests " << boxes.tests);
  BOOST_CHECK_MESSAGE(stretches <= limits.stretches * n, name << ": stretches " << stretches);
  return pairs;
}

Point anywhere(Random& random) { return {random.uniform(), random.uniform()}; }

Track leg(double begin, const Point& from, double end, const Point& to)
{
  return {{begin, from}, {end, to}};
}

Tracks crossing(std::size_t n)
{
  Random random(n);
  Tracks tracks;
  for(std::size_t i = 0; i < n; ++i)
    tracks.push_back(leg(0, anywhere(random), 60, anywhere(random)));
  return tracks;
}

Tracks standing(std::size_t n)
{
  Random random(n);
  Tracks tracks;
  for(std::size_t i = 0; i < n; ++i) {
    const Point place = anywhere(random);
    tracks.push_back(leg(0, place, 60, place));
  }
  return tracks;
}

// A track that makes so many steps within a time.
Track wandering(Point place, double begin, double duration, std::size_t steps, double length,
                Random& random)
{
  Track track;
  for(std::size_t i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(steps);
    track.emplace_back(begin + duration * part, place);
    place = Point(place.x() + length * (random.uniform() - .5),
                  place.y() + length * (random.uniform() - .5));
  }
  return track;
}

// n legs in tracks of ten minutes.
Tracks short_tracks(std::size_t n)
{
  Random random(n);
  Tracks tracks;
  const double step = .1 / std::sqrt(static_cast<double>(n));
  for(std::size_t i = 0; i < n / 10; ++i)
    tracks.push_back(wandering(anywhere(random), 1440 * random.uniform(), 10, 10, step, random));
  return tracks;
}

// The last leg of each track lasts for hours and goes anywhere.
Tracks tracks_with_gaps(std::size_t n)
{
  Random random(1);
  Tracks tracks = short_tracks(n);
  for(Track& track : tracks)
    track.emplace_back(track.back().first + 300, anywhere(random));
  return tracks;
}

Tracks with_more(Tracks tracks, const Tracks& more)
{
  tracks.insert(tracks.end(), more.begin(), more.end());
  return tracks;
}

Track moored(std::size_t legs)
{
  Random random(legs);
  Track track = wandering({0, 0}, 0, 1440, legs, 0, random);
  for(auto& fix : track)
    fix.second = Point(1e-6 * random.uniform(), 1e-6 * random.uniform());
  return track;
}

// Tracks whose fixes all have the same times, in cells of a lattice.
Tracks of_equal_times(std::size_t n)
{
  Random random(n);
  Tracks tracks;
  for(std::size_t i = 0; i < n / 20; ++i)
    tracks.push_back(wandering(Point(static_cast<double>(i % 40), static_cast<double>(i / 40)), 0,
                               1440, 20, .01, random));
  return tracks;
}

// Tracks on one way, at times that are close to each other.
Tracks convoy(std::size_t n)
{
  Random random(n);
  Tracks tracks;
  for(std::size_t i = 0; i < n; ++i) {
    const double late = 1e-3 * random.uniform();
    tracks.push_back(leg(late, {0, random.uniform()}, 60 + late, {1, random.uniform()}));
  }
  return tracks;
}

// Without cuts, boxes of legs that cross all would be compared .22 n^2 times. Those of a convoy
// meet .33 n^2 times, and cuts do not help.
BOOST_AUTO_TEST_CASE(legs_across_the_scene_are_cut)
{
  for(const std::size_t n : {1000, 4000}) {
    const auto m = static_cast<double>(n);
    check_work("crossing", crossing(n), 1 / m, {.12 * m, .12 * m});
    check_work("crossing, and standing still", with_more(crossing(n), standing(n)), 1 / m,
               {.04 * m, .03 * m, 12});
    check_work("with gaps", tracks_with_gaps(n), .5 / std::sqrt(m), {6, 3});
    check_work("convoy", convoy(n), 1e-6, {.34 * m, .34 * m});
    check_work("one long leg", with_more(short_tracks(n), {leg(0, {0, 0}, 1440, {1, 1})}),
               .5 / std::sqrt(m), {2, .2});
  }
}

BOOST_AUTO_TEST_CASE(legs_that_are_apart_in_space_or_time_are_not_compared)
{
  for(const std::size_t n : {2000, 8000}) {
    const auto m = static_cast<double>(n);
    Random random(n);
    check_work("standing still", standing(n), .5 / std::sqrt(m), {1, 1});
    check_work("equal times", of_equal_times(n), .5, {2, .1});
    check_work("a long track", with_more(short_tracks(n),
                                         {wandering({.5, .5}, 0, 1440, n, .01, random)}),
               .5 / std::sqrt(m), {2, .2});
  }
}

BOOST_AUTO_TEST_CASE(legs_of_one_track_and_of_known_pairs_are_not_compared)
{
  for(const std::size_t n : {10000, 100000}) {
    const double once = 1 / static_cast<double>(n);
    check_work("a moored track", {moored(n)}, 1, {2, 0});
    check_work("two moored tracks", {moored(n), moored(n)}, 1e-3, {4, once});
  }
  const Tracks equal(400, leg(0, {0, 0}, 1, {1, 1}));
  const double pairs_each = 399. / 2;
  check_work("equal legs", equal, 0, {pairs_each, pairs_each});
}

// The fixes are copied. Stretches take most memory where legs are cut.
BOOST_AUTO_TEST_CASE(memory_is_linear_in_legs_and_pairs)
{
  const auto check = [](const std::string& name, const Tracks& tracks, double bound,
                        double limit) {
    double legs = 0, pairs = 0;
    for(const Track& track : tracks)
      legs += static_cast<double>(track.size() - 1);
    reset_peak();
    const std::size_t before = current_bytes();
    CGAL::fixed_radius_near_tracks(tracks, CGAL::within_distance(bound),
                                   [&](std::size_t, std::size_t) { ++pairs; });
    const double bytes = static_cast<double>(peak_bytes() - before) / (legs + pairs);
    BOOST_TEST_MESSAGE(name << ": " << legs << " legs, " << pairs << " pairs, bytes / (n + k) "
                            << bytes);
    BOOST_CHECK_MESSAGE(bytes <= limit, name << ": " << bytes);
  };
  for(const std::size_t n : {2000, 8000}) {
    check("crossing", crossing(n), 1 / static_cast<double>(n), 1200);
    check("equal legs", Tracks(n / 4, leg(0, {0, 0}, 1, {1, 1})), 0, 50);
    check("standing still", standing(n), 1e-3, 250);
    check("moored", {moored(10 * n), moored(10 * n)}, 1, 230);
  }
}

// They take no memory, so they are too many before the fixes are.
BOOST_AUTO_TEST_CASE(tracks_without_fixes_count)
{
  const Track none;
  Legs legs;
  for(internal::Place count = 1; count < internal::max_place / 2; ++count)
    legs.add_track(none);
  BOOST_CHECK_THROW(legs.add_track(none), std::length_error);
}

} // namespace
