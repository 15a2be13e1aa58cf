// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H

// Cuts space into parts of about as many points, and of about the same work.

#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/balanced_split.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
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
    : sample_(&sample), reach_(reach), is_in_first_(sample.size())
  {
    for(int axis = 0; axis < sample.dimension; ++axis)
      orders_.push_back(order_along(axis));
    cut(0, sample.size(), 0, part_count);
    sample_ = nullptr;
    orders_ = {};
    is_in_first_ = {};
  }

  // A part, and one of its boxes. A part around another one is in boxes on both sides of it.
  struct Part_place
  {
    int part;
    std::size_t box;
  };
  static constexpr std::size_t max_boxes = 128; // of a part; most have no points

  // Returns where a point is. `x[axis]` is a double that stands for its coordinate, always the same
  // one.
  template <class Coordinates>
  Part_place find(const Coordinates& x, std::uint64_t id) const
  {
    std::size_t box = 1;
    const Node* node = &nodes_.front();
    while(node->axis >= 0) {
      const double value = x[static_cast<std::size_t>(node->axis)];
      const bool is_below = value < node->value || (value == node->value && id < node->id);
      const Side& side = is_below ? node->below : node->above;
      box = side.is_divided && box < max_boxes / 2 ? 2 * box + !is_below : box;
      node = &nodes_[static_cast<std::size_t>(side.next)];
    }
    return {node->below.next, box};
  }

  template <class Coordinates>
  int owner(const Coordinates& x, std::uint64_t id) const
  {
    return find(x, id).part;
  }

private:
  // What is on one side of a cut: a node, or a part. If it is divided, its other half is above the
  // second cut, or below the first one.
  struct Side
  {
    int next = 0;
    bool is_divided = false;
  };

  struct Node
  {
    int axis = -1; // of a cut; a node without an axis is a part
    double value = 0;
    std::uint64_t id = 0;
    Side below, above;
  };

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

  std::vector<std::uint32_t> order_along(int axis) const
  {
    std::vector<std::tuple<double, std::uint64_t, std::uint32_t>> points;
    points.reserve(sample_->size());
    for(std::size_t i = 0; i < sample_->size(); ++i)
      points.emplace_back(sample_->point(i)[axis], sample_->ids[i], static_cast<std::uint32_t>(i));
    std::sort(points.begin(), points.end());
    std::vector<std::uint32_t> order;
    order.reserve(points.size());
    for(const auto& point : points)
      order.push_back(std::get<2>(point));
    return order;
  }

  // Cuts the points [first, last) of all orders into parts [part, part + part_count), and returns
  // the node. Points on both sides of a part are cut together.
  int cut(std::size_t first, std::size_t last, int part, int part_count)
  {
    const std::size_t node = new_node();
    nodes_[node].below.next = part;
    if(part_count == 1 || first == last)
      return static_cast<int>(node);
    const int first_count = part_count / 2;
    const Axis_split split = best_split(first, last, static_cast<double>(first_count) / part_count);
    const bool is_divided = split.low > first && split.high < last;
    const std::size_t second = is_divided ? new_node() : node;
    set_cut(nodes_[second], split.axis, first, last, split.high);
    if(split.low > first)
      set_cut(nodes_[node], split.axis, first, last, split.low);
    const std::size_t middle = separate(first, last, split);
    int inside = cut(first, middle, part, first_count);
    int outside = cut(middle, last, part + first_count, part_count - first_count);
    if(!split.is_first_inside)
      std::swap(inside, outside);
    nodes_[second].below = {inside, false};
    nodes_[second].above = {outside, is_divided};
    if(split.low > first) {
      nodes_[node].below = {outside, is_divided};
      nodes_[node].above = {is_divided ? static_cast<int>(second) : inside, false};
    }
    return static_cast<int>(node);
  }

  std::size_t new_node()
  {
    nodes_.emplace_back();
    return nodes_.size() - 1;
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

  // Cuts below the point at a place of the order.
  void set_cut(Node& node, int axis, std::size_t first, std::size_t last, std::size_t place) const
  {
    node.axis = axis;
    node.value = std::numeric_limits<double>::infinity();
    if(place == last)
      return;
    node.value = cut_value(place, axis, first);
    if(node.value == coordinate_of(place, axis))
      node.id = sample_->ids[item(place, axis)];
  }

  // Returns where to cut below a point: between it and the point before it, if there is a double
  // between them.
  double cut_value(std::size_t place, int axis, std::size_t first) const
  {
    const double above = coordinate_of(place, axis);
    if(place == first)
      return above;
    const double below = coordinate_of(place - 1, axis);
    const double value = below / 2 + above / 2;
    return below < value && value < above ? value : above;
  }

  // Returns the load of the points near a cut.
  double near_cut(int axis, std::size_t first, std::size_t last, std::size_t place) const
  {
    const double value = cut_value(place, axis, first);
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
  std::vector<std::vector<std::uint32_t>> orders_; // of the sample along each axis
  std::vector<char> is_in_first_;

  std::vector<Node> nodes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BISECTION_H
