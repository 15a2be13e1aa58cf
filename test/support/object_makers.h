// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makers of the types of objects of a kernel, for object_scenes.h.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H

#include "kernel_types.h"

#include <cstddef>
#include <utility>

namespace test_support {

// Objects of a type Type<Kernel>, which are made of so many points. Boxes are made of two opposite
// corners.
template <int Dimension, int Points, template <class> class Type, bool AreBoxes = false>
struct Object_maker
{
  static constexpr int dimension = Dimension, points = Points;
  static constexpr bool are_boxes = AreBoxes;

  // Number i of the points.
  template <class Kernel, class Coordinates>
  static auto point(const Coordinates& c, std::size_t i)
  {
    return Kernel_types<Kernel, Dimension>::point([&](std::size_t axis) {
      return typename Kernel::FT(c[Dimension * i + axis]);
    });
  }

  template <class Kernel, class Coordinates>
  static Type<Kernel> make(const Coordinates& c)
  {
    return make<Kernel>(c, std::make_index_sequence<Points>());
  }

private:
  template <class Kernel, class Coordinates, std::size_t... i>
  static Type<Kernel> make(const Coordinates& c, std::index_sequence<i...>)
  {
    return Type<Kernel>(point<Kernel>(c, i)...);
  }
};

template <class K>
using Segment_of_plane = typename K::Segment_2;
template <class K>
using Triangle_of_plane = typename K::Triangle_2;
template <class K>
using Rectangle_of_plane = typename K::Iso_rectangle_2;
template <class K>
using Segment_of_space = typename K::Segment_3;
template <class K>
using Triangle_of_space = typename K::Triangle_3;
template <class K>
using Cuboid_of_space = typename K::Iso_cuboid_3;
template <class K>
using Tetrahedron_of_space = typename K::Tetrahedron_3;

struct Segments_2 : Object_maker<2, 2, Segment_of_plane> {};
struct Triangles_2 : Object_maker<2, 3, Triangle_of_plane> {};
struct Rectangles_2 : Object_maker<2, 2, Rectangle_of_plane, true> {};
struct Segments_3 : Object_maker<3, 2, Segment_of_space> {};
struct Triangles_3 : Object_maker<3, 3, Triangle_of_space> {};
struct Cuboids_3 : Object_maker<3, 2, Cuboid_of_space, true> {};
struct Tetrahedra_3 : Object_maker<3, 4, Tetrahedron_of_space> {};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
