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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Carried>
void write_sampled(const Part_points<Carried>& part, std::size_t position, int dimension,
                   std::vector<char>& bytes)
{
  write_bytes(&part.ids[position], 1, bytes);
  for(int axis = 0; axis < dimension; ++axis) {
    const double x = part.lower_bounds(position)[static_cast<std::size_t>(axis)];
    write_bytes(&x, 1, bytes);
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

// Appends `count` random points to `bytes`.
template <class Carried>
void choose_sample(const Part_points<Carried>& part, std::size_t count, int dimension,
                   std::vector<char>& bytes)
{
  for_random_positions(part.size(), count, [&](std::uint64_t position) {
    write_sampled(part, static_cast<std::size_t>(position), dimension, bytes);
  });
}

// Appends the points in `bytes` to a sample, each with the same load.
inline void read_sample(const std::vector<char>& bytes, const Point_load& load,
                        Point_sample& sample)
{
  const auto dimension = static_cast<std::size_t>(sample.dimension);
  for(Byte_reader reader(bytes); !reader.is_at_end();) {
    std::uint64_t id;
    reader.read(&id, 1);
    sample.ids.push_back(id);
    sample.coordinates.resize(sample.coordinates.size() + dimension);
    reader.read(sample.coordinates.data() + sample.coordinates.size() - dimension, dimension);
    sample.loads.push_back(load);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CHOOSE_SAMPLE_H
