// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H

// A sample of points, each for some of the work of a search.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Point_sample
{
  int dimension = 0;
  std::vector<double> coordinates; // of one point after another
  std::vector<std::uint64_t> ids;
  std::vector<double> weights;

  std::size_t size() const { return ids.size(); }
  const double* point(std::size_t i) const
  {
    return coordinates.data() + i * static_cast<std::size_t>(dimension);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H
