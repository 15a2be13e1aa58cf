// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makers of the types of objects of a kernel, for object_scenes.h.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H

#include <cstddef>
#include <utility>

namespace test_support {

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
    using FT = typename Kernel::FT;
    if constexpr(Dimension == 2)
      return typename Kernel::Point_2(FT(c[2 * i]), FT(c[2 * i + 1]));
    else
      return typename Kernel::Point_3(FT(c[3 * i]), FT(c[3 * i + 1]), FT(c[3 * i + 2]));
  }

private:
  template <class Kernel, class Coordinates, std::size_t... I>
  static auto make(const Coordinates& c, std::index_sequence<I...>)
  {
    using Object = typename Maker::template Object<Kernel>;
    return Object(point<Kernel>(c, I)...);
  }
};

struct Points_2 : Object_maker<Points_2, 2, 1>
{
  template <class K>
  using Object = typename K::Point_2;
};

struct Points_3 : Object_maker<Points_3, 3, 1>
{
  template <class K>
  using Object = typename K::Point_3;
};

struct Segments_2 : Object_maker<Segments_2, 2, 2>
{
  template <class K>
  using Object = typename K::Segment_2;
};

struct Triangles_2 : Object_maker<Triangles_2, 2, 3>
{
  template <class K>
  using Object = typename K::Triangle_2;
};

struct Rectangles_2 : Object_maker<Rectangles_2, 2, 2, true>
{
  template <class K>
  using Object = typename K::Iso_rectangle_2;
};

struct Segments_3 : Object_maker<Segments_3, 3, 2>
{
  template <class K>
  using Object = typename K::Segment_3;
};

struct Triangles_3 : Object_maker<Triangles_3, 3, 3>
{
  template <class K>
  using Object = typename K::Triangle_3;
};

struct Cuboids_3 : Object_maker<Cuboids_3, 3, 2, true>
{
  template <class K>
  using Object = typename K::Iso_cuboid_3;
};

struct Tetrahedra_3 : Object_maker<Tetrahedra_3, 3, 4>
{
  template <class K>
  using Object = typename K::Tetrahedron_3;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
