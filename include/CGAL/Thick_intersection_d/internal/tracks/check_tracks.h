// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CHECK_TRACKS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CHECK_TRACKS_H

// What tracks are, and what is wrong with those that are none. A mistake in a call gets one
// sentence.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A fix as it is stored, or void for other types. Elements of a std::map have constant times.
template <class Fix>
struct Stored_fix : Named_type<void> {};
template <class Time, class Point>
struct Stored_fix<std::pair<Time, Point>>
{
  static constexpr int dimension = dimension_or<std::remove_const_t<Point>>(0);
  static constexpr bool is_fix = is_number_v<std::remove_const_t<Time>>
                                 && Is_point<std::remove_const_t<Point>>::value
                                 && (dimension == 2 || dimension == 3);
  using type = std::conditional_t<
    is_fix, std::pair<std::remove_const_t<Time>, std::remove_const_t<Point>>, void>;
};

// The type of the fixes of a track, or void for other types.
template <class Track, class = void>
struct Fix_of : Named_type<void> {};
template <class Track>
struct Fix_of<Track, std::enable_if_t<Is_range<const Track>::value>>
  : Stored_fix<std::decay_t<Reference_of<Iterator_of<const Track>>>>
{};
template <class Track>
using Fix_of_t = typename Fix_of<Track>::type;

// Checks tracks of two types, which may be the same. Returns whether a search can be compiled.
template <class First, class Second>
constexpr bool check_tracks()
{
  constexpr bool are_tracks
    = !std::is_void_v<Fix_of_t<First>> && !std::is_void_v<Fix_of_t<Second>>;
  constexpr bool are_alike = std::is_same_v<Fix_of_t<First>, Fix_of_t<Second>>;
  static_assert(are_tracks, "A track must be a range of std::pair<Time, Point>, with a number type "
                            "and points in the plane or in space. For others, pass a property map "
                            "to such tracks as point_map.");
  static_assert(are_alike || !are_tracks,
                "The tracks of the two ranges must have times and points of the same types.");
  return are_tracks && are_alike;
}

// Throws for a time: "The time of fix 1 of track 2 is ..."
[[noreturn]] inline void throw_wrong_time(std::size_t fix, std::size_t track, const char* what)
{
  std::string message("The time of fix ");
  message.append(std::to_string(fix)).append(" of track ").append(std::to_string(track));
  throw std::invalid_argument(message.append(what));
}

template <class Fix>
void check_fix(const Fix& fix, std::size_t number, std::size_t track)
{
  if(!is_finite_number(fix.first))
    throw_wrong_time(number, track, " is NaN or infinite.");
  for(int axis = 0; axis < dimension_or<typename Fix::second_type>(0); ++axis)
    if(!are_bounds_of_finite(coordinate_bounds(fix.second, axis))) {
      const std::string name = "fix " + std::to_string(number) + " of track";
      throw_not_finite(name.c_str(), track, axis);
    }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CHECK_TRACKS_H
