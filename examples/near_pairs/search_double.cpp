// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search with plain doubles in the points.

#include "closest_with_kernel.h"
#include "search_with_kernel.h"

#include <CGAL/Simple_cartesian.h>

namespace near_pairs {

Search_result search_double(const Scene& scene, const Options& options, const Pair_sink& sink)
{
  return search_with_kernel<CGAL::Simple_cartesian<double>>(scene, options, sink);
}

Closest_result closest_double(const Scene& scene, const Options& options)
{
  return closest_with_kernel<CGAL::Simple_cartesian<double>>(scene, options);
}

} // namespace near_pairs
