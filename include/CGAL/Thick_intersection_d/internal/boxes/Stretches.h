// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_STRETCHES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_STRETCHES_H

// Long segments in stretches. The box of a long segment may meet those of very many small objects,
// and the boxes of its stretches only few of them.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
using Interval_box = std::array<Interval, Dimension>;

template <std::size_t Axes>
bool do_boxes_meet(const std::array<Interval, Axes>& a, const std::array<Interval, Axes>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), do_meet);
}

// Returns an interval that encloses, along an axis, stretch `index` of `count` of a segment between
// points in two intervals. `count` is a power of two. From each stretch to the next, an end of the
// interval never falls or never rises, because rounding is monotone. So the stretches whose boxes
// meet another box follow each other.
//
// Where a stretch begins and ends is off by less than eight units in the last place of the largest
// coordinate, in every rounding mode, and by the least doubles if a product underflows.
//
// Not inline: two calls give the same doubles, also where compilers fuse products and sums.
BOOST_NOINLINE inline Interval interval_of_stretch(const Interval& source, const Interval& target,
                                                   Place index, Place count)
{
  Interval whole = source;
  whole.add(target);
  if(count == 1 || whole.half_length() >= 0x1p1022) // differences may overflow
    return whole;
  const double slack = (std::max)(std::fabs(whole.low), std::fabs(whole.high)) * 0x1p-48
                       + (std::numeric_limits<double>::min)();
  const auto at = [&](Place end, double from, double to) {
    return from + (to - from) * (static_cast<double>(end) / count);
  };
  Interval stretch;
  for(const Place end : {index, index + 1}) {
    stretch.add(at(end, source.low, target.low) - slack);
    stretch.add(at(end, source.high, target.high) + slack);
  }
  return {(std::max)(whole.low, stretch.low), (std::min)(whole.high, stretch.high)};
}

// Into how many stretches to cut a segment that is searched together with a set of boxes, which it
// takes as spread evenly over the space that they are in.
template <int Dimension>
class Stretch_planner
{
public:
  // Looks at a sample of the boxes of the objects at the positions [first, last). All boxes are
  // longer than objects by the same reach.
  template <class Objects>
  Stretch_planner(const Objects& objects, std::size_t first, std::size_t last)
    : box_count_(static_cast<double>(last - first)), reach_(objects.reach())
  {
    constexpr std::size_t boxes_to_look_at = 1000;
    const std::size_t step = (last - first) / boxes_to_look_at + 1;
    std::vector<Interval_box<Dimension>> boxes;
    Interval_box<Dimension> space;
    for(std::size_t position = first; position < last; position += step) {
      const auto intervals = objects.intervals(position);
      boxes.emplace_back();
      for(int axis = 0; axis < Dimension; ++axis) {
        boxes.back()[axis] = intervals(axis);
        space[axis].add(intervals(axis));
      }
    }
    for(int axis = 0; axis < Dimension; ++axis)
      per_length_[axis] = 1 / space[axis].length();
    for(const Interval_box<Dimension>& box : boxes)
      add_products(box, 1. / static_cast<double>(boxes.size()));
  }

  // Returns the number of stretches, a power of two, with which the search of a segment in a box is
  // expected to cost least. `cost` is that of a stretch, in that of a pair of boxes that meet.
  Place best_count(const Interval_box<Dimension>& box, double cost) const
  {
    Place best = 1;
    double least = worthwhile * (cost + expected_meetings(box, 1));
    for(Place count = 2; count <= most_stretches && count * cost < least; count *= 2) {
      const double sum = count * (cost + expected_meetings(box, 1. / count));
      if(sum < least) {
        least = sum;
        best = count;
      }
    }
    return best;
  }

private:
  using Products = std::array<double, (1 << Dimension)>;

  static constexpr double worthwhile = 0.85; // of the cost of a segment that is not cut
  static constexpr Place most_stretches = 64;

  // The share of the space that a length takes along an axis. If there is no space, NaN is not less
  // than 1.
  double share(double length, int axis) const
  {
    return (std::min)(1., length * per_length_[axis]);
  }

  void add_products(const Interval_box<Dimension>& box, double weight)
  {
    Products products = {weight};
    for(int axis = 0; axis < Dimension; ++axis)
      for(std::size_t set = 0; set < std::size_t(1) << axis; ++set)
        products[set | std::size_t(1) << axis] = products[set] * share(box[axis].length(), axis);
    for(std::size_t set = 0; set < products.size(); ++set)
      mean_products_[set] += products[set];
  }

  // Returns how many boxes of the set meet that of an object as long as the one in `box`, times
  // `factor`. Two boxes with the shares s and t meet along an axis with about the probability
  // s + t - s t. The mean of the product over all axes is linear in each t.
  double expected_meetings(const Interval_box<Dimension>& box, double factor) const
  {
    Products means = mean_products_;
    for(int axis = Dimension - 1; axis >= 0; --axis) {
      const double s = share((box[axis].length() - reach_) * factor + reach_, axis);
      for(std::size_t set = 0; set < std::size_t(1) << axis; ++set)
        means[set] = s * means[set] + (1 - s) * means[set | std::size_t(1) << axis];
    }
    return box_count_ * means[0];
  }

  double box_count_;
  double reach_;
  std::array<double, Dimension> per_length_; // the share of the space that a length of 1 takes
  Products mean_products_ = {}; // of the shares along each set of axes, which are bits
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_STRETCHES_H
