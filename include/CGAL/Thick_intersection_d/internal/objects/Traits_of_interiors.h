// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TRAITS_OF_INTERIORS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TRAITS_OF_INTERIORS_H

// The traits of objects of which some, or all, are without their boundaries.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Thick_object_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_shapes_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/interiors.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <atomic>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether objects of a kind, without a radius, have an interior unless they are degenerate.
template <class Kind>
constexpr bool is_solid_kind()
{
  if constexpr(Vertex_count<Kind>::value == 0)
    return false;
  else
    return is_iso_box_v<Kind> || Vertex_count<Kind>::value > vertex_dimension_v<Kind>;
}

// Whether interiors() takes objects of a kind.
template <class Kind>
struct May_be_open : std::bool_constant<is_solid_kind<Kind>() || Is_thickened<Kind>::value>
{};

// The question whether two objects intersect of which at least one is open.
struct Do_open_vertices_intersect
{
  template <class Orientation, Shape A, Shape B>
  bool ask(Asked_vertices<Orientation, A, B>& vertices, Arithmetic_tier& tier) const
  {
    return ask_vertices<Orientation, A, B>(
      vertices, tier, [this](Orientation& orientation, const auto& a, const auto& b) {
        return do_open_shapes_intersect<A, B>(orientation, a, b, is_a_open, is_b_open);
      });
  }

  static constexpr bool knows_common_vertex = false;

  Do_open_vertices_intersect swapped() const { return {is_b_open, is_a_open}; }

  bool is_a_open;
  bool is_b_open;
};

// Whether an object without a radius has an interior: then that meets the object.
template <class Object>
bool has_interior_points(const Object& object)
{
  if constexpr(is_solid_kind<Object>()) {
    Arithmetic_tier tier = Arithmetic_tier::INT64;
    return ask_kernel_objects(Do_open_vertices_intersect{true, false}, object, object, tier);
  }
  else
    return false;
}

// Returns whether the radius of an object is above zero.
template <class Object>
bool is_thick([[maybe_unused]] const Object& object)
{
  if constexpr(Is_thickened<Object>::value)
    return object.second > typename Object::second_type(0);
  else
    return false;
}

// Whether two objects of one known kind each intersect.
//
// The interior of an object with a radius above zero is all that is closer to it than the radius.
// So it meets another object iff the two are closer than the sum of the radii. The same holds for
// an open object without a radius, if it has an interior, and another one with a radius: if they
// are closer, so are points of the interior, and if not, only points of the boundary are at the
// least distance, because a convex function that is above zero has no least value inside.
template <bool Is_a_open, bool Is_b_open, class A, class B>
bool do_open_kinds_intersect(const A& a, const B& b, Arithmetic_tier& tier)
{
  const auto& hull_a = hull_points(a);
  const auto& hull_b = hull_points(b);
  const bool is_a_thick = is_thick(a), is_b_thick = is_thick(b);
  if constexpr(Is_thickened<A>::value || Is_thickened<B>::value)
    if(is_a_thick || is_b_thick) {
      if((Is_a_open && !is_a_thick && !has_interior_points(hull_a))
         || (Is_b_open && !is_b_thick && !has_interior_points(hull_b)))
        return false;
      using Exact = typename Common_exact_number<std::tuple<A, B>>::type;
      Hull_bound touching;
      touching.is_open = true;
      const auto no_distance = [] { return Squared_bound<Exact>(within_distance(0).open()); };
      return are_kinds_near(a, b, touching, no_distance, tier);
    }
  if constexpr((Is_a_open && !is_solid_kind<Hull_points_t<A>>())
               || (Is_b_open && !is_solid_kind<Hull_points_t<B>>()))
    return false;
  else
    return ask_kernel_objects(Do_open_vertices_intersect{Is_a_open, Is_b_open}, hull_a, hull_b,
                              tier);
}

// Objects of one range, or of two. The first one is of the first range.
template <class Object, bool Is_first_open, bool Is_second_open>
class Traits_of_interiors : public Thick_object_traits_d<Object>
{
public:
  class Do_intersect_d
  {
  public:
    bool decide(const Object& a, const Object& b) const
    {
      Arithmetic_tier tier = least_tier_;
      const bool do_intersect = with_kinds(a, b, [&](const auto& x, const auto& y) {
        return do_open_kinds_intersect<Is_first_open, Is_second_open>(x, y, tier);
      });
      if(counts_ != nullptr)
        counts_->add(tier);
      return do_intersect;
    }

