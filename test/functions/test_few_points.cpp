// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Few points are searched each with each, on the stack. They get the pairs and the order of reports
// that are promised for any number of points, and they get no memory. Scenes of all sizes, and
// their closest pairs, are those of test_fuzz.

#include "support/check_closest_pair.h"
#include "support/check_pairs.h"
#include "support/counting_allocator.h"
#include "support/instruction_sets.h"

using namespace test_support;

namespace {

// The pairs of the first `size` points, of which `first_size` are the first set, if there are two.
Pairs pairs_among(const Pairs& pairs, std::size_t size, std::size_t first_size = 0)
{
  Pairs among;
  for(const Pair& pair : pairs)
    if(pair.second < size
       && (first_size == 0 || (pair.first < first_size && pair.second >= first_size)))
      among.emplace_back(pair.first, pair.second - first_size);
  return among;
}

// Checks the pairs of the first n points, for any n. A search that is given a profile takes the way
// of many points.
template <class Maker, class NT>
void check_all_sizes(const std::string& name, const Points& scene, const Pairs& truth,
                     const CGAL::Distance_bound<NT>& bound)
{
  const auto all = make_points<Maker>(scene);
  auto points = all;
  for(std::size_t size = 0; size <= all.size(); ++size) {
    const std::string what = name + ", " + std::to_string(size) + " points";
    points.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size));
    Pairs found, found_with_profile;
    BOOST_CHECK(CGAL::fixed_radius_near_neighbors(points, bound, Pair_collector{found}));
    CGAL::Scene_profile profile;
    CGAL::fixed_radius_near_neighbors(points, bound, Pair_collector{found_with_profile}, profile);
    check_pairs(what, pairs_among(truth, size), found);
    check_pairs(what + ", profile", found, found_with_profile);
    for(const std::size_t first_size : {size / 3, size - size / 8}) {
      const auto [a, b] = split(points, first_size);
      found.clear();
      BOOST_CHECK(CGAL::fixed_radius_near_neighbors(a, b, bound, Pair_collector{found}));
      if(first_size != 0)
        check_pairs(what + " in two sets", pairs_among(truth, size, first_size), found);
      else
        BOOST_CHECK(found.empty());
    }
  }
}

} // namespace

// Squares of numbers that are no squares, bounds beyond all points, and bounds of other types.
BOOST_AUTO_TEST_CASE(bounds_of_any_kind)
{
  const Points scene_points = shuffled(lattice_points(2, 12, 1), 4);
  const auto check = [&](const std::string& name, const Radius& radius, const auto& bound) {
    const Truth truth = brute_force(scene_points, radius);
    check_all_sizes<Epick_points<2>>(name, scene_points, truth.pairs, bound);
    check_all_sizes<Epick_points<2>>(name + ", open", scene_points, truth.open_pairs, bound.open());
  };
  check("13", Radius::of_square("13"), CGAL::within_squared_distance(13));
  check("13 as float", Radius::of_square("13"), CGAL::within_squared_distance(13.f));
  check("13 as rational", Radius::of_square("13"),
        CGAL::within_squared_distance(CGAL::Exact_rational(13)));
  check("2 as long double", Radius::of_length(2), CGAL::within_distance(2.L));
  check("infinite", Radius::of_length(100), CGAL::within_distance(infinity));
  check("huge", Radius::of_length(100), CGAL::within_distance(1e300));
}

