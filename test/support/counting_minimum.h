// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Counts the comparisons that the divide and conquer for the closest pair makes.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_COUNTING_MINIMUM_H
#define THICK_INTERSECTION_TEST_SUPPORT_COUNTING_MINIMUM_H

#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>

#include <cstddef>
#include <map>

namespace test_support {

struct Work_of_division
{
  std::size_t comparisons = 0;         // of coordinates and of distances
  std::size_t max_candidates = 0;      // of a point in a strip
  std::map<std::size_t, std::size_t> candidates; // by point, in the strip that is scanned
};

template <class Elements>
class Counting_minimum : public CGAL::Thick_intersection_d::internal::Pair_minimum<Elements>
{
  using Base = CGAL::Thick_intersection_d::internal::Pair_minimum<Elements>;

public:
  Counting_minimum(const Elements& points, const CGAL::Thick_intersection_d::internal::Scene& scene,
                   Work_of_division& work)
    : Base(points, scene), work_(work)
  {}

  bool less(std::size_t i, std::size_t j, int axis) const
  {
    ++work_.comparisons;
    return Base::less(i, j, axis);
  }

  // A new strip begins when points are compared along axis 0.
  bool is_beyond(std::size_t i, std::size_t j, int axis) const
  {
    ++work_.comparisons;
    if(axis == 0)
      work_.candidates.clear();
    return Base::is_beyond(i, j, axis);
  }

  // The first point is the one that others are candidates of.
  void offer(std::size_t i, std::size_t j)
  {
    ++work_.comparisons;
    work_.max_candidates = (std::max)(work_.max_candidates, ++work_.candidates[i]);
    Base::offer(i, j);
  }

private:
  Work_of_division& work_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_COUNTING_MINIMUM_H
