// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H

// A sample of points, with what each of them stands for.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Memory goes with the points of a part, and time with its pairs as well.
struct Point_load
{
  double points = 0;
  double pairs = 0;
};

struct Point_sample
{
  int dimension = 0;
  std::vector<double> coordinates; // of one point after another
  std::vector<std::uint64_t> ids;
  std::vector<Point_load> loads;

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
