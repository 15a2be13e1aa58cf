// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers of coordinates that are doubles, and the sample of a scene, in the library that
// programs link if they define CGAL_THICK_INTERSECTION_D_COMPILED.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene_sample.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>

#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template class Squared_bound<Exact_of_doubles>;
template Squared_bound<Exact_of_doubles>::Squared_bound(const Distance_bound<double>&);
template Squared_bound<Exact_of_doubles>::Squared_bound(const Distance_bound<Exact_of_doubles>&);
template void add_exact_square(Exact_of_doubles&, const double&, const double&);
template Sign compare_exactly(const Exact_of_doubles&, const Exact_of_doubles&);
template Distance_filter make_distance_filter(const Squared_bound<Exact_of_doubles>&, int);
template Distance_filter make_certified_filter(const Squared_bound<Exact_of_doubles>&);
template Distance_filter widen(
  const Distance_filter&, const Squared_bound<Exact_of_doubles>&, double);
template Scaled_filter scaled_filter(
  const Squared_bound<Exact_of_doubles>&, const Scene&, const Scaled_filter&);
template void Scene_sample::add_axis(std::vector<double>&, Double_grid&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
