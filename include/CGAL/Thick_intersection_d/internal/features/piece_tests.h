// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_PIECE_TESTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_PIECE_TESTS_H

// Whether two pieces of boundaries tell that their features are a pair.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/features/Interiors_overlap.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Pairs of features that intersect. Their pieces may meet where their boxes do.
struct Pieces_intersect
{
  template <class Pieces>
  static bool do_meet(const Pieces& pieces, std::size_t i, std::size_t j)
  {
    Arithmetic_tier tier = Arithmetic_tier::INT64;
    return do_objects_intersect(pieces.thick(i), pieces.thick(j), tier);
  }

  // Whether the first vertex of a part is inside a polygon, where boundaries do not meet.
  template <class Pieces>
  static bool is_inside(const Pieces& pieces, std::size_t part, std::size_t filled)
  {
    return pieces.is_inside(pieces.first_piece(part), filled);
  }

  static Interval grown(const Interval& interval) { return interval; }

  // Whether features are a pair if one is inside the other.
  static constexpr bool takes_insides() { return true; }
};

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
// in one range or in both. `Thick` is the type of pieces with their radii.
template <class Pieces, class Thick, class Relation, bool is_first_open, bool is_second_open>
struct Piece_test
{
  using type = Interiors_overlap<Pieces, is_first_open, is_second_open>;
};
template <class Pieces, class Thick, class Relation>
struct Piece_test<Pieces, Thick, Relation, false, false>
{
  using type = Relation;
};
template <class Pieces, class Thick, class NT>
struct Piece_test<Pieces, Thick, Distance_bound<NT>, false, false>
{
  using type = Pieces_near<Thick>;
};

template <class Test, class Relation>
Test make_piece_test(const Relation& relation, [[maybe_unused]] const Threads& threads)
{
  if constexpr(std::is_constructible_v<Test, const Relation&>)
    return Test(relation);
  else
    return Test(threads);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_PIECE_TESTS_H
