// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_EVERYWHERE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_EVERYWHERE_H

// Which pieces of features are taken: all of them. Others have the same functions, and choose.

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Everywhere
{
  static constexpr bool takes_all = true;

  // Whether a feature may meet others.
  static bool takes(std::size_t) { return true; }

  // Whether a face of it may meet others.
  template <class Point>
  static bool takes_face(std::size_t, const Point&, const Point&, const Point&)
  {
    return true;
  }

  // Whether a face is beyond what may be inside another feature.
  template <class Face>
  static bool is_beyond(std::size_t, const Face&)
  {
    return false;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_EVERYWHERE_H
