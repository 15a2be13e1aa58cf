// A user's first program: succeeds if, of three points, exactly the near pair is reported, and of
// many points on a line, all pairs of neighbors. With oneTBB, threads share the search.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Thick_intersection_d/version.h>
#include <CGAL/config.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_neighbor_lists.h>
#include <CGAL/tags.h>

#include <atomic>
#include <cstddef>
#include <vector>

#if CGAL_THICK_INTERSECTION_D_VERSION_NR < CGAL_VERSION_NUMBER(0, 2, 0)
#error "This program needs Thick_intersection_d 0.2.0 or later."
#endif

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool finds_pair()
{
  const std::vector<Kernel::Point_2> points = {{0, 0}, {3, 0}, {3, 1}};
  std::size_t pairs = 0, near_pairs = 0;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(1),
                                    [&](std::size_t i, std::size_t j) {
                                      ++pairs;
                                      near_pairs += (i == 1 && j == 2);
                                    });
  return pairs == 1 && near_pairs == 1;
}

bool finds_neighbors_on_line()
{
  using Tag = CGAL::Parallel_if_available_tag;
  constexpr std::size_t size = 100000;
  std::vector<Kernel::Point_3> points;
  for(std::size_t i = 0; i < size; ++i)
    points.emplace_back(static_cast<double>(i) / 8, 0.5, static_cast<double>(i % 2));
  const auto bound = CGAL::within_distance(0.25);
  std::atomic<std::size_t> pairs = 0;
  CGAL::fixed_radius_near_neighbors<Tag>(points, bound, [&](std::size_t i, std::size_t j) {
    pairs += j == i + 2;
  });
  return pairs == size - 2
         && CGAL::fixed_radius_neighbor_lists<Tag>(points, bound).number_of_pairs() == size - 2;
}

int main() { return finds_pair() && finds_neighbors_on_line() ? 0 : 1; }
