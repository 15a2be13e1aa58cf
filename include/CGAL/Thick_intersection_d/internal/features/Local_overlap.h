// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_LOCAL_OVERLAP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_LOCAL_OVERLAP_H

// Do two polygons overlap near a point?
//
// Near a point, a polygon is made of sectors. Its arms are the directions in which its edges leave
// the point. Next to one direction, the tree of the rings tells whether the polygon is inside.
// From there around the point, each arm leads from the inside to the outside, or back. So all edges
// at the point are seen, whatever rings they are of, and two that lie on each other cancel.
//
// All questions are about the coordinates of given points, or the orientation of three of them,
// unless the point is one where edges cross.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A point is the first vertex of an object: of a segment, or of a point.

// Whether a vertex of an edge is a point.
template <class Segment, class Object>
bool is_vertex_at(const Segment& edge, int v, const Object& point)
{
  return compare_with_point(edge, v, point, 0) == EQUAL
         && compare_with_point(edge, v, point, 1) == EQUAL;
}

// Whether a point is on an edge.
template <class Segment, class Object>
bool is_point_on(const Object& point, const Segment& edge)
{
  for(int axis = 0; axis < 2; ++axis) {
    const Sign side = compare_with_point(edge, 0, point, axis);
    if(side != EQUAL && side == compare_with_point(edge, 1, point, axis))
      return false;
  }
  return orientation_of_ends(edge, 0, edge, 1, point, 0) == ZERO;
}

// Whether an edge is on the line of another one.
template <class Segment>
bool is_along(const Segment& line, const Segment& edge)
{
  return orientation_of_ends(line, 0, line, 1, edge, 0) == ZERO
         && orientation_of_ends(line, 0, line, 1, edge, 1) == ZERO;
}

// A direction in which an edge leaves a point: to one of its ends.
template <class Segment>
struct Arm
{
  const Segment* edge;
  int end;
  bool is_second; // of two polygons
  bool is_low;    // below the point, or to the right of it
};

template <class Segment>
using Arms = boost::container::small_vector<Arm<Segment>, 16>;

template <class Segment, class Object>
Arm<Segment> arm_of(const Segment& edge, int end, bool is_second, const Object& point)
{
  const Sign y = compare_with_point(edge, end, point, 1);
  const bool is_low
    = y == EQUAL ? compare_with_point(edge, end, point, 0) == LARGER : y == SMALLER;
  return {&edge, end, is_second, is_low};
}

// Sorts the arms counterclockwise, from the direction to the right, which comes last.
template <class Segment, class Object>
bool is_arm_before(const Arm<Segment>& a, const Arm<Segment>& b, const Object& point)
{
  return a.is_low != b.is_low
           ? b.is_low
           : orientation_of_ends(*a.edge, a.end, *b.edge, b.end, point, 0) == LEFT_TURN;
}

// A part of a feature at a point, by one of its pieces. If the point is on the boundaries of two
// parts, each two of their segments ask about it, and a few of these times are enough. The segment
// that asks must come before others that begin there, or, if it only goes through the point, before
// all others. Those that begin there come first, because two that go through the point on one line
// do not ask about it. Nor do those count, for this reason, that go along the segment it crosses.
// Then the first two that cross there ask, and four pairs at most.
struct Part_at_point
{
  Place part;
  Place segment;
  bool is_first_asked;       // whether only the first segment asks
  Place crossed = max_place; // a segment of the other part, if both go through the point
};

// What a part of a feature is at a point.
template <class Pieces, class Object>
class Part_near_point
{
  using Segment = typename Pieces::Segment;

public:
  // Adds the arms of the part.
  Part_near_point(const Pieces& pieces, const Object& point, const Part_at_point& place,
                  bool is_second, Arms<Segment>& arms)
    : pieces_(pieces), point_(point), place_(place), is_second_(is_second), arms_(arms)
  {
    if(pieces.is_polygon(place.part))
      is_inside_ = pieces.is_inside_beside(
        point, place.part, [this](Place segment) { return does_cross(segment); },
        [this] { return is_asked_by_other_; });
    else if(!is_vertex_at(pieces[place.segment], 1, point))
      for(int side = 0; side < 2; ++side) // a polyline goes on, and both sides are outside of it
        add_arm(pieces[place.segment], 1);
  }

  // Whether another segment asks. Then nothing else is known.
  bool is_asked_by_other() const { return is_asked_by_other_; }

