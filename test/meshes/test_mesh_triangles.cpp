// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangles that share a vertex or an edge, in all directions of a small lattice, on doubles and on
// a kernel.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/meshes/mesh_triangles.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

BOOST_AUTO_TEST_SUITE(mesh_triangles)

using namespace test_support;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Doubles = internal::Staged_orientation<3>;
using Numbers = internal::Kernel_orientation<Kernel, 3>;

void read(const Point& p, Doubles::Vertex& result) { result.x = {p.x(), p.y(), p.z()}; }
void read(const Point& p, Numbers::Vertex& result) { result = p; }

// Asks about faces that share the first of these points.
template <class Orientation, std::size_t Count>
bool do_faces_intersect(const std::array<Point, Count>& points)
{
  typename Orientation::template Vertices<Count> vertices;
  for(std::size_t k = 0; k < Count; ++k)
    read(points[k], vertices[k]);
  return internal::do_faces_intersect<Orientation, Count>(vertices);
}

// The neighbors of the origin on the lattice.
std::vector<Point> directions()
{
  std::vector<Point> result;
  for(int i = 0; i < 27; ++i)
    if(i != 13)
      result.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
  return result;
}

// All directions, up to symmetry.
const std::vector<Point> few = {Point(1, 0, 0), Point(1, 1, 0), Point(1, 1, 1)};

// They have more in common than the vertex iff one meets the edge of the other that is opposite.
BOOST_AUTO_TEST_CASE(triangles_at_a_vertex_meet_where_an_opposite_edge_does)
{
  const Point v(0, 0, 0);
  const std::vector<Point> all = directions();
  std::size_t intersecting = 0, wrong = 0;
  for(const Point& a : few)
    for(const Point& b : all)
      for(const Point& c : all)
        for(const Point& d : all)
          if(!CGAL::collinear(v, a, b) && !CGAL::collinear(v, c, d)) {
            const bool truth
              = CGAL::do_intersect(Kernel::Triangle_3(v, a, b), Kernel::Segment_3(c, d))
                || CGAL::do_intersect(Kernel::Triangle_3(v, c, d), Kernel::Segment_3(a, b));
            intersecting += truth;
            wrong += truth != do_faces_intersect<Doubles, 5>({v, a, b, c, d});
            wrong += truth != do_faces_intersect<Numbers, 5>({v, a, b, c, d});
          }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(intersecting, 5000u);
}

// Then a point on the segment from the middle of the edge to the third vertex of one triangle is in
// the other triangle.
BOOST_AUTO_TEST_CASE(triangles_at_an_edge_meet_if_one_is_folded_onto_the_other)
{
  const Point p(0, 0, 0);
  const std::vector<Point> all = directions();
  std::size_t intersecting = 0, wrong = 0;
  for(const Point& q : few)
    for(const Point& a : all)
      for(const Point& b : all)
        if(!CGAL::collinear(p, q, a) && !CGAL::collinear(p, q, b)) {
          const Point middle = CGAL::midpoint(p, q);
          const Point close = middle + (a - middle) / 1024;
          const bool truth = Kernel::Triangle_3(p, q, b).has_on(close);
          intersecting += truth;
          wrong += truth != do_faces_intersect<Doubles, 4>({p, q, a, b});
          wrong += truth != do_faces_intersect<Numbers, 4>({p, q, a, b});
        }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(intersecting, 100u);
}

BOOST_AUTO_TEST_CASE(points_with_inexact_predicates_are_converted)
{
  using Inexact = CGAL::Simple_cartesian<long double>;
  const auto p = internal::with_exact_predicates(Inexact::Point_3(1, 2, 3));
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  static_assert(std::is_same_v<decltype(p), const Exact::Point_3>);
  BOOST_CHECK_EQUAL(p, Exact::Point_3(1, 2, 3));
}

BOOST_AUTO_TEST_SUITE_END()
