// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call, which the macro CALL_<name> names; the kernel alone without. With CALL_FIVE_CALLS, five
// calls of five kinds.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <vector>

using Point_2 = CGAL::Epick::Point_2;
using Point_3 = CGAL::Epick::Point_3;

#if defined(CALL_NEAR_POINTS) || defined(CALL_NEAR_POINTS_IN_SPACE)
#include <CGAL/fixed_radius_near_points.h>

int main()
{
#ifdef CALL_NEAR_POINTS
  const std::vector<Point_2> points = {{0, 0}, {0, 0.05}};
#else
  const std::vector<Point_3> points = {{0, 0, 0}, {0, 0.05, 0}};
#endif
  int count = 0;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(0.1),
                                    [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}

#elif defined(CALL_NEIGHBOR_LISTS)
#include <CGAL/fixed_radius_near_neighbors.h>

int main()
{
  const std::vector<Point_3> points = {{0, 0, 0}, {0, 0.05, 0}};
  const auto lists = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.1));
  return lists[0].size() == 1 ? 0 : 1;
}

#elif defined(CALL_CLOSEST_PAIR) || defined(CALL_CLOSEST_PAIR_IN_SPACE)
#include <CGAL/closest_pair.h>

int main()
{
#ifdef CALL_CLOSEST_PAIR
  const std::vector<Point_2> points = {{0, 0}, {0, 1}, {3, 0}};
#else
  const std::vector<Point_3> points = {{0, 0, 0}, {0, 1, 0}, {3, 0, 0}};
#endif
  return CGAL::closest_pair(points).second == 1 ? 0 : 1;
}

#elif defined(CALL_SEGMENTS) || defined(CALL_TRIANGLES)
#include <CGAL/thick_intersection_d.h>

int main()
{
#ifdef CALL_SEGMENTS
  const std::vector<CGAL::Epick::Segment_2> objects = {{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}};
#else
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
  const std::vector<CGAL::Epick::Triangle_3> objects = {{a, b, c}, {a, b, d}};
#endif
  int count = 0;
  CGAL::thick_self_intersection_d(objects, [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}

#elif defined(CALL_NEAR_SEGMENTS)
#include <CGAL/fixed_radius_near_neighbors.h>

int main()
{
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 2);
  const std::vector<CGAL::Epick::Segment_3> segments = {{a, b}, {c, d}};
  int count = 0;
  CGAL::fixed_radius_near_neighbors(segments, CGAL::within_distance(1),
                                    [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}

#elif defined(CALL_BOXES)
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/thick_box_intersection_d.h>

int main()
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  const std::vector<Box> boxes = {CGAL::Bbox_3(0, 0, 0, 1, 1, 1), CGAL::Bbox_3(0, 1, 0, 1, 2, 1)};
  int count = 0;
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Box&, const Box&) { ++count; });
  return count == 1 ? 0 : 1;
}

#elif defined(CALL_FIVE_CALLS)
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

int main()
{
  using Point = Point_3;
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
  const std::vector<Point> points = {a, b, c, d};
  const auto bound = CGAL::within_distance(1);
  int count = 0;
  const auto report = [&](std::size_t, std::size_t) { ++count; };
  CGAL::fixed_radius_near_neighbors(points, bound, report);
  count += static_cast<int>(CGAL::fixed_radius_neighbor_lists(points, bound)[0].size());
  count += static_cast<int>(CGAL::closest_pair(points).second);

  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  const std::vector<Box> boxes = {a.bbox() + b.bbox(), a.bbox() + c.bbox()};
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Box&, const Box&) { ++count; });
  const std::vector<CGAL::Epick::Triangle_3> triangles = {{a, b, c}, {a, b, d}};
  CGAL::thick_self_intersection_d(triangles, report);
  return count == 9 ? 0 : 1;
}

#elif defined(CALL_BOX_INTERSECTION) // for comparison
#include <CGAL/box_intersection_d.h>

int main()
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 2>;
  std::vector<Box> boxes = {Box(CGAL::Bbox_2(0, 0, 1, 1)), Box(CGAL::Bbox_2(0, 1, 1, 2))};
  int count = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box&, const Box&) { ++count; });
  return count == 1 ? 0 : 1;
}

#else
int main()
{
  const Point_2 point(0, 0);
  return point.x() == 0 ? 0 : 1;
}
#endif
