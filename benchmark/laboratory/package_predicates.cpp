// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// This package: the intersection test of its traits on several kernels, with wider arithmetic than
// most determinants need, and within a whole search.

#include "predicate_columns.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/thick_intersection_d.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace lab {
namespace {

using CGAL::Arithmetic_tier;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Objects>
using Traits_of = CGAL::Thick_object_traits_d<typename Objects::value_type>;

auto by_traits()
{
  return [](const auto& objects) {
    return Traits_of<std::decay_t<decltype(objects)>>(objects).do_intersect_d_object();
  };
}

// The first arithmetic behind the filter is `tier`. The counts have to live as long as the test.
template <class Objects>
auto test_by_tier(const Objects& objects, Arithmetic_tier tier)
{
  using Counts = CGAL::Thick_intersection_d::internal::Shared_decision_counts;
  const auto counts = std::make_shared<Counts>();
  Traits_of<Objects> traits(objects);
  traits.decide_by(tier, *counts);
  return [counts, test = traits.do_intersect_d_object()](const auto& a, const auto& b) {
    return test(a, b);
  };
}

auto by_tier(Arithmetic_tier tier)
{
  return [tier](const auto& objects) { return test_by_tier(objects, tier); };
}

// ---- the search ---------------------------------------------------------------------------------

// All pairs that a search reports, and the profile that it makes of the scene.
template <class Objects>
Pairs found_pairs(const Objects& objects)
{
  Pairs pairs;
  const auto append
    = [&](std::size_t i, std::size_t j) { pairs.push_back(std::minmax(i, j)); };
  CGAL::Scene_profile profile;
  CGAL::thick_self_intersection_d(objects, append, profile);
  return test_support::sorted(std::move(pairs));
}

Answers ask_search(const Object_questions& questions, double milliseconds)
{
  return with_maker(questions.objects.kind, [&](auto maker) {
    const auto objects = objects_of<Epick>(maker, questions.objects);
    return answers_of_search(questions, milliseconds, [&] { return found_pairs(objects); });
  });
}

} // namespace

Predicate_columns package_predicates()
{
  using Double_kernel = CGAL::Simple_cartesian<double>;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto forced = [](const std::string& name, Arithmetic_tier tier) {
    return predicate_column<Epick>("ours, " + name, "ours", by_tier(tier));
  };
  return {
    predicate_column<Epick>("ours, EPICK", "ours", by_traits()),
    predicate_column<Double_kernel>("ours, double", "ours", by_traits()),
    predicate_column<Epeck>("ours, EPECK", "ours", by_traits()),
    predicate_column<Rational_kernel>("ours, rational", "ours", by_traits()),
    forced("int128", Arithmetic_tier::INT128),
    forced("int192", Arithmetic_tier::INT192),
    forced("filter + exact", Arithmetic_tier::FILTERED_EXACT),
    {"ours, search", "ours", knows_closed, ask_search},
  };
}

} // namespace lab
