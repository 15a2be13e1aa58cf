// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The oracle of distances, against two others: the least distance of two simplices of vertices, by
// rational equations, and the gaps between two boxes.

#include "distance_oracle.h"
#include "lattice_hulls.h"
#include "unit_test.h"

using namespace test_support;

namespace {

using Vectors = Hull_vectors<std::int64_t>;
using Equations = std::vector<std::vector<Rational>>; // each with its right side at the end

// Solves as many linear equations as there are unknowns. Returns nothing if they are dependent.
std::optional<std::vector<Rational>> solution(Equations rows)
{
  for(std::size_t k = 0; k < rows.size(); ++k) {
    std::size_t pivot = k;
    while(pivot < rows.size() && rows[pivot][k] == 0)
      ++pivot;
    if(pivot == rows.size())
      return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for(std::size_t i = 0; i < rows.size(); ++i)
      if(i != k && rows[i][k] != 0) {
        const Rational factor = rows[i][k] / rows[k][k];
        for(std::size_t j = k; j < rows[i].size(); ++j)
          rows[i][j] -= factor * rows[k][j];
      }
  }
  std::vector<Rational> unknowns;
  for(std::size_t k = 0; k < rows.size(); ++k)
    unknowns.push_back(rows[k].back() / rows[k][k]);
  return unknowns;
}

// The simplex of the vertices whose bits are set.
Vectors chosen(const Vectors& vertices, std::size_t bits)
{
  Vectors result;
  for(std::size_t k = 0; k < vertices.size(); ++k)
    if((bits >> k & 1) != 0)
      result.push_back(vertices[k]);
  return result;
}

// The least square of a sum of the vectors with weights. The weights of the first `size_a` vectors
// have the sum 1, and so have the others: by Lagrange, the products of the sum with all vectors of
// one kind are equal. Returns nothing if the weights are not unique, or if some are negative.
std::optional<Rational> least_square(const Vectors& vectors, std::size_t size_a)
{
  const std::size_t size = vectors.size();
  Equations rows(size + 2, std::vector<Rational>(size + 3, 0));
  for(std::size_t i = 0; i < size; ++i) {
    for(std::size_t j = 0; j < size; ++j)
      rows[i][j] = dot(vectors[i], vectors[j]);
    const std::size_t kind = size + (i < size_a ? 0 : 1);
    rows[i][kind] = rows[kind][i] = 1;
  }
  rows[size].back() = rows[size + 1].back() = 1;
  const auto weights = solution(rows);
  if(!weights || std::any_of(weights->begin(), weights->begin() + std::ptrdiff_t(size),
                             [](const Rational& w) { return w < 0; }))
    return std::nullopt;
  return Rational(-(*weights)[size] - (*weights)[size + 1]);
}

// The nearest points are in the relative interiors of two simplices. If these had more than five
// vertices, some could be left out.
Rational least_squared_distance(const Vectors& a, const Vectors& b)
{
  std::optional<Rational> least;
  for(std::size_t i = 1; i < std::size_t(1) << a.size(); ++i)
    for(std::size_t j = 1; j < std::size_t(1) << b.size(); ++j) {
      Vectors vectors = chosen(a, i);
      const std::size_t size_a = vectors.size();
      for(const auto& q : chosen(b, j))
        vectors.push_back({-q[0], -q[1], -q[2]});
      if(vectors.size() > 5)
        continue;
      const auto square = least_square(vectors, size_a);
      if(square && (!least || *square < *least))
        least = square;
    }
  return least.value();
}

Vectors vertices_of_box(const Vectors& ends)
{
  Vectors vertices;
  for(std::size_t k = 0; k < 8; ++k)
    vertices.push_back({ends[k & 1][0], ends[k >> 1 & 1][1], ends[k >> 2 & 1][2]});
  return vertices;
}

// Along each axis, the gap of the two intervals.
Rational squared_distance_of_boxes(const Vectors& a, const Vectors& b)
{
  std::int64_t sum = 0;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low_a, high_a] = std::minmax(a[0][axis], a[1][axis]);
    const auto [low_b, high_b] = std::minmax(b[0][axis], b[1][axis]);
    const std::int64_t gap = (std::max)({std::int64_t(0), low_b - high_a, low_a - high_b});
    sum += gap * gap;
  }
  return sum;
}

// Of up to `most` vertices each. Returns how many of the distances are zero.
std::size_t check_simplices(int count, std::size_t most, std::size_t side, std::uint64_t seed)
{
  Random random(seed);
  std::size_t zeros = 0;
  for(int i = 0; i < count; ++i) {
    const Lattice lattice = {i % 4 == 0 ? 2u : 3u, side};
    const Vectors a = lattice_hull(random, lattice, 1 + random.below(most));
    const Vectors b = lattice_hull(random, lattice, 1 + random.below(most));
    const Rational square = squared_distance_of_hulls(a, b);
    BOOST_REQUIRE_EQUAL(square, least_squared_distance(a, b));
    zeros += square == 0;
  }
  return zeros;
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_are_the_least_ones_of_simplices)
{
  const std::size_t zeros = check_simplices(300, 4, 3, 1) + check_simplices(300, 4, 5, 2)
                            + check_simplices(300, 4, 12, 3);
  BOOST_CHECK_GT(zeros, 900 / 6);
  BOOST_CHECK_LT(zeros, 900 / 2);
  for(std::size_t side = 2; side < 10; ++side) // points and segments
    check_simplices(500, 2, side, side);
}

BOOST_AUTO_TEST_CASE(distances_of_boxes_are_those_of_their_gaps)
{
  Random random(3);
  for(int i = 0; i < 300; ++i) {
    const Vectors a = lattice_hull(random, {3, 2 + random.below(8)}, 2);
    const Vectors b = lattice_hull(random, {3, 2 + random.below(8)}, 2);
    BOOST_REQUIRE_EQUAL(squared_distance_of_hulls(vertices_of_box(a), vertices_of_box(b)),
                        squared_distance_of_boxes(a, b));
  }
}

BOOST_AUTO_TEST_CASE(distances_are_compared_with_bounds_and_radii_by_their_squares)
{
  const auto compare = [](const Rational& square, const Rational& value, bool is_squared,
                          const Rational& radii) {
    return compare_distance(square, {value, is_squared, false}, radii);
  };
  // Distances 5 and root of 2, of which the second is between 1.4 and 1.5.
  BOOST_CHECK_EQUAL(compare(25, 3, false, 2), 0);
  BOOST_CHECK_EQUAL(compare(25, 9, true, 2), 0);
  BOOST_CHECK_EQUAL(compare(25, 10, true, 2), -1);
  BOOST_CHECK_EQUAL(compare(25, 8, true, 2), 1);
  BOOST_CHECK_EQUAL(compare(2, 2, true, 0), 0);
  BOOST_CHECK_EQUAL(compare(8, 2, true, Rational(7, 5)), 1);
  BOOST_CHECK_EQUAL(compare(8, 2, true, Rational(3, 2)), -1);
  BOOST_CHECK_EQUAL(compare(0, 0, true, 3), -1);
  BOOST_CHECK(are_near(25, 2, {3, false, false}));
  BOOST_CHECK(!are_near(25, 2, {3, false, true}));
  BOOST_CHECK(!are_near(0, 2, {0, false, true}));
  BOOST_CHECK(do_intersect(25, 5));
  BOOST_CHECK(!do_intersect(25, Rational(49, 10)));
}
