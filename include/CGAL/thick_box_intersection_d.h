// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_BOX_INTERSECTION_D_H
#define CGAL_THICK_BOX_INTERSECTION_D_H

// All intersecting pairs of iso-oriented boxes, in the place of CGAL::box_intersection_d().

#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/boxes/Numbered_boxes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_ranges_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace CGAL {

/// \ingroup PkgThickIntersectionDRef
/// The choices of `thick_box_intersection_d()`. Those of `CGAL::Box_intersection_d` are taken too.
namespace Thick_box_intersection_d {

/// whether two sequences are one sequence given twice, or two different sequences.
enum Setting {
  COMPLETE,   ///< One sequence is given twice.
  BIPARTITE   ///< The two sequences are different.
};

/// whether the upper ends belong to the boxes.
enum Topology {
  HALF_OPEN,   ///< Boxes that only touch do not intersect.
  CLOSED       ///< Boxes that touch intersect.
};

} // namespace Thick_box_intersection_d

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of boxes of a sequence that intersect, each exactly once.

The function takes the arguments of `CGAL::box_self_intersection_d()` and reports the same pairs,
with the same box first. Programs change the names of the header and of the function. For boxes of
any sizes in fixed dimension \f$ d \f$ it takes \f$ O(n \log^{d-1} n + k) \f$ time and \f$ O(n) \f$
space, where \f$ k \f$ is the number of intersecting pairs. Coordinates that are no doubles are
rounded first; then \f$ k \f$ counts the pairs of rounded boxes that touch or overlap. Beyond four
dimensions, it counts the pairs that do so along those axes that separate most boxes: eight for
boxes of \cgal and if `dimension()` of the box traits is a constant expression, four otherwise.

It differs in the following.
- The boxes are neither reordered nor copied. The callback gets the boxes of the user, so their
  addresses tell them. `const` iterators and forward iterators are fine.
- Coordinates have any number type with exact comparisons, such as `Exact_rational` and `long long`.
- Coordinates may be infinite, and as large as their type allows.
- The traits object is used, and may have a state.
- Boxes need no id.
- The header is under the LGPL.

Closed boxes intersect if they touch. Half-open boxes do not contain their upper ends, so boxes that
touch do not intersect. A half-open box that is a single number \f$ x \f$ along an axis intersects
the boxes that contain \f$ x \f$ in their interior. Along the first axis it also intersects the
boxes of lower id that begin at \f$ x \f$; this is what \cgal reports. A box with a lower end above
its upper end is empty and intersects no box.

Comparisons alone decide, so the result is exact. The two zeros are equal.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, the same pairs are reported
in any order. Several threads call the callback and the traits at once, so these must allow this.
`Parallel_tag` requires \tbb.

\tparam RandomAccessIterator has boxes, or pointers to boxes, as value type.

\tparam Callback is callable with two dereferenced iterators. If it returns `bool`, it stops the
search by returning `false`. Other results are ignored, as by \cgal.

\tparam BoxTraits is a model of the concept `BoxIntersectionTraits_d` of \cgal. Its functions need
not be static. It needs no types. Boxes are told by their positions if it has no function `id()`.

\tparam Topology is an enumeration with the enumerators `CLOSED` and `HALF_OPEN`.

\param begin, end the boxes.
\param callback is called for each pair. The first box is the one with the greater lower end along
the last axis. If these ends are equal, it is the one with the greater id. Boxes with the same id
are one box, and no pair.
\param box_traits reads boxes.
\param cutoff is ignored. There is nothing to tune.
\param topology whether boxes are closed or half-open.

\return `false` iff the callback stopped the search.

