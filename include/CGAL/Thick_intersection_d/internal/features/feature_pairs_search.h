// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H

// The searches behind thick_feature_self_intersection_d(), thick_feature_intersection_d() and
// fixed_radius_near_features().
//
// Of polylines and polygons, the pieces of all boundaries take the box route, and then the first
// vertices of parts and the polygons that these may be inside. If there are meshes, the features do
// themselves: first to find where they may meet others, and then as pairs that are decided.

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boundaries.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_insides.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_pieces.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_regions.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_pairs.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_pieces.h>
#include <CGAL/Thick_intersection_d/internal/features/check_feature_types.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/piece_tests.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Reports the pairs of first vertices of parts and polygons that they are inside, unless the
// features are a known pair, by put(a, b).
template <class Pieces, class Test, class Put, class Progress>
bool report_insides(const Pieces& pieces, const Part_range& parts, const Part_range& filled,
                    const Test& test, Known_pairs& known, const Put& put, Progress& progress,
                    const Threads& threads)
{
  const Feature_insides<Pieces, Test> insides(pieces, parts, filled, test, known);
  const auto take = [&](std::size_t i, std::size_t j) {
    return put(insides.feature_of(i), insides.feature_of(insides.point_count() + j));
  };
  return report_meeting_boxes(insides, Two_sets{insides.point_count()}, take, progress, threads);
}

// The same of one range, or of a feature of each of two.
template <class Pieces, class Sets, class Test, class Put, class Progress>
bool report_all_insides(const Pieces& pieces, const Sets& sets, const Test& test,
                        Known_pairs& known, const Put& put, Progress& progress,
                        const Threads& threads)
{
  const std::size_t part = pieces.first_part_from(sets.first_of_second());
  const std::size_t filled = pieces.first_filled_from(sets.first_of_second());
  const auto report = [&](const Part_range& of_parts, const Part_range& of_filled) {
    return report_insides(pieces, of_parts, of_filled, test, known, put, progress, threads);
  };
  const Part_range last_parts = {part, pieces.part_count()};
  const Part_range last_filled = {filled, pieces.filled_count()};
  if constexpr(Sets::are_two)
    return report({0, part}, last_filled) && report(last_parts, {0, filled});
  else
    return report(last_parts, last_filled);
}

// Reports the pairs of polylines and polygons: of those whose pieces pass the test, and then of
// those of which one is inside the other. Returns false iff the search was stopped.
template <class Pieces, class Features, class Sets, class Test, class Report,
          class NamedParameters>
bool report_pairs_without_faces(const Features& features, const Sets& sets, const Test& test,
                                Report& report, const NamedParameters& np, const Threads& threads)
{
  Pieces pieces;
  pieces.add_features(features);
  const bool has_insides = pieces.filled_count() != 0 && test.takes_insides();
  auto progress = make_progress(
    np, pieces.size() + (has_insides ? pieces.part_count() + pieces.filled_count() : 0));
  Known_pairs known(threads);
  const Feature_boundaries<Pieces, Test> boundaries(pieces, test, known);
  const std::size_t second = pieces.first_piece_from(sets.first_of_second());
  if(!report_meeting_groups(boundaries, sets, second, report, progress, threads))
    return false;
  const auto put = [&](std::size_t a, std::size_t b) { // those of the first range are smaller
    return report((std::min)(a, b), (std::max)(a, b) - sets.first_of_second());
  };
  if constexpr(Pieces::dimension == 2)
    return !has_insides
           || report_all_insides(pieces, sets, test, known, put, progress, threads);
  else
    return true;
}

// Reports the pairs of meshes and polylines.
template <class Pieces, class Features, class Sets, class Test, class Report,
          class NamedParameters>
bool report_solid_pairs(const Features& features, const Sets& sets, const Test& test,
                        Report& report, const NamedParameters& np, const Threads& threads)
{
  Feature_regions regions(features, test, threads);
  Unwatched_progress unwatched;
  report_meeting_boxes(regions, sets, report, unwatched, threads);
  const Pieces pieces(features, regions, test);
  const Solid_pairs<Features, Pieces, Test> pairs(features, regions, pieces, test, threads);
  auto progress = make_progress(np, pairs.size());
  return report_meeting_boxes(pairs, sets, report, progress, threads);
}

// Reports the pairs. `relation` is a bound, or the test of pieces itself. Returns false iff the
// search was stopped.
template <class Features, class Sets, class Relation, class Report, class NamedParameters>
bool report_feature_pairs(const Features& features, const Sets& sets, const Relation& relation,
                          Report& report, const NamedParameters& np, const Threads& threads)
{
  check_denormals();
  using First = std::decay_t<decltype(features.first())>;
  using Second = std::decay_t<decltype(features.second())>;
  using Piece = Common_piece<Piece_of_features<First>, Piece_of_features<Second>>;
  using Radius = Common_radius<Radius_of_features<First>, Radius_of_features<Second>>;
  using Thick = typename Thick_piece<Piece, Radius>::type;
  if constexpr(Vertex_count<Piece>::value == 2) {
    using Pieces = Feature_pieces<Piece, Radius>;
    using Test
      = typename Piece_test<Pieces, Thick, Relation, First::are_open, Second::are_open>::type;
    const auto test = make_piece_test<Test>(relation, threads);
    return report_pairs_without_faces<Pieces>(features, sets, test, report, np, threads);
  }
  else {
    using Test = typename Piece_test<void, Thick, Relation, false, false>::type;
    const auto test = make_piece_test<Test>(relation, threads);
    using Pieces = Solid_pieces<Piece, Radius, Test>;
    return report_solid_pairs<Pieces>(features, sets, test, report, np, threads);
  }
}

// Reports the pairs of features of one range, or of two, in the same way.
template <class Relation, class Callback, class NamedParameters, class... Ranges>
bool search_features(const Relation& relation, Callback& callback, const NamedParameters& np,
                     const Threads& threads, Ranges&... ranges)
{
  const auto search = [&](const auto& features, const auto& sets, auto& report) {
    if constexpr(check_feature_search<std::decay_t<decltype(features)>, NamedParameters>())
      return report_feature_pairs(features, sets, relation, report, np, threads);
    else
      return false;
  };
  return search_ranges<!is_bound_v<Relation>>(callback, np, threads, search, ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H
