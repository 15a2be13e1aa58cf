// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Faces to triangles, by cutting off ears; see face_triangles.h. CGAL's triangulations and convex
// partitions are under the GPL, and faces have few corners.

#include "face_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace near_pairs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

// The axis along which triangles from the first corner cover the most.
std::size_t axis_of_view(const Corners& corners)
{
  std::array<double, 3> areas = {0, 0, 0};
  const std::array<double, 3>& origin = corners.front();
  for(std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::array<double, 3>& p = corners[i];
    const std::array<double, 3>& q = corners[i + 1];
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      areas[axis] += std::abs((p[u] - origin[u]) * (q[v] - origin[v])
                              - (p[v] - origin[v]) * (q[u] - origin[u]));
    }
  }
  return std::max_element(areas.begin(), areas.end()) - areas.begin();
}

class Ear_cutter
{
public:
  explicit Ear_cutter(const Corners& corners) : left_(corners.size()), is_no_ear_(corners.size())
  {
    std::iota(left_.begin(), left_.end(), std::size_t(0));
    const std::size_t axis = axis_of_view(corners);
    for(const std::array<double, 3>& corner : corners)
      points_.emplace_back(corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
    turn_ = turn_at_lowest();
  }

  std::vector<std::array<std::size_t, 3>> cut()
  {
    // Invariant: the triangles and the corners that are left have the boundary of the face, and the
    // last `failed` corners are no ears. Convex faces get diagonals from the first corner, as other
    // programs draw them. After a round without an ear, all corners are tested anew: where edges
    // touch, more corners become ears than the neighbors of one that is cut off.
    std::size_t failed = 0;
    for(std::size_t at = 1; left_.size() > 3; at %= left_.size())
      if(!is_no_ear_[left_[at]] && is_ear(at, failed >= 2 * left_.size())) {
        take(at);
        failed = 0;
      }
      else {
        is_no_ear_[left_[at++]] = true;
        if(++failed % left_.size() == 0)
          std::fill(is_no_ear_.begin(), is_no_ear_.end(), false);
        if(failed == 3 * left_.size())
          return {};
      }
    if(CGAL::orientation(point(0), point(1), point(2)) * turn_ == CGAL::NEGATIVE)
      return {};
    take(1);
    return std::move(triangles_);
  }

private:
  const Point& point(std::size_t at) const { return points_[left_[at % left_.size()]]; }

  // The turn of the whole face, which the corner that is lowest along both axes has. If that is
  // straight, an edge lies on another one there, or ends in it.
  CGAL::Orientation turn_at_lowest() const
  {
    const std::size_t size = points_.size();
    const std::size_t lowest
      = std::min_element(points_.begin(), points_.end()) - points_.begin();
    for(std::size_t step = 0; step < size; ++step) {
      const std::size_t at = lowest + step;
      const CGAL::Orientation turn = CGAL::orientation(
        points_[(at + size - 1) % size], points_[at % size], points_[(at + 1) % size]);
      if(turn != CGAL::COLLINEAR)
        return turn;
    }
    return CGAL::COLLINEAR;
  }

  // Whether the corner makes a triangle that has no other corner. Flat triangles are for the last:
  // they are corners inside of edges.
  bool is_ear(std::size_t at, bool may_be_flat) const
  {
    const Point& p = point(at + left_.size() - 1);
    const Point& q = point(at);
    const Point& r = point(at + 1);
    const CGAL::Orientation turn = CGAL::orientation(p, q, r);
    if(turn == CGAL::COLLINEAR || turn != turn_)
      return turn == CGAL::COLLINEAR && may_be_flat;
    const auto is_inside = [&](std::size_t corner) {
      const Point& s = points_[corner];
      return s != p && s != q && s != r && CGAL::orientation(p, q, s) != -turn
             && CGAL::orientation(q, r, s) != -turn && CGAL::orientation(r, p, s) != -turn;
    };
    return std::none_of(left_.begin(), left_.end(), is_inside);
  }

  void take(std::size_t at)
  {
    const std::size_t size = left_.size();
    const std::size_t before = left_[(at + size - 1) % size], behind = left_[(at + 1) % size];
    triangles_.push_back({before, left_[at], behind});
    is_no_ear_[before] = is_no_ear_[behind] = false;
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  std::vector<Point> points_;     // as seen along an axis
  std::vector<std::size_t> left_; // the corners that are not cut off
  std::vector<bool> is_no_ear_;   // of all corners: tested since a neighbor was cut off
  CGAL::Orientation turn_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

} // namespace

bool are_in_plane(const Corners& corners)
{
  const auto point = [&](std::size_t i) {
    return Kernel::Point_3(corners[i][0], corners[i][1], corners[i][2]);
  };
  std::size_t second = 1, third = 2;
  while(second < corners.size() && point(second) == point(0))
    ++second;
  for(third = second + 1; third < corners.size(); ++third)
    if(!CGAL::collinear(point(0), point(second), point(third)))
      break;
  for(std::size_t i = third + 1; i < corners.size(); ++i)
    if(!CGAL::coplanar(point(0), point(second), point(third), point(i)))
      return false;
  return true;
}

std::vector<std::array<std::size_t, 3>> triangles_of(const Corners& corners)
{
  std::vector<std::array<std::size_t, 3>> triangles = Ear_cutter(corners).cut();
  if(triangles.empty() && !are_in_plane(corners)) // it crosses itself as it is seen
    for(std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles.push_back({0, i, i + 1});
  return triangles;
}

} // namespace near_pairs
