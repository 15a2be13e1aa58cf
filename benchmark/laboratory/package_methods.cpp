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

template <class Kernel, int Dimension>
auto kernel_points(const Point_scene& scene)
{
  return test_support::make_points<test_support::Cartesian_points<Kernel, Dimension>>(
    scene.points);
}

template <class Kernel, int Dimension>
Found find(const Point_scene& scene)
{
  const auto points = kernel_points<Kernel, Dimension>(scene);
  return test_support::with_bound(scene.radius, [&](const auto& bound) {
    return timed(false,
                 [&](Pairs& pairs) { pairs = test_support::near_pairs(points, bound); });
  });
}

// The traits alone see no scene, so that the filter is what decides first.
template <class Kernel, int Dimension>
Found find_by_the_book(const Point_scene& scene)
{
  const auto points = kernel_points<Kernel, Dimension>(scene);
  return test_support::with_bound(scene.radius, [&](const auto& bound) {
    return timed(false, [&](Pairs& pairs) {
      pairs = test_support::near_pairs_by_recursion(points, bound, Dimension);
    });
  });
}

// The search by a tier, or by the tier that the scene needs if that is a more general one.
template <int Dimension, CGAL::Arithmetic_tier tier>
Found find_by_tier(const Point_scene& scene)
{
  const auto points = kernel_points<CGAL::Simple_cartesian<double>, Dimension>(scene);
  return test_support::with_bound(scene.radius, [&](const auto& bound) {
    CGAL::Scene_profile profile;
    profile.force_tier((std::max)(tier, CGAL::profile_scene(points, bound).needed_tier()));
    return timed(false, [&](Pairs& pairs) {
      const auto append = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
      CGAL::fixed_radius_near_neighbors(points, bound, append, profile);
    });
  });
}

template <int Dimension>
std::vector<Method> methods()
{
  using Double_kernel = CGAL::Simple_cartesian<double>;
  return {
    {"ours, double", "ours", find<Double_kernel, Dimension>},
    {"ours, double, book route", "ours", find_by_the_book<Double_kernel, Dimension>},
    {"ours, int64", "ours", find_by_tier<Dimension, CGAL::Arithmetic_tier::INT64>},
    {"ours, int128", "ours", find_by_tier<Dimension, CGAL::Arithmetic_tier::INT128>},
    {"ours, filter + exact", "ours",
     find_by_tier<Dimension, CGAL::Arithmetic_tier::FILTERED_EXACT>},
    {"ours, EPICK", "ours", find<CGAL::Exact_predicates_inexact_constructions_kernel, Dimension>},
    {"ours, EPECK", "ours", find<CGAL::Exact_predicates_exact_constructions_kernel, Dimension>},
    {"ours, rational", "ours", find<CGAL::Simple_cartesian<CGAL::Exact_rational>, Dimension>},
    {"ours, Cartesian<Mpzf>", "ours", find<CGAL::Cartesian<CGAL::Mpzf>, Dimension>},
    {"ours, MPFR 169 bits", "ours",
     find<CGAL::Simple_cartesian<test_support::Mpfr_number<50>>, Dimension>},
  };
}

} // namespace

std::vector<Method> package_methods(int dimension)
{
  return dimension == 2 ? methods<2>() : methods<3>();
}

} // namespace lab
