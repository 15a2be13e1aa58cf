// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_ROUTE_H

// Chooses the route of objects by their traits.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/segment_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {

template <class Object>
class Thick_object_traits_d;

namespace Thick_intersection_d {
namespace internal {

// Whether traits give the interval of an object along an axis.
template <class Traits, class = void>
struct Has_intervals : std::false_type {};
template <class Traits>
struct Has_intervals<Traits,
                     std::void_t<decltype(std::declval<const Traits&>().interval_d_object())>>
  : std::true_type {};

// Whether traits compare objects along axes, as the recursive route needs.
template <class Traits, class = void>
struct Has_close_predicate : std::false_type {};
template <class Traits>
struct Has_close_predicate<
  Traits, std::void_t<decltype(std::declval<const Traits&>().is_close_along_axis_d_object())>>
  : std::true_type {};

// The dimension of objects, or 0 if only the traits object knows it.
template <class Traits, class = void>
struct Object_dimension : std::integral_constant<int, 0> {};
template <class Traits>
struct Object_dimension<Traits, std::void_t<decltype(Traits::Dimension::value)>>
  : std::integral_constant<int, Traits::Dimension::value>
{};

// Whether traits make boxes of all intervals at once, and ask no more about boxes that meet, as
// those of kernel objects do. Their boxes are finite if check() has not thrown, so these objects
// never take the recursive route. A class that derives from these traits may ask something else.
template <class Traits>
struct Has_boxes : std::false_type {};
template <class Object>
struct Has_boxes<Thick_object_traits_d<Object>> : std::true_type {};

// Decides about objects by their boxes. A specialization for some traits may know more.
template <class Traits>
struct Box_filter_of_traits
{
  using type = void;
};

// Objects whose traits give intervals, as the box route reads them.
template <class Elements, class Traits>
class Traits_boxes : public Objects_in_boxes<Object_dimension<Traits>::value>
{
public:
  using Box_filter = typename Box_filter_of_traits<Traits>::type;

  Traits_boxes(const Elements& objects, const Traits& traits)
    : objects_(objects), traits_(traits), interval_(traits.interval_d_object()),
      do_intersect_(traits.do_intersect_d_object())
  {}

  std::size_t size() const { return objects_.size(); }
  int dimension() const { return traits_.dimension(); }

  auto intervals(std::size_t position) const
  {
    if constexpr(Has_boxes<Traits>::value)
      return intervals_of(Traits::box(objects_[position]));
    else
      return [this, position](int axis) {
        const std::pair<double, double> interval = interval_(objects_[position], axis);
        return Interval{interval.first, interval.second};
      };
  }

  // Boxes are as long as objects, and not longer, as those of Near_object_boxes are.
  double reach() const { return 0; }
  Interval with_reach(const Interval& interval) const { return interval; }

  bool are_exact() const
  {
    if constexpr(Has_boxes<Traits>::value)
      return Traits::do_boxes_decide && !traits_.is_counting();
    else
      return false;
  }

  void prefetch(std::size_t position) const { prefetch_object(objects_, position); }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    if constexpr(Has_boxes<Traits>::value)
      return do_intersect_.decide(objects_[i], objects_[j]);
    else
      return do_intersect_(objects_[i], objects_[j]);
  }

  // Returns whether all intervals are finite. Throws if an interval is empty or NaN.
  bool are_finite(const Threads& threads) const
  {
    if constexpr(Has_boxes<Traits>::value)
      return true;
    std::atomic<bool> are_finite = true;
    threads.check_each(size(), [&](std::size_t position) {
      if(!is_finite(position))
        are_finite.store(false, std::memory_order_relaxed);
    });
    return are_finite;
  }

private:
  // Throws if an interval of the object is empty or NaN.
  bool is_finite(std::size_t position) const
  {
    bool is_finite = true;
    for(int axis = 0; axis < dimension(); ++axis) {
      const Interval interval = intervals(position)(axis);
      if(!(interval.low <= interval.high))
        throw std::invalid_argument("The interval of object " + std::to_string(position)
                                    + " along axis " + std::to_string(axis)
                                    + " is empty or NaN.");
      is_finite = is_finite && std::isfinite(interval.low) && std::isfinite(interval.high);
    }
    return is_finite;
  }

  const Elements& objects_;
  const Traits& traits_;
  decltype(std::declval<const Traits&>().interval_d_object()) interval_;
  decltype(std::declval<const Traits&>().do_intersect_d_object()) do_intersect_;
};

template <class Traits, class Object, class = void>
struct Has_check : std::false_type {};
template <class Traits, class Object>
struct Has_check<Traits, Object,
                 std::void_t<decltype(std::declval<const Traits&>().check(
                   std::declval<const Object&>(), std::size_t()))>>
  : std::true_type {};

// Whether traits check the objects of a range, or of one of two.
template <class Traits, class Object>
struct Has_any_check : Has_check<Traits, Object>
{};
template <class Traits, class A, class B>
struct Has_any_check<Traits, One_of_two<A, B>>
  : std::disjunction<Has_check<Traits, std::decay_t<A>>, Has_check<Traits, std::decay_t<B>>>
{};

// Checks each object with the traits, if they have check() for its type, as the traits of the
// package do. Other traits have to check their objects themselves.
template <class Elements, class Traits>
void check_objects(const Elements& objects, const Traits& traits, const Threads& threads)
{
  if constexpr(Has_any_check<Traits, typename Elements::value_type>::value)
    threads.check_each(objects.size(), [&](std::size_t position) {
      of_range(objects[position], [&]([[maybe_unused]] const auto& object) {
        if constexpr(Has_check<Traits, std::decay_t<decltype(object)>>::value)
          traits.check(object, position);
      });
    });
}

// Reports the pairs by the route that the traits allow. Boxes of finite doubles are for the box
// route. Objects beyond the range of doubles have boxes that all meet there, so they take the
// recursive route, if the traits have its predicates.
template <class Elements, class Sets, class Traits, class Callback, class NamedParameters>
bool report_objects(const Elements& objects, const Sets& sets, const Traits& traits,
                    Callback& callback, const NamedParameters& np, const Threads& threads)
{
  auto progress = make_progress(np, objects.size());
  constexpr bool may_recurse = Has_close_predicate<Traits>::value && !Has_boxes<Traits>::value;
  if constexpr(Has_intervals<Traits>::value) {
    const Traits_boxes<Elements, Traits> boxes(objects, traits);
    const bool are_finite = boxes.are_finite(threads);
    if(are_finite || !may_recurse) {
      if constexpr(Sets::are_two && Has_boxes<Traits>::value
                   && Has_segments<typename Elements::value_type>::value
                   && are_tests_known_v<typename Elements::value_type>)
        return report_segment_pairs(boxes, objects, sets, callback, progress, threads);
      else
        return report_meeting_boxes(boxes, sets, callback, progress, threads);
    }
  }
  if constexpr(may_recurse) {
    const auto report = reporter_of(callback);
    return search_recursively(objects, sets, traits, report, progress, threads);
  }
  else
    return true;
}

// A specialization for some traits may take a faster route.
template <class Traits>
struct Object_route
{
  template <class Elements, class Sets, class Callback, class NamedParameters>
  static bool report(const Elements& objects, const Sets& sets, const Traits& traits,
                     Callback& callback, const NamedParameters& np, const Threads& threads)
  {
    check_objects(objects, traits, threads);
    return report_objects(objects, sets, traits, callback, np, threads);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_ROUTE_H
