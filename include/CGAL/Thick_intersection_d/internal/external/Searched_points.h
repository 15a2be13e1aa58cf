// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H

// The points of a part as elements of a search, which reports them by their ids.

#include <CGAL/Thick_intersection_d/internal/external/Id_places.h>
#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A search reports points by numbers of 32 bits. If it reported places, the ids of both points of
// each pair would have to be looked up, and they are all over the memory. So the number of a point
// that the part owns is its id, with the first bit set, if that has room. The number of any other
// point is its place, which has less than 32 bits. Only for near ties, a point is found by its id.
template <int Dimension>
class Searched_points
{
public:
  using value_type = Stored_point<Dimension>;

  // The part stays where it is.
  explicit Searched_points(const Loaded_points<Dimension>& part)
    : points_(part.columns().points), ids_(part.columns().ids), size_(part.size()),
      owned_(part.owned()), places_(part, ids_end)
  {}

  std::size_t size() const { return size_; }
  const value_type& operator[](std::size_t place) const { return points_[place]; }

  Place number(std::size_t place) const
  {
    const std::uint64_t id = ids_[place];
    return static_cast<Place>(place < owned_ && id < ids_end ? first_id + id : place);
  }

  // A place is its own place.
  std::size_t place(std::size_t number) const
  {
    return is_id(number) ? places_(short_id(number)) : number;
  }

  // Whether a number is an id. Then short_id() tells which.
  static bool is_id(std::size_t number) { return number >= first_id; }
  static std::uint64_t short_id(std::size_t number) { return number - first_id; }

  std::uint64_t id(std::size_t number) const
  {
    return is_id(number) ? short_id(number) : ids_[number];
  }

  bool is_owned(std::size_t number) const { return is_id(number) || number < owned_; }

private:
  static constexpr std::size_t first_id = std::size_t(1) << 31;
  static constexpr std::uint64_t ids_end = max_place - first_id;

  const value_type* points_;
  const std::uint64_t* ids_;
  std::size_t size_;
  std::size_t owned_;
  Id_places<Dimension> places_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H
