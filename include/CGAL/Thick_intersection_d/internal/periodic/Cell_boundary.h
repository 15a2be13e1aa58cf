// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_BOUNDARY_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_BOUNDARY_H

// Which homes are so near the boundary of their cell that they may be in a pair with another cell.
//
// Let f_k be how many times vector k goes into a home, f_k' into another home, and R_k into a
// vector of the length of the bound at most. If the first home and the other one, moved by m, are
// within the bound, then |f_k - f_k' - m_k| <= R_k. So m_k is within R_k of the range of f_k minus
// f_k', and f_k is within R_k of the upper end of its range where m_k is positive. These conditions
// are tested with room for all rounding, so no pair is lost. They are necessary only: the search
// decides about what they leave.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_fractions.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Cell_boundary
{
public:
  using Fractions = std::array<double, Dimension>;

  // Points may be anywhere if `are_anywhere`: then their homes are in one cell, and the points
  // themselves if they fit into it as they are. Throws std::length_error if the bound or the scene
  // is too many periods long.
  template <class Elements>
  Cell_boundary(const Threads& threads, const Lattice_basis<Dimension>& basis,
                const Elements& points, const Scene& scene, double reach, bool are_anywhere)
    : fractions_(threads, basis, points, scene), rank_(basis.rank())
  {
    low_ends_.fill(-1); // where there is no vector, points are at zero
    high_ends_.fill(1);
    for(int k = 0; k < rank_; ++k)
      set_range(k, reach, are_anywhere);
    set_inner_box();
  }

  // Writes the positions of those points of [first, last) whose homes may be near the boundary or
  // not the points themselves, in order, and perhaps of a few others. Returns how many. They come
  // in no order that a processor could foresee, so each point is written down, and kept or not.
  template <class Elements>
  BOOST_NOINLINE
  std::size_t find_near(const Elements& points, std::size_t first, std::size_t last,
                        Place* positions) const
  {
    std::size_t count = 0;
    if(has_inner_box_)
      for(std::size_t position = first; position < last; ++position) {
        positions[count] = static_cast<Place>(position);
        count += !is_in_inner_box(doubles(points[position]),
                                  std::make_index_sequence<Dimension>());
      }
    else
      for(std::size_t position = first; position < last; ++position) {
        positions[count] = static_cast<Place>(position);
        count += may_be_near(fractions_(points[position]));
      }
    return count;
  }

  // Returns how many times the vectors go into the home of a point, and sets `cell` to the cell of
  // the point: zero unless points may be anywhere.
  template <class Point>
  Fractions fractions_in_cell(const Point& point, Fractions& cell) const
  {
    Fractions f = fractions_(point);
    cell = {};
    for(int k = 0; k < rank_; ++k)
      if(are_wrapped_[k]) {
        cell[k] = std::floor(f[k] - cell_begins_[k]);
        f[k] -= cell[k];
      }
    return f;
  }

  // The sides of the range of homes that a home is near, as bits. Moved by vector k, a home at the
  // low side may be near homes, and one at the high side moved by the opposite of the vector.
  unsigned sides(const Fractions& f) const
  {
    return sides(f, std::make_index_sequence<Dimension>());
  }
  static constexpr unsigned low_side(int k) { return 1U << k; }
  static constexpr unsigned high_side(int k) { return 1U << (Dimension + k); }
  static constexpr unsigned high_sides = (1U << 2 * Dimension) - (1U << Dimension);
  static constexpr unsigned all_sides = (1U << 2 * Dimension) - 1;

  // Whether a home that is moved twice by one vector is near no home.
  bool is_moved_once() const { return is_moved_once_; }

  // How many vectors k may move a home, for it to be near homes: from the first number to the last.
  double first_move(const Fractions& f, int k) const
  {
    return -floor_of(f[k] + reaches_[k] - ranges_[k].low);
  }
  double last_move(const Fractions& f, int k) const
  {
    return floor_of(ranges_[k].high + reaches_[k] - f[k]);
  }

private:
  // Returns the largest integer that is not above x. The compiler's code of std::floor() is a call
  // where processors may lack the instruction. Here x is within a few ranges of fractions of zero,
  // which are shorter than integers can be.
  static double floor_of(double x)
  {
    const double integer = static_cast<int>(x);
    return integer > x ? integer - 1 : integer;
  }

  void set_range(int k, double reach, bool are_anywhere)
  {
    const double error = fractions_.error(k);
    Interval range = fractions_.range(k);
    reaches_[k] = fractions_.fraction_of(k, reach);
    check_length("The bound", reaches_[k], max_offset / 4);
    check_length("The scene", range.length(), max_offset / 2);
    are_wrapped_[k] = are_anywhere && !(range.length() < 1);
    if(are_wrapped_[k]) {
      cell_begins_[k] = range.low;
      range.high = range.low + 1 + error;
      range.low -= error;
    }
    const double slack = 2 * error + 0x1p-45 * (range.high - range.low + reaches_[k] + 2
                                                + std::fabs(range.low));
    reaches_[k] += slack;
    ranges_[k] = range;
    is_moved_once_ = is_moved_once_ && range.length() + 2 * reaches_[k] < 2;
    low_ends_[k] = range.high - 1 + reaches_[k];
    high_ends_[k] = range.low + 1 - reaches_[k];
  }

  static void check_length(const char* what, double periods, double limit)
  {
    if(!(periods < limit))
      throw std::length_error(std::string(what) + " is " + count_text(periods)
                              + " periods long, and must be shorter than " + count_text(limit)
                              + ".");
  }

  // Sets the inner box: coordinates in it, ends included, are those of homes inside. There is one
  // if each vector is along an axis.
  void set_inner_box()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    inner_box_.fill({-infinity, infinity});
    has_inner_box_ = fractions_.have_coordinates();
    if(has_inner_box_)
      for(int k = 0; k < rank_; ++k)
        inner_box_[fractions_.axis_of(k)]
          = fractions_.coordinates_between(k, low_ends_[k], high_ends_[k]);
  }

  template <class Point>
  static Fractions doubles(const Point& point)
  {
    Fractions x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = coordinate_bounds(point, axis).first;
    return x;
  }

  template <std::size_t... I>
  bool is_in_inner_box(const Fractions& x, std::index_sequence<I...>) const
  {
    return ((unsigned(x[I] >= inner_box_[I].low) & unsigned(x[I] <= inner_box_[I].high)) & ...)
           != 0;
  }

  // Whether a point with these fractions may have its home near a side, or elsewhere: then it is
  // beyond the range of homes.
  bool may_be_near(const Fractions& f) const { return sides(f) != 0; }

  template <std::size_t... K>
  unsigned sides(const Fractions& f, std::index_sequence<K...>) const
  {
    return ((unsigned(f[K] <= low_ends_[K]) * low_side(K)) | ...)
           | ((unsigned(f[K] >= high_ends_[K]) * high_side(K)) | ...);
  }

  const Cell_fractions<Dimension> fractions_;
  int rank_;
  std::array<bool, Dimension> are_wrapped_ = {};
  Fractions cell_begins_ = {};
  bool is_moved_once_ = true;
  Fractions reaches_ = {};
  std::array<Interval, Dimension> ranges_ = {}; // of the homes
  Fractions low_ends_; // homes beyond them may be near homes in another cell
  Fractions high_ends_;
  std::array<Interval, Dimension> inner_box_;
  bool has_inner_box_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_BOUNDARY_H
