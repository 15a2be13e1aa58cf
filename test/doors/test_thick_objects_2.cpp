// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles and rectangles in the plane, on the kernels.

#define BOOST_TEST_MODULE thick_objects_2
#include "support/check_objects.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace {

template <class Kernel, class Coordinates>
typename Kernel::Point_2 point_2(const Coordinates& c, std::size_t i)
{
  using FT = typename Kernel::FT;
  return typename Kernel::Point_2(FT(c[2 * i]), FT(c[2 * i + 1]));
}

struct Segments_2
{
  static constexpr int dimension = 2, points = 2;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Segment_2(point_2<K>(c, 0), point_2<K>(c, 1));
  }
};
struct Triangles_2
{
  static constexpr int dimension = 2, points = 3;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Triangle_2(point_2<K>(c, 0), point_2<K>(c, 1), point_2<K>(c, 2));
  }
};
struct Rectangles_2
{
  static constexpr int dimension = 2, points = 2;
  template <class K, class Coordinates>
  static auto make(const Coordinates& c)
  {
    return typename K::Iso_rectangle_2(point_2<K>(c, 0), point_2<K>(c, 1));
  }
};

template <class Maker>
void check_on_kernels()
{
  check_type_of_object<Maker, Double_kernel, Float_kernel, Epick, Epeck, Rational_kernel>();
  check_scenes_of_objects<Maker, Double_kernel, Float_kernel, Epick, Epeck, Rational_kernel>();
}

} // namespace

BOOST_AUTO_TEST_CASE(segments) { check_on_kernels<Segments_2>(); }
BOOST_AUTO_TEST_CASE(triangles) { check_on_kernels<Triangles_2>(); }
BOOST_AUTO_TEST_CASE(rectangles) { check_on_kernels<Rectangles_2>(); }
