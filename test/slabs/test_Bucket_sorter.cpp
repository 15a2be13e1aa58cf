// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The sorts by buckets against the sort of the standard library.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Bucket_sorter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>

BOOST_AUTO_TEST_SUITE(Bucket_sorter)

using namespace test_support;

using Generator = std::mt19937_64;
using Point = internal::Slab_point<2, double>;

// Coordinates of all sizes: buckets of buckets are crowded.
std::vector<Point> crowded_points(Generator& random, std::size_t n, int scales)
{
  std::vector<Point> points;
  while(points.size() < n) {
    const int exponent = static_cast<int>(random() % static_cast<std::uint64_t>(scales));
    const double x = std::ldexp(static_cast<double>(random() % 1000) - 500, exponent);
    points.push_back({{x, -x}, static_cast<internal::Place>(points.size())});
  }
  return points;
}

BOOST_AUTO_TEST_CASE(buckets_sort)
{
  internal::Bucket_sorter<Point> sorter;
  Generator random(6);
  for(const int scales : {1, 10, 1000})
    for(const std::size_t n : {0, 1, 16, 17, 100, 5000}) {
      auto points = crowded_points(random, n, scales);
      std::vector<double> expected;
      for(const auto& p : points)
        expected.push_back(p.x[1]);
      std::sort(expected.begin(), expected.end());
      sorter.sort(points.data(), points.data() + n, 1);
      std::vector<double> sorted;
      std::vector<bool> is_there(n, false);
      for(const auto& p : points) {
        sorted.push_back(p.x[1]);
        BOOST_CHECK_EQUAL(p.x[0], -p.x[1]);
        BOOST_CHECK(!is_there[p.position]);
        is_there[p.position] = true;
      }
      BOOST_CHECK_MESSAGE(sorted == expected, n << " points of " << scales << " scales");
    }
}

BOOST_AUTO_TEST_SUITE_END()
