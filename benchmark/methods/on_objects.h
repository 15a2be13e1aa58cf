// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The objects of a scene in EPICK, and the exact test of two of them.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_ON_OBJECTS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_ON_OBJECTS_H

#include "Method.h"

#include "scenes/Object_scene.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Thick_ball_traits_d.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace thick_benchmark {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ball_3 = std::pair<Epick::Point_3, double>;

// One set, or two.
template <class Object>
struct Objects
{
  std::vector<Object> a;
  std::vector<Object> b;
  bool are_two_sets;
};

// ---- objects from numbers -----------------------------------------------------------------------

template <class Point>
Point point_at(const double* x)
{
  if constexpr(CGAL::Ambient_dimension<Point>::value == 2)
    return Point(x[0], x[1]);
  else
    return Point(x[0], x[1], x[2]);
}

// An object of a kernel with two corners or more.
template <class Object, class Point, std::size_t Corners>
struct From_corners
{
  static Object make(const double* x)
  {
    return make(x, std::make_index_sequence<Corners>());
  }

private:
  template <std::size_t... Corner>
  static Object make(const double* x, std::index_sequence<Corner...>)
  {
    constexpr std::size_t dimension = CGAL::Ambient_dimension<Point>::value;
    return Object(point_at<Point>(x + Corner * dimension)...);
  }
};

struct Ball_from_numbers
{
  static Ball_3 make(const double* x) { return {point_at<Epick::Point_3>(x), x[3]}; }
};

using Rectangle_from_numbers = From_corners<Epick::Iso_rectangle_2, Epick::Point_2, 2>;
using Cuboid_from_numbers = From_corners<Epick::Iso_cuboid_3, Epick::Point_3, 2>;

template <class Maker>
auto make_objects(const Object_scene& scene)
{
  using Object = decltype(Maker::make(nullptr));
  Objects<Object> objects{{}, {}, scene.size_a != 0};
  for(std::size_t i = 0; i < scene.size(); ++i)
    (objects.are_two_sets && i >= scene.size_a ? objects.b : objects.a)
      .push_back(Maker::make(scene.object(i)));
  return objects;
}

// ---- searches -----------------------------------------------------------------------------------

template <class Answer, class Maker, class Search>
Run<Answer> run_on_objects(const Object_scene& scene, const Search& search)
{
  using Objects = decltype(make_objects<Maker>(scene));
  const auto objects = std::make_shared<const Objects>(make_objects<Maker>(scene));
  return [objects, search] {
    Answer answer;
    search(*objects, answer);
    return answer;
  };
}

// Of search(objects, answer), on segments, triangles and tetrahedra of a kernel.
template <class Answer, class Kernel, class Search>
Run<Answer> run_on_simplices(const Object_scene& scene, const Search& search)
{
  using K = Kernel;
  using Segment_2 = From_corners<typename K::Segment_2, typename K::Point_2, 2>;
  using Segment_3 = From_corners<typename K::Segment_3, typename K::Point_3, 2>;
  using Triangle_2 = From_corners<typename K::Triangle_2, typename K::Point_2, 3>;
  using Triangle_3 = From_corners<typename K::Triangle_3, typename K::Point_3, 3>;
  using Tetrahedron_3 = From_corners<typename K::Tetrahedron_3, typename K::Point_3, 4>;
  const bool is_plane = scene.dimension == 2;
  switch(scene.shape) {
  case Shape::SEGMENT:
    return is_plane ? run_on_objects<Answer, Segment_2>(scene, search)
                    : run_on_objects<Answer, Segment_3>(scene, search);
  case Shape::TRIANGLE:
    return is_plane ? run_on_objects<Answer, Triangle_2>(scene, search)
                    : run_on_objects<Answer, Triangle_3>(scene, search);
  case Shape::TETRAHEDRON:
    return run_on_objects<Answer, Tetrahedron_3>(scene, search);
  default:
    throw std::invalid_argument("a scene of another shape");
  }
}

// Of search(objects, answer), in EPICK.
template <class Answer, class Search>
Run<Answer> run_on_objects(const Object_scene& scene, const Search& search)
{
  if(scene.shape == Shape::BALL)
    return run_on_objects<Answer, Ball_from_numbers>(scene, search);
  if(scene.shape != Shape::BOX)
    return run_on_simplices<Answer, Epick>(scene, search);
  return scene.dimension == 2 ? run_on_objects<Answer, Rectangle_from_numbers>(scene, search)
                              : run_on_objects<Answer, Cuboid_from_numbers>(scene, search);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_ON_OBJECTS_H
