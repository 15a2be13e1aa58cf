// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TIES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TIES_H

// Decides the pairs that lanes leave undecided: by 32-bit integers, by doubles, by integers of the
// grid. Asks those who know the exact numbers about the rest.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What does not depend on the numbers in slabs: near ties of doubles.
template <int Dimension>
class Double_ties
{
public:
  using Doubles = std::array<double, Dimension>;

  Double_ties(const Near_points<Dimension>& points, const Near_task<Dimension>& task)
    : points_(points), task_(task)
  {}

  // Returns the position of a point that is reported by a number.
  std::size_t position(Place number) const
  {
    return points_.are_numbered ? points_.position(number) : number;
  }

  // It takes longer to find a point by its number than to read it.
  void prefetch(Place number) const
  {
    if(!points_.are_numbered)
      prefetch_doubles(points_, number);
  }

  Doubles scaled_doubles_of(std::size_t position) const
  {
    Doubles x = doubles_of(points_, position);
    for(double& value : x)
      value *= task_.near.scale;
    return x;
  }

  // Decides about the points that are reported by the numbers `at`, and have the scaled doubles x
  // and y.
  bool is_pair(Doubles& x, Doubles& y, Found_pair at, Decision_counts& counts)
  {
    double s = 0;
    for(int axis = 0; axis < Dimension; ++axis)
      s += (x[axis] - y[axis]) * (x[axis] - y[axis]);
    if(s <= task_.near.filter.inside) {
      counts.add(Arithmetic_tier::DOUBLE);
      return true;
    }
    return !(s > task_.near.filter.outside)
           && decide_tie(x, y, position(at.i), position(at.j), counts);
  }

private:
  // Most lattices come here with most of their pairs. So the integers are fetched once.
  BOOST_NOINLINE bool decide_tie(Doubles& x, Doubles& y, std::size_t i, std::size_t j,
                                 Decision_counts& counts)
  {
    if(task_.near.scale != 1)
      take_back_scale(x, y, i, j);
    if(!are_integers_known_) {
      integers_ = points_.integers();
      are_integers_known_ = true;
    }
    if(integers_ != nullptr)
      if(const std::optional<bool> is = integers_->decide(
           [&](int axis) { return x[axis]; }, [&](int axis) { return y[axis]; }, Dimension)) {
        counts.add(integers_->tier());
        return *is;
      }
    return points_.is_pair(i, j, counts);
  }

  // Sets the scaled doubles of two points to their doubles. They are read again if one of them may
  // have underflowed, perhaps to the least normal number: those of both, because runs may have the
  // axes in another order.
  void take_back_scale(Doubles& x, Doubles& y, std::size_t i, std::size_t j) const
  {
    constexpr double least = (std::numeric_limits<double>::min)();
    bool are_normal = true;
    for(int axis = 0; axis < Dimension; ++axis) {
      are_normal = are_normal && std::fabs(x[axis]) > least && std::fabs(y[axis]) > least;
      x[axis] /= task_.near.scale;
      y[axis] /= task_.near.scale;
    }
    if(!are_normal) {
      x = doubles_of(points_, i);
      y = doubles_of(points_, j);
    }
  }

  const Near_points<Dimension>& points_;
  const Near_task<Dimension>& task_;
  const Integer_distance* integers_ = nullptr; // if there are any
  bool are_integers_known_ = false;
};

template <class Point>
class Near_ties
{
  static constexpr int dimension = Point::dimension;
  static constexpr bool are_doubles = std::is_same_v<typename Point::Number, double>;
  using Run = typename Point::Run;
  using Doubles = typename Double_ties<dimension>::Doubles;

public:
  Near_ties(const Near_points<dimension>& points, const Near_task<dimension>& task)
    : scale_(task.scale), ties_(points, task)
  {}

  // Prefetches what is_pair() reads, if it is not that of runs.
  void prefetch(Found_pair at) const
  {
    if(!are_doubles && !scale_.is_exact()) {
      ties_.prefetch(at.i);
      ties_.prefetch(at.j);
    }
  }

  // Decides about two points of runs. `pair` has their places in the runs, and `at` has what they
  // are reported by.
  bool is_pair(const Run& a, const Run& b, Found_pair pair, Found_pair at, Decision_counts& counts)
  {
    if constexpr(are_doubles) {
      Doubles x, y;
      for(int axis = 0; axis < dimension; ++axis) {
        x[axis] = a.x[axis][pair.i];
        y[axis] = b.x[axis][pair.j];
      }
      return ties_.is_pair(x, y, at, counts);
    }
    else {
      if(scale_.is_exact())
        return decide_in_steps(a, b, pair, counts);
      Doubles x = ties_.scaled_doubles_of(ties_.position(at.i));
      Doubles y = ties_.scaled_doubles_of(ties_.position(at.j));
      return ties_.is_pair(x, y, at, counts);
    }
  }

private:
  // Coordinates are steps of the grid.
  bool decide_in_steps(const Run& a, const Run& b, Found_pair pair, Decision_counts& counts) const
  {
    std::uint64_t square = 0;
    for(int axis = 0; axis < dimension; ++axis) {
      const std::int64_t gap = std::int64_t(a.x[axis][pair.i]) - b.x[axis][pair.j];
      square += static_cast<std::uint64_t>(gap * gap);
    }
    counts.add(Arithmetic_tier::INT64);
    return scale_.holds_for(square);
  }

  const Narrow_scale<dimension>& scale_;
  Double_ties<dimension> ties_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TIES_H
