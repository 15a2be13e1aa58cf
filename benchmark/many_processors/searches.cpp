// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "make_search.h"
#include "searches.h"

#include "scenes/generators.h"
#include "scenes/object_generators.h"

#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_neighbor_lists.h>

#include <cmath>
#include <cstdint>

namespace thick_benchmark {

namespace {

template <int Dimension>
Many_search near_pairs(const Scene& scene)
{
  const auto points = shared_points<Dimension>(scene);
  return search_of_pairs([points, bound = CGAL::within_distance(scene.r)](auto tag,
                                                                          const auto& callback) {
    CGAL::fixed_radius_near_neighbors<decltype(tag)>(*points, bound, callback);
  });
}

template <int Dimension>
Many_search neighbor_lists(const Scene& scene)
{
  const auto points = shared_points<Dimension>(scene);
  const auto search = [points, bound = CGAL::within_distance(scene.r)](auto tag, auto& lists) {
    lists = CGAL::fixed_radius_neighbor_lists<decltype(tag)>(*points, bound);
  };
  return search_of_lists(search);
}

template <int Dimension>
Many_search closest_pair(const Scene& scene)
{
  const auto points = shared_points<Dimension>(scene);
  return search_of_pairs([points](auto tag, const auto& callback) {
    const auto [i, j]
      = CGAL::closest_pair<decltype(tag)>(*points, CGAL::parameters::random_seed(1));
    callback(i, j);
  });
}

// The pairs of a scene, up to a limit.
std::uint64_t count_pairs(const Scene& scene, std::uint64_t limit)
{
  std::uint64_t count = 0;
  CGAL::fixed_radius_near_neighbors(*shared_points<2>(scene), CGAL::within_distance(scene.r),
                                    [&](std::size_t, std::size_t) { return ++count <= limit; });
  return count;
}

std::size_t root(std::size_t n)
{
  return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
}

} // namespace

std::vector<Many_row> many_rows()
{
  using Triangle = From_corners<Epick::Triangle_3, Epick::Point_3, 3>;
  const auto sparse = [](int dimension, std::size_t n) {
    return uniform(dimension, n, static_cast<double>(n) / 2);
  };
  const auto dense = [](int dimension, std::size_t n) {
    return uniform(dimension, n, 10 * static_cast<double>(n));
  };
  return {
    {"2D near pairs, k ~ n/2", 33, [=](auto n) { return near_pairs<2>(sparse(2, n)); }},
    {"2D near pairs, k ~ 10 n", 33, [=](auto n) { return near_pairs<2>(dense(2, n)); }},
    {"2D near pairs, lattice", 33, [](auto n) { return near_pairs<2>(lattice(2, root(n), 1)); }},
    {"2D near pairs, clusters", 28,
     [](auto n) { return near_pairs<2>(with_fitting_distance(clusters(2, n), count_pairs)); }},
    {"3D near pairs, k ~ n/2", 28, [=](auto n) { return near_pairs<3>(sparse(3, n)); }},
    {"3D near pairs, k ~ 10 n", 28, [=](auto n) { return near_pairs<3>(dense(3, n)); }},
    {"2D lists, k ~ n/2", 20, [=](auto n) { return neighbor_lists<2>(sparse(2, n)); }},
    {"2D lists, k ~ 10 n", 20, [=](auto n) { return neighbor_lists<2>(dense(2, n)); }},
    {"3D lists, k ~ 10 n", 20, [=](auto n) { return neighbor_lists<3>(dense(3, n)); }},
    {"2D closest pair", 14, [=](auto n) { return closest_pair<2>(sparse(2, n)); }},
    {"3D closest pair", 14, [=](auto n) { return closest_pair<3>(sparse(3, n)); }},
    {"2D squares by a power law", 24,
     [](auto n) { return objects<Rectangle_from_numbers>(power_law_boxes(2, n, double(n))); }},
    {"3D triangles, k ~ n/2", 30,
     [](auto n) { return objects<Triangle>(uniform_triangles(n, double(n) / 2)); }},
  };
}

} // namespace thick_benchmark
