// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "object_columns.h"

#include "methods/box_intersection.h"
#include "methods/boxes_of_objects.h"
#include "support/recursion_variants.h"

#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/thick_intersection_d.h>

#include <type_traits>

namespace lab {
namespace {

using CGAL::Box_intersection_d::CLOSED;
using CGAL::Box_intersection_d::HALF_OPEN;
using CGAL::Box_intersection_d::Topology;

template <class Answer, class Search>
Run<Answer> run_on_boxes_or_balls(const Object_scene& scene, const Search& search)
{
  const auto search_set
    = [search](const auto& objects, Answer& answer) { search(objects.a, answer); };
  if(scene.shape == Shape::BALL)
    return run_on_objects<Answer, Ball_from_numbers>(scene, search_set);
  return scene.dimension == 2 ? run_on_objects<Answer, Rectangle_from_numbers>(scene, search_set)
                              : run_on_objects<Answer, Cuboid_from_numbers>(scene, search_set);
}

// Of search(objects, answer).
template <class Search>
Object_column column(const std::string& name, const std::string& group, const Search& search)
{
  Object_column column;
  column.name = name;
  column.group = group;
  column.prepare = [search](const Object_scene& scene) {
    return run_on_boxes_or_balls<Found>(scene, search);
  };
  column.prepare_count = [search](const Object_scene& scene) {
    return run_on_boxes_or_balls<Tally>(scene, search);
  };
  return column;
}

// ---- whether two balls meet whose boxes do; there is nothing to decide about other objects ------

struct Exactly
{
  bool operator()(const Ball_3& a, const Ball_3& b) const
  {
    return CGAL::Thick_ball_traits_d<Epick::Point_3>::Do_intersect_d(3)(a, b);
  }
};

template <class NT>
struct Squared_in
{
  bool operator()(const Ball_3& a, const Ball_3& b) const
  {
    NT square = 0;
    for(int axis = 0; axis < 3; ++axis) {
      const NT difference = static_cast<NT>(a.first[axis]) - static_cast<NT>(b.first[axis]);
      square += difference * difference;
    }
    const NT sum = static_cast<NT>(a.second) + static_cast<NT>(b.second);
    return square <= sum * sum;
  }
};

// Takes balls as their surfaces, and the squares of their radii rounded.
struct As_spheres
{
  static Epick::Sphere_3 sphere(const Ball_3& ball)
  {
    return Epick::Sphere_3(ball.first, ball.second * ball.second);
  }
  bool operator()(const Ball_3& a, const Ball_3& b) const
  {
    return CGAL::do_intersect(sphere(a), sphere(b));
  }
};

// The test of the objects at two positions.
template <class Test, class Object>
auto test_of(const std::vector<Object>& objects)
{
  return [&](std::size_t i, std::size_t j) -> bool {
    if constexpr(std::is_same_v<Object, Ball_3>)
      return Test()(objects[i], objects[j]);
    else
      return true;
  };
}

// ---- others -------------------------------------------------------------------------------------

template <class NT, class Test, class Round>
auto by_boxes(const Round& round, std::ptrdiff_t cutoff, Topology topology = CLOSED)
{
  return [=](const auto& objects, auto& answer) {
    box_intersection<CGAL::Sequential_tag>(boxes_of<NT>(objects, round),
                                           test_of<Test>(objects), answer, cutoff, topology);
  };
}

// ---- ours ---------------------------------------------------------------------------------------

template <class Object>
auto traits_of(const std::vector<Object>& objects)
{
  if constexpr(std::is_same_v<Object, Ball_3>)
    return CGAL::Thick_ball_traits_d<Epick::Point_3>(objects);
  else
    return CGAL::Thick_object_traits_d<Object>(objects);
}

auto by_search()
{
  return [](const auto& objects, auto& answer) {
    CGAL::thick_self_intersection_d(objects, answer,
                                    CGAL::parameters::geom_traits(traits_of(objects)));
  };
}

auto by_recursive_route()
{
  return [](const auto& objects, auto& answer) {
    test_support::search_by_variant(objects, traits_of(objects), {}, answer);
  };
}

} // namespace

std::vector<Object_column> object_columns(Shape shape)
{
  std::vector<Object_column> columns = {
    column("boxes, cutoff 10", "boxes", by_boxes<double, Exactly>(outwards, 10)),
    column("boxes, cutoff 1000", "boxes", by_boxes<double, Exactly>(outwards, 1000)),
    column("boxes, half-open", "boxes", by_boxes<double, Exactly>(as_written, 1000, HALF_OPEN)),
    column("boxes of floats", "form", by_boxes<float, Squared_in<float>>(as_written, 1000)),
  };
  if(shape == Shape::BALL)
    for(const Object_column& other : {
          column("boxes as written", "form", by_boxes<double, Exactly>(as_written, 1000)),
          column("boxes, test in double", "form",
                 by_boxes<double, Squared_in<double>>(outwards, 1000)),
          column("boxes, Sphere_3", "library", by_boxes<double, As_spheres>(outwards, 1000)),
        })
      columns.push_back(other);
  columns.push_back(column("ours", "ours", by_search()));
  columns.push_back(column("ours, recursive route", "ours", by_recursive_route()));
  return columns;
}

} // namespace lab
