// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CHOOSE_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CHOOSE_SAMPLE_H

// Chooses points of a process for a sample of the points of all processes.

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/parts/Byte_reader.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Appends `count` random points, one of each of `count` ranges of positions, to `bytes`.
template <class Carried>
void choose_sample(const Part_points<Carried>& part, std::size_t count, int dimension,
                   std::vector<char>& bytes)
{
  Random_numbers random;
  for(std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * part.size() / count;
    const std::size_t end = (i + 1) * part.size() / count;
    if(begin == end)
      continue;
    const std::size_t position = begin + random() % (end - begin);
    write_bytes(&part.ids[position], 1, bytes);
    for(int axis = 0; axis < dimension; ++axis) {
      const double x = part.lower_bounds(position)[static_cast<std::size_t>(axis)];
      write_bytes(&x, 1, bytes);
    }
  }
}

// Returns the points in `bytes`, with equal weights.
inline Point_sample read_sample(const std::vector<char>& bytes, int dimension)
{
  Point_sample sample;
  sample.dimension = dimension;
  for(Byte_reader reader(bytes); !reader.is_at_end();) {
    std::uint64_t id;
    reader.read(&id, 1);
    sample.ids.push_back(id);
    sample.coordinates.resize(sample.coordinates.size() + static_cast<std::size_t>(dimension));
    reader.read(sample.coordinates.data() + sample.coordinates.size() - dimension,
                static_cast<std::size_t>(dimension));
    sample.weights.push_back(1);
  }
  return sample;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CHOOSE_SAMPLE_H
