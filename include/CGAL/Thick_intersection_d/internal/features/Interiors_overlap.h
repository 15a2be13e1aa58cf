// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_INTERIORS_OVERLAP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_INTERIORS_OVERLAP_H

// Does the interior of a polygon meet the interior of another one, or a closed part of a feature?
//
// The answer is found near points: where two edges cross, at the vertices of one boundary on the
// other one, and at the first vertices of parts.
//
// Proof. The boundary of a polygon A is where an odd number of its edges lie. It has the interior
// on one side, up to single points. Let F be a region inside of A and B, and let C be its outer
// boundary.
//
// (1) C has edges of both boundaries. Where it goes from one to the other, F is a sector between
// arms of both. A vertex of A or B is there, or two edges cross, and the question there finds F.
//
// (2) C is of A alone, say. Follow the ring of an edge of C, and the rings that touch it, inside of
// B. Either they all stay there, or they reach an edge of B, at a point that is asked about. If the
// last edge before it is on the boundary of A, this is seen there. If not, edges of A cancel: they
// are an antenna, or a bridge between two places. Then all vertices of A are asked about. One of
// them finds F: follow an edge of C, as a boundary of A in B, to its end, or to a vertex where
// another edge begins to cancel it.
//
// (3) These rings stay inside of B. If the outer ring of A is one of them, its first vertex is
// inside of B. Sectors of A are there, or edges cancel, and all vertices are asked about. If not,
// they are holes. What is just outside of them is in A and in B as well: a region with an outer
// boundary farther outside, for which the same holds.
//
// If B is closed, its edges count besides. If an edge has a point inside of A, then either all of
// its polyline or ring has, and the first vertex too, or, for holes, (3) holds. Or an edge goes on
// into A where it leaves the boundary of A, and its arm is seen there.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Local_overlap.h>
#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_shapes_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How two edges meet: at the source of one of them, or of both, or inside of both. It is nothing if
// they only meet at the target of one, where another edge begins, or a polyline ends.
struct Edge_contact
{
  bool is_source_a = false;
  bool is_source_b = false;
  bool is_crossing = false;
};

// The ends of two edges, a and then b, decide about their contact. Edges that touch often have
// vertices in common, which make no turn.
template <class Orientation>
class Contact_of_ends
{
  using Point = typename Orientation::Point;

public:
  explicit Contact_of_ends(typename Orientation::template Vertices<4>& vertices)
    : orientation_(vertices), plane_(orientation_, 0, 1),
      a_{Point(vertices[0]), Point(vertices[1])}, b_{Point(vertices[2]), Point(vertices[3])}
  {}

  Edge_contact operator()() const
  {
    const Sign b0 = side(a_, b_[0]), b1 = side(a_, b_[1]);
    if(b0 == b1 && b0 != ZERO)
      return {};
    const Sign a0 = side(b_, a_[0]), a1 = side(b_, a_[1]);
    if(a0 == a1)
      return a0 == ZERO ? on_line() : Edge_contact();
    if(a1 == ZERO || b1 == ZERO)
      return {};
    return {a0 == ZERO && b0 != ZERO, b0 == ZERO, a0 != ZERO && b0 != ZERO};
  }

private:
  using Edge = Simplex<Orientation, 2>;

  static bool are_equal(const Point& p, const Point& q)
  {
    return are_points_equal<Orientation>(p, q);
  }

  Sign side(const Edge& edge, const Point& p) const
  {
    return are_equal(edge[0], p) || are_equal(edge[1], p)
             ? ZERO : plane_.orientation(edge[0], edge[1], p);
  }

  // Sources that are equal count once.
  Edge_contact on_line() const
  {
    if(are_equal(a_[0], a_[1]) || are_equal(b_[0], b_[1]))
      return {};
    const auto is_on = [this](const Point& source, const Edge& edge) {
      return plane_.do_boxes_meet(source, source, edge[0], edge[1]) && !are_equal(source, edge[1]);
    };
    const bool is_source_a = is_on(a_[0], b_);
    return {is_source_a, is_on(b_[0], a_) && !(is_source_a && are_equal(a_[0], b_[0])), false};
  }

