// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which curves intersect: arcs of circles of an exact circular kernel, whose points are algebraic
// numbers of degree 2. The search asks for their bbox() and do_intersect(), and for nothing else,
// and finds what comparing all pairs finds.

#include <CGAL/Exact_circular_kernel_2.h> // under the GPL, unlike the package
#include <CGAL/point_generators_2.h>
#include <CGAL/thick_intersection_d.h>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_circular_kernel_2;
using Point = Kernel::Point_2;
using Arc = Kernel::Circular_arc_2;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// The arcs of rails, cams and cutters: from a point through another one to a third.
std::vector<Arc> make_arcs(std::size_t count)
{
  CGAL::Random random(3);
  const auto near = [&](int x) { return x + random.get_int(-40, 41); };
  std::vector<Arc> arcs;
  while(arcs.size() < count) {
    const int x = random.get_int(0, 1000), y = random.get_int(0, 1000);
    const Point p(near(x), near(y)), q(near(x), near(y)), r(near(x), near(y));
    if(!CGAL::collinear(p, q, r))
      arcs.emplace_back(p, q, r);
  }
  return arcs;
}

int main()
{
  const std::vector<Arc> arcs = make_arcs(600);
  Pairs found;
  CGAL::thick_self_intersection_d(arcs, std::back_inserter(found));

  Pairs expected;
  for(std::size_t i = 0; i < arcs.size(); ++i)
    for(std::size_t j = i + 1; j < arcs.size(); ++j)
      if(do_intersect(arcs[i], arcs[j]))
        expected.emplace_back(i, j);
  std::sort(found.begin(), found.end());
  std::cout << found.size() << " pairs of arcs intersect, "
            << (found == expected ? "as" : "not as") << " comparing all pairs says\n";
  return found == expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
