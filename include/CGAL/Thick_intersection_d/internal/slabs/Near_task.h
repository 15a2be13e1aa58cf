// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TASK_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TASK_H

// What a search by slabs is told and asks: doubles and positions. The search knows no type of the
// user. It reads points, and gives pairs, in blocks.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Doubles in memory. Along an axis, that of a point is `step` bytes behind that of the point
// before. The step is 0 along an axis that all points share.
template <int Dimension>
struct Doubles_view
{
  std::array<const char*, Dimension> x;
  std::array<std::ptrdiff_t, Dimension> step;

  const double* at(std::size_t place, int axis) const
  {
    return reinterpret_cast<const double*>(x[axis]
                                           + static_cast<std::ptrdiff_t>(place) * step[axis]);
  }

  // Whether the coordinates of each point follow each other, and so do the points.
  bool is_packed() const
  {
    bool is_packed = true;
    for(int axis = 1; axis < Dimension; ++axis)
      is_packed = is_packed && step[axis] == step[0]
                  && x[axis] == x[0] + static_cast<std::ptrdiff_t>(sizeof(double)) * axis;
    return is_packed;
  }
};

// The points of a search. Several threads may call the functions at once.
template <int Dimension>
class Near_points
{
public:
  static constexpr int all_axes = -1;

  std::size_t size = 0;
  bool are_viewed = false;          // the search reads `views`, and does not call read()
  bool are_numbered = false;        // points are reported by numbers instead of positions
  std::size_t first_size = 0;       // of the points in the first view
  Doubles_view<Dimension> views[2]; // of the first points, and of all others

  // Sets x[i * Dimension + axis] to a double of the point at `first` + i, for `count` points, along
  // one axis or all of them.
  virtual void read(std::size_t first, std::size_t count, int axis, double* x) const = 0;

  // Sets x[i * Dimension + axis] to a double of the point at positions[i], for `count` points.
  virtual void read_at(const Place* positions, std::size_t count, double* x) const = 0;

  // May prefetch the point at a position.
  virtual void prefetch(std::size_t position) const = 0;

  // Sets numbers[i] to the number of the point at `first` + i, for `count` points.
  virtual void read_numbers(std::size_t first, std::size_t count, Place* numbers) const = 0;

  // Returns the position of the point with a number.
  virtual std::size_t position(Place number) const = 0;

  // Returns what decides near ties first, or nullptr.
  virtual const Integer_distance* integers() const = 0;

  // Decides about the points at two positions, which integers leave undecided.
  virtual bool is_pair(std::size_t i, std::size_t j, Decision_counts& counts) const = 0;

  // Counts points as finished. Returns false to stop.
  virtual bool advance(std::size_t finished) = 0;

protected:
  ~Near_points() = default;
};

class Pair_taker
{
public:
  // Takes up to a thousand pairs of positions, the lesser first. Returns false to stop.
  virtual bool take(const Found_pair* pairs, std::size_t count) = 0;

protected:
  ~Pair_taker() = default;
};

// Takes the results of a whole search.
class Result_taker : public Pair_taker
{
public:
  // Takes the pairs of the position i and each of the positions [first, last), which are behind i.
  // Returns false to stop.
  virtual bool take_row(Place i, Place first, Place last)
  {
    for(Found_pair pair = {i, first}; pair.j < last; ++pair.j)
      if(!take(&pair, 1))
        return false;
    return true;
  }

protected:
  ~Result_taker() = default;
};

class List_bins; // of List_bins.h, which those who make lists include

class List_taker : public Result_taker
{
public:
  // Returns bins of this thread for complete lists.
  virtual List_bins& local_lists() = 0;

protected:
  ~List_taker() = default;
};

template <int Dimension>
struct Near_task
{
  std::array<Interval, Dimension> box; // of the points
  Scaled_filter near;
  Narrow_scale<Dimension> scale; // is usable if coordinates have 32 bits
  Point_sets sets;
  Threads threads;
  Shared_decision_counts* counts = nullptr; // or null
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_TASK_H
