// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_NEAR_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_NEAR_PAIRS_H

// The question that lanes ask about two points, and the pairs that they have found, of points or of
// boxes, which sweeps decide and report.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <array>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What lanes call when they have found many pairs. Does not own the function. The call returns
// false to stop.
class Flush
{
public:
  template <class Function>
  explicit Flush(const Function& function)
    : function_(&function),
      call_([](const void* f) { return (*static_cast<const Function*>(f))(); })
  {}

  bool operator()() const { return call_(function_); }

private:
  const void* function_;
  bool (*call_)(const void*);
};

// The point at place i of one run, and the point at place j of the same run or another run.
struct Found_pair
{
  Place i;
  Place j;
};

// Where many boxes meet, most pairs are found in rows: the pairs {i, j}, {i, j + 1} and so on, one
// in each lane. A row is stored as its first pair. This is quicker to write and to read.
struct Found_pairs
{
  static constexpr Place capacity = 1024;
  static constexpr Place row_capacity = capacity / lanes;

  Place count = 0;
  Place row_count = 0;
  std::array<Found_pair, capacity + lanes> pairs; // `lanes` more before a look at count
  std::array<Found_pair, row_capacity> rows;
};

// What sums of squares of differences are computed in.
template <class Number>
using Real_of = std::conditional_t<std::is_same_v<Number, double>, double, float>;

template <class Number>
struct Near_question
{
  Number reach;            // along axis 0
  Real_of<Number> inside;  // a computed squared distance up to it is certainly within the bound
  Real_of<Number> outside; // and one above it is certainly beyond
};

struct Near_pairs
{
  static constexpr Place capacity = 1024;

  bool is_full_of_undecided() const { return undecided_count >= capacity; }

  Place count = 0;
  Place undecided_count = 0;
  // The positions of points that are certainly within the bound, the lesser first. There is room
  // for the pairs of all lanes before a look at the count.
  std::array<Found_pair, capacity + lanes> pairs;
  std::array<Found_pair, capacity + lanes> undecided; // places, as in Found_pair
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_NEAR_PAIRS_H
