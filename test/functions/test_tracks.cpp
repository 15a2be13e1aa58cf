// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which points that move come within a distance, on several kernels, places and scales, against
// rational numbers, and when two of them are closest.

#include "support/check_tracks.h"
#include "support/seeds.h"
#include "support/usual_kernels.h"

#include <boost/property_map/function_property_map.hpp>

#include <list>
#include <map>

using namespace test_support;

namespace {

const Line_placement near_one = {Scale::ONE, 1, 0x1p-52}, far_away = {Scale::ONE, 0x1p+52, 1};
const Line_placement huge = {Scale::HUGE_POWER}, tiny = {Scale::DENORMAL};
const Line_placement thirds = {Scale::THIRD}, close_by = {Scale::CLOSE};

template <class Kernel, int Dimension, class Time>
void check_random_tracks(std::uint64_t count, const std::vector<Track_placement>& placements)
{
  check_seeds(count, [&](std::uint64_t seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
      check_tracks<Kernel, Dimension, Time>(random_track_scene(seed, 12, seed % 5, Dimension),
                                            placements);
  });
}

// What a search of tracks in the plane has decided.
template <class Tracks>
CGAL::Scene_profile profile_of(const Tracks& tracks, double r,
                               CGAL::Scene_profile profile = CGAL::Scene_profile())
{
  CGAL::fixed_radius_near_tracks(tracks, CGAL::within_distance(r),
                                 [](std::size_t, std::size_t) {}, profile);
  return profile;
}

} // namespace

using Track_2 = std::vector<std::pair<double, Epick::Point_2>>;

BOOST_AUTO_TEST_CASE(tracks_of_doubles_in_the_plane)
{
  const std::vector<Track_placement> placements
    = {{}, {near_one, {}}, {far_away, near_one}, {huge, {}}, {tiny, tiny}, {{}, huge}};
  check_random_tracks<Epick, 2, double>(25, placements);
  check_random_tracks<Double_kernel, 2, double>(8, placements);
}

BOOST_AUTO_TEST_CASE(tracks_of_doubles_in_space)
{
  check_random_tracks<Epick, 3, double>(
    25, {{}, {near_one, far_away}, {far_away, {}}, {huge, huge}, {tiny, {}}});
}

BOOST_AUTO_TEST_CASE(tracks_of_lazy_numbers)
{
  check_random_tracks<Epeck, 2, Epeck::FT>(10, {{}, {thirds, thirds}, {close_by, {}}});
  check_random_tracks<Epeck, 3, double>(10, {{thirds, {}}, {close_by, near_one}});
}

BOOST_AUTO_TEST_CASE(tracks_of_rationals)
{
  check_random_tracks<Rational_kernel, 2, Exact_rational>(10, {{thirds, thirds}, {{}, close_by}});
  check_random_tracks<Rational_kernel, 3, int>(10, {{}, {thirds, {}}});
}

BOOST_AUTO_TEST_CASE(times_of_other_types_than_coordinates)
{
  check_random_tracks<Epick, 2, unsigned>(10, {{}});
  check_random_tracks<Epick, 3, long long>(10, {{}, {near_one, {Scale::ONE, 0x1p+62, 1024}}});
  check_random_tracks<Epick, 2, Exact_rational>(10, {{near_one, thirds}});
  check_random_tracks<CGAL::Simple_cartesian<float>, 3, float>(10, {{}});
}

// Nearly all boxes of these legs meet, so they are cut.
BOOST_AUTO_TEST_CASE(tracks_across_the_whole_scene)
{
  for(const std::uint64_t seed : {1, 2, 3, 4}) {
    const std::size_t fixes = 2 + seed % 2;
    Random random(seed);
    Track_scene scene = {{}, 3, false};
    const auto coordinate = [&] { return static_cast<int>(random.below(1000)); };
    while(scene.tracks.size() < 120) {
      scene.tracks.emplace_back();
      for(int time = coordinate() % 3; scene.tracks.back().size() < fixes; time += 50 * int(seed))
        scene.tracks.back().push_back({time, {coordinate(), coordinate(), 0}});
    }
    const Pairs expected = expected_pairs(scene);
    BOOST_CHECK_GT(expected.size(), 30u);
    check_placed_tracks<Epick, 2, double>(scene, expected, {});
    check_placed_tracks<Epeck, 2, double>(scene, expected, {thirds, {}});
    check_placed_tracks<Epick, 2, double>(scene, expected, {{Scale::ONE, -0x1p1020, 0x1p1011}, {}});
  }
}

BOOST_AUTO_TEST_CASE(a_track_exists_from_its_first_fix_to_its_last)
{
  const Epick::Point_2 p(0, 0), q(4, 0);
  const std::vector<Track_2> tracks
    = {{}, {{1, p}}, {{1, p}}, {{1.5, p}}, {{1, p}, {2, p}}, {{2, p}, {3, q}}, {{2.5, q}}};
  check_pairs("at one place", {{1, 2}, {1, 4}, {2, 4}, {3, 4}, {4, 5}},
              near_tracks(tracks, CGAL::within_distance(0)));
  check_pairs("at one time", {{1, 2}, {1, 4}, {2, 4}, {3, 4}, {4, 5}, {5, 6}},
              near_tracks(tracks, CGAL::within_distance(infinity)));
  BOOST_CHECK(near_tracks(tracks, CGAL::within_distance(0).open()).empty());
  BOOST_CHECK(!CGAL::closest_approach(tracks[0], tracks[1]));
  BOOST_CHECK(!CGAL::closest_approach(tracks[1], tracks[3]));
}

