// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H

// Points that stand for all others.

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>

#include <algorithm>
#include <cmath>
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

  // Adds a point. `x[axis]` is a double that stands for its coordinate.
  template <class Coordinates>
  void add(const Coordinates& x, std::uint64_t id)
  {
    for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      coordinates.push_back(x[axis]);
    ids.push_back(id);
  }
};

// Calls visit(position) for a random position of each of `count` ranges of [0, size).
template <class Visit>
void for_random_positions(std::uint64_t size, std::size_t count, const Visit& visit)
{
  Random_numbers random;
  for(std::size_t i = 0; i < count; ++i) {
    const std::uint64_t begin = i * size / count, end = (i + 1) * size / count;
    if(begin != end)
      visit(begin + random() % (end - begin));
  }
}

// Returns the number of points in a sample of all points. With 1024 for each part, a part is off by
// 3 %. All processes have the whole sample, so there are fewer for each of many.
inline std::uint64_t sample_size_of_parts(int part_count)
{
  return static_cast<std::uint64_t>(1024. * part_count
                                    / (std::max)(1., std::sqrt(part_count / 64.)));
}

// Returns how many points of a sample have lower ids. So a sample has about as many points of each
// stretch of ids.
inline std::size_t sampled_before(std::uint64_t id, std::uint64_t point_count, int part_count)
{
  if(point_count == 0)
    return 0;
  return static_cast<std::size_t>(id * sample_size_of_parts(part_count) / point_count);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_POINT_SAMPLE_H
