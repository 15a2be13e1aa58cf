// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search and the closest pair with exact rational numbers in the points.

#include "closest_with_kernel.h"
#include "search_with_kernel.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace near_pairs {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Search_result search_exact(const Scene& scene, const Search_options& options,
                           const Pair_sink& sink, const Pair_sink& lost)
{
  return search_with_kernel<Kernel>(scene, options, sink, lost);
}

Closest_result closest_exact(const Scene& scene, const Search_options& options)
{
  return closest_with_kernel<Kernel>(scene, options);
}

} // namespace near_pairs
