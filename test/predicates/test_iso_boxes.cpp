// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Iso-boxes and segments, triangles, tetrahedra and each other, flat or not, against the oracle.

#include "support/lattice_hulls.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/iso_boxes.h>

BOOST_AUTO_TEST_SUITE(iso_boxes)

using namespace test_support;

// The vertices that a question is about, for the package.
template <int Dimension, std::size_t Size>
auto vertices_of(const Integers& vertices, int exponent)
{
  typename internal::Staged_orientation<Dimension>::template Vertices<Size> result;
  for(std::size_t k = 0; k < Size; ++k)
    result[k].x = as_doubles<Dimension>(vertices[k], std::ldexp(1., exponent));
  return result;
}

// All corners of a box, or the lower one and the upper one.
template <int Dimension>
Integers box(Random& random, std::size_t side, bool has_all_corners)
{
  const Lattice lattice = {Dimension, side};
  const auto p = lattice_point(random, lattice), q = lattice_point(random, lattice);
  const auto corner = [&](std::size_t bits) {
    Hull_vector<std::int64_t> x = {};
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      const auto [low, high] = std::minmax(p[axis], q[axis]);
      x[axis] = (bits >> axis & 1) == 0 ? low : high;
    }
    return x;
  };
  const std::size_t last = (std::size_t(1) << Dimension) - 1;
  if(!has_all_corners)
    return {corner(0), corner(last)};
  Integers corners;
  for(std::size_t bits = 0; bits <= last; ++bits)
    corners.push_back(corner(bits));
  return corners;
}

template <int Dimension, std::size_t Count>
bool is_found(const Integers& object, const Integers& corners, int exponent)
{
  constexpr std::size_t corner_count = std::size_t(1) << Dimension;
  using Orientation = internal::Staged_orientation<Dimension>;
  Integers all = object;
  all.insert(all.end(), corners.begin(), corners.end());
  auto vertices = vertices_of<Dimension, Count + corner_count>(all, exponent);
  internal::Simplex<Orientation, Count> a;
  internal::Box_corners<Orientation> b;
  for(std::size_t k = 0; k < Count; ++k)
    a[k] = typename Orientation::Point(vertices[k]);
  for(std::size_t k = 0; k < corner_count; ++k)
    b[k] = typename Orientation::Point(vertices[Count + k]);
  Orientation orientation(vertices);
  return internal::does_meet_iso_box(orientation, a, b);
}

// Objects of vertices on a lattice. Most are near a side of the box.
template <int Dimension, std::size_t Count>
void check_objects()
{
  Random random(Count);
  std::size_t wrong = 0, intersecting = 0, asked = 0;
  for(const std::size_t side : {2, 3, 5, 9, 14})
    for(int i = 0; i < 4000; ++i) {
      const Integers object = lattice_hull(random, {Dimension, side}, Count);
      const Integers corners = box<Dimension>(random, side, true);
      const bool truth = do_hulls_intersect(object, corners);
      wrong += is_found<Dimension, Count>(object, corners, random.below(2) == 0 ? 0 : -1074)
               != truth;
      intersecting += truth;
      ++asked;
    }
  BOOST_TEST_CONTEXT(Count << " vertices and a box in dimension " << Dimension)
  {
    BOOST_CHECK_EQUAL(wrong, 0u);
    BOOST_CHECK_GT(intersecting, 1000u);
    BOOST_CHECK_GT(asked - intersecting, 1000u);
  }
}

BOOST_AUTO_TEST_CASE(objects_and_a_rectangle)
{
  check_objects<2, 2>();
  check_objects<2, 3>();
}

BOOST_AUTO_TEST_CASE(objects_and_a_cuboid)
{
  check_objects<3, 2>();
  check_objects<3, 3>();
  check_objects<3, 4>();
}

template <int Dimension>
void check_two_boxes()
{
  using Orientation = internal::Staged_orientation<Dimension>;
  Random random(Dimension);
  for(int i = 0; i < 3000; ++i) {
    const Integers a = box<Dimension>(random, 5, false), b = box<Dimension>(random, 5, false);
    bool truth = true;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      truth = truth && a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis];
    auto vertices = vertices_of<Dimension, 4>({a[0], a[1], b[0], b[1]}, 0);
    const auto point = [&](std::size_t k) { return typename Orientation::Point(vertices[k]); };
    BOOST_CHECK_EQUAL(internal::do_iso_boxes_intersect<Orientation>({point(0), point(1)},
                                                                    {point(2), point(3)}),
                      truth);
  }
}

BOOST_AUTO_TEST_CASE(two_boxes)
{
  check_two_boxes<2>();
  check_two_boxes<3>();
}

BOOST_AUTO_TEST_SUITE_END()
