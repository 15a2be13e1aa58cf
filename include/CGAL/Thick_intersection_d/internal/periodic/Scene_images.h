// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H

// The images of points that a periodic search needs besides the points.
//
// Each point has a home: the point itself in an iso-box, or else an image of it in or near one cell
// of the lattice. An offset m between the homes of two points has components m_1, m_2, ... in the
// basis of the lattice. The pairs of homes with m = 0 are those of a search without periods. Of
// other pairs, each is that of a home and of a home moved by an offset whose first component that
// is not zero is positive, with one of two opposite offsets. So these offsets are enough, and give
// each pair once.
//
// Let f_k be how many times vector k goes into a home, f_k' into another home, and R_k into a
// vector of the length of the bound at most. If the first home and the moved other one are within
// the bound, then |f_k - f_k' - m_k| <= R_k. So m_k is within R_k of the range of f_k minus f_k',
// and f_k is within R_k of the upper end of its range where m_k is positive. These conditions are
// tested with room for all rounding, so no pair is lost. They are necessary only: the search
// decides about what they leave.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_fractions.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension, class Exact>
class Scene_images
{
  using Fractions = std::array<double, Dimension>;

public:
  // Takes points whose homes are themselves, or points anywhere if `are_wrapped`. Throws
  // std::length_error if a point or the bound is too many periods long.
  template <class Elements, class Sets>
  CGAL_RARELY_CALLED
  Scene_images(const Elements& points, const Sets& sets, const Periods<Dimension, Exact>& periods,
               const Lattice_basis<Dimension>& basis, const Cell_fractions<Dimension>& fractions,
               double reach, bool are_wrapped)
    : periods_(periods), basis_(basis), fractions_(fractions), are_wrapped_(are_wrapped)
  {
    low_ends_.fill(-1); // where there is no vector, points are at zero
    high_ends_.fill(1);
    for(int k = 0; k < basis.rank(); ++k)
      set_range(k, reach);
    add_points(points, sets);
  }

  // Whether the home of a point is not the point itself. Only then there are homes.
  bool are_moved() const { return are_moved_; }
  const std::vector<Image<Dimension>>& homes() const { return homes_; }

  // The homes near which other images may be, and then these images.
  const std::vector<Image<Dimension>>& near() const { return near_; }
  std::size_t first_near_size() const { return first_near_size_; }
  bool have_near() const { return first_near_size_ != 0 && first_near_size_ != near_.size(); }

private:
  void set_range(int k, double reach)
  {
    const double error = fractions_.error(k);
    Interval range = are_wrapped_ ? Interval{-error, 1 + error} : fractions_.range(k);
    reaches_[k] = fractions_.fraction_of(k, reach);
    if(!(reaches_[k] < max_offset / 4) || !(range.length() < max_offset / 4))
      throw std::length_error("The bound or the scene is too many periods long.");
    const double slack = 2 * error + 0x1p-45 * (range.high - range.low + reaches_[k] + 2
                                                + std::fabs(range.low));
    reaches_[k] += slack;
    ranges_[k] = range;
    low_ends_[k] = range.high - 1 + reaches_[k];
    high_ends_[k] = range.low + 1 - reaches_[k];
  }

  template <class Elements, class Sets>
  BOOST_NOINLINE void add_points(const Elements& points, const Sets& sets)
  {
    std::vector<Image<Dimension>> moved;
    for(std::size_t position = 0; position < points.size(); ++position)
      add(points, position, sets, moved);
    first_near_size_ = near_.size();
    near_.insert(near_.end(), moved.begin(), moved.end());
  }

  // Most points are far from the boundary, and take the first lines only.
  template <class Elements, class Sets>
  void add(const Elements& points, std::size_t position, const Sets& sets,
           std::vector<Image<Dimension>>& moved)
  {
    const auto& point = points[position];
    std::array<double, Dimension> x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = coordinate_bounds(point, axis).first;
    const Fractions f = fractions_(x);
    if(are_moved_ || !is_inside(f, std::make_index_sequence<Dimension>()))
      add_near_boundary(points, position, f, sets, moved);
  }

  // Whether a home is in no pair with another cell. If it may be moved, it is none of this kind.
  template <std::size_t... K>
  bool is_inside(const Fractions& f, std::index_sequence<K...>) const
  {
    return (((f[K] > low_ends_[K]) & (f[K] < high_ends_[K])) & ...);
  }

