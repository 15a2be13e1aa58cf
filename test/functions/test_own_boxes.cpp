// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes and traits of one's own, without the header of CGAL: what the functions take.

#include <CGAL/thick_box_intersection_d.h>

#ifdef CGAL_BOX_INTERSECTION_D_H
#error "The header of CGAL is under the GPL: ours does without."
#endif

#include "support/pairs.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(own_boxes)

using namespace test_support;
using namespace CGAL::Thick_box_intersection_d;

// The least that a box needs.
template <std::size_t D>
struct Plain_box
{
  std::array<double, D> low, high;

  static constexpr int dimension() { return D; }
  double min_coord(int i) const { return low[static_cast<std::size_t>(i)]; }
  double max_coord(int i) const { return high[static_cast<std::size_t>(i)]; }
};

using Interval = Plain_box<1>;
using Intervals = std::vector<Interval>;

const Intervals chain = {{{0}, {1}}, {{1}, {2}}, {{2}, {3}}, {{5}, {6}}};

// The pairs of positions in two vectors.
struct Position_collector
{
  const Interval* first;
  const Interval* second;
  Pairs* pairs;
  void operator()(const Interval& a, const Interval& b) const
  {
    pairs->emplace_back(&a - first, &b - second);
  }
};

template <class... Arguments>
Pairs self_pairs(const Intervals& boxes, const Arguments&... arguments)
{
  Pairs pairs;
  CGAL::thick_box_self_intersection_d(
    boxes.begin(), boxes.end(), Position_collector{boxes.data(), boxes.data(), &pairs},
    arguments...);
  return sorted(pairs);
}

template <class... Arguments>
Pairs pairs_between(const Intervals& a, const Intervals& b, const Arguments&... arguments)
{
  Pairs pairs;
  CGAL::thick_box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                                 Position_collector{a.data(), b.data(), &pairs}, arguments...);
  return sorted(pairs);
}

// Points, made to boxes by a distance that is known at run time only.
struct Fattening_traits
{
  double distance;
  int dimension() const { return 1; }
  double min_coord(double x, int) const { return x - distance; }
  double max_coord(double x, int) const { return x + distance; }
};

