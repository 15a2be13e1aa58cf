// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects that touch, are degenerate or have extreme coordinates, where predicates of kernels gave
// wrong pairs: against the oracle of hulls.

#include "support/check_pairs.h"
#include "support/hull_oracle.h"
#include "support/usual_kernels.h"

#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_homogeneous.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/multiprecision/cpp_int.hpp>

using namespace test_support;

namespace {

using Integer = boost::multiprecision::int512_t;

template <class Object>
Pairs pairs_of(const std::vector<Object>& objects)
{
  return sorted(reported([&](auto collect) {
    CGAL::thick_self_intersection_d(objects, collect);
  }));
}

// The pairs of the hulls of some vertices each.
Pairs pairs_of_hulls(const std::vector<Hull_vectors<Integer>>& hulls)
{
  return pairs_where(hulls.size(), [&](std::size_t i, std::size_t j) {
    return do_hulls_intersect(hulls[i], hulls[j]);
  });
}

// ---- kernels of integers ------------------------------------------------------------------------

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

// ---- degenerate objects -------------------------------------------------------------------------

namespace {

// Objects of so many vertices on a small lattice: often in one place, on a line or in a plane.
template <class Kernel, class Object, std::size_t vertex_count>
void check_small_objects(unsigned int seed)
{
  Random random(seed);
  std::vector<Hull_vectors<Integer>> hulls;
  std::vector<Object> objects;
  for(int i = 0; i < 60; ++i) {
    std::array<typename Kernel::Point_3, vertex_count> vertices;
    hulls.emplace_back();
    for(auto& vertex : vertices) {
      const int x[3] = {int(random.below(4)), int(random.below(3)), int(random.below(3))};
      hulls.back().push_back({x[0], x[1], x[2]});
      vertex = typename Kernel::Point_3(x[0], x[1], x[2]);
    }
    std::apply([&](const auto&... vertex) { objects.emplace_back(vertex...); }, vertices);
  }
  BOOST_CHECK(pairs_of(objects) == pairs_of_hulls(hulls));
}

template <class Kernel>
void check_degenerate_objects()
{
  for(unsigned int seed = 0; seed < 3; ++seed) {
    check_small_objects<Kernel, typename Kernel::Point_3, 1>(seed);
    check_small_objects<Kernel, typename Kernel::Segment_3, 2>(seed);
    check_small_objects<Kernel, typename Kernel::Triangle_3, 3>(seed);
    check_small_objects<Kernel, typename Kernel::Tetrahedron_3, 4>(seed);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(degenerate_objects_are_the_sets_that_they_are)
{
  check_degenerate_objects<Epick>();
  check_degenerate_objects<Double_kernel>();
  check_degenerate_objects<Epeck>();
  check_degenerate_objects<Rational_kernel>();
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

// ---- extremes -----------------------------------------------------------------------------------

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

BOOST_AUTO_TEST_CASE(objects_that_touch_at_all_scales_are_pairs)
{
  for(const int exponent : {-1074, -1030, -400, 0, 400, 1000}) {
    const auto point = [&](int x, int y, int z) {
      return Epick::Point_3(std::ldexp(x, exponent), std::ldexp(y, exponent),
                            std::ldexp(z, exponent));
    };
    // Two bricks in a tilted plane that touch in the middle of an edge, and one above them.
    const std::vector<Epick::Triangle_3> triangles
      = {{point(0, 0, 0), point(6, 0, 6), point(0, 6, 12)},
         {point(3, 3, 9), point(9, 3, 15), point(9, 9, 27)},
         {point(3, 3, 10), point(9, 3, 16), point(9, 9, 28)}};
    BOOST_CHECK(pairs_of(triangles) == Pairs({{0, 1}}));
  }
}

// One of two triangles is moved by a last bit, so that they touch no longer.
BOOST_AUTO_TEST_CASE(last_bit_decides_whether_objects_touch)
{
  for(const double height : {0.1, 1e3, 1e16}) {
    const auto triangle = [](double x, double z) {
      return Epick::Triangle_3(Epick::Point_3(x, 0, z), Epick::Point_3(x + 1, 0, z),
                               Epick::Point_3(x, 1, z));
    };
    const double above = std::nextafter(height, 1e300), below = std::nextafter(height, 0);
    const std::vector<Epick::Triangle_3> triangles
      = {triangle(0, height), triangle(0.5, height), triangle(0, above), triangle(0, below)};
    BOOST_CHECK(pairs_of(triangles) == Pairs({{0, 1}}));
  }
}
