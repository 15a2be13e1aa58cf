// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A run of points for the lanes: sorted along axis 0, in columns, with its end behind them.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_RUN_OF_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_RUN_OF_POINTS_H

#include "point_scene.h"

#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

namespace test_support {

template <int Dimension, class Number = double>
class Run_of_points
{
public:
  // The positions count from `first_position`.
  explicit Run_of_points(Points points, std::size_t first_position = 0) : points_(std::move(points))
  {
    namespace internal = CGAL::Thick_intersection_d::internal;
    std::sort(points_.begin(), points_.end());
    for(std::size_t i = 0; i < points_.size(); ++i) {
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        columns_[axis].push_back(static_cast<Number>(points_[i][axis]));
      positions_.push_back(static_cast<internal::Place>(first_position + i));
    }
    for(internal::Place lane = 0; lane < internal::lanes; ++lane) {
      positions_.push_back(0); // is loaded, but not used
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        columns_[axis].push_back(axis == 0 ? internal::end_of_run<Number>(lane) : 0);
    }
  }

  const Points& points() const { return points_; } // in the order of the run

  CGAL::Thick_intersection_d::internal::Run<Dimension, Number> run() const
  {
    CGAL::Thick_intersection_d::internal::Run<Dimension, Number> run;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      run.x[axis] = columns_[axis].data();
    run.positions = positions_.data();
    run.size = static_cast<CGAL::Thick_intersection_d::internal::Place>(points_.size());
    return run;
  }

private:
  Points points_;
  std::array<std::vector<Number>, Dimension> columns_;
  std::vector<CGAL::Thick_intersection_d::internal::Place> positions_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_RUN_OF_POINTS_H