\throws std::invalid_argument if a coordinate is NaN, before anything is reported. The message gives
the position of the box. Exceptions of the callback and of the traits pass through.
\throws std::length_error if there are 2<sup>31</sup> - 1 boxes or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `thick_box_intersection_d()`
\sa `thick_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class RandomAccessIterator, class Callback,
          class BoxTraits, class Topology = Thick_box_intersection_d::Topology,
          class = std::enable_if_t<!std::is_arithmetic_v<BoxTraits>>>
bool thick_box_self_intersection_d(RandomAccessIterator begin, RandomAccessIterator end,
                                   Callback callback, BoxTraits box_traits,
                                   [[maybe_unused]] std::ptrdiff_t cutoff = 10,
                                   Topology topology = Topology::CLOSED)
{
  namespace internal = Thick_intersection_d::internal;
  const auto boxes = internal::make_elements_of(begin, end);
  const auto no_boxes = internal::make_elements_of(end, end);
  const internal::Box_rules rules = {topology == Topology::CLOSED, true};
  return internal::report_box_pairs<internal::One_set>(boxes, no_boxes, box_traits, rules, callback,
                                                       internal::Threads(ConcurrencyTag()));
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of boxes of a sequence that intersect, each exactly once, with default traits.

The default traits call the member functions `min_coord(i)` and `max_coord(i)` of a box, the static
member function `dimension()` and, if there is one, the member function `id()`. The boxes of
`CGAL::Box_intersection_d` have all of them.
*/
template <class ConcurrencyTag = Sequential_tag, class RandomAccessIterator, class Callback,
          class Topology = Thick_box_intersection_d::Topology>
bool thick_box_self_intersection_d(RandomAccessIterator begin, RandomAccessIterator end,
                                   Callback callback, std::ptrdiff_t cutoff = 10,
                                   Topology topology = Topology::CLOSED)
{
  using Handle = typename std::iterator_traits<RandomAccessIterator>::value_type;
  const Thick_intersection_d::internal::Box_members<Handle> box_traits;
  return thick_box_self_intersection_d<ConcurrencyTag>(begin, end, callback, box_traits, cutoff,
                                                       topology);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a box of one sequence and a box of another that intersect, each exactly once.

The function takes the arguments of `CGAL::box_intersection_d()` and reports the same pairs.
Otherwise it is as `thick_box_self_intersection_d()`, where \f$ n \f$ is the number of boxes of both
sequences and \f$ k \f$ is the number of intersecting pairs between them. The two sequences may be
one sequence, or overlap in memory. Their boxes may have different types if the traits take both.

\tparam Setting is an enumeration with the enumerators `BIPARTITE` and `COMPLETE`.

\param begin1, end1 the boxes of the first sequence.
\param begin2, end2 the boxes of the second sequence.
\param callback is called for each pair, with the box of the first sequence and the box of the
second. Boxes with the same id are no pair.
\param box_traits, cutoff, topology as for `thick_box_self_intersection_d()`.
\param setting `BIPARTITE` for all pairs. `COMPLETE` if the second sequence is the first or a copy
of it: each pair is then reported once, as by `thick_box_self_intersection_d()`, which does half the
work.

\return `false` iff the callback stopped the search.

\throws std::invalid_argument as `thick_box_self_intersection_d()`. Positions in the message go on
from the first sequence to the second.

\sa `thick_box_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class RandomAccessIterator1,
          class RandomAccessIterator2, class Callback, class BoxTraits,
          class Topology = Thick_box_intersection_d::Topology,
          class Setting = Thick_box_intersection_d::Setting,
          class = std::enable_if_t<!std::is_arithmetic_v<BoxTraits>>>
bool thick_box_intersection_d(RandomAccessIterator1 begin1, RandomAccessIterator1 end1,
                              RandomAccessIterator2 begin2, RandomAccessIterator2 end2,
                              Callback callback, BoxTraits box_traits,
                              [[maybe_unused]] std::ptrdiff_t cutoff = 10,
                              Topology topology = Topology::CLOSED,
                              Setting setting = Setting::BIPARTITE)
{
  namespace internal = Thick_intersection_d::internal;
  const auto boxes1 = internal::make_elements_of(begin1, end1);
  const auto boxes2 = internal::make_elements_of(begin2, end2);
  const internal::Box_rules rules = {topology == Topology::CLOSED, setting == Setting::COMPLETE};
  return internal::report_box_pairs<internal::Two_sets>(boxes1, boxes2, box_traits, rules, callback,
                                                        internal::Threads(ConcurrencyTag()));
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a box of one sequence and a box of another that intersect, each exactly once,
with the default traits of `thick_box_self_intersection_d()`.
*/
template <class ConcurrencyTag = Sequential_tag, class RandomAccessIterator1,
          class RandomAccessIterator2, class Callback,
          class Topology = Thick_box_intersection_d::Topology,
          class Setting = Thick_box_intersection_d::Setting>
bool thick_box_intersection_d(RandomAccessIterator1 begin1, RandomAccessIterator1 end1,
                              RandomAccessIterator2 begin2, RandomAccessIterator2 end2,
                              Callback callback, std::ptrdiff_t cutoff = 10,
                              Topology topology = Topology::CLOSED,
                              Setting setting = Setting::BIPARTITE)
{
  using Handle = typename std::iterator_traits<RandomAccessIterator1>::value_type;
  const Thick_intersection_d::internal::Box_members<Handle> box_traits;
  return thick_box_intersection_d<ConcurrencyTag>(begin1, end1, begin2, end2, callback, box_traits,
                                                  cutoff, topology, setting);
}

} // namespace CGAL

#endif // CGAL_THICK_BOX_INTERSECTION_D_H
