// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distances of hulls of integer vertices, degenerate ones too, against the oracle: the distance
// itself is the bound, closed and open.

#include "support/distance_oracle.h"
#include "support/lattice_hulls.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

BOOST_AUTO_TEST_SUITE(exact_hull_distance)

using namespace test_support;

template <std::size_t Dimension>
std::vector<std::array<std::int64_t, Dimension>> in_dimension(const Integers& vertices)
{
  std::vector<std::array<std::int64_t, Dimension>> result(vertices.size());
  for(std::size_t k = 0; k < vertices.size(); ++k)
    std::copy_n(vertices[k].begin(), Dimension, result[k].begin());
  return result;
}

// Whether the distance is at most its true value, not less, and not at most a smaller one.
template <std::size_t Dimension>
bool is_distance_right(const Integers& a, const Integers& b, const Rational& square)
{
  const auto numerator = static_cast<std::int64_t>(boost::multiprecision::numerator(square));
  const auto denominator = static_cast<std::int64_t>(boost::multiprecision::denominator(square));
  const auto is_any_near = [&](const auto& within) {
    return internal::Exact_hull_distance<std::int64_t, Dimension,
                                         std::decay_t<decltype(within)>>(
      within)(in_dimension<Dimension>(a), in_dimension<Dimension>(b));
  };
  return is_any_near([&](std::int64_t n, std::int64_t d) {
           return n * denominator <= numerator * d;
         })
         && !is_any_near([&](std::int64_t n, std::int64_t d) {
              return n * denominator < numerator * d;
            })
         && !is_any_near([&](std::int64_t n, std::int64_t d) {
              return 2 * n * denominator <= numerator * d;
            });
}

// Vertices, edges and triangles are next to each other in all combinations.
template <std::size_t Dimension>
void check_hulls(std::size_t count_a, std::size_t count_b)
{
  Random random(10 * count_a + count_b);
  std::size_t apart = 0, wrong = 0;
  for(const std::size_t side : {2, 3, 5, 9, 17})
    for(int i = 0; i < 500; ++i) {
      const Integers a = lattice_hull(random, {Dimension, side}, count_a);
      const Integers b = lattice_hull(random, {Dimension, side}, count_b);
      const Rational square = squared_distance_of_hulls(a, b);
      if(square == 0)
        continue;
      ++apart;
      wrong += !is_distance_right<Dimension>(a, b, square);
    }
  BOOST_TEST_CONTEXT(count_a << " and " << count_b << " vertices in dimension " << Dimension)
  {
    BOOST_CHECK_EQUAL(wrong, 0u);
    BOOST_CHECK_GT(apart, 100u);
  }
}

// In dimension d, of up to d + 1 vertices each.
template <std::size_t Dimension>
void check_all_hulls()
{
  for(std::size_t a = 1; a <= Dimension + 1; ++a)
    for(std::size_t b = 1; b <= Dimension + 1; ++b)
      check_hulls<Dimension>(a, b);
}

BOOST_AUTO_TEST_CASE(hulls_in_the_plane) { check_all_hulls<2>(); }
BOOST_AUTO_TEST_CASE(hulls_in_space) { check_all_hulls<3>(); }

BOOST_AUTO_TEST_SUITE_END()
