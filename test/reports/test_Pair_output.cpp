// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Callbacks of positions and of elements, and output iterators of both; and which callbacks stop.

#include "support/pairs.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

BOOST_AUTO_TEST_SUITE(Pair_output)

using namespace test_support;

// As Numbered_elements, with elements that exist and elements that are made.
struct Names
{
  std::vector<std::string> names;
  const std::string& element(std::size_t position) const { return names[position]; }
};
struct Squares
{
  std::size_t element(std::size_t position) const { return position * position; }
};

const Names names = {{"a", "b", "c"}};
const Squares squares;

template <class Callback>
decltype(auto) output_to(Callback& callback)
{
  static_assert(internal::check_callback<Callback, Names, Squares>());
  return internal::pair_output(names, squares, callback, internal::Threads());
}

BOOST_AUTO_TEST_CASE(callback_of_positions_is_called_itself)
{
  const auto callback = [](std::size_t, std::size_t) {};
  const auto& output = output_to(callback);
  BOOST_CHECK(&output == &callback);
}

BOOST_AUTO_TEST_CASE(callback_that_is_an_lvalue_is_not_copied)
{
  struct Counter
  {
    Counter() = default;
    Counter(const Counter&) = delete;
    void operator()(const std::string&, std::size_t) { ++calls; }
    int calls = 0;
  };
  Counter counter;
  const auto callback = CGAL::with_elements(counter);
  auto&& output = output_to(callback);
  static_assert(std::is_void_v<decltype(output(0, 0))>);
  output(1, 1);
  BOOST_CHECK_EQUAL(counter.calls, 1);
}

BOOST_AUTO_TEST_CASE(output_iterators_take_pairs)
{
  Pairs positions;
  auto out = std::back_inserter(positions);
  output_to(out)(1, 2);
  BOOST_CHECK(positions == (Pairs{{1, 2}}));

  std::vector<std::pair<std::string, std::size_t>> elements;
  auto callback = CGAL::with_elements(std::back_inserter(elements));
  auto&& output = output_to(callback);
  output(1, 2);
  output(2, 0);
  BOOST_REQUIRE_EQUAL(elements.size(), 2u);
  BOOST_CHECK(elements[0] == std::make_pair(std::string("b"), std::size_t(4)));
  BOOST_CHECK(elements[1] == std::make_pair(std::string("c"), std::size_t(0)));
}

BOOST_AUTO_TEST_CASE(an_output_iterator_that_is_an_lvalue_advances)
{
  Pairs room(2);
  auto out = room.begin();
  auto&& output = output_to(out);
  output(1, 2);
  output(0, 1);
  BOOST_CHECK(out == room.end());
  BOOST_CHECK(room == (Pairs{{1, 2}, {0, 1}}));
}

static_assert(!internal::One_set::are_two && internal::Two_sets::are_two);

BOOST_AUTO_TEST_CASE(a_callback_that_returns_nothing_never_stops)
{
  std::size_t sum = 0;
  const auto add = [&](std::size_t i, std::size_t j) { sum += 10 * i + j; };
  const auto report = internal::reporter_of(add);
  BOOST_CHECK(report(1, 2));
  BOOST_CHECK(report(3, 4));
  BOOST_CHECK_EQUAL(sum, 46u);
}

BOOST_AUTO_TEST_CASE(a_callback_stops_by_returning_false)
{
  const auto is_small = [](std::size_t i, std::size_t) { return i < 2; };
  const auto report = internal::reporter_of(is_small);
  BOOST_CHECK(report(1, 2));
  BOOST_CHECK(!report(2, 3));
}

BOOST_AUTO_TEST_SUITE_END()