  Orientation orientation_;
  Projection<Orientation> plane_;
  Edge a_, b_;
};

template <class Segment>
Edge_contact contact_of(const Segment& a, const Segment& b)
{
  Staged_orientation<2>::Vertices<4> vertices;
  if(read_vertex(a, 0, vertices[0]) && read_vertex(a, 1, vertices[1])
     && read_vertex(b, 0, vertices[2]) && read_vertex(b, 1, vertices[3]))
    return Contact_of_ends<Staged_orientation<2>>(vertices)();
  using Orientation
    = Kernel_orientation<typename Common_exact_kernel<Segment, Segment>::type, 2>;
  typename Orientation::template Vertices<4> exact_vertices
    = {exact_end<Segment>(a, 0), exact_end<Segment>(a, 1), exact_end<Segment>(b, 0),
       exact_end<Segment>(b, 1)};
  return Contact_of_ends<Orientation>(exact_vertices)();
}

// A kernel that holds the points where segments cross.
template <class Segment>
struct Crossing_kernel
{
  using Kernel = Kernel_with_exact_predicates<typename Kernel_traits<Segment>::Kernel>;
  using Category = typename Algebraic_structure_traits<typename Kernel::FT>::Algebraic_category;
  using type = std::conditional_t<std::is_convertible_v<Category, Field_tag>, Kernel,
                                  Simple_cartesian<Exact_rational>>;
};

// Returns the point where two segments cross.
template <class Segment>
auto crossing_of(const Segment& a, const Segment& b)
{
  using Kernel = typename Crossing_kernel<Segment>::type;
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_2;
  const auto difference = [](const Segment& p, int i, const Segment& q, int j, int axis) {
    return FT(exact_end<Point>(q, j).cartesian(axis) - exact_end<Point>(p, i).cartesian(axis));
  };
  const FT ax = difference(a, 0, a, 1, 0), ay = difference(a, 0, a, 1, 1);
  const FT bx = difference(b, 0, b, 1, 0), by = difference(b, 0, b, 1, 1);
  const FT cx = difference(a, 0, b, 0, 0), cy = difference(a, 0, b, 0, 1);
  const FT part(FT(cx * by - cy * bx) / FT(ax * by - ay * bx));
  return Point(FT(exact_end<Point>(a, 0).cartesian(0) + part * ax),
               FT(exact_end<Point>(a, 0).cartesian(1) + part * ay));
}

// The second part is open as well, or closed. The test of segments, as Feature_boundaries asks it,
// and of first vertices, as Feature_insides does. Several threads ask at once.
template <class Pieces, bool is_first_open, bool is_second_open>
class Interiors_overlap
{
  using Segment = typename Pieces::Segment;
  static constexpr bool are_both_open = is_first_open && is_second_open;

public:
  explicit Interiors_overlap(const Threads& threads) : searched_(threads) {}

  static Interval grown(const Interval& interval) { return interval; }
  static constexpr bool takes_insides() { return true; }

  // Whether two segments show that their features are a pair.
  bool do_meet(const Pieces& pieces, std::size_t i, std::size_t j) const
  {
    const auto [a, b] = open_first(i, j);
    const Place part_a = pieces.part_of(a), part_b = pieces.part_of(b);
    const Edge_contact contact = contact_of(pieces[a], pieces[b]);
    const auto do_overlap = [&](const auto& point, bool is_vertex) {
      return do_overlap_at(pieces, point, {part_a, a, is_vertex}, {part_b, b, is_vertex});
    };
    if(contact.is_crossing)
      return are_plain(pieces, {part_a, a, false}, {part_b, b, false})
             || do_overlap(crossing_of(pieces[a], pieces[b]), false);
    return (contact.is_source_a && do_overlap(pieces[a], true))
           || (contact.is_source_b && do_overlap(pieces[b], true));
  }