  private:
    friend class Traits_of_interiors;
    Arithmetic_tier least_tier_ = Arithmetic_tier::INT64;
    Shared_decision_counts* counts_ = nullptr;
  };

  static constexpr bool do_boxes_decide = false;

  void decide_by(Arithmetic_tier tier, Shared_decision_counts& counts)
  {
    do_intersect_.least_tier_ = tier;
    do_intersect_.counts_ = &counts;
  }

  Do_intersect_d do_intersect_d_object() const { return do_intersect_; }

private:
  Do_intersect_d do_intersect_;
};

template <class Object, bool Is_first_open, bool Is_second_open>
struct Has_boxes<Traits_of_interiors<Object, Is_first_open, Is_second_open>>
  : std::true_type {};

// Boxes of doubles without their upper ends. They meet iff the interiors of the boxes do, and iff
// one of these meets the other box, unless a box is flat.
template <class Elements, class Traits>
class Half_open_boxes : public Traits_boxes<Elements, Traits>
{
  using Base = Traits_boxes<Elements, Traits>;

public:
  using Base::Base;

  auto intervals(std::size_t position) const
  {
    return [intervals = Base::intervals(position)](int axis) { return half_open(intervals(axis)); };
  }

  bool are_exact() const { return true; }

  bool have_flat(const Threads& threads) const
  {
    std::atomic<bool> have_flat = false;
    threads.check_each(this->size(), [&](std::size_t position) {
      const auto intervals = Base::intervals(position);
      for(int axis = 0; axis < this->dimension(); ++axis)
        if(!(intervals(axis).low < intervals(axis).high))
          have_flat.store(true, std::memory_order_relaxed);
    });
    return have_flat;
  }
};

// A search with a profile asks about each pair instead, and counts.
template <class Object, bool Is_first_open, bool Is_second_open>
struct Object_route<Traits_of_interiors<Object, Is_first_open, Is_second_open>>
{
  template <class Elements, class Sets, class Traits, class Callback, class NamedParameters>
  static bool report(const Elements& objects, const Sets& sets, const Traits& traits,
                     Callback& callback, const NamedParameters& np, const Threads& threads)
  {
    check_objects(objects, traits, threads);
    if constexpr(Kinds<Object>::template are_all<Is_box_of_doubles>) {
      const Half_open_boxes<Elements, Traits> boxes(objects, traits);
      if(!boxes.have_flat(threads)) {
        auto progress = make_progress(np, objects.size());
        return report_meeting_boxes(boxes, sets, callback, progress, threads);
      }
    }
    return report_objects(objects, sets, traits, callback, np, threads);
  }
};

// The first and the second range of a search, which may be one.
template <class Elements>
using First_range = std::decay_t<decltype(std::declval<const Elements&>().first())>;
template <class Elements>
using Second_range = std::decay_t<decltype(std::declval<const Elements&>().second())>;

template <class Elements>
inline constexpr bool have_interiors_v
  = First_range<Elements>::are_open || Second_range<Elements>::are_open;

template <class Range>
constexpr bool are_kinds_with_interiors()
{
  using Object_kinds = Kinds<typename Range::value_type>;
  return Object_kinds::template are_all<Is_known_kind>
         && (!Range::are_open || Object_kinds::template are_all<May_be_open>);
}

// Checks that open objects have an interior, and that those beside them are of the package.
template <class Elements, class NamedParameters>
constexpr bool check_open_objects()
{
  constexpr bool have_none = !have_interiors_v<Elements>;
  constexpr bool has_traits
    = !parameters::is_default_parameter<NamedParameters, internal_np::geom_traits_t>::value;
  constexpr bool are_kinds = are_kinds_with_interiors<First_range<Elements>>()
                             && are_kinds_with_interiors<Second_range<Elements>>()
                             && are_tests_known_v<typename Elements::value_type>;
  static_assert(have_none || !has_traits,
                "geom_traits decide about objects as they are: pass them without interiors().");
  static_assert(have_none || has_traits || are_kinds,
                "interiors() takes objects with an interior: triangles in the plane, tetrahedra, "
                "iso-boxes, and objects with a radius. Beside them may be other objects of a "
                "kernel.");
  return have_none || (!has_traits && are_kinds);
}

// The traits of objects of the package.
template <class Elements>
using Default_traits = std::conditional_t<
  have_interiors_v<Elements>,
  Traits_of_interiors<typename Elements::value_type, First_range<Elements>::are_open,
                      Second_range<Elements>::are_open>,
  Thick_object_traits_d<typename Elements::value_type>>;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TRAITS_OF_INTERIORS_H
