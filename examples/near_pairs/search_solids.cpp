// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of solids; see search_solids.h.

#include "search_solids.h"

#include "progress.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace near_pairs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Soup = std::pair<std::vector<Kernel::Point_3>, std::vector<std::array<std::size_t, 3>>>;

std::vector<Soup> soups_of(const std::vector<Feature>& solids)
{
  std::vector<Soup> soups;
  for(const Feature& solid : solids) {
    Soup& soup = soups.emplace_back();
    for(const std::array<double, 3>& point : solid.mesh.points)
      soup.first.emplace_back(point[0], point[1], point[2]);
    soup.second = solid.mesh.triangles;
  }
  return soups;
}

template <class ConcurrencyTag>
bool report_pairs_by(const std::vector<std::vector<Feature>>& sets, const Exact_bound& bound,
                     const Search_options& options, const Pair_functor& functor)
{
  Locked_functor callback(functor);
  const auto go_on = progress_functor(options.progress);
  const auto parameters = CGAL::parameters::callback(go_on);
  const std::vector<Soup> first = soups_of(sets.front());
  if(sets.size() == 1)
    return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, bound, callback, parameters);
  return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, soups_of(sets.back()), bound,
                                                          callback, parameters);
}

} // namespace

bool report_solid_pairs(const std::vector<std::vector<Feature>>& sets, const Exact_bound& bound,
                        const Search_options& options, const Pair_functor& functor)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    return report_pairs_by<CGAL::Parallel_tag>(sets, bound, options, functor);
#endif
  return report_pairs_by<CGAL::Sequential_tag>(sets, bound, options, functor);
}

} // namespace near_pairs