// Doubles do not tell these times apart.
BOOST_AUTO_TEST_CASE(tracks_without_a_common_time_are_not_near_at_any_bound)
{
  const Epick::Point_2 p(0, 0), q(1, 0);
  const std::int64_t t = 1700000000000000000; // nanoseconds since 1970
  const std::vector<std::vector<std::pair<std::int64_t, Epick::Point_2>>> tracks
    = {{{t, p}, {t + 10, q}}, {{t + 20, p}, {t + 30, q}}, {{t + 10, q}, {t + 20, p}}};
  check_pairs("nanoseconds", {{0, 2}, {1, 2}},
              near_tracks(tracks, CGAL::within_distance(infinity)));
  check_pairs("nanoseconds, squared", {{0, 2}, {1, 2}},
              near_tracks(tracks, CGAL::within_squared_distance(infinity)));
}

// Most pairs of boxes are of two tracks that are a known pair. So the search gives up to compare
// them one by one, and begins anew when it has found the first two tracks.
BOOST_AUTO_TEST_CASE(short_tracks_beside_many_that_stay_are_found_once)
{
  const Epick::Point_2 p(0, 0);
  Track_2 port;
  for(int time = 0; time <= 20; ++time)
    port.emplace_back(time, p);
  std::vector<Track_2> tracks(2, Track_2{{0, p}, {1, p}});
  tracks.resize(702, port);
  std::size_t count = 0, count_of_first = 0;
  CGAL::fixed_radius_near_tracks(tracks, CGAL::within_distance(1),
                                 [&](std::size_t i, std::size_t j) {
                                   ++count;
                                   count_of_first += i == 0 && j == 1;
                                 });
  BOOST_CHECK_EQUAL(count, tracks.size() * (tracks.size() - 1) / 2);
  BOOST_CHECK_EQUAL(count_of_first, 1u);
}

// The first time counts: the tracks are side by side all the time, or twice at one place.
BOOST_AUTO_TEST_CASE(the_first_of_several_closest_approaches_is_returned)
{
  const auto at = [](double x, double y) { return Epick::Point_2(x, y); };
  const Track_2 a = {{1, at(0, 0)}, {7, at(6, 0)}}, b = {{0, at(0, 2)}, {10, at(10, 2)}};
  const auto side_by_side = CGAL::closest_approach(a, b);
  BOOST_CHECK(side_by_side->time == 1 && side_by_side->squared_distance == 5);
  const Track_2 still = {{0, at(0, 0)}, {4, at(0, 0)}};
  const Track_2 forth_and_back = {{0, at(-1, 1)}, {2, at(1, 1)}, {4, at(-1, 1)}};
  const auto twice = CGAL::closest_approach(forth_and_back, still);
  BOOST_CHECK(twice->time == 1 && twice->squared_distance == 1);
}

BOOST_AUTO_TEST_CASE(ranges_of_all_forms_are_tracks)
{
  using Point = Epick::Point_2;
  const std::list<std::map<int, Point>> maps
    = {{{0, Point(0, 0)}, {2, Point(2, 0)}}, {{1, Point(1, 1)}}, {{3, Point(1, 1)}}};
  check_pairs("tracks", {{0, 1}}, near_tracks(maps, CGAL::within_distance(1)));
  const std::vector<std::size_t> numbers = {2, 1, 0};
  const auto track_of = boost::make_function_property_map<std::size_t, std::map<int, Point>>(
    [&](std::size_t i) { return *std::next(maps.begin(), static_cast<std::ptrdiff_t>(i)); });
  Pairs pairs;
  CGAL::fixed_radius_near_tracks(
    numbers, CGAL::within_distance(1),
    CGAL::with_elements([&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); }),
    CGAL::parameters::point_map(track_of));
  check_pairs("tracks", {{1, 0}}, pairs);
  const std::vector<std::vector<std::pair<int, Point>>> others = {{{2, Point(2, 1)}}};
  check_pairs("tracks", {{0, 0}}, near_tracks(maps, others, CGAL::within_distance(1)));
}

BOOST_AUTO_TEST_CASE(profiles_tell_the_degree_and_which_arithmetic_decides)
{
  using CGAL::Arithmetic_tier;
  const auto at = [](double x, double y) { return Epick::Point_2(x, y); };
  const std::vector<Track_2> common
    = {{{0, at(0, 0)}, {3, at(6, 0)}}, {{0, at(3, 2)}, {3, at(3, 2)}},
       {{0, at(9, 9)}, {3, at(8, 9)}}};
  CGAL::Scene_profile profile = profile_of(common, 2);
  BOOST_CHECK_EQUAL(profile.size(), 3u);
  BOOST_CHECK_EQUAL(profile.dimension(), 3);
  BOOST_CHECK_EQUAL(profile.degree(), 4);
  BOOST_CHECK_EQUAL(profile.needed_tier(), Arithmetic_tier::INT128);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::INT128), 1u);
  profile.force_tier(Arithmetic_tier::FILTERED_EXACT);
  profile = profile_of(common, 2, profile);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::INT128), 0u);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::FILTERED_EXACT), 1u);
  std::vector<Track_2> others = common;
  others[1][1].first = 4;
  others[2][0].second = at(8.0625, 9);
  profile = profile_of(others, 2);
  BOOST_CHECK_EQUAL(profile.degree(), 10);
  BOOST_CHECK_EQUAL(profile.grid_exponent(), -4);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::INT128), 1u);
  others[1][1].first = 3 + 0x1p-40;
  profile = profile_of(others, 2);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::FILTERED_EXACT), 1u);
}
