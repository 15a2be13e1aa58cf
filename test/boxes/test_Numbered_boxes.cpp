// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of two ranges in one numbering, as intervals of doubles.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Numbered_boxes.h>

BOOST_AUTO_TEST_SUITE(Numbered_boxes)

using namespace test_support;

template <class NT>
struct Interval_box
{
  NT low, high;
  static int dimension() { return 1; }
  const NT& min_coord(int) const { return low; }
  const NT& max_coord(int) const { return high; }
};

template <class NT>
using Boxes = std::vector<Interval_box<NT>>;

template <class NT>
auto numbered(const Boxes<NT>& first, const Boxes<NT>& second)
{
  static const internal::Box_members<Interval_box<NT>> traits;
  return internal::Numbered_boxes<Boxes<NT>, Boxes<NT>, internal::Box_members<Interval_box<NT>>>(
    first, second, traits);
}

struct Box_with_id : Interval_box<int>
{
  int number;
  explicit Box_with_id(int number) : Interval_box<int>{0, 1}, number(number) {}
  int id() const { return number; }
};

// Whether the ids of two ranges show that they are distinct.
bool are_distinct(const std::vector<int>& first, const std::vector<int>& second)
{
  using Traits = internal::Box_members<Box_with_id>;
  using Range = std::vector<Box_with_id>;
  const Traits traits;
  const Range a(first.begin(), first.end()), b(second.begin(), second.end());
  return internal::Numbered_boxes<Range, Range, Traits>(a, b, traits).have_distinct_ids();
}

BOOST_AUTO_TEST_CASE(ids_that_ascend_are_distinct)
{
  BOOST_CHECK(are_distinct({1, 2, 3}, {}));
  BOOST_CHECK(are_distinct({1, 2}, {3, 4}));
  BOOST_CHECK(are_distinct({3, 4}, {1, 2}));
  BOOST_CHECK(are_distinct({}, {7}));
  BOOST_CHECK(are_distinct({}, {}));
  BOOST_CHECK(!are_distinct({1, 2, 2, 3}, {}));
  BOOST_CHECK(!are_distinct({1, 2}, {2, 3}));
  BOOST_CHECK(!are_distinct({1, 2}, {1, 2}));
  BOOST_CHECK(!are_distinct({2, 3}, {1, 2}));
  BOOST_CHECK(!are_distinct({5}, {5}));
  BOOST_CHECK(!are_distinct({2, 1, 3, 2}, {}));
}

BOOST_AUTO_TEST_CASE(ends_that_are_no_numbers_are_refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Boxes<double>& bad : {Boxes<double>{{0, 1}, {nan, 1}}, Boxes<double>{{0, nan}}}) {
    BOOST_CHECK_THROW(numbered(bad, {}), std::invalid_argument);
    BOOST_CHECK_THROW(numbered({{0, 1}}, bad), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(numbers_are_positions_if_no_box_is_empty)
{
  const Boxes<int> first = {{0, 1}, {2, 3}}, second = {{4, 5}};
  const auto boxes = numbered(first, second);
  BOOST_CHECK_EQUAL(boxes.size(), 3u);
  BOOST_CHECK_EQUAL(boxes.first_size(), 2u);
  BOOST_CHECK(&boxes.of_first_range(1) == &first[1]);
  BOOST_CHECK(&boxes.of_second_range(2) == &second[0]);
  BOOST_CHECK_EQUAL(boxes.position_in_range(1), 1u);
  BOOST_CHECK_EQUAL(boxes.position_in_range(2), 0u);
}

BOOST_AUTO_TEST_CASE(empty_boxes_have_no_numbers)
{
  const Boxes<int> first = {{1, 0}, {2, 3}, {1, 0}}, second = {{1, 0}, {4, 5}, {6, 6}};
  const auto boxes = numbered(first, second);
  BOOST_CHECK_EQUAL(boxes.size(), 3u);
  BOOST_CHECK_EQUAL(boxes.first_size(), 1u);
  BOOST_CHECK(&boxes.of_first_range(0) == &first[1]);
  BOOST_CHECK(&boxes.of_second_range(2) == &second[2]);
  BOOST_CHECK_EQUAL(boxes.position_in_range(1), 1u);
  BOOST_CHECK_EQUAL(boxes.interval(1, 0).low, 4);
  BOOST_CHECK_EQUAL(numbered(Boxes<int>{{1, 0}}, Boxes<int>()).size(), 0u);
}

BOOST_AUTO_TEST_CASE(intervals_enclose_boxes)
{
  using NT = CGAL::Exact_rational;
  const Boxes<NT> thirds = {{NT(1) / 3, NT(2) / 3}}, halves = {{NT(1) / 2, NT(3) / 2}};
  const auto boxes = numbered(thirds, halves);
  BOOST_CHECK(NT(boxes.interval(0, 0).low) < NT(1) / 3);
  BOOST_CHECK(NT(boxes.interval(0, 0).high) > NT(2) / 3);
  BOOST_CHECK_EQUAL(boxes.interval(1, 0).high, 1.5);
  BOOST_CHECK(!boxes.have_double_ends());
  BOOST_CHECK(numbered(halves, halves).have_double_ends());
}

BOOST_AUTO_TEST_CASE(flat_boxes_are_noticed_and_empty_boxes_are_not_flat)
{
  const Boxes<double> empty = {{1, 0}}, flat = {{0., -0.}};
  BOOST_CHECK(!numbered(empty, empty).has_degenerate_box());
  BOOST_CHECK(numbered(empty, flat).has_degenerate_box());
}

BOOST_AUTO_TEST_SUITE_END()
