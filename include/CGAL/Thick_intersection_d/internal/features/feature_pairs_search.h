// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H

// The searches behind thick_feature_self_intersection_d(), thick_feature_intersection_d() and
// fixed_radius_near_features(): the pieces of all boundaries take the box route, and then the first
// vertices of parts and the polygons and solids that these may be inside.

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/Asked_features.h>
#include <CGAL/Thick_intersection_d/internal/features/Everywhere.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boundaries.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boxes.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_insides.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_pieces.h>
#include <CGAL/Thick_intersection_d/internal/features/Meeting_features.h>
#include <CGAL/Thick_intersection_d/internal/features/check_feature_types.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/piece_tests.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Where the second range begins, in the numberings of features, parts, filled ones and pieces. If
// there is one range, this is at zero.
struct Feature_ranges
{
  std::size_t features = 0;
  std::size_t parts = 0;
  std::size_t filled = 0;
  std::size_t pieces = 0;
};

template <class Sets>
Sets sets_of(std::size_t first_size)
{
  Sets sets = {};
  if constexpr(Sets::are_two)
    sets.first_size = first_size;
  return sets;
}

template <class Sets, class Pieces, class Report>
class Feature_search
{
public:
  Feature_search(const Pieces& pieces, const Feature_ranges& second, Report& report,
                 const Threads& threads)
    : pieces_(pieces), second_(second), report_(report), threads_(threads), known_(threads)
  {}

  // Reports the pairs of features whose pieces pass the test. Returns false iff the search was
  // stopped.
  template <class Test, class Progress>
  bool search_boundaries(const Test& test, Progress& progress)
  {
    const Feature_boundaries<Pieces, Test> boundaries(pieces_, test, known_);
    const auto take = [&](std::size_t i, std::size_t j) {
      return put(pieces_.feature_of(i), pieces_.feature_of(second_.pieces + j));
    };
    return report_meeting_boxes(boundaries, sets_of<Sets>(second_.pieces), take, progress,
                                threads_);
  }

  // Then reports those of which one is inside the other. The second range of filled ones begins at
  // `second_filled`.
  template <class Filled, class Test, class Progress>
  bool search_insides(const Filled& filled, std::size_t second_filled, const Test& test,
                      Progress& progress)
  {
    const Part_range first_parts = {0, second_.parts};
    const Part_range first_filled = {0, second_filled};
    const Part_range last_parts = {second_.parts, pieces_.part_count()};
    const Part_range last_filled = {second_filled, filled.filled_count()};
    if constexpr(Sets::are_two)
      return search_insides(first_parts, filled, last_filled, test, progress)
             && search_insides(last_parts, filled, first_filled, test, progress);
    else
      return search_insides(last_parts, filled, last_filled, test, progress);
  }

private:
  template <class Filled, class Test, class Progress>
  bool search_insides(const Part_range& parts, const Filled& filled, const Part_range& range,
                      const Test& test, Progress& progress)
  {
    const Feature_insides<Pieces, Filled, Test> insides(pieces_, parts, filled, range, test,
                                                        known_);
    const auto take = [&](std::size_t i, std::size_t j) {
      return put(insides.feature_of(i), insides.feature_of(insides.point_count() + j));
    };
    return report_meeting_boxes(insides, Two_sets{insides.point_count()}, take, progress, threads_);
  }

  // Reports a pair of features. Those of the first range have the smaller numbers.
  auto put(std::size_t a, std::size_t b)
  {
    return report_((std::min)(a, b), (std::max)(a, b) - second_.features);
  }

  const Pieces& pieces_;
  const Feature_ranges second_;
  Report& report_;
  const Threads threads_;
  Known_pairs known_;
};

// Reads the features of one range, or of two. Returns where the second one begins.
template <class Sets, class First, class Second, class Pieces, class Where>
Feature_ranges read_features(const First& first, const Second& second, Pieces& pieces,
                             const Where& where)
{
  Feature_ranges ranges;
  pieces.add_features(first, where);
  if constexpr(Sets::are_two) {
    ranges = {pieces.feature_count(), pieces.part_count(), pieces.filled_count(), pieces.size()};
    pieces.add_features(second, where);
  }
  return ranges;
}

// Reports the pairs of polylines and polygons. Returns false iff the search was stopped.
template <class Sets, class Pieces, class First, class Second, class Test, class Report,
          class NamedParameters>
