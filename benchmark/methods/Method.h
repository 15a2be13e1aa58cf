// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The interface of all methods: a name, and a way from a scene to an answer. An answer is the
// callback at the same time. It is told pairs, answer(i, j), or neighbours, answer.neighbour(i, j),
// by methods that ask for the neighbours of one point after the other; then it is told (j, i), too,
// and perhaps (i, i).

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_METHOD_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_METHOD_H

#include "scenes/Scene.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace thick_benchmark {

template <class Answer>
using Run = std::function<Answer()>;

template <class Answer, class Scene = thick_benchmark::Scene>
struct Method
{
  std::string name;
  // Makes the points or objects in the method's own type. What it returns can be run as often as
  // wanted.
  std::function<Run<Answer>(const Scene&)> prepare;
};

// A way to the pairs of a scene that tells how many there are.
struct Counted
{
  std::string name;
  Run<std::size_t> count;
};

// ---- to make them -------------------------------------------------------------------------------

// Of search(points, answer), on the points of a kernel.
template <class Answer, class Kernel, int Dimension, class Search>
Run<Answer> run_on_points_d(const Scene& scene, const Search& search)
{
  using Points = std::vector<Point_t<Kernel, Dimension>>;
  const auto points = std::make_shared<const Points>(make_points<Kernel, Dimension>(scene));
  return [points, search] {
    Answer answer;
    search(*points, answer);
    return answer;
  };
}

template <class Answer, class Kernel, class Search>
Run<Answer> run_on_points(const Scene& scene, const Search& search)
{
  return scene.dimension == 2 ? run_on_points_d<Answer, Kernel, 2>(scene, search)
                              : run_on_points_d<Answer, Kernel, 3>(scene, search);
}

// Of search(points, r, answer).
template <class Answer, class Kernel, class Search>
auto on_points(const Search& search)
{
  return [search](const Scene& scene) {
    return run_on_points<Answer, Kernel>(
      scene, [search, r = scene.r](const auto& points, Answer& answer) {
        search(points, r, answer);
      });
  };
}

// std::sort of the x-coordinates, the measure of all methods. It finds nothing.
template <class Answer>
Run<Answer> sort_of_x(const Scene& scene)
{
  return [unsorted = x_coordinates(scene)] {
    std::vector<double> x = unsorted;
    std::sort(x.begin(), x.end());
    return Answer();
  };
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_METHOD_H
