// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PAIRS_SEARCH_H

// The searches behind thick_feature_self_intersection_d(), thick_feature_intersection_d() and
// fixed_radius_near_features(): the pieces of all boundaries take the box route, and then the first
// vertices of parts and the polygons and solids that these may be inside.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boundaries.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_insides.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_pieces.h>
#include <CGAL/Thick_intersection_d/internal/features/Interiors_overlap.h>
#include <CGAL/Thick_intersection_d/internal/features/Known_pairs.h>
#include <CGAL/Thick_intersection_d/internal/features/Meeting_features.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/near_objects_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Pairs of features that are within a bound. If one is inside the other, their distance is zero.
template <class Object>
class Pieces_near : public Pieces_intersect
{
public:
  template <class NT>
  explicit Pieces_near(const Distance_bound<NT>& bound)
    : are_near_(bound, Arithmetic_tier::INT64, nullptr),
      takes_zero_(!bound.is_open() || bound.value() != NT(0))
  {}

  template <class Pieces>
  bool do_meet(const Pieces& pieces, std::size_t i, std::size_t j) const
  {
    return are_near_(pieces.thick(i), pieces.thick(j));
  }

  // Two intervals meet if their distance is at most the reach.
  Interval grown(const Interval& interval) const { return longer(interval, are_near_.reach()); }

  bool takes_insides() const { return takes_zero_; }

private:
  const Are_objects_near<Object> are_near_;
  const bool takes_zero_;
};

// The test of pieces for features that intersect, or that are within a bound, or whose interiors do
// in one range or in both.
template <class Pieces, class Relation, bool is_first_open, bool is_second_open>
struct Piece_test
{
  using type = Interiors_overlap<Pieces, is_first_open, is_second_open>;
};
template <class Pieces>
struct Piece_test<Pieces, Pieces_intersect, false, false>
{
  using type = Pieces_intersect;
};
template <class Pieces, class NT>
struct Piece_test<Pieces, Distance_bound<NT>, false, false>
{
  using type = Pieces_near<typename Pieces::Thick>;
};

template <class Test, class Relation>
Test make_piece_test(const Relation& relation, [[maybe_unused]] const Threads& threads)
{
  if constexpr(std::is_constructible_v<Test, const Relation&>)
    return Test(relation);
  else
    return Test(threads);
}

// Where the second range begins, in the numberings of features, parts, filled ones and pieces. If
// there is one range, this is at zero.
struct Feature_ranges
{
  std::size_t features = 0;
  std::size_t parts = 0;
  std::size_t filled = 0;
  std::size_t pieces = 0;
};

template <class Sets, class Pieces, class Report, class Progress>
class Feature_search
{
public:
  Feature_search(const Pieces& pieces, const Feature_ranges& second, Report& report,
                 Progress& progress, const Threads& threads)
    : pieces_(pieces), second_(second), report_(report), progress_(progress), threads_(threads),
      known_(threads)
  {}

  // Reports the pairs of features whose pieces pass the test, and then those of which one is inside
  // the other. Returns false iff the search was stopped.
  template <class Test>
  bool search(const Test& test)
  {
    const Feature_boundaries<Pieces, Test> boundaries(pieces_, test, known_);
    Sets sets = {};
    if constexpr(Sets::are_two)
      sets.first_size = second_.pieces;
    const auto take = [&](std::size_t i, std::size_t j) {
      return put(pieces_.feature_of(i), pieces_.feature_of(second_.pieces + j));
    };
    return report_meeting_boxes(boundaries, sets, take, progress_, threads_)
           && (pieces_.filled_count() == 0 || !test.takes_insides() || search_insides(test));
  }

private:
  template <class Test>
  bool search_insides(const Test& test)
  {
    const Part_range first_parts = {0, second_.parts};
    const Part_range first_filled = {0, second_.filled};
    const Part_range last_parts = {second_.parts, pieces_.part_count()};
    const Part_range last_filled = {second_.filled, pieces_.filled_count()};
    if constexpr(Sets::are_two)
      return search_insides(test, first_parts, last_filled)
             && search_insides(test, last_parts, first_filled);
    else
      return search_insides(test, last_parts, last_filled);
  }

  template <class Test>
  bool search_insides(const Test& test, const Part_range& parts, const Part_range& filled)
  {
    if constexpr(Pieces::may_be_filled) {
      const Feature_insides<Pieces, Test> insides(pieces_, test, parts, filled, known_);
      const auto take = [&](std::size_t i, std::size_t j) {
        return put(insides.feature_of(i), insides.feature_of(insides.point_count() + j));
      };
      return report_meeting_boxes(insides, Two_sets{insides.point_count()}, take, progress_,
                                  threads_);
    }
    else
      return true;
  }

  // Reports a pair of features. Those of the first range have the smaller numbers.
  auto put(std::size_t a, std::size_t b)
  {
    return report_((std::min)(a, b), (std::max)(a, b) - second_.features);
  }

  const Pieces& pieces_;
  const Feature_ranges second_;
  Report& report_;
  Progress& progress_;
  const Threads threads_;
  Known_pairs known_;
};

// Reads the features of one range, or of two. Returns where the second one begins.
template <class Sets, class First, class Second, class Pieces, class Is_wanted>
Feature_ranges read_features(const First& first, const Second& second, Pieces& pieces,
                             const Is_wanted& is_wanted)
{
  Feature_ranges ranges;
  pieces.add_features(first, is_wanted);
  if constexpr(Sets::are_two) {
    ranges = {pieces.feature_count(), pieces.part_count(), pieces.filled_count(), pieces.size()};
    pieces.add_features(second, is_wanted);
  }
  return ranges;
}

// The same, where meshes are read only if their boxes meet others.
template <class Sets, class First, class Second, class Pieces, class Test>
Feature_ranges read_features(const First& first, const Second& second, Pieces& pieces,
                             const Test& test, const Threads& threads)
{
  if constexpr(!Pieces::have_faces)
    return read_features<Sets>(first, second, pieces, [](std::size_t) { return true; });
  else {
    Feature_boxes boxes;
    boxes.add_features(first);
    Sets sets = {};
    if constexpr(Sets::are_two) {
      sets.first_size = first.size();
      boxes.add_features(second);
    }
    Meeting_features<Test> features(boxes, test);
    features.search(sets, threads);
    return read_features<Sets>(first, second, pieces,
                               [&](std::size_t position) { return features.has_met(position); });
  }
}

// Reads the features, and reports the pairs. `relation` is a bound, or the test of pieces itself.
// Returns false iff the search was stopped.
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
  Pieces pieces;
  const Feature_ranges ranges = read_features<Sets>(first, second, pieces, test, threads);
  const bool has_insides = pieces.filled_count() != 0 && test.takes_insides();
  auto&& report = pair_output(first, second, callback, threads);
  auto progress = make_progress(
    np, pieces.size() + (has_insides ? pieces.part_count() + pieces.filled_count() : 0));
  using Report = std::remove_reference_t<decltype(report)>;
  return Feature_search<Sets, Pieces, Report, decltype(progress)>(pieces, ranges, report, progress,
                                                                  threads)
    .search(test);
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
