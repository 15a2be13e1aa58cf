// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makers of the types of objects of a kernel, for object_scenes.h.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H

#include <cstddef>

namespace test_support {

// Number i of the points of an object.
template <class Kernel, int Dimension, class Coordinates>
auto point_of_object(const Coordinates& c, std::size_t i)
{
  using FT = typename Kernel::FT;
  if constexpr(Dimension == 2)
    return typename Kernel::Point_2(FT(c[2 * i]), FT(c[2 * i + 1]));
  else
    return typename Kernel::Point_3(FT(c[3 * i]), FT(c[3 * i + 1]), FT(c[3 * i + 2]));
}

// What all makers have. Boxes are made of two opposite corners.
template <int Dimension, int Points, bool AreBoxes = false>
struct Object_maker
{
  static constexpr int dimension = Dimension, points = Points;
  static constexpr bool are_boxes = AreBoxes;

  template <class Kernel, class Coordinates>
  static auto point(const Coordinates& c, std::size_t i)
  {
    return point_of_object<Kernel, Dimension>(c, i);
  }
};

struct Points_2 : Object_maker<2, 1>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return point<K>(c, 0);
  }
};

struct Points_3 : Object_maker<3, 1>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return point<K>(c, 0);
  }
};

struct Segments_2 : Object_maker<2, 2>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Segment_2(point<K>(c, 0), point<K>(c, 1));
  }
};

struct Triangles_2 : Object_maker<2, 3>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Triangle_2(point<K>(c, 0), point<K>(c, 1), point<K>(c, 2));
  }
};

struct Rectangles_2 : Object_maker<2, 2, true>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Iso_rectangle_2(point<K>(c, 0), point<K>(c, 1));
  }
};

struct Segments_3 : Object_maker<3, 2>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Segment_3(point<K>(c, 0), point<K>(c, 1));
  }
};

struct Triangles_3 : Object_maker<3, 3>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Triangle_3(point<K>(c, 0), point<K>(c, 1), point<K>(c, 2));
  }
};

struct Cuboids_3 : Object_maker<3, 2, true>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Iso_cuboid_3(point<K>(c, 0), point<K>(c, 1));
  }
};

struct Tetrahedra_3 : Object_maker<3, 4>
{
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Tetrahedron_3(point<K>(c, 0), point<K>(c, 1), point<K>(c, 2),
                                     point<K>(c, 3));
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_MAKERS_H
