// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Traits of one's own with intervals and nothing else, in any dimension.

#define BOOST_TEST_MODULE own_intervals
#include "support/pairs.h"

#include <CGAL/Dimension.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test_support;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// Objects need not be copyable, nor need the traits.
struct Box
{
  std::array<double, 6> low, high;
  bool is_allowed = true;

  Box(const std::array<double, 6>& l, const std::array<double, 6>& h) : low(l), high(h) {}
  Box(Box&&) = default;
};

// What a predicate may return instead of a bool.
struct Answer
{
  bool value;
  operator bool() const { return value; }
};

// Boxes that meet, and do not begin at the same number along axis 0.
class Minimal_traits
{
public:
  using Object_d = Box;

  explicit Minimal_traits(int dimension) : dimension_(dimension) {}
  Minimal_traits(const Minimal_traits&) = delete;

  struct Interval_d
  {
    std::pair<double, double> operator()(const Box& a, int axis) const
    {
      const auto i = static_cast<std::size_t>(axis);
      return {a.low[i], a.high[i]};
    }
  };

  struct Do_intersect_d
  {
    int dimension;
    Answer operator()(const Box& a, const Box& b) const
    {
      bool meet = a.low[0] != b.low[0];
      for(std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
        meet = meet && a.low[i] <= b.high[i] && b.low[i] <= a.high[i];
      return {meet};
    }
  };

  int dimension() const { return dimension_; }
  Interval_d interval_d_object() const { return {}; }
  Do_intersect_d do_intersect_d_object() const { return {dimension_}; }

private:
  int dimension_;
};

struct Space_traits : Minimal_traits
{
  using Dimension = CGAL::Dimension_tag<3>;

  Space_traits() : Minimal_traits(3) {}
  void check(const Box& box, std::size_t position) const
  {
    if(!box.is_allowed)
      throw std::invalid_argument("Object " + std::to_string(position) + " is not allowed.");
  }
};

// Extents over three decades; some boxes share a lower end, and some are infinite along axis 0.
std::vector<Box> random_boxes(std::size_t n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  std::vector<Box> boxes;
  for(std::size_t i = 0; i < n; ++i) {
    std::array<double, 6> low, high;
    for(std::size_t axis = 0; axis < 6; ++axis) {
      low[axis] = std::floor(number(random) * 256) / 256;
      high[axis] = low[axis] + std::pow(10, -3 * number(random));
    }
    if(i % 100 == 0)
      low[0] = -infinity;
    if(i % 100 == 1)
      high[0] = infinity;
    boxes.emplace_back(low, high);
  }
  return boxes;
}

template <class Traits>
void check_pairs(const std::vector<Box>& boxes, const Traits& traits)
{
  const auto do_intersect = traits.do_intersect_d_object();
  Pairs expected, found;
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(std::size_t j = i + 1; j < boxes.size(); ++j)
      if(do_intersect(boxes[i], boxes[j]))
        expected.emplace_back(i, j);
  CGAL::thick_self_intersection_d(
    boxes, [&](std::size_t i, std::size_t j) { found.emplace_back(i, j); },
    CGAL::parameters::geom_traits(traits));
  const auto difference = compare(expected, found);
  BOOST_CHECK_MESSAGE(difference.empty(), "dimension " << traits.dimension() << ": " << difference);
  BOOST_CHECK(!expected.empty());
}

template <class Traits>
std::string error_of(const std::vector<Box>& boxes, const Traits& traits)
{
  try {
    CGAL::thick_self_intersection_d(
      boxes, [](std::size_t, std::size_t) { BOOST_ERROR("reported before all was checked"); },
      CGAL::parameters::geom_traits(traits));
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(minimal_traits_suffice_in_any_dimension)
{
  const std::vector<Box> boxes = random_boxes(2000, 1);
  for(int dimension = 1; dimension <= 6; ++dimension)
    check_pairs(boxes, Minimal_traits(dimension));
  check_pairs(boxes, Space_traits());
}

BOOST_AUTO_TEST_CASE(pairs_between_two_ranges_are_found)
{
  const std::vector<Box> a = random_boxes(800, 2), b = random_boxes(600, 3);
  const Minimal_traits traits(4);
  Pairs expected, found;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < b.size(); ++j)
      if(traits.do_intersect_d_object()(a[i], b[j]))
        expected.emplace_back(i, j);
  CGAL::thick_intersection_d(
    a, b, [&](std::size_t i, std::size_t j) { found.emplace_back(i, j); },
    CGAL::parameters::geom_traits(traits));
  BOOST_CHECK(compare(expected, found).empty());
}

BOOST_AUTO_TEST_CASE(empty_intervals_and_nan_are_refused_by_name)
{
  std::vector<Box> boxes = random_boxes(200, 4);
  const Minimal_traits traits(3);
  std::swap(boxes[7].low[2], boxes[7].high[2]);
  BOOST_CHECK(error_of(boxes, traits).find("object 7 along axis 2") != std::string::npos);
  boxes[5].high[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK(error_of(boxes, traits).find("object 5 along axis 1") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(check_of_the_traits_comes_first)
{
  std::vector<Box> boxes = random_boxes(200, 5);
  boxes[150].is_allowed = false;
  BOOST_CHECK_EQUAL(error_of(boxes, Space_traits()), "Object 150 is not allowed.");
}
