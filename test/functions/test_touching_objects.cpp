// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of integers and of numbers beyond the doubles, where predicates of kernels gave wrong
// pairs. Objects that touch or are degenerate, at all scales, are in test_kinds.

#include "support/found_pairs.h"
#include "support/hull_oracle.h"
#include "support/usual_kernels.h"

#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_homogeneous.h>

#include <boost/multiprecision/cpp_int.hpp>

using namespace test_support;

namespace {

using Integer = boost::multiprecision::int512_t;

// The pairs of the hulls of some vertices each.
Pairs pairs_of_hulls(const std::vector<Hull_vectors<Integer>>& hulls)
{
  return pairs_where(hulls.size(), [&](std::size_t i, std::size_t j) {
    return do_hulls_intersect(hulls[i], hulls[j]);
  });
}

// Segments with ends x/w, y/w of up to `bits` bits. Many share ends or are nearly parallel.
template <class Kernel>
void check_integer_segments(int bits)
{
  using NT = typename Kernel::RT;
  Random random(static_cast<unsigned int>(bits));
  const auto draw = [&] {
    return static_cast<std::int64_t>(random.below(4)) * ((std::int64_t(1) << bits) / 4)
           + static_cast<std::int64_t>(random.below(2));
  };
  std::vector<typename Kernel::Segment_2> segments;
  std::vector<Hull_vectors<Integer>> hulls;
  for(int i = 0; i < 60; ++i) {
    const std::int64_t x[4] = {draw(), draw(), draw(), draw()};
    segments.emplace_back(typename Kernel::Point_2(NT(x[0]), NT(x[1])),
                          typename Kernel::Point_2(NT(x[2]), NT(x[3])));
    hulls.push_back({{Integer(x[0]), Integer(x[1]), 0}, {Integer(x[2]), Integer(x[3]), 0}});
  }
  const Pairs expected = pairs_of_hulls(hulls);
  check_pairs(std::to_string(bits) + " bits", expected, pairs_of(segments));
  BOOST_CHECK_GT(expected.size(), 100u);
}

} // namespace

BOOST_AUTO_TEST_CASE(products_of_integers_do_not_overflow)
{
  for(const int bits : {10, 40, 60}) {
    check_integer_segments<CGAL::Homogeneous<long long>>(bits);
    check_integer_segments<CGAL::Simple_homogeneous<long long>>(bits);
    check_integer_segments<CGAL::Simple_cartesian<long long>>(bits);
  }
}

BOOST_AUTO_TEST_CASE(test_of_two_objects_takes_objects_whose_boxes_are_apart)
{
  using Triangle = Epick::Triangle_3;
  const Triangle a(Epick::Point_3(0, 0, 0), Epick::Point_3(1, 0, 0), Epick::Point_3(2, 0, 0));
  const Triangle b(Epick::Point_3(3, 0, 0), Epick::Point_3(4, 0, 0), Epick::Point_3(5, 0, 0));
  const Triangle c(Epick::Point_3(2, 0, 0), Epick::Point_3(2, 0, 0), Epick::Point_3(2, 0, 0));
  const auto do_intersect = CGAL::Thick_object_traits_d<Triangle>().do_intersect_d_object();
  BOOST_CHECK(!do_intersect(a, b));
  BOOST_CHECK(do_intersect(a, c));
  BOOST_CHECK(!do_intersect(b, c));
}

BOOST_AUTO_TEST_CASE(exact_numbers_beyond_the_doubles_are_searched)
{
  using Number = Epeck::FT;
  Number huge(1);
  for(int i = 0; i < 2000; ++i)
    huge *= 2;
  const auto segment = [&](int x0, int y0, int x1, int y1) {
    return Epeck::Segment_2(Epeck::Point_2(x0 * huge, y0 * huge + 1),
                            Epeck::Point_2(x1 * huge, y1 * huge + 1));
  };
  const std::vector<Epeck::Segment_2> segments
    = {segment(-1, -1, 1, 1), segment(-1, 1, 1, -1), segment(3, 1, 2, 2), segment(1, 1, 4, 1),
       segment(0, -2, 5, -2)};
  BOOST_CHECK(pairs_of(segments) == Pairs({{0, 1}, {0, 3}, {2, 3}}));
}

