// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_GRID_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_GRID_H

// Cuts points into tiles by a sample.

#include <CGAL/Thick_intersection_d/internal/external/Stripes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Rows of tiles, cut across two axes. The sample decides where to cut and nothing else: every point
// has one tile, whatever the sample was. A search cuts slabs across the last axis, and strips
// across the one before it. So tiles that follow each other are searched after each other.
template <int Dimension>
class Tile_grid
{
public:
  // Needs a point of the sample. The number of tiles is a multiple of 4.
  template <class Point>
  Tile_grid(const std::vector<Point>& sample, std::size_t tile_count)
    : size_(tile_count)
  {
    std::array<std::vector<double>, Dimension> values;
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      for(const Point& point : sample)
        values[axis].push_back(point.x[axis]);
      std::sort(values[axis].begin(), values[axis].end());
    }
    choose_axes(values);
    stripes_.emplace_back(values[axes_[0]], tile_count / columns_);
    stripes_.emplace_back(values[axes_[1]], columns_);
  }

  std::size_t size() const { return size_; }
  static constexpr std::size_t columns() { return columns_; }

  // The axis across which rows are cut, and that across which columns are.
  const std::array<std::size_t, 2>& axes() const { return axes_; }

  // Rows are numbered one after another.
  template <class Point>
  std::size_t operator()(const Point& point) const
  {
    return stripes_[0](point.x[axes_[0]]) * columns_ + stripes_[1](point.x[axes_[1]]);
  }

private:
  // Takes the two axes along which most points extend most, and all points if most are equal. Of
  // lengths that are alike, those of later axes are better.
  void choose_axes(const std::array<std::vector<double>, Dimension>& values)
  {
    std::array<std::pair<int, int>, Dimension> lengths;
    std::array<std::size_t, Dimension> order;
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      const std::vector<double>& x = values[axis];
      const std::size_t outliers = x.size() / 64;
      const double most = x[x.size() - 1 - outliers] / 2 - x[outliers] / 2;
      const double all = x.back() / 2 - x.front() / 2;
      lengths[axis] = {std::ilogb(most), std::ilogb(all)};
      order[axis] = Dimension - 1 - axis;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return lengths[i] > lengths[j]; });
    axes_ = {order[0], order[1]};
  }

  // Few, because a part that is cut into rows alone has few points near others.
  static constexpr std::size_t columns_ = 4;

  std::size_t size_;
  std::array<std::size_t, 2> axes_;
  std::vector<Stripes> stripes_; // rows, columns
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_GRID_H