BOOST_AUTO_TEST_CASE(closed_boxes_touch_and_half_open_boxes_do_not)
{
  BOOST_CHECK((self_pairs(chain) == Pairs{{1, 0}, {2, 1}}));
  BOOST_CHECK(self_pairs(chain, 10, HALF_OPEN).empty());
  BOOST_CHECK((pairs_between(chain, chain, 10, HALF_OPEN)
               == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

BOOST_AUTO_TEST_CASE(positions_tell_boxes_without_ids)
{
  const Intervals equal(3, Interval{{0}, {1}}), copy = equal;
  const Pairs each_once = {{1, 0}, {2, 0}, {2, 1}};
  BOOST_CHECK(self_pairs(equal) == each_once);
  BOOST_CHECK(pairs_between(equal, copy, 10, CLOSED, COMPLETE) == each_once);
  BOOST_CHECK(pairs_between(equal, equal, 10, CLOSED, COMPLETE) == each_once);
  BOOST_CHECK_EQUAL(pairs_between(equal, copy).size(), 9u);
}

// A box of another type, with its center and its size.
struct Ball_of_line
{
  float center, radius;

  static constexpr int dimension() { return 1; }
  double min_coord(int) const { return static_cast<double>(center) - static_cast<double>(radius); }
  double max_coord(int) const { return static_cast<double>(center) + static_cast<double>(radius); }
};

// Few boxes, and many.
BOOST_AUTO_TEST_CASE(two_ranges_may_hold_boxes_of_two_types)
{
  for(const int size : {4, 300}) {
    Intervals intervals;
    std::vector<Ball_of_line> balls; // ball j meets the intervals j and j + 1 at an end
    for(int i = 0; i < size; ++i) {
      intervals.push_back({{2. * i}, {2. * i + 1}});
      balls.push_back({2.f * static_cast<float>(i) + 1.5f, .5f});
    }
    for(const auto topology : {CLOSED, HALF_OPEN}) {
      Pairs pairs, expected;
      CGAL::thick_box_intersection_d(
        intervals.begin(), intervals.end(), balls.begin(), balls.end(),
        [&](const Interval& a, const Ball_of_line& b) {
          pairs.emplace_back(&a - intervals.data(), &b - balls.data());
        }, 10, topology);
      for(std::size_t i = 0; i < intervals.size() && topology == CLOSED; ++i) {
        if(i > 0)
          expected.emplace_back(i, i - 1);
        expected.emplace_back(i, i);
      }
      BOOST_CHECK(sorted(pairs) == expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(traits_have_a_state)
{
  const std::vector<double> points = {0, 1, 3};
  for(const double distance : {0.25, 0.5, 1.}) {
    std::size_t count = 0;
    CGAL::thick_box_self_intersection_d(points.begin(), points.end(),
                                        [&](double, double) { ++count; },
                                        Fattening_traits{distance});
    BOOST_CHECK_EQUAL(count, distance < 0.5 ? 0u : distance < 1 ? 1u : 2u);
  }
}

BOOST_AUTO_TEST_CASE(a_pointer_stands_for_its_box)
{
  Intervals boxes = chain;
  std::vector<Interval*> pointers;
  std::vector<std::shared_ptr<const Interval>> shared;
  for(Interval& box : boxes) {
    pointers.push_back(&box);
    shared.push_back(std::make_shared<const Interval>(box));
  }
  Pairs pairs;
  CGAL::thick_box_self_intersection_d(
    pointers.begin(), pointers.end(),
    [&](Interval* a, Interval* b) { pairs.emplace_back(a - boxes.data(), b - boxes.data()); });
  BOOST_CHECK((sorted(pairs) == Pairs{{1, 0}, {2, 1}}));

  std::size_t count = 0; // boxes of different types
  CGAL::thick_box_intersection_d(
    pointers.begin(), pointers.end(), shared.begin(), shared.end(),
    [&](const Interval*, const std::shared_ptr<const Interval>&) { ++count; });
  BOOST_CHECK_EQUAL(count, 8u);
}

BOOST_AUTO_TEST_CASE(forward_iterators_are_fine)
{
  const std::list<Interval> boxes(chain.begin(), chain.end());
  std::size_t count = 0;
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Interval&, const Interval&) { ++count; });
  BOOST_CHECK_EQUAL(count, 2u);
}

BOOST_AUTO_TEST_CASE(an_empty_box_meets_no_box)
{
  const Interval empty = {{infinity}, {-infinity}}, turned = {{2}, {1}}, all = {{0}, {9}};
  BOOST_CHECK((self_pairs({empty, all, turned, all, empty, turned}) == Pairs{{3, 1}}));
  BOOST_CHECK((pairs_between({turned, all, empty}, {all, empty, turned, all})
               == Pairs{{1, 0}, {1, 3}}));
  BOOST_CHECK((pairs_between({empty, empty}, {all})).empty());
  BOOST_CHECK((self_pairs({empty, all, all}, 10, HALF_OPEN) == Pairs{{2, 1}}));
}

BOOST_AUTO_TEST_CASE(infinite_boxes_are_boxes)
{
  const double max = (std::numeric_limits<double>::max)();
  const Intervals boxes = {{{-infinity}, {infinity}}, {{-infinity}, {-max}}, {{max}, {infinity}},
                           {{infinity}, {infinity}},  {{-max}, {max}}};
  BOOST_CHECK((self_pairs(boxes)
               == Pairs{{1, 0}, {2, 0}, {2, 4}, {3, 0}, {3, 2}, {4, 0}, {4, 1}}));
  BOOST_CHECK((self_pairs(boxes, 10, HALF_OPEN) == Pairs{{1, 0}, {2, 0}, {4, 0}}));
}

BOOST_AUTO_TEST_CASE(false_stops_the_search_and_other_results_do_not)
{
  std::size_t count = 0;
  const auto count_and_return = [&](auto result) {
    count = 0;
    return CGAL::thick_box_self_intersection_d(chain.begin(), chain.end(),
                                               [&, result](const Interval&, const Interval&) {
                                                 ++count;
                                                 return result;
                                               });
  };
  BOOST_CHECK(!count_and_return(false));
  BOOST_CHECK_EQUAL(count, 1u);
  BOOST_CHECK(count_and_return(true));
  BOOST_CHECK_EQUAL(count, 2u);
  BOOST_CHECK(count_and_return(0));
  BOOST_CHECK_EQUAL(count, 2u);
}

BOOST_AUTO_TEST_CASE(boxes_in_parallel)
{
  std::vector<Plain_box<2>> boxes; // a grid of squares that touch
  for(double x = 0; x < 40; ++x)
    for(double y = 0; y < 40; ++y)
      boxes.push_back({{x, y}, {x + 1, y + 1}});
  Pairs found;
  std::mutex mutex;
  CGAL::thick_box_self_intersection_d<CGAL::Parallel_if_available_tag>(
    boxes.begin(), boxes.end(), [&](const Plain_box<2>& a, const Plain_box<2>& b) {
      const std::lock_guard<std::mutex> lock(mutex);
      found.emplace_back(&a - boxes.data(), &b - boxes.data());
    });
  BOOST_CHECK_EQUAL(found.size(), 2u * 39 * 40 + 2 * 39 * 39);
  found = sorted(found);
  BOOST_CHECK(std::unique(found.begin(), found.end()) == found.end());
}

BOOST_AUTO_TEST_SUITE_END()
