// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search with CGAL's usual kernel, EPICK.

#include "search_with_kernel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace near_pairs {

Search_result search_epick(const Scene& scene, const Search_options& options,
                           const Pair_sink& sink)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return search_with_kernel<Kernel>(scene, options, sink);
}

} // namespace near_pairs