bool report_pairs_without_faces(const First& first, const Second& second, const Test& test,
                                Report& report, const NamedParameters& np, const Threads& threads)
{
  Pieces pieces;
  const Feature_ranges ranges = read_features<Sets>(first, second, pieces, Everywhere());
  const bool has_insides = pieces.filled_count() != 0 && test.takes_insides();
  auto progress = make_progress(
    np, pieces.size() + (has_insides ? pieces.part_count() + pieces.filled_count() : 0));
  Feature_search<Sets, Pieces, Report> search(pieces, ranges, report, threads);
  if(!search.search_boundaries(test, progress))
    return false;
  if constexpr(Pieces::dimension == 2)
    return !has_insides || search.search_insides(pieces, ranges.filled, test, progress);
  else
    return true;
}

// The same of meshes and polylines. First come the boxes of features. Faces are read where these
// meet, and all faces of a mesh if a vertex of another feature may be inside.
template <class Sets, class Pieces, class First, class Second, class Test, class Report,
          class NamedParameters>
bool report_solid_pairs(const First& first, const Second& second, const Test& test, Report& report,
                        const NamedParameters& np, const Threads& threads)
{
  Feature_boxes boxes;
  boxes.add_features(first);
  if constexpr(Sets::are_two)
    boxes.add_features(second);
  Meeting_features<Test> meeting(boxes, test, threads);
  meeting.search(sets_of<Sets>(first.size()), threads);
  Pieces pieces;
  const Feature_ranges ranges = read_features<Sets>(first, second, pieces, meeting);
  const bool has_insides = test.takes_insides();
  auto progress = make_progress(
    np, pieces.size() + (has_insides ? pieces.part_count() + boxes.size() : 0));
  Feature_search<Sets, Pieces, Report> search(pieces, ranges, report, threads);
  if(!search.search_boundaries(test, progress))
    return false;
  if(!has_insides)
    return true;
  const Asked_features asked(boxes);
  if(!search.search_insides(asked, ranges.features, test, progress))
    return false;
  Pieces solids;
  const Feature_ranges solid_ranges = read_features<Sets>(first, second, solids, asked);
  Unwatched_progress unwatched;
  return search.search_insides(solids, solid_ranges.filled, test, unwatched);
}

// Reports the pairs. `relation` is a bound, or the test of pieces itself. Returns false iff the
// search was stopped.
template <class Sets, class First, class Second, class Relation, class Callback,
          class NamedParameters>
bool report_feature_pairs(const First& first, const Second& second, const Relation& relation,
                          Callback& callback, const NamedParameters& np, const Threads& threads)
{
  check_denormals();
  using Pieces
    = Feature_pieces<Common_piece<Piece_of_features<First>, Piece_of_features<Second>>,
                     Common_radius<Radius_of_features<First>, Radius_of_features<Second>>>;
  using Test = typename Piece_test<Pieces, Relation, First::are_open, Second::are_open>::type;
  const auto test = make_piece_test<Test>(relation, threads);
  auto&& report = pair_output(first, second, callback, threads);
  if constexpr(Pieces::have_faces)
    return report_solid_pairs<Sets, Pieces>(first, second, test, report, np, threads);
  else
    return report_pairs_without_faces<Sets, Pieces>(first, second, test, report, np, threads);
}

// Reports the pairs of features of a range.
template <class Range, class Relation, class Callback, class NamedParameters>
bool search_features(Range& range, const Relation& relation, Callback& callback,
                     const NamedParameters& np, const Threads& threads)
{
  if constexpr(check_feature_search<Relation, Callback, NamedParameters, Range, Range>()) {
    const auto elements = make_elements(range, np);
    return report_feature_pairs<One_set>(elements, elements, relation, callback, np, threads);
  }
  else
    return false;
}

// The same of two ranges.
template <class First, class Second, class Relation, class Callback,
          class NamedParameters>
bool search_features(First& first, Second& second, const Relation& relation, Callback& callback,
                     const NamedParameters& np, const Threads& threads)
{
  if constexpr(check_feature_search<Relation, Callback, NamedParameters, First, Second>())
    return report_feature_pairs<Two_sets>(make_elements(first, np), make_elements(second, np),
                                          relation, callback, np, threads);
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H
