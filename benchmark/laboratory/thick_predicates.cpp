// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// This package about objects with radii, open objects and solids: its tests on several kernels, and
// whole searches. And CGAL's distances of segments.

#include "predicate_columns.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/interiors.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <algorithm>
#include <array>
#include <utility>

namespace lab {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

bool knows_thick(const Kind& kind) { return kind.meaning == Meaning::THICK; }
bool knows_open(const Kind& kind) { return kind.meaning == Meaning::OPEN; }

template <class Kernel, class Maker>
auto thickened_objects_of(Maker maker, const Object_set& set)
{
  const auto objects = objects_of<Kernel>(maker, set);
  std::vector<std::pair<std::decay_t<decltype(objects[0])>, typename Kernel::FT>> thickened;
  for(std::size_t i = 0; i < objects.size(); ++i)
    thickened.emplace_back(objects[i], typename Kernel::FT(set.radius(i)));
  return thickened;
}

// The sorted pairs that search(callback) reports.
template <class Search>
Pairs pairs_of(const Search& search)
{
  Pairs pairs;
  search([&](std::size_t i, std::size_t j) { pairs.push_back(std::minmax(i, j)); });
  return test_support::sorted(std::move(pairs));
}

// ---- radii --------------------------------------------------------------------------------------

// Of make_predicate(objects), the predicate about two of them.
template <class Kernel, class Make_predicate>
Predicate_column thick_column(const std::string& name, const std::string& group,
                              const Make_predicate& make_predicate)
{
  return {name, group, knows_thick, [=](const Object_questions& questions, double milliseconds) {
            return with_segments_maker(questions.objects.kind, [&](auto maker) {
              const auto objects = thickened_objects_of<Kernel>(maker, questions.objects);
              const auto predicate = make_predicate(objects);
              return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
                return predicate(objects[i], objects[j]);
              });
            });
          }};
}

auto by_squared_distance()
{
  return [](const auto&) {
    return [](const auto& a, const auto& b) {
      return CGAL::squared_distance(a.first, b.first) <= CGAL::square(a.second + b.second);
    };
  };
}

auto by_thick_traits()
{
  return [](const auto& objects) {
    using Object = typename std::decay_t<decltype(objects)>::value_type;
    return CGAL::Thick_object_traits_d<Object>(objects).do_intersect_d_object();
  };
}

Answers search_thick(const Object_questions& questions, double milliseconds)
{
  return with_segments_maker(questions.objects.kind, [&](auto maker) {
    const auto objects = thickened_objects_of<Epick>(maker, questions.objects);
    return answers_of_search(questions, milliseconds, [&] {
      return pairs_of([&](auto report) { CGAL::thick_self_intersection_d(objects, report); });
    });
  });
}

// ---- interiors ----------------------------------------------------------------------------------

template <class Kernel>
Predicate_column open_column(const std::string& name)
{
  const auto ask = [](const Object_questions& questions, double milliseconds) {
    return with_thick_maker(questions.objects.kind, [&](auto maker) {
      const auto objects = objects_of<Kernel>(maker, questions.objects);
      using Object = typename decltype(objects)::value_type;
      using namespace CGAL::Thick_intersection_d::internal;
      using Traits = Traits_of_interiors<Object, true, true>;
      const auto test = Traits().do_intersect_d_object();
      return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
        return test.decide(objects[i], objects[j]);
      });
    });
  };
  return {name, "ours", knows_open, ask};
}

Answers search_open(const Object_questions& questions, double milliseconds)
{
  return with_thick_maker(questions.objects.kind, [&](auto maker) {
    const auto objects = objects_of<Epick>(maker, questions.objects);
    return answers_of_search(questions, milliseconds, [&] {
      return pairs_of([&](auto report) {
        CGAL::thick_self_intersection_d(CGAL::interiors(objects), report);
      });
    });
  });
}

Answers search_polygons(const Object_questions& questions, double milliseconds)
{
  std::vector<CGAL::Polygon_2<Epick>> polygons;
  for(const auto& t : objects_of<Epick>(Triangles_2(), questions.objects)) {
    const Epick::Point_2 vertices[] = {t[0], t[1], t[2]};
    polygons.emplace_back(vertices, vertices + 3);
  }
  return answers_of_search(questions, milliseconds, [&] {
    return pairs_of([&](auto report) {
      CGAL::thick_feature_self_intersection_d(CGAL::interiors(polygons), report);
    });
  });
}

// ---- solids -------------------------------------------------------------------------------------

Answers search_solids(const Object_questions& questions, double milliseconds)
{
  using Soup = std::pair<std::vector<Epick::Point_3>, std::vector<std::array<int, 3>>>;
  std::vector<Soup> solids;
  for(const auto& t : objects_of<Epick>(Tetrahedra_3(), questions.objects))
    solids.push_back({{t[0], t[1], t[2], t[3]}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}});
  return answers_of_search(questions, milliseconds, [&] {
    return pairs_of([&](auto report) { CGAL::thick_feature_self_intersection_d(solids, report); });
  });
}

} // namespace

Predicate_columns thick_predicates()
{
  using Double_kernel = CGAL::Simple_cartesian<double>;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  return {
    thick_column<Double_kernel>("squared_distance, double", "form", by_squared_distance()),
    thick_column<Epick>("squared_distance, EPICK", "kernel", by_squared_distance()),
    thick_column<Epeck>("squared_distance, EPECK", "kernel", by_squared_distance()),
    thick_column<Epick>("ours, EPICK", "ours", by_thick_traits()),
    thick_column<Epeck>("ours, EPECK", "ours", by_thick_traits()),
    thick_column<Rational_kernel>("ours, rational", "ours", by_thick_traits()),
    open_column<Epick>("ours, EPICK"),
    open_column<Epeck>("ours, EPECK"),
    open_column<Rational_kernel>("ours, rational"),
    {"ours, search", "ours", knows_thick, search_thick},
    {"ours, search", "ours", knows_open, search_open},
    {"ours, search", "ours",
     [](const Kind& kind) { return kind.meaning == Meaning::SOLID; }, search_solids},
    {"ours, polygons", "ours",
     [](const Kind& kind) { return knows_open(kind) && kind.dimension == 2; }, search_polygons},
  };
}

} // namespace lab
