// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGES_H

// Points moved by offsets, as elements of a search. A moved coordinate is a sum that is never
// rounded. The search reads doubles that enclose it, and asks for the sum itself only if these do
// not decide, as with the points of a lazy kernel.

#include <CGAL/Dimension.h>
#include <CGAL/Interval_nt.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The point at a position, moved.
template <int Dimension>
struct Image
{
  Place position;
  Offset<Dimension> offset;
};

// `Source` is a reference to a point, or a copy.
template <class Source, int Dimension, class Exact>
class Image_point
{
  using Moves = Periods<Dimension, Exact>;

public:
  using Ambient_dimension = Dimension_tag<Dimension>;

  Image_point(Source&& source, const Image<Dimension>& image, const Moves& periods)
    : source_(std::forward<Source>(source)), image_(image), periods_(periods)
  {}

  int dimension() const { return Dimension; }

  Exact cartesian(int axis) const
  {
    return periods_.moved(coordinate(source_, axis), image_.offset, axis);
  }

  // Doubles that enclose the coordinates.
  struct Approximation
  {
    const Image_point& point;

    Interval_nt<false> cartesian(int axis) const
    {
      return point.periods_.moved_bounds(point.source_, point.image_.offset, axis);
    }
  };
  Approximation approx() const { return {*this}; }

private:
  Source source_;
  const Image<Dimension>& image_;
  const Moves& periods_;
};

template <class Elements, int Dimension, class Exact>
class Images
{
  using Source = decltype(std::declval<const Elements&>()[0]);

public:
  using value_type = Image_point<Source, Dimension, Exact>;

  Images(const Elements& points, const Periods<Dimension, Exact>& periods,
         const std::vector<Image<Dimension>>& images)
    : points_(points), periods_(periods), images_(images)
  {}

  std::size_t size() const { return images_.size(); }

  value_type operator[](std::size_t position) const
  {
    const Image<Dimension>& image = images_[position];
    return {points_[image.position], image, periods_};
  }

  // Prefetches the point that is moved.
  void prefetch(std::size_t position) const { prefetch_point(points_, images_[position].position); }

private:
  const Elements& points_;
  const Periods<Dimension, Exact>& periods_;
  const std::vector<Image<Dimension>>& images_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGES_H