// Sums of squares, or the square of the bound, that are rounded to the same double as the other.
BOOST_AUTO_TEST_CASE(sums_that_are_rounded_onto_the_bound)
{
  for(const double tiny : {0x1p-30, 0x1p-60, 0x1p-200, 0x1p-1000})
    for(const Points& pair :
        {Points{{0, 0, 0}, {tiny, 1, 0}}, Points{{0, 0, 0}, {1, tiny, tiny}}}) {
      const Truth truth = brute_force(pair, Radius::of_length(1));
      BOOST_REQUIRE(truth.pairs.empty());
      check_all_sizes<Epick_points<3>>("above", pair, {}, CGAL::within_distance(1));
    }
  const Points below = {{0, 0, 0}, {5, 4, 0}}, above = {{0, 0, 0}, {5, 3, 0}};
  check_all_sizes<Epick_points<3>>("41", below, {}, CGAL::within_distance(std::sqrt(41.)));
  check_all_sizes<Epick_points<3>>("34", above, {{0, 1}},
                                   CGAL::within_distance(std::sqrt(34.)).open());
  for(const bool is_first : {false, true}) {
    Points gap = {{-0x1p-60, 0, 0}, {1, 0, 0}}, short_gap = {{0x1p-60, 0, 0}, {1, 0, 0}};
    if(is_first) {
      std::swap(gap[0], gap[1]);
      std::swap(short_gap[0], short_gap[1]);
    }
    check_all_sizes<Epick_points<3>>("gap", gap, {}, CGAL::within_distance(1));
    check_all_sizes<Epick_points<3>>("short gap", short_gap, {{0, 1}},
                                     CGAL::within_distance(1).open());
  }
}

BOOST_AUTO_TEST_CASE(a_callback_stops_the_search_of_few_points)
{
  for(const std::size_t size : {3, 8, 9, 100}) {
    const auto points = make_points<Epick_points<2>>(identical_points(2, size, 1));
    std::size_t count = 0;
    const auto stop = [&](std::size_t, std::size_t) { return ++count != 2; };
    BOOST_CHECK(!CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(0), stop));
    BOOST_CHECK_EQUAL(count, 2u);
    count = 0;
    BOOST_CHECK(!CGAL::fixed_radius_near_neighbors(points, points, CGAL::within_distance(0), stop));
    BOOST_CHECK_EQUAL(count, 2u);
    const auto fail = [&](std::size_t, std::size_t) { throw std::out_of_range("callback"); };
    BOOST_CHECK_THROW(CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(0), fail),
                      std::out_of_range);

  }
}

// Scenes without near ties: those are found by the filter of each instruction set.
BOOST_AUTO_TEST_CASE(the_order_of_few_pairs_depends_on_the_input_alone)
{
  for(const std::size_t size : {5, 8, 9, 40, 256}) {
    const auto points = make_points<Epick_points<3>>(uniform_points(3, size, 0, 1, 11));
    Pairs expected;
    const auto bound = CGAL::within_distance(0.5);
    CGAL::fixed_radius_near_neighbors(points, bound, Pair_collector{expected});
    for(const auto set : instruction_sets()) {
      const Forced_instruction_set forced(set);
      Pairs found;
      CGAL::fixed_radius_near_neighbors(points, bound, Pair_collector{found});
      BOOST_CHECK(found == expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(few_points_need_no_memory)
{
  const Points scenes[] = {uniform_points(3, 256, 0, 1, 5), lattice_points(3, 6, 0.1),
                           identical_points(3, 256, 0.3),
                           uniform_points(3, 256, -8e307, 1.6e308, 10)};
  for(const Points& scene : scenes) {
    const auto all = make_points<Epick_points<3>>(scene);
    const auto bound = CGAL::within_distance(0.1);
    for(std::size_t size = 0; size <= all.size(); ++size) {
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(size);
      const std::vector<Epick::Point_3> points(all.begin(), end);
      std::size_t count = 0;
      const auto add = [&](std::size_t, std::size_t) { ++count; };
      const auto search = [&] {
        const Memory_that_runs_out none(0);
        if(size >= 2) {
          CGAL::closest_pair(points);
          CGAL::has_close_pair(points, bound);
        }
        CGAL::fixed_radius_near_neighbors(points, bound, add);
        if(2 * size <= 256)
          CGAL::fixed_radius_near_neighbors(points, points, bound, add);
      };
      BOOST_CHECK_NO_THROW(search());
    }
  }
}

// Lanes read all columns of the ends. Programs that look for memory nobody wrote would complain.
BOOST_AUTO_TEST_CASE(runs_end_in_every_column)
{
  const std::vector<Epick::Point_3> points(20, CGAL::ORIGIN);
  internal::Few_runs<Epick::Point_3> runs;
  const auto run = runs.make(points, 0, points.size());
  for(const double* column : run.x)
    for(std::size_t end = 0; end < internal::lanes; ++end)
      BOOST_CHECK(std::isnan(column[points.size() + end]));
}
