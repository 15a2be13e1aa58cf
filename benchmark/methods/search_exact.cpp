// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "kernel_search.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace thick_benchmark {

Search search_exact(const Scene& scene)
{
  return kernel_search<CGAL::Simple_cartesian<CGAL::Exact_rational>>(scene);
}

} // namespace thick_benchmark
