// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// This package: on several kernels, by both routes, by each arithmetic that is exact for a scene.

#include "columns.h"

#include "support/kernels.h"
#include "support/mpfr_kernel_number.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

namespace lab {
namespace {

using CGAL::Arithmetic_tier;
using Double_kernel = CGAL::Simple_cartesian<double>;
using test_support::with_bound;

template <class Kernel>
Run<Found> by_search(const Scene& scene)
{
  return with_bound(radius_of(scene), [&](const auto& bound) {
    return run_on_points<Found, Kernel>(scene, [bound](const auto& points, Found& found) {
      CGAL::fixed_radius_near_neighbors(points, bound, found);
    });
  });
}

// The traits alone see no scene, so that the filter is what decides first.
Run<Found> by_traits(const Scene& scene)
{
  return with_bound(radius_of(scene), [&](const auto& bound) {
    return run_on_points<Found, Double_kernel>(scene, [bound](const auto& points, Found& found) {
      using Point = typename std::decay_t<decltype(points)>::value_type;
      CGAL::thick_self_intersection_d(
        points, found, CGAL::parameters::geom_traits(CGAL::Thick_point_traits_d<Point>(bound)));
    });
  });
}

template <int Dimension, class Bound>
Arithmetic_tier needed_tier(const Scene& scene, const Bound& bound)
{
  return CGAL::profile_scene(make_points<Double_kernel, Dimension>(scene), bound).needed_tier();
}

// The search by a tier, or by the tier that the scene needs if that is a more general one.
template <Arithmetic_tier tier>
Run<Found> by_tier(const Scene& scene)
{
  return with_bound(radius_of(scene), [&](const auto& bound) {
    const Arithmetic_tier needed
      = scene.dimension == 2 ? needed_tier<2>(scene, bound) : needed_tier<3>(scene, bound);
    const auto search = [=](const auto& points, Found& found) {
      CGAL::Scene_profile profile;
      profile.force_tier((std::max)(tier, needed));
      CGAL::fixed_radius_near_neighbors(points, bound, found, profile);
    };
    return run_on_points<Found, Double_kernel>(scene, search);
  });
}

} // namespace

Columns package_columns()
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  using Mpfr_kernel = CGAL::Simple_cartesian<test_support::Mpfr_number<50>>;
  return {
    {{"ours, double", by_search<Double_kernel>}, "ours"},
    {{"ours, double, recursive route", by_traits}, "ours"},
    {{"ours, int64", by_tier<Arithmetic_tier::INT64>}, "ours"},
    {{"ours, int128", by_tier<Arithmetic_tier::INT128>}, "ours"},
    {{"ours, filter + exact", by_tier<Arithmetic_tier::FILTERED_EXACT>}, "ours"},
    {{"ours, EPICK", by_search<Epick>}, "ours"},
    {{"ours, EPECK", by_search<Epeck>}, "ours"},
    {{"ours, rational", by_search<CGAL::Simple_cartesian<CGAL::Exact_rational>>}, "ours"},
    {{"ours, Cartesian<Mpzf>", by_search<CGAL::Cartesian<CGAL::Mpzf>>}, "ours"},
    {{"ours, MPFR 169 bits", by_search<Mpfr_kernel>}, "ours"},
  };
}

} // namespace lab
