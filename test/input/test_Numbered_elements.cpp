// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Elements of ranges of all kinds, by number: nothing is copied that can be referred to.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/indirect_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/range/iterator_range.hpp>

#include <forward_list>

BOOST_AUTO_TEST_SUITE(Numbered_elements)

using namespace test_support;

template <class Elements>
std::vector<int> numbers_of(const Elements& elements)
{
  std::vector<int> numbers;
  for(std::size_t i = 0; i < elements.size(); ++i)
    numbers.push_back(static_cast<int>(elements[i]));
  return numbers;
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

// Numbers that live in the iterators, as descriptors do in those of a mesh.
BOOST_AUTO_TEST_CASE(elements_may_live_in_their_iterators)
{
  using Iterator = boost::counting_iterator<int, std::random_access_iterator_tag, std::ptrdiff_t>;
  const auto range = boost::make_iterator_range(Iterator(5), Iterator(9));
  const internal::Numbered_elements<std::remove_const_t<decltype(range)>> elements(range);
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{5, 6, 7, 8}));
  BOOST_CHECK(&elements[1] == &elements[1]); // is still there
  static_assert(internal::may_hold_element<Iterator>());
  BOOST_CHECK(internal::holds_element(Iterator(5)));
}

// Iterates over numbers that it makes, and advances step by step, as the iterators over a mesh of
// CGAL 6 do after removals.
struct Stepping_iterator
  : boost::iterator_facade<Stepping_iterator, int, std::random_access_iterator_tag, int>
{
  Stepping_iterator(int number, int* steps) : number(number), steps(steps) {}

  int dereference() const { return number; }
  bool equal(const Stepping_iterator& other) const { return number == other.number; }
  void increment() { advance(1); }
  void decrement() { advance(-1); }
  void advance(std::ptrdiff_t n)
  {
    number += static_cast<int>(n);
    *steps += std::abs(static_cast<int>(n));
  }
  std::ptrdiff_t distance_to(const Stepping_iterator& other) const
  {
    *steps += std::abs(other.number - number);
    return other.number - number;
  }

  int number;
  int* steps;
};

BOOST_AUTO_TEST_CASE(iterators_that_make_elements_go_once_through_the_range)
{
  int steps = 0;
  const auto range = boost::make_iterator_range(Stepping_iterator(0, &steps),
                                                Stepping_iterator(1000, &steps));
  const internal::Numbered_elements<std::remove_const_t<decltype(range)>> elements(range);
  BOOST_CHECK_EQUAL(elements[999], 999);
  BOOST_CHECK_EQUAL(elements[500], 500);
  BOOST_CHECK_EQUAL(steps, 1000);
}

BOOST_AUTO_TEST_CASE(elements_of_other_iterators_are_found_without_a_table)
{
  const std::vector<int> vector = {3, 1};
  const std::vector<const int*> pointers = {&vector[1], &vector[0]};
  using Pointer = std::vector<const int*>::const_iterator;
  using Iterator = boost::indirect_iterator<Pointer>;
  static_assert(internal::has_random_access<Iterator>);
  static_assert(!internal::may_hold_element<Pointer>());
  static_assert(!internal::may_hold_element<const int*>());
  struct
  {
    int before = 0;
    boost::indirect_iterator<const int* const*> iterator;
    int after = 0;
  } neighbors;
  const int* const numbers[] = {&vector[0], &neighbors.before, &neighbors.after};
  for(const int* const& number : numbers) {
    neighbors.iterator = boost::indirect_iterator<const int* const*>(&number);
    BOOST_CHECK(!internal::holds_element(neighbors.iterator));
  }
  const auto range = boost::make_iterator_range(Iterator(pointers.begin()),
                                                Iterator(pointers.end()));
  const internal::Numbered_elements<std::remove_const_t<decltype(range)>> elements(range);
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{1, 3}));
  BOOST_CHECK(&elements[1] == &vector[0]);
}

// A view of C++20 that remembers where it begins, and ends where a number is negative.
class Until_negative
{
public:
  struct Sentinel
  {
    friend bool operator!=(const int* it, Sentinel) { return *it >= 0; }
  };

  explicit Until_negative(const int* first) : first_(first) {}
  const int* begin() { return first_; }
  Sentinel end() { return {}; }

private:
  const int* first_;
};

BOOST_AUTO_TEST_CASE(a_range_may_change_when_it_is_read_and_end_in_a_sentinel)
{
  const int numbers[] = {3, 1, 4, -1, 5};
  Until_negative range(numbers);
  static_assert(!internal::Is_range<const Until_negative>::value);
  const auto elements = internal::make_elements(range, CGAL::parameters::default_values());
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{3, 1, 4}));
  BOOST_CHECK(&elements[1] == &numbers[1]);
}

// As a Point_set_3, which has indices as elements.
struct Range_with_map : std::vector<std::pair<int, char>>
{
  using std::vector<std::pair<int, char>>::vector;
  CGAL::First_of_pair_property_map<std::pair<int, char>> point_map() const { return {}; }
};

BOOST_AUTO_TEST_CASE(a_range_may_bring_its_map)
{
  const Range_with_map range = {{3, 'a'}, {1, 'b'}};
  const auto elements = internal::make_elements(range, CGAL::parameters::default_values());
  BOOST_CHECK((numbers_of(elements) == std::vector<int>{3, 1}));
  BOOST_CHECK(&elements.element(1) == &range[1]);

  using Map = CGAL::Second_of_pair_property_map<std::pair<int, char>>;
  const auto letters = internal::make_elements(range, CGAL::parameters::point_map(Map()));
  BOOST_CHECK((numbers_of(letters) == std::vector<int>{'a', 'b'}));
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
  BOOST_CHECK(&elements.element(0) == &items.front());

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
