// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_RANGES_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_RANGES_SEARCH_H

// The searches behind thick_box_self_intersection_d() and thick_box_intersection_d().

#include <CGAL/Iterator_range.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Meeting_boxes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Numbered_boxes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How CGAL reports pairs. In a complete search, the first box of a pair comes after the second box
// along the last axis. So a pair is reported once, also if the second range is a copy of the first.
struct Box_rules
{
  bool are_closed;
  bool is_complete;
};

// Hands the boxes of each pair to the user's callback, by the rules.
template <class Boxes, class Meeting, class Sets, class Callback>
class Box_reporter
{
public:
  Box_reporter(const Boxes& boxes, const Meeting& meeting, bool is_complete, Callback& callback)
    : boxes_(boxes), meeting_(meeting), is_complete_(is_complete), callback_(callback)
  {}

  // Returns false to stop the search.
  bool operator()(std::size_t i, std::size_t j) const
  {
    const int last_axis = boxes_.dimension() - 1;
    if constexpr(Sets::are_two) {
      j += boxes_.first_size();
      if(meeting_.are_same(i, j) || (is_complete_ && !meeting_.comes_before(j, i, last_axis)))
        return true;
      return call(boxes_.of_first_range(i), boxes_.of_second_range(j));
    }
    else {
      if(meeting_.are_same(i, j))
        return true;
      if(meeting_.comes_before(i, j, last_axis))
        std::swap(i, j);
      return call(boxes_.of_first_range(i), boxes_.of_first_range(j));
    }
  }

private:
  // CGAL ignores what a callback returns. Here `bool` alone has a meaning.
  template <class A, class B>
  bool call(A&& a, B&& b) const
  {
    if constexpr(std::is_same_v<std::invoke_result_t<Callback&, A, B>, bool>)
      return callback_(std::forward<A>(a), std::forward<B>(b));
    else {
      callback_(std::forward<A>(a), std::forward<B>(b));
      return true;
    }
  }

  const Boxes& boxes_;
  const Meeting& meeting_;
  const bool is_complete_;
  Callback& callback_;
};

// The dimension of boxes, or 0 if it is no constant.
template <class Traits, class = void>
struct Static_dimension : std::integral_constant<int, 0> {};
template <class Traits>
struct Static_dimension<Traits, std::void_t<std::integral_constant<int, Traits::dimension()>>>
  : std::integral_constant<int, Traits::dimension()> {};

template <class First, class Second, class Callback>
constexpr bool check_box_search()
{
  using A = decltype(std::declval<const First&>().element(0));
  using B = decltype(std::declval<const Second&>().element(0));
  constexpr bool takes_boxes = std::is_invocable_v<Callback&, A, B>;
  static_assert(takes_boxes, "The callback must take two boxes, as the iterators give them.");
  return takes_boxes;
}

// The box route is faster for more boxes.
inline constexpr std::size_t max_few_boxes = 64;

// Whether boxes of doubles in the plane or in space meet. No branch, because none is predictable.
template <class Box>
bool do_few_boxes_meet(const Box& a, const Box& b)
{
  unsigned are_apart = 0;
  for(std::size_t axis = 0; axis < a.size(); ++axis)
    are_apart |= unsigned(a[axis].high < b[axis].low) | unsigned(b[axis].high < a[axis].low);
  return are_apart == 0;
}

// Reports the pairs of few boxes that doubles decide about: each with each, on the stack, in the
// order of the user. Returns false iff the search was stopped.
template <int Dimension, class Meeting, class Sets, class Report>
BOOST_NOINLINE bool report_few_boxes(const Meeting& meeting, [[maybe_unused]] const Sets& sets,
                                     const Report& report)
{
  std::size_t first = 0, end = meeting.size(); // of the second set, and of the first one
  if constexpr(Sets::are_two)
    first = end = sets.first_size;
  std::array<std::array<Interval, Dimension>, max_few_boxes> boxes;
  for(std::size_t i = 0; i < meeting.size(); ++i)
    for(int axis = 0; axis < Dimension; ++axis)
      boxes[i][axis] = meeting.intervals(i)(axis);
  for(std::size_t i = 0; i < end; ++i)
    for(std::size_t j = (std::max)(i + 1, first); j < meeting.size(); ++j)
      if(do_few_boxes_meet(boxes[i], boxes[j]) && !report(i, j - first))
        return false;
  return true;
}

// Checks the boxes, and reports the pairs. Returns false iff the search was stopped.
template <class Sets, class First, class Second, class Traits, class Callback>
bool report_box_pairs(const First& first, const Second& second, const Traits& traits,
                      const Box_rules& rules, Callback& callback, const Threads& threads)
{
  if constexpr(check_box_search<First, Second, Callback>()) {
    check_denormals();
    using Boxes = Numbered_boxes<First, Second, Traits>;
    const Boxes boxes(first, second, traits);
    using Meeting = Meeting_boxes<Static_dimension<Traits>::value, Boxes>;
    const Meeting meeting(boxes, rules.are_closed);
    Box_reporter<Boxes, Meeting, Sets, Callback> report(boxes, meeting, rules.is_complete,
                                                        callback);
    Sets sets = {};
    if constexpr(Sets::are_two)
      sets.first_size = boxes.first_size();
    if constexpr(constexpr int dimension = Static_dimension<Traits>::value;
                 dimension == 2 || dimension == 3)
      if(boxes.size() <= max_few_boxes && meeting.are_exact())
        return report_few_boxes<dimension>(meeting, sets, report);
    Unwatched_progress progress;
    return report_meeting_boxes(meeting, sets, report, progress, threads);
  }
  else
    return false;
}

template <class Iterator>
auto make_elements_of(Iterator begin, Iterator end)
{
  return Numbered_elements<Iterator_range<Iterator>>(make_range(begin, end));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_RANGES_SEARCH_H
