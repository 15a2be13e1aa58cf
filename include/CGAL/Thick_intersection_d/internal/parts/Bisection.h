// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H

// Cuts space into parts of about as many points, and of about the same work.

#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/parts/Cut_tree.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/balanced_split.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Each cut goes along the axis where the fewest points of the sample are within reach of it, since
// these points go to both sides. Points with the same coordinate are cut by their ids, so a crowd
// of equal points is shared as well. The sample decides where to cut and nothing else.
class Bisection : public Cut_tree
{
public:
  static constexpr int all_parts = -1;

  // Makes the cuts of all parts, or only those on the way to one part. If each part has the same
  // sample, the cuts that it must tell others are all cuts of the tree.
  Bisection(const Point_sample& sample, int part_count, double reach, int part = all_parts)
    : Cut_tree(part_count), sample_(&sample), reach_(reach), wanted_part_(part),
      is_in_first_(sample.size())
  {
    const std::vector<Keyed_value> by_id = order_by_id();
    for(int axis = 0; axis < sample.dimension; ++axis)
      orders_.push_back(order_along(axis, by_id));
    make_cuts(0, sample.size(), 0, part_count);
    sample_ = nullptr;
    orders_ = {};
    is_in_first_ = {};
  }

  // The cuts that other parts must add.
  const std::vector<Cut>& own_cuts() const { return own_cuts_; }

private:
  // One group is [low, high) of the order along an axis, and the other one is around it.
  struct Axis_split
  {
    int axis = 0;
    bool is_first_inside = true; // the group with the lower parts
    std::size_t low = 0;
    std::size_t high = 0;
    double error = 0;
    double near_points = 0; // near the cuts
    double length = 0;
  };

  // A split is found to an accuracy of one of so many steps.
  static constexpr std::size_t max_steps = 2048;

  std::vector<Keyed_value> order_by_id() const
  {
    std::vector<Keyed_value> order;
    order.reserve(sample_->size());
    for(const std::uint64_t id : sample_->ids)
      order.push_back({id, static_cast<std::uint32_t>(order.size())});
    radix_sort(order);
    return order;
  }

  // Points with the same coordinate stay in the order of their ids.
  std::vector<std::uint32_t> order_along(int axis, std::vector<Keyed_value> points) const
  {
    for(Keyed_value& point : points)
      point.key = radix_key(sample_->point(point.value)[axis]);
    radix_sort(points);
    std::vector<std::uint32_t> order;
    order.reserve(points.size());
    for(const Keyed_value& point : points)
      order.push_back(point.value);
    return order;
  }

  // Cuts the points [first, last) of all orders into parts [part, part + part_count). Space without
  // points has one part. Points on both sides of a part are cut together.
  void make_cuts(std::size_t first, std::size_t last, int part, int part_count)
  {
    const bool is_wanted = wanted_part_ == all_parts
                           || (part <= wanted_part_ && wanted_part_ < part + part_count);
    if(part_count == 1 || first == last || !is_wanted)
      return;
    const int first_count = part_count / 2;
    const Axis_split split = best_split(first, last, static_cast<double>(first_count) / part_count);
    Cut cut;
    cut.place = place_of_cut(part, part_count);
    cut.axis = split.axis;
    cut.is_first_inside = split.is_first_inside;
    if(split.low > first)
      cut.low = border_below(split.axis, first, split.low);
    if(split.high < last)
      cut.high = border_below(split.axis, first, split.high);
    add({cut});
    if(part == wanted_part_)
      own_cuts_.push_back(cut);
    const std::size_t middle = separate(first, last, split);
    make_cuts(first, middle, part, first_count);
    make_cuts(middle, last, part + first_count, part_count - first_count);
  }

