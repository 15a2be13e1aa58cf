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
// arms of both. A vertex of A or B is there, or two edges cross, and a question there finds F.
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
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether the vertices of an edge are on different sides of the line of another one, strictly: then
// the product of these sides is negative. It is positive if they are on one side.
template <class Segment>
int product_of_sides(const Segment& line, const Segment& edge)
{
  const Sign side = orientation_of_ends(line, 0, line, 1, edge, 0);
  return side == ZERO ? 0 : side * orientation_of_ends(line, 0, line, 1, edge, 1);
}

// Whether an edge has the source of another one. It does not count as the target of the edge, where
// the next edge begins, or a polyline ends.
template <class Segment>
bool has_source(const Segment& edge, const Segment& other)
{
  return is_point_on(other, edge) && !is_vertex_at(edge, 1, other);
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
  using Vector = typename Kernel::Vector_2;
  const auto end = [](const Segment& s, int v) { return Point(exact_end<Point>(s, v)); };
  const Vector along_a(end(a, 0), end(a, 1)), along_b(end(b, 0), end(b, 1));
  const Vector between(end(a, 0), end(b, 0));
  const FT part(FT(CGAL::determinant(between, along_b)) / FT(CGAL::determinant(along_a, along_b)));
  return Point(end(a, 0) + along_a * part);
}

// The second part is open as well, or closed. The test of segments, as Feature_boundaries asks it,
// and of first vertices, as Feature_insides does. Several threads ask at once.
template <class Pieces, bool is_first_open, bool is_second_open>
class Interiors_overlap
{
  using Segment = typename Pieces::Segment;
  static constexpr bool are_both_open = is_first_open && is_second_open;
  static constexpr std::size_t many = 500; // edges

public:
  explicit Interiors_overlap(const Threads& threads) : searched_(threads) {}

  static Interval grown(const Interval& interval) { return interval; }
  static constexpr bool takes_insides() { return true; }

  // Whether two segments show that their features are a pair.
  bool do_meet(const Pieces& pieces, std::size_t i, std::size_t j) const
  {
    const auto [a, b] = open_first(i, j);
    const Segment &edge_a = pieces[a], &edge_b = pieces[b];
    const int along_a = product_of_sides(edge_a, edge_b);
    const int along_b = along_a > 0 ? 1 : product_of_sides(edge_b, edge_a);
    if(along_a > 0 || along_b > 0)
      return false;
    Part_at_point at_a = {pieces.part_of(a), a, true}, at_b = {pieces.part_of(b), b, true};
    if(along_a < 0 && along_b < 0) {
      at_a.crossed = b;
      at_b.crossed = a;
      return are_plain(pieces, at_a, at_b)
             || do_overlap_at(pieces, crossing_of(edge_a, edge_b), at_a, at_b);
    }
    const bool begins_on_b = has_source(edge_b, edge_a);
    return (begins_on_b && do_overlap_at(pieces, edge_a, at_a, at_b))
           || (has_source(edge_a, edge_b) && !(begins_on_b && is_vertex_at(edge_a, 0, edge_b))
               && do_overlap_at(pieces, edge_b, at_a, at_b));
  }

  // Whether the first vertex of a part is inside of a polygon and shows that they are a pair. Edges
  // ask if it is on the boundary.
  bool is_inside(const Pieces& pieces, std::size_t part, std::size_t filled) const
  {
    const Place polygon = pieces.filled(filled).part, first = pieces.part(part).piece;
    Arms<Segment> arms;
    const Part_at_point place = {polygon, first, false};
    const Part_near_point<Pieces, Segment> near(pieces, pieces[first], place, true, arms);
    if(!near.is_inside() || near.has_point())
      return false;
    const auto [a, b] = open_first(part, polygon);
    return do_overlap_at(pieces, pieces[first], {a, first, false}, {b, first, false});
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
  // enough. Where many edges are near, does not know: the point itself tells with less work, if few
  // of them are at its height.
  static bool are_plain(const Pieces& pieces, const Part_at_point& a, const Part_at_point& b)
  {
    const Bbox_2 box_a = bounding_box(pieces[a.segment]),
                 box_b = bounding_box(pieces[b.segment]);
    const Bbox_2 box((std::max)(box_a.xmin(), box_b.xmin()), (std::max)(box_a.ymin(), box_b.ymin()),
                     (std::min)(box_a.xmax(), box_b.xmax()),
                     (std::min)(box_a.ymax(), box_b.ymax()));
    std::size_t asked = 0;
    const auto is_alone = [&](const Part_at_point& place, Place other) {
      return !pieces.is_any_in_box(box, place.part, [&](Place segment) {
        if(++asked > many)
          return true;
        return segment != place.segment && do_overlap(box, bounding_box(pieces[segment]))
               && may_cross_both(pieces[segment], pieces[place.segment], pieces[other]);
      });
    };
    return is_alone(a, b.segment) && (!are_both_open || is_alone(b, a.segment));
  }

  // Whether an edge may have the point where two others cross. It has not if its ends are on one
  // side of one of them, or if it meets the line of one at a vertex, and that of the other between
  // its vertices.
  static bool may_cross_both(const Segment& edge, const Segment& a, const Segment& b)
  {
    const int along_a = product_of_sides(a, edge), along_b = product_of_sides(b, edge);
    return along_a <= 0 && along_b <= 0
           && ((along_a == 0) == (along_b == 0) || is_along(along_a == 0 ? a : b, edge));
  }

  mutable Known_pairs searched_; // parts whose vertices were all asked about
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_INTERIORS_OVERLAP_H