  template <class Elements, class Sets>
  BOOST_NOINLINE
  void add_near_boundary(const Elements& points, std::size_t position, Fractions f,
                         const Sets& sets, std::vector<Image<Dimension>>& moved)
  {
    const auto& point = points[position];
    Fractions cell = {};
    bool is_near_low = false, is_near_high = false;
    for(int k = 0; k < basis_.rank(); ++k) {
      if(are_wrapped_ && !(f[k] >= 0 && f[k] < 1)) {
        cell[k] = std::floor(f[k]);
        f[k] -= cell[k];
      }
      is_near_low = is_near_low || f[k] <= low_ends_[k];
      is_near_high = is_near_high || f[k] >= high_ends_[k];
    }
    const bool is_near_any = is_near_low || is_near_high;
    const bool is_first
      = is_of_first(sets, position) && (Sets::are_two ? is_near_any : is_near_high);
    if(is_first || are_moved_ || cell != Fractions{}) {
      const Image<Dimension> home
        = moved_image(point, position, [&](int k) { return -cell[k]; });
      add_home(points, home);
      if(is_first)
        near_.push_back(home);
    }
    if(is_of_second(sets, position) && (Sets::are_two ? is_near_any : is_near_low))
      add_moved(point, f, cell, position, Sets::are_two, moved);
    if(near_.size() + moved.size() >= max_place / 2)
      throw std::length_error("There are too many images of points within the bound.");
  }

  // Homes are kept from the first one on that is not the point itself.
  template <class Elements>
  void add_home(const Elements& points, const Image<Dimension>& home)
  {
    if(!are_moved_ && home.offset == Offset<Dimension>{})
      return;
    are_moved_ = true;
    for(std::size_t i = homes_.size(); i < home.position; ++i)
      homes_.push_back(moved_image(points[i], i, [](int) { return 0.; }));
    homes_.push_back(home);
  }

  static bool is_of_first(const One_set&, std::size_t) { return true; }
  static bool is_of_second(const One_set&, std::size_t) { return true; }
  static bool is_of_first(const Two_sets& sets, std::size_t i) { return i < sets.first_size; }
  static bool is_of_second(const Two_sets& sets, std::size_t i) { return i >= sets.first_size; }

  // Appends the images of a home that may be within the bound of homes: those moved by positive
  // offsets, or by all that are not zero.
  template <class Point>
  void add_moved(const Point& point, const Fractions& f, const Fractions& cell,
                 std::size_t position, bool are_all, std::vector<Image<Dimension>>& moved) const
  {
    Fractions first = {}, last = {};
    for(int k = 0; k < basis_.rank(); ++k) {
      first[k] = std::ceil(ranges_[k].low - reaches_[k] - f[k]);
      last[k] = std::floor(ranges_[k].high + reaches_[k] - f[k]);
      if(first[k] > last[k])
        return;
    }
    if(!are_all)
      first[0] = (std::max)(first[0], 0.);
    // Invariant: m is the next offset, in lexicographical order.
    for(Fractions m = first; m[0] <= last[0] && moved.size() < max_place / 2;) {
      const Fractions zero = {};
      if(are_all ? m != zero : m > zero)
        moved.push_back(moved_image(point, position, [&](int k) { return m[k] - cell[k]; }));
      int k = Dimension - 1;
      for(++m[k]; k > 0 && m[k] > last[k]; ++m[k]) {
        m[k] = first[k];
        --k;
      }
    }
  }

  // Returns the point at a position, moved by vectors(k) times vector k of the basis.
  template <class Point, class Vectors>
  Image<Dimension> moved_image(const Point& point, std::size_t position,
                               const Vectors& vectors) const
  {
    Image<Dimension> image = {static_cast<Place>(position), {}, {}};
    for(int i = 0; i < Dimension; ++i) {
      double sum = 0; // rounded only if it is refused
      for(int k = 0; k < basis_.rank(); ++k)
        sum += vectors(k) * static_cast<double>(basis_.steps(k)[i]);
      if(!(std::fabs(sum) < max_offset))
        throw std::length_error("An image of point " + std::to_string(position)
                                + " is too many periods away.");
      image.offset[i] = static_cast<int>(sum);
    }
    for(int axis = 0; axis < Dimension; ++axis)
      image.bounds[axis] = periods_.moved_bounds(point, image.offset, axis);
    return image;
  }

  const Periods<Dimension, Exact>& periods_;
  const Lattice_basis<Dimension>& basis_;
  const Cell_fractions<Dimension> fractions_;
  bool are_wrapped_;
  bool are_moved_ = false;
  Fractions reaches_ = {};
  std::array<Interval, Dimension> ranges_ = {}; // of the homes
  Fractions low_ends_; // homes beyond them may be near homes in another cell
  Fractions high_ends_;
  std::vector<Image<Dimension>> homes_;
  std::vector<Image<Dimension>> near_;
  std::size_t first_near_size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