  // Whether the point is on the boundary.
  bool has_point() const { return has_point_; }

  // Whether the interior is right of the point, slightly above it.
  bool is_inside() const { return is_inside_; }

private:
  bool does_cross(Place segment)
  {
    const Segment& edge = pieces_[segment];
    const Sign height = compare_with_point(edge, 0, point_, 1);
    if(height != EQUAL && height == compare_with_point(edge, 1, point_, 1))
      return false; // above or below the point, as most edges are
    const bool begins = is_vertex_at(edge, 0, point_), ends = is_vertex_at(edge, 1, point_);
    if(!begins && !ends && !is_point_on(point_, edge))
      return does_ray_cross(point_, edge);
    has_point_ = true;
    if(!begins)
      add_arm(edge, 0);
    if(!ends)
      add_arm(edge, 1);
    if(place_.is_first_asked && segment != place_.segment && !ends) {
      const bool asker_begins = is_vertex_at(pieces_[place_.segment], 0, point_);
      if(begins == asker_begins ? segment < place_.segment && !is_along_crossed(edge) : begins)
        is_asked_by_other_ = true;
    }
    return false;
  }

  bool is_along_crossed(const Segment& edge) const
  {
    return place_.crossed != max_place && is_along(pieces_[place_.crossed], edge);
  }

  void add_arm(const Segment& edge, int end)
  {
    arms_.push_back(arm_of(edge, end, is_second_, point_));
  }

  const Pieces& pieces_;
  const Object& point_;
  const Part_at_point& place_;
  const bool is_second_;
  Arms<Segment>& arms_;
  bool is_asked_by_other_ = false;
  bool has_point_ = false;
  bool is_inside_ = false;
};

enum class Local_answer {
  NOTHING,
  ANTENNA, // edges of one polygon cancel where they are inside of the other one
  OVERLAP
};

// Goes around a point. `are_inside` tells which of two parts are inside next to the direction to
// the right.
//
// If the second part is closed, its arms count as well: where one of them is inside of the first
// part, and on none of its edges.
template <bool is_second_open, class Segment, class Object>
Local_answer overlap_of_arms(Arms<Segment>& arms, std::array<bool, 2> are_inside,
                             const Object& point)
{
  const auto is_before = [&](const Arm<Segment>& a, const Arm<Segment>& b) {
    return is_arm_before(a, b, point);
  };
  std::sort(arms.begin(), arms.end(), is_before);
  bool are_antennas = false;
  for(auto arm = arms.begin(); !(are_inside[0] && are_inside[1]); ) {
    if(arm == arms.end())
      return are_antennas ? Local_answer::ANTENNA : Local_answer::NOTHING;
    std::array<std::size_t, 2> counts = {0, 0}; // of arms in one direction
    const auto first = arm;
    for(; arm != arms.end() && !is_before(*first, *arm); ++arm)
      ++counts[arm->is_second];
    if(!is_second_open && counts[0] == 0 && are_inside[0])
      return Local_answer::OVERLAP;
    are_antennas |= counts[0] == 0 ? are_inside[0] && counts[1] % 2 == 0
                                   : counts[1] == 0 && are_inside[1] && counts[0] % 2 == 0;
    for(std::size_t part = 0; part < 2; ++part)
      are_inside[part] ^= counts[part] % 2 != 0;
  }
  return Local_answer::OVERLAP;
}

// Returns whether the interior of a polygon meets a part near a point of the part, or its interior
// if it is open as well.
template <bool is_second_open, class Pieces, class Object>
Local_answer find_local_overlap(const Pieces& pieces, const Object& point,
                                const Part_at_point& a, const Part_at_point& b)
{
  using Near = Part_near_point<Pieces, Object>;
  Arms<typename Pieces::Segment> arms;
  const Near near_a(pieces, point, a, false, arms);
  if(near_a.is_asked_by_other())
    return Local_answer::NOTHING;
  if(!is_second_open && near_a.is_inside() && !near_a.has_point())
    return Local_answer::OVERLAP;
  const Near near_b(pieces, point, b, true, arms);
  if(near_b.is_asked_by_other())
    return Local_answer::NOTHING;
  return overlap_of_arms<is_second_open>(arms, {near_a.is_inside(), near_b.is_inside()}, point);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_LOCAL_OVERLAP_H
