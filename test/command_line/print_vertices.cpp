// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Prints the vertices that CGAL's reader finds in a mesh, for compare_meshes.py. The status is 1 if
// it refuses the file.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

int main(int, char** argv)
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  const bool is_read = CGAL::IO::read_polygon_soup(std::string(argv[1]), points, faces);
  for(const auto& point : points)
    std::printf("%.17g %.17g %.17g\n", point.x(), point.y(), point.z());
  return is_read ? 0 : 1;
}
