// A user's first program: succeeds if, of three points, exactly the near pair is reported.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Thick_intersection_d/version.h>
#include <CGAL/config.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <cstddef>
#include <vector>

#if CGAL_THICK_INTERSECTION_D_VERSION_NR < CGAL_VERSION_NUMBER(0, 2, 0)
#error "This program needs Thick_intersection_d 0.2.0 or later."
#endif

int main()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::vector<Kernel::Point_2> points = {{0, 0}, {3, 0}, {3, 1}};
  std::size_t pairs = 0, near_pairs = 0;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(1),
                                    [&](std::size_t i, std::size_t j) {
                                      ++pairs;
                                      near_pairs += (i == 1 && j == 2);
                                    });
  return pairs == 1 && near_pairs == 1 ? 0 : 1;
}
