// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_SAMPLE_H

// What a few points suggest about a scene before all of them are read. It may be wrong, so it only
// chooses what is worth a try.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Scene_sample
{
public:
  template <class Elements>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED explicit Scene_sample(const Elements& points)
  {
    if(points.size() == 0)
      return;
    const std::size_t count = (std::min)(points.size(), max_count);
    const int dimension = dimension_of(points[0]);
    Double_grid grid;
    std::vector<double> coordinates;
    for(int axis = 0; axis < dimension; ++axis) {
      coordinates.clear();
      for(std::size_t i = 0; i < count; ++i) {
        const auto& point = points[i * points.size() / count];
        if(dimension_of(point) == dimension)
          add(coordinate_bounds(point, axis), coordinates);
      }
      add_axis(coordinates, grid);
    }
    grid_exponent_ = grid.exponent();
  }

  // Whether the coordinates may be doubles on a grid. Then it is this one, or a finer one.
  bool may_have_grid() const { return may_have_grid_; }
  int grid_exponent() const { return grid_exponent_; }

  // Whether it may be a grid whose squares of differences doubles hold, if these are small.
  bool may_have_coarse_grid() const
  {
    return may_have_grid_ && std::ldexp(extent_, -grid_exponent_) <= max_coarse_steps;
  }

  // The number of axes along which the points differ; they may differ along more of them.
  int extended_axis_count() const { return extended_axis_count_; }

  // Whether coordinates are often equal along all axes, as those of a lattice are, which has many
  // ties. Those of random points are not.
  bool is_repetitive() const
  {
    return extended_axis_count_ != 0 && repetitive_axis_count_ == extended_axis_count_;
  }

private:
  static constexpr std::size_t max_count = 512;
  static constexpr std::ptrdiff_t min_repetitions = 16;
  static constexpr double max_coarse_steps = 0x1p40; // of the extent

  void add(const std::pair<double, double>& bounds, std::vector<double>& coordinates)
  {
    if(bounds.first != bounds.second)
      may_have_grid_ = false;
    if(std::isfinite(bounds.first))
      coordinates.push_back(bounds.first);
  }

  template <class Number> // double
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void add_axis(std::vector<Number>& coordinates, Double_grid& grid);

  bool may_have_grid_ = true;
  int grid_exponent_ = 0;
  double extent_ = 0;
  int extended_axis_count_ = 0;
  int repetitive_axis_count_ = 0;
};

template <class Number>
void Scene_sample::add_axis(std::vector<Number>& coordinates, Double_grid& grid)
{
  std::sort(coordinates.data(), coordinates.data() + coordinates.size()); // as in Slabs.h
  if(coordinates.empty() || coordinates.front() == coordinates.back())
    return;
  for(const double x : coordinates)
    grid.add(x);
  extent_ = (std::max)(extent_, coordinates.back() - coordinates.front());
  const auto end = std::unique(coordinates.begin(), coordinates.end());
  ++extended_axis_count_;
  repetitive_axis_count_ += coordinates.end() - end >= min_repetitions;
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template void Scene_sample::add_axis(std::vector<double>&, Double_grid&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_SAMPLE_H
