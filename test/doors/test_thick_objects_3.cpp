// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles, cuboids and tetrahedra in space, on the kernels.

#define BOOST_TEST_MODULE thick_objects_3
#include "support/check_objects.h"

using namespace test_support;

namespace {

template <class Kernel, class Coordinates>
typename Kernel::Point_3 point_3(const Coordinates& c, std::size_t i)
{
  using FT = typename Kernel::FT;
  return typename Kernel::Point_3(FT(c[3 * i]), FT(c[3 * i + 1]), FT(c[3 * i + 2]));
}

struct Segments_3
{
  static constexpr int dimension = 3, points = 2;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Segment_3(point_3<K>(c, 0), point_3<K>(c, 1));
  }
};
struct Triangles_3
{
  static constexpr int dimension = 3, points = 3;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Triangle_3(point_3<K>(c, 0), point_3<K>(c, 1), point_3<K>(c, 2));
  }
};
struct Cuboids_3
{
  static constexpr int dimension = 3, points = 2;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Iso_cuboid_3(point_3<K>(c, 0), point_3<K>(c, 1));
  }
};
struct Tetrahedra_3
{
  static constexpr int dimension = 3, points = 4;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Tetrahedron_3(point_3<K>(c, 0), point_3<K>(c, 1), point_3<K>(c, 2),
                                     point_3<K>(c, 3));
  }
};

template <class Maker>
void check_on_kernels()
{
  check_type_of_object<Maker, Double_kernel, Epeck>();
  check_scenes_of_objects<Maker, Double_kernel, Epeck>();
}

} // namespace

BOOST_AUTO_TEST_CASE(segments) { check_on_kernels<Segments_3>(); }
BOOST_AUTO_TEST_CASE(triangles) { check_on_kernels<Triangles_3>(); }
BOOST_AUTO_TEST_CASE(cuboids) { check_on_kernels<Cuboids_3>(); }
BOOST_AUTO_TEST_CASE(tetrahedra) { check_on_kernels<Tetrahedra_3>(); }
