// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makers of the types of objects of a kernel.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_MAKERS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_MAKERS_H

#include "support/kernel_types.h"

namespace lab {

// What all makers do: Maker::Object<K> is the type, in a kernel, of the objects that have so many
// points. Boxes are made of two opposite corners.
template <class Maker, int Dimension, int Points, bool AreBoxes = false>
struct Object_maker
{
  static constexpr int dimension = Dimension, points = Points;
  static constexpr bool are_boxes = AreBoxes;

  template <class Kernel, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return make<Kernel>(c, std::make_index_sequence<Points>());
  }

  // Number i of the points of an object.
  template <class Kernel, class Coordinates>
  static auto point(const Coordinates& c, std::size_t i)
  {
    return test_support::Kernel_types<Kernel, Dimension>::point([&](std::size_t axis) {
      return typename Kernel::FT(c[Dimension * i + axis]);
    });
  }

private:
  template <class Kernel, class Coordinates, std::size_t... I>
  static auto make(const Coordinates& c, std::index_sequence<I...>)
  {
    using Object = typename Maker::template Object<Kernel>;
    return Object(point<Kernel>(c, I)...);
  }
};

template <int Dimension>
struct Segments_maker : Object_maker<Segments_maker<Dimension>, Dimension, 2>
{
  template <class K>
  using Object = typename test_support::Kernel_types<K, Dimension>::Segment;
};

template <int Dimension>
struct Triangles_maker : Object_maker<Triangles_maker<Dimension>, Dimension, 3>
{
  template <class K>
  using Object = typename test_support::Kernel_types<K, Dimension>::Triangle;
};

template <int Dimension>
struct Iso_boxes_maker : Object_maker<Iso_boxes_maker<Dimension>, Dimension, 2, true>
{
  template <class K>
  using Object = typename test_support::Kernel_types<K, Dimension>::Iso_box;
};

struct Tetrahedra_3 : Object_maker<Tetrahedra_3, 3, 4>
{
  template <class K>
  using Object = typename K::Tetrahedron_3;
};

using Segments_2 = Segments_maker<2>;
using Segments_3 = Segments_maker<3>;
using Triangles_2 = Triangles_maker<2>;
using Triangles_3 = Triangles_maker<3>;
using Rectangles_2 = Iso_boxes_maker<2>;
using Cuboids_3 = Iso_boxes_maker<3>;

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_MAKERS_H
