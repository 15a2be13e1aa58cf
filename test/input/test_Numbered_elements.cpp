// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Elements of ranges of all kinds, by number: nothing is copied that can be referred to.

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <forward_list>
#include <list>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Numbered_elements)

namespace internal = CGAL::Thick_intersection_d::internal;

template <class Elements>
std::vector<int> numbers_of(const Elements& elements)
{
  std::vector<int> by_loop, by_number;
  for(const auto& element : elements)
    by_loop.push_back(static_cast<int>(element));
  for(std::size_t i = 0; i < elements.size(); ++i)
    by_number.push_back(static_cast<int>(elements[i]));
  BOOST_CHECK(by_loop == by_number);
  return by_number;
}

BOOST_AUTO_TEST_CASE(elements_are_numbered_in_the_order_of_the_range)
{
  const std::vector<int> vector = {3, 1, 4, 1, 5};
  const std::list<int> list(vector.begin(), vector.end());
  const std::forward_list<int> forward(vector.begin(), vector.end());
  const int array[] = {3, 1, 4, 1, 5};
  BOOST_CHECK(numbers_of(internal::Numbered_elements<std::vector<int>>(vector)) == vector);
  BOOST_CHECK(numbers_of(internal::Numbered_elements<std::list<int>>(list)) == vector);
  BOOST_CHECK(numbers_of(internal::Numbered_elements<std::forward_list<int>>(forward)) == vector);
  BOOST_CHECK(numbers_of(internal::Numbered_elements<int[5]>(array)) == vector);
  BOOST_CHECK(numbers_of(internal::Numbered_elements<std::list<int>>(std::list<int>())).empty());
}

BOOST_AUTO_TEST_CASE(elements_stay_where_they_are)
{
  const std::vector<int> vector = {3, 1, 4};
  const std::list<int> list = {3, 1, 4};
  BOOST_CHECK(&internal::Numbered_elements<std::vector<int>>(vector)[1] == &vector[1]);
  BOOST_CHECK(&internal::Numbered_elements<std::list<int>>(list)[0] == &list.front());
}

BOOST_AUTO_TEST_CASE(elements_may_be_made_for_the_occasion)
{
  const std::vector<bool> range = {true, false, true};
  const internal::Numbered_elements<std::vector<bool>> elements(range);
  static_assert(std::is_same_v<decltype(elements)::value_type, bool>);
  static_assert(!std::is_reference_v<decltype(elements[0])>);
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{1, 0, 1}));
}

BOOST_AUTO_TEST_CASE(a_map_looks_into_the_elements)
{
  using Item = std::pair<int, char>;
  using Map = CGAL::First_of_pair_property_map<Item>;
  const std::list<Item> items = {{3, 'a'}, {1, 'b'}};
  const internal::Numbered_elements<std::list<Item>, Map> elements(items, Map());
  static_assert(std::is_same_v<decltype(elements)::value_type, int>);
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{3, 1}));
  BOOST_CHECK(&elements[0] == &items.front().first);

  const auto named = internal::make_elements(items, CGAL::parameters::point_map(Map()));
  BOOST_CHECK((numbers_of(named) == std::vector<int>{3, 1}));
  const auto whole = internal::make_elements(items, CGAL::parameters::default_values());
  BOOST_CHECK(&whole[1] == &items.back());
}

BOOST_AUTO_TEST_CASE(two_ranges_have_one_numbering)
{
  const std::vector<int> first = {3, 1, 4};
  const std::list<int> second = {1, 5};
  const std::vector<int> none;
  const internal::Numbered_elements<std::vector<int>> a(first), c(none);
  const internal::Numbered_elements<std::list<int>> b(second);
  const internal::Joined_elements joined(a, b);
  BOOST_CHECK((numbers_of(joined) == std::vector<int>{3, 1, 4, 1, 5}));
  BOOST_CHECK(&joined[2] == &first.back());
  BOOST_CHECK(&joined[3] == &second.front());
  BOOST_CHECK((numbers_of(internal::Joined_elements(c, b)) == std::vector<int>{1, 5}));
  BOOST_CHECK((numbers_of(internal::Joined_elements(b, c)) == std::vector<int>{1, 5}));
}

BOOST_AUTO_TEST_SUITE_END()