  // Of splits that are good enough, the one with the fewest points near it is best, and then the
  // one along the longest axis.
  Axis_split best_split(std::size_t first, std::size_t last, double share) const
  {
    Axis_split best;
    for(int axis = 0; axis < sample_->dimension; ++axis) {
      const std::size_t step = (last - first) / max_steps + 1;
      const Split found = Split_finder(sums_along(axis, first, last, step), share)();
      const auto place = [&](std::size_t i) { return (std::min)(first + i * step, last); };
      Axis_split other;
      other.axis = axis;
      other.is_first_inside = found.begin <= found.end;
      other.low = place((std::min)(found.begin, found.end));
      other.high = place((std::max)(found.begin, found.end));
      other.error = found.error;
      for(const std::size_t cut : {other.low, other.high})
        other.near_points += cut > first && cut < last ? near_cut(axis, first, last, cut) : 0;
      other.length = coordinate_of(last - 1, axis) - coordinate_of(first, axis);
      if(axis == 0 || is_better(other, best))
        best = other;
    }
    return best;
  }

  static bool is_better(const Axis_split& a, const Axis_split& b)
  {
    const double error_a = (std::max)(a.error, Split_finder::tolerance);
    const double error_b = (std::max)(b.error, Split_finder::tolerance);
    if(error_a != error_b)
      return error_a < error_b;
    return a.near_points != b.near_points ? a.near_points < b.near_points : a.length > b.length;
  }

  // Returns the loads of the points before each step along an axis, and of all of them, as shares.
  std::vector<Point_load> sums_along(int axis, std::size_t first, std::size_t last,
                                     std::size_t step) const
  {
    std::vector<Point_load> sums(1);
    Point_load sum;
    for(std::size_t place = first; place < last; ++place) {
      const Point_load& load = sample_->loads[item(place, axis)];
      sum = {sum.points + load.points, sum.pairs + load.pairs};
      if((place - first + 1) % step == 0 || place + 1 == last)
        sums.push_back(sum);
    }
    for(Point_load& part : sums)
      part = {part.points / (sum.points > 0 ? sum.points : 1),
              part.pairs / (sum.pairs > 0 ? sum.pairs : 1)};
    return sums;
  }

  std::size_t item(std::size_t place, int axis) const
  {
    return orders_[static_cast<std::size_t>(axis)][place];
  }

  double coordinate_of(std::size_t place, int axis) const
  {
    return sample_->point(item(place, axis))[axis];
  }

  // Returns the border below the point at a place of the order: between it and the point before it,
  // if there is a double between them.
  Border border_below(int axis, std::size_t first, std::size_t place) const
  {
    const double above = coordinate_of(place, axis);
    const double below = place > first ? coordinate_of(place - 1, axis) : above;
    const double value = below / 2 + above / 2;
    const bool is_between = below < value && value < above;
    return is_between ? Border{value, 0} : Border{above, sample_->ids[item(place, axis)]};
  }

  // Returns the load of the points near a cut.
  double near_cut(int axis, std::size_t first, std::size_t last, std::size_t place) const
  {
    const double value = border_below(axis, first, place).value;
    double sum = 0;
    for(std::size_t i = place; i > first && value - coordinate_of(i - 1, axis) <= reach_; --i)
      sum += sample_->loads[item(i - 1, axis)].points;
    for(std::size_t i = place; i < last && coordinate_of(i, axis) - value <= reach_; ++i)
      sum += sample_->loads[item(i, axis)].points;
    return sum;
  }

  // Moves the points of the first group to the front in all orders, and returns where it ends.
  std::size_t separate(std::size_t first, std::size_t last, const Axis_split& split)
  {
    for(std::size_t place = first; place < last; ++place) {
      const bool is_inside = split.low <= place && place < split.high;
      is_in_first_[item(place, split.axis)] = is_inside == split.is_first_inside;
    }
    for(std::vector<std::uint32_t>& order : orders_)
      std::stable_partition(order.begin() + static_cast<std::ptrdiff_t>(first),
                            order.begin() + static_cast<std::ptrdiff_t>(last),
                            [&](std::uint32_t i) { return is_in_first_[i] != 0; });
    const std::size_t inside_size = split.high - split.low;
    return split.is_first_inside ? first + inside_size : last - inside_size;
  }

  // While the cuts are made:
  const Point_sample* sample_;
  double reach_;
  int wanted_part_; // or all parts
  std::vector<std::vector<std::uint32_t>> orders_; // of the sample along each axis
  std::vector<char> is_in_first_;
  std::vector<Cut> own_cuts_; // those whose first part is the wanted one
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
