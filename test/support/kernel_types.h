// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The types of a kernel in the plane or in space, with the same names for both.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KERNEL_TYPES_H
#define THICK_INTERSECTION_TEST_SUPPORT_KERNEL_TYPES_H

#include "standard_library.h"

namespace test_support {

template <class K, int Dimension>
struct Kernel_types;

template <class K>
struct Kernel_types<K, 2>
{
  using Point = typename K::Point_2;
  using Segment = typename K::Segment_2;
  using Triangle = typename K::Triangle_2;
  using Iso_box = typename K::Iso_rectangle_2;

  // Coordinate i is x(i). Homogeneous points have another one.
  template <class Function, class... Last>
  static Point point(const Function& x, const Last&... last)
  {
    return Point(x(std::size_t(0)), x(std::size_t(1)), last...);
  }
};

template <class K>
struct Kernel_types<K, 3>
{
  using Point = typename K::Point_3;
  using Segment = typename K::Segment_3;
  using Triangle = typename K::Triangle_3;
  using Iso_box = typename K::Iso_cuboid_3;

  template <class Function, class... Last>
  static Point point(const Function& x, const Last&... last)
  {
    return Point(x(std::size_t(0)), x(std::size_t(1)), x(std::size_t(2)), last...);
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KERNEL_TYPES_H
