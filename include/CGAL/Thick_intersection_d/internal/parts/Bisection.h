// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H

// Cuts space into boxes, one for each part, of about the same work.

#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Each cut goes along the axis where the fewest points of the sample are within reach of it, since
// these points go to both sides. Points with the same coordinate are cut by their ids, so a crowd
// of equal points is shared as well. The sample decides where to cut and nothing else: every point
// has one part, whatever the sample was.
class Bisection
{
public:
  Bisection(const Point_sample& sample, int part_count, double reach)
    : sample_(&sample), reach_(reach), order_(sample.size())
  {
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    cut(0, order_.size(), 0, part_count);
    sample_ = nullptr;
    order_ = {};
  }

  // Returns the part of a point. `x[axis]` is a double that stands for its coordinate, always the
  // same one.
  template <class Coordinates>
  int owner(const Coordinates& x, std::uint64_t id) const
  {
    int node = 0;
    while(!cuts_[static_cast<std::size_t>(node)].is_part) {
      const Cut& cut = cuts_[static_cast<std::size_t>(node)];
      const double value = x[static_cast<std::size_t>(cut.axis)];
      const bool is_below = value < cut.value || (value == cut.value && id < cut.id);
      node = is_below ? node + 1 : cut.next;
    }
    return cuts_[static_cast<std::size_t>(node)].next;
  }

private:
  // The node below a cut follows it. `next` is the node above it, or the number of a part.
  struct Cut
  {
    double value = std::numeric_limits<double>::infinity(); // without a sample, all are below
    std::uint64_t id = 0;
    int axis = 0;
    int next = 0;
    bool is_part = false;
  };

  // Cuts a box with the points [first, last) of the order into parts [part, part + part_count).
  void cut(std::size_t first, std::size_t last, int part, int part_count)
  {
    const std::size_t node = cuts_.size();
    cuts_.emplace_back();
    cuts_[node].is_part = part_count == 1;
    cuts_[node].next = part;
    if(part_count == 1)
      return;
    const int parts_below = part_count / 2;
    const double share = static_cast<double>(parts_below) / part_count;
    const int axis = best_axis(first, last, share);
    sort_along(axis, first, last);
    const std::size_t middle = first_above(first, last, share);
    cuts_[node].axis = axis;
    if(middle < last) {
      cuts_[node].value = cut_value(middle, axis, first);
      if(cuts_[node].value == coordinate_of(middle, axis))
        cuts_[node].id = sample_->ids[order_[middle]];
    }
    cut(first, middle, part, parts_below);
    cuts_[node].next = static_cast<int>(cuts_.size());
    cut(middle, last, part + parts_below, part_count - parts_below);
  }

  // Of axes that cut the same number of points, the one along which they extend most is best.
  int best_axis(std::size_t first, std::size_t last, double share)
  {
    int best = 0;
    std::size_t least_count = 0;
    double best_length = 0;
    for(int axis = 0; axis < sample_->dimension && first < last; ++axis) {
      sort_along(axis, first, last);
      const std::size_t count = near_cut(axis, first, last, first_above(first, last, share));
      const double length = coordinate_of(last - 1, axis) - coordinate_of(first, axis);
      if(axis == 0 || count < least_count || (count == least_count && length > best_length)) {
        best = axis;
        least_count = count;
        best_length = length;
      }
    }
    return best;
  }

  double coordinate_of(std::size_t i, int axis) const { return sample_->point(order_[i])[axis]; }

  void sort_along(int axis, std::size_t first, std::size_t last)
  {
    const auto begin = order_.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
              [&](std::size_t i, std::size_t j) {
                const double x = sample_->point(i)[axis];
                const double y = sample_->point(j)[axis];
                return x != y ? x < y : sample_->ids[i] < sample_->ids[j];
              });
  }

  // Returns the place in the order where the weight before it is closest to a share of all weight.
  std::size_t first_above(std::size_t first, std::size_t last, double share) const
  {
    double all = 0;
    for(std::size_t i = first; i < last; ++i)
      all += weight_of(i);
    double below = 0; // the weight of [first, place)
    std::size_t place = first;
    while(place < last && below + weight_of(place) / 2 < share * all)
      below += weight_of(place++);
    return place;
  }

  double weight_of(std::size_t i) const { return sample_->weights[order_[i]]; }

  // Returns where to cut below the point at `middle`: between it and the point before it, if there
  // is a double between them.
  double cut_value(std::size_t middle, int axis, std::size_t first) const
  {
    const double above = coordinate_of(middle, axis);
    if(middle == first)
      return above;
    const double below = coordinate_of(middle - 1, axis);
    const double value = below / 2 + above / 2;
    return below < value && value < above ? value : above;
  }

  // Returns how many of the points, which are in order along the axis, are near a cut at `middle`.
  std::size_t near_cut(int axis, std::size_t first, std::size_t last, std::size_t middle) const
  {
    if(middle == last)
      return 0;
    const double value = cut_value(middle, axis, first);
    std::size_t count = 0;
    for(std::size_t i = first; i < last; ++i)
      count += std::fabs(coordinate_of(i, axis) - value) <= reach_;
    return count;
  }

  const Point_sample* sample_; // while the cuts are made
  double reach_;
  std::vector<std::size_t> order_;
  std::vector<Cut> cuts_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
