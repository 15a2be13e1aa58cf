// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of tracks on a kernel, in one range and in two, against the oracle.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_TRACKS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_TRACKS_H

#include "check_pairs.h"
#include "kernel_types.h"
#include "scales.h"
#include "track_oracle.h"
#include "unit_test.h"

#include <CGAL/fixed_radius_near_tracks.h>

namespace test_support {

struct Track_scene
{
  Lattice_tracks tracks;
  int r;
  bool is_open;
};

// Tracks of up to `legs` legs on a small lattice, so that many touch at the bound, have times in
// common, or stand still. In some scenes all have the same times.
inline Track_scene random_track_scene(std::uint64_t seed, std::size_t size, std::size_t legs,
                                      int dimension)
{
  Random random(seed);
  const auto below = [&](int n) { return static_cast<int>(random.below(std::uint64_t(n))); };
  const int side = 2 + below(9), longest = 1 + below(4);
  const bool have_common_times = below(3) == 0;
  Track_scene scene = {{}, below(4), below(3) == 0};
  while(scene.tracks.size() < size) {
    scene.tracks.emplace_back();
    Lattice_fix fix = {have_common_times ? 0 : below(12), {below(side), below(side), 0}};
    for(std::size_t k = random.below(legs + 2); k != 0; --k) {
      if(dimension == 3)
        fix.place[2] = below(side);
      scene.tracks.back().push_back(fix);
      fix.time += have_common_times ? 2 : 1 + below(longest);
      if(below(4) != 0)
        fix.place = {below(side), below(side), fix.place[2]};
    }
  }
  return scene;
}

inline Pairs expected_pairs(const Track_scene& scene)
{
  return pairs_where(scene.tracks.size(), [&](std::size_t i, std::size_t j) {
    return are_tracks_near(scene.tracks[i], scene.tracks[j], scene.r * scene.r, scene.is_open);
  });
}

// Where a lattice is, in which units: x becomes origin + unit x, and that on a scale.
struct Line_placement
{
  Scale scale = Scale::ONE;
  double origin = 0;
  double unit = 1;

  template <class NT>
  NT place(int x) const
  {
    return scaled<NT>(origin + unit * x, scale);
  }

  // Returns by how much a lattice of width 1 is longer then.
  template <class NT>
  Exact_rational factor() const
  {
    return Exact_rational(internal::to_exact_rational(place<NT>(1))
                          - internal::to_exact_rational(place<NT>(0)));
  }
};

struct Track_placement
{
  Line_placement places;
  Line_placement times;
};

template <class Kernel, int Dimension, class Time>
using Placed_tracks
  = std::vector<std::vector<std::pair<Time, typename Kernel_types<Kernel, Dimension>::Point>>>;

template <class Kernel, int Dimension, class Time>
Placed_tracks<Kernel, Dimension, Time> placed_tracks(const Lattice_tracks& tracks,
                                                     const Track_placement& placement)
{
  Placed_tracks<Kernel, Dimension, Time> placed;
  for(const Lattice_track& track : tracks) {
    placed.emplace_back();
    for(const Lattice_fix& fix : track)
      placed.back().emplace_back(
        placement.times.template place<Time>(fix.time),
        Kernel_types<Kernel, Dimension>::point([&](std::size_t axis) {
          return placement.places.template place<typename Kernel::FT>(fix.place[axis]);
        }));
  }
  return placed;
}

template <class... Arguments>
Pairs near_tracks(const Arguments&... arguments)
{
  Pairs pairs;
  Locked_collector collect(pairs);
  BOOST_CHECK(CGAL::fixed_radius_near_tracks(arguments..., collect));
  return sorted(pairs);
}

// The bound may be a number that the kernel does not have.
template <class Kernel, int Dimension, class Time>
void check_placed_tracks(const Track_scene& scene, const Pairs& expected,
                         const Track_placement& placement)
{
  const auto tracks = placed_tracks<Kernel, Dimension, Time>(scene.tracks, placement);
  const Exact_rational r(placement.places.factor<typename Kernel::FT>() * scene.r);
  const CGAL::Distance_bound<Exact_rational> bound(r, false, scene.is_open);
  const auto [a, b] = split(tracks, tracks.size() / 2);
  check_pairs("pairs", expected, near_tracks(tracks, bound), near_tracks(a, b, bound), a.size());
  const auto lists = CGAL::fixed_radius_track_lists<CGAL::Parallel_if_available_tag>(tracks, bound);
  check_pairs("lists", in_both_orders(expected), pairs_in_lists(lists));
  check_pairs("lists of two", of_two_sets(expected, a.size()),
              pairs_in_lists(CGAL::fixed_radius_track_lists(a, b, bound)));
}

// A few pairs of the scene.
template <class Kernel, int Dimension, class Time>
void check_approaches(const Track_scene& scene, const Track_placement& placement)
{
  const auto tracks = placed_tracks<Kernel, Dimension, Time>(scene.tracks, placement);
  const Exact_rational unit = placement.places.factor<typename Kernel::FT>();
  const Exact_rational time_unit = placement.times.factor<Time>();
  const Exact_rational origin(internal::to_exact_rational(placement.times.place<Time>(0)));
  for(std::size_t i = 0; i + 1 < tracks.size(); ++i) {
    const std::optional<Approach> expected = approach_of(scene.tracks[i], scene.tracks[i + 1]);
    const auto found = CGAL::closest_approach(tracks[i], tracks[i + 1]);
    BOOST_REQUIRE_EQUAL(expected.has_value(), found.has_value());
    if(expected) {
      BOOST_CHECK(found->squared_distance == expected->square * unit * unit);
      BOOST_CHECK(found->time == origin + expected->time * time_unit);
    }
  }
}

// Scenes of as many seeds as check_seeds() draws.
template <class Kernel, int Dimension, class Time>
void check_tracks(const Track_scene& scene, const std::vector<Track_placement>& placements)
{
  const Pairs expected = expected_pairs(scene);
  for(std::size_t k = 0; k < placements.size(); ++k)
    BOOST_TEST_CONTEXT("placement " << k) {
      check_placed_tracks<Kernel, Dimension, Time>(scene, expected, placements[k]);
      check_approaches<Kernel, Dimension, Time>(scene, placements[k]);
    }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_TRACKS_H
