// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "kernel_search.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace thick_benchmark {

Search search_epeck(const Scene& scene)
{
  return kernel_search<CGAL::Exact_predicates_exact_constructions_kernel>(scene);
}

} // namespace thick_benchmark
