// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Methods without a kernel: the forms of distance_forms.h, cells and nanoflann.

#include "columns.h"

#include "methods/Cell_list.h"
#include "methods/distance_forms.h"
#include "methods/nanoflann.h"

#include <CGAL/Simple_cartesian.h>

namespace lab {
namespace {

using Double_kernel = CGAL::Simple_cartesian<double>;

template <class Form>
auto by_form()
{
  return on_points<Found, Arrays>([](const auto& points, double r, Found& found) {
    for_each_candidate(points, r, [&](std::size_t i, std::size_t j) {
      if(Form::is_near(points[i], points[j], r))
        found(i, j);
    });
  });
}

// ---- cells: candidates are decided exactly, so that only lost ones are wrong --------------------

struct By_division
{
  double r;
  double operator()(double x) const { return std::floor(x / r); }
};

struct By_inverse
{
  explicit By_inverse(double r) : inverse(1 / r) {}
  double inverse;
  double operator()(double x) const { return std::floor(x * inverse); }
};

template <class Cell_of>
Run<Found> by_cells(const Scene& scene)
{
  const Cell_of cell_of{test_support::upper_bound(radius_of(scene))};
  const auto search = [cell_of, exact = exact_points(scene)](const auto& points, Found& found) {
    const Cell_list cells(points, cell_of);
    cells.for_each_candidate([&](std::size_t i, std::size_t j) {
      if(exact.are_within_radius(i, j))
        found(i, j);
    });
  };
  return run_on_points<Found, Arrays>(scene, search);
}

// ---- libraries ----------------------------------------------------------------------------------

#ifdef THICK_BENCHMARK_HAS_NANOFLANN
auto by_nanoflann(double (*square)(double))
{
  return on_points<Found, Double_kernel>([square](const auto& points, double r, Found& found) {
    nanoflann_search(points, square(r), found);
  });
}

double open_square(double r) { return r * r; }
#endif

} // namespace

Columns plain_columns()
{
  return {
    {{"double", by_form<Squared_in<double>>()}, "form"},
    {{"double, sqrt", by_form<With_square_root>()}, "form"},
    {{"double, hypot", by_form<With_hypot>()}, "form"},
    {{"double, expanded", by_form<Expanded>()}, "form"},
    {{"float", by_form<Squared_in<float>>()}, "form"},
    {{"long double", by_form<Squared_in<long double>>()}, "form"},
    {{"grid, x / r", by_cells<By_division>}, "grid"},
    {{"grid, x * (1 / r)", by_cells<By_inverse>}, "grid"},
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
    {{"nanoflann, open", by_nanoflann(open_square)}, "library"},
    {{"nanoflann, closed", by_nanoflann(nanoflann_closed)}, "library"},
#endif
  };
}

} // namespace lab
