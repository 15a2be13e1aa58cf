// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NUMBERED_TEST_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NUMBERED_TEST_H

// The test of a sweep over runs that have numbers instead of positions (Slab_lists.h).

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` is a test for Near_sweep. `Lists` has position(number).
template <class Test, class Lists>
class Numbered_test
{
public:
  using Run = typename Test::Run;

  Numbered_test(const Test& test, const Lists& lists) : test_(test), lists_(lists) {}

  decltype(auto) question() const { return test_.question(); }

  void ask_for(const Run& a, const Run& b, Found_pair pair) const
  {
    with_positions(a, b, pair, [&](const Run& p, const Run& q) { test_.ask_for(p, q, {0, 0}); });
  }

  bool is_pair(const Run& a, const Run& b, Found_pair pair, Decision_counts& counts) const
  {
    bool is_pair = false;
    with_positions(a, b, pair, [&](const Run& p, const Run& q) {
      is_pair = test_.is_pair(p, q, {0, 0}, counts);
    });
    return is_pair;
  }

private:
  // Calls task(p, q) with the runs of the two points of a pair, with their positions.
  template <class Task>
  void with_positions(const Run& a, const Run& b, Found_pair pair, const Task& task) const
  {
    const Place i = lists_.position(a.positions[pair.i]);
    const Place j = lists_.position(b.positions[pair.j]);
    task(run_of(a, pair.i, i), run_of(b, pair.j, j));
  }

  // Returns the run of one point, with its position.
  static Run run_of(const Run& run, Place place, const Place& position)
  {
    Run point = run;
    for(auto& column : point.x)
      column += place;
    point.positions = &position;
    point.size = 1;
    return point;
  }

  const Test& test_;
  const Lists& lists_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NUMBERED_TEST_H