  // Whether the first vertex of a part is inside of a polygon and shows that they are a pair.
  bool is_inside(const Pieces& pieces, std::size_t part, const Pieces&, std::size_t filled) const
  {
    const Place polygon = pieces.filled(filled).part;
    const auto at = [&](std::size_t position) {
      return Part_at_point{static_cast<Place>(position), pieces.part(position).piece,
                           false};
    };
    const Segment& point = pieces[pieces.part(part).piece];
    Arms<Segment> arms;
    const Part_at_point place = at(polygon);
    const Part_near_point<Pieces, Segment> near(pieces, point, place, true, arms);
    if(!near.is_inside() || near.has_point())
      return false;
    const auto [a, b] = open_first(part, polygon);
    return do_overlap_at(pieces, point, at(a), at(b));
  }

private:
  // Two positions, where that of an open part comes first. Those of the first range are smaller.
  static std::pair<Place, Place> open_first(std::size_t i, std::size_t j)
  {
    const bool are_in_order = (i < j) == is_first_open;
    return {static_cast<Place>(are_in_order ? i : j), static_cast<Place>(are_in_order ? j : i)};
  }

  template <class Object>
  bool do_overlap_at(const Pieces& pieces, const Object& point, const Part_at_point& a,
                     const Part_at_point& b) const
  {
    const Local_answer answer = find_local_overlap<are_both_open>(pieces, point, a, b);
    return answer == Local_answer::OVERLAP
           || (answer == Local_answer::ANTENNA && do_overlap_at_vertices(pieces, a.part, b.part));
  }

  // Asks about all vertices of two parts, once for two parts.
  bool do_overlap_at_vertices(const Pieces& pieces, Place a, Place b) const
  {
    if(!searched_.add(a, b))
      return false;
    const auto is_any = [&](Place part) {
      for(Place s = pieces.part(part).piece; s != pieces.last_segment(part); ++s)
        if(find_local_overlap<are_both_open>(pieces, pieces[s], {a, s, part == a},
                                             {b, s, part == b}) == Local_answer::OVERLAP)
          return true;
      return false;
    };
    return is_any(a) || (are_both_open && is_any(b));
  }

  // Whether two parts whose edges cross have no other edges at the point where they do. Then each
  // is on one side of its edge there, so they overlap. If the second part is closed, its edge is
  // enough.
  static bool are_plain(const Pieces& pieces, const Part_at_point& a, const Part_at_point& b)
  {
    const Bbox_2 box_a = bounding_box(pieces[a.segment]),
                 box_b = bounding_box(pieces[b.segment]);
    const Bbox_2 box((std::max)(box_a.xmin(), box_b.xmin()), (std::max)(box_a.ymin(), box_b.ymin()),
                     (std::min)(box_a.xmax(), box_b.xmax()),
                     (std::min)(box_a.ymax(), box_b.ymax()));
    const auto is_alone = [&](const Part_at_point& place, Place other) {
      return !pieces.is_any_in_box(box, place.part, [&](Place segment) {
        return segment != place.segment && do_overlap(box, bounding_box(pieces[segment]))
               && may_cross_both(pieces[segment], pieces[place.segment], pieces[other]);
      });
    };
    return is_alone(a, b.segment) && (!are_both_open || is_alone(b, a.segment));
  }

  // Whether an edge may have the point where two others cross. It has not if its ends are on one
  // side of one of them, or if it meets their lines at a vertex that is not on both.
  static bool may_cross_both(const Segment& edge, const Segment& a, const Segment& b)
  {
    const auto side
      = [&](const Segment& line, int v) { return orientation_of_ends(line, 0, line, 1, edge, v); };
    const Sign a0 = side(a, 0), a1 = side(a, 1);
    if(a0 == a1 && a0 != ZERO)
      return false;
    const Sign b0 = side(b, 0), b1 = side(b, 1);
    if(b0 == b1 && b0 != ZERO)
      return false;
    if(a0 == a1 || b0 == b1) // on one of the lines
      return true;
    const bool has_vertex = a0 == ZERO || a1 == ZERO || b0 == ZERO || b1 == ZERO;
    return !has_vertex || (a0 == ZERO && b0 == ZERO) || (a1 == ZERO && b1 == ZERO);
  }

  mutable Known_pairs searched_; // parts whose vertices were all asked about
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_INTERIORS_OVERLAP_H
