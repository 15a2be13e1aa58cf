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

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_boundary.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
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

template <int Dimension>
class Scene_images
{
  using Boundary = Cell_boundary<Dimension>;
  using Fractions = typename Boundary::Fractions;
  using Image_list = std::vector<Image<Dimension>>;

public:
  // Throws std::length_error if a point is too many periods long.
  template <class ConcurrencyTag, class Elements, class Sets>
  CGAL_RARELY_CALLED
  Scene_images(ConcurrencyTag, const Elements& points, const Sets& sets,
               const Lattice_basis<Dimension>& basis, const Boundary& boundary)
    : basis_(basis), boundary_(boundary)
  {
    std::vector<Found> found(block_count<ConcurrencyTag>());
    for_each_numbered_block<ConcurrencyTag>(
      found.size(), points.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
        add_points(points, first, last, sets, found[block]);
      });
    collect(found, points.size());
  }

  // Whether the home of a point is not the point itself. Only then there are homes.
  bool are_moved() const { return !homes_.empty(); }
  const Image_list& homes() const { return homes_; }

  // The homes near which other images may be, and then these images.
  const Image_list& near() const { return near_; }
  std::size_t first_near_size() const { return first_near_size_; }
  bool have_near() const { return first_near_size_ != 0 && first_near_size_ != near_.size(); }

private:
  struct Found
  {
    Image_list moved_homes; // those that are not the points themselves
    Image_list near_homes;
    Image_list near_others;
  };

  // The points are still in the cache when the few near the boundary are read again.
  static constexpr std::size_t points_at_once = 1024;

  template <class Elements, class Sets>
  void add_points(const Elements& points, std::size_t first, std::size_t last, const Sets& sets,
                  Found& found) const
  {
    std::array<Place, points_at_once> positions;
    for(; first < last; first += points_at_once) {
      const std::size_t end = (std::min)(first + points_at_once, last);
      const std::size_t count = boundary_.find_near(points, first, end, positions.data());
      for(std::size_t i = 0; i < count; ++i)
        add(points[positions[i]], positions[i], sets, found);
    }
  }

  // Adds the home of a point, and images of it, where others may be near them.
  template <class Point, class Sets>
  BOOST_NOINLINE
  void add(const Point& point, Place position, const Sets& sets, Found& found) const
  {
    Fractions cell;
    const Fractions f = boundary_.fractions_in_cell(point, cell);
    const bool is_near_low = boundary_.is_near_low(f), is_near_high = boundary_.is_near_high(f);
    const bool is_near_any = is_near_low || is_near_high;
    Image<Dimension> home = {position, {}};
    if(cell != Fractions{}) {
      home = moved_image(position, [&](int k) { return -cell[k]; });
      found.moved_homes.push_back(home);
    }
    if(is_of_first(sets, position) && (Sets::are_two ? is_near_any : is_near_high))
      found.near_homes.push_back(home);
    if(is_of_second(sets, position) && (Sets::are_two ? is_near_any : is_near_low))
      add_moved(f, cell, position, Sets::are_two, found.near_others);
    if(found.near_homes.size() + found.near_others.size() >= max_near)
      throw_too_many();
  }

  void collect(const std::vector<Found>& found, std::size_t size)
  {
    for(const Found& part : found)
      near_.insert(near_.end(), part.near_homes.begin(), part.near_homes.end());
    first_near_size_ = near_.size();
    for(const Found& part : found)
      near_.insert(near_.end(), part.near_others.begin(), part.near_others.end());
    if(near_.size() >= max_near)
      throw_too_many();
    for(const Found& part : found)
      for(const Image<Dimension>& home : part.moved_homes)
        set_home(size, home);
  }

  // Homes are kept if one of them is not the point itself.
  void set_home(std::size_t size, const Image<Dimension>& home)
  {
    if(homes_.empty())
      for(std::size_t i = 0; i < size; ++i)
        homes_.push_back({static_cast<Place>(i), {}});
    homes_[home.position] = home;
  }

  static constexpr std::size_t max_near = max_place / 2; // as of points

  [[noreturn]] static void throw_too_many()
  {
    throw std::length_error("There are too many images of points within the bound.");
  }

  static bool is_of_first(const One_set&, std::size_t) { return true; }
  static bool is_of_second(const One_set&, std::size_t) { return true; }
  static bool is_of_first(const Two_sets& sets, std::size_t i) { return i < sets.first_size; }
  static bool is_of_second(const Two_sets& sets, std::size_t i) { return i >= sets.first_size; }

  // Appends the images of a home that may be within the bound of homes: those moved by positive
  // offsets, or by all that are not zero.
  void add_moved(const Fractions& f, const Fractions& cell, Place position, bool are_all,
                 Image_list& moved) const
  {
    Fractions first = {}, last = {};
    for(int k = 0; k < basis_.rank(); ++k) {
      first[k] = boundary_.first_move(f, k);
      last[k] = boundary_.last_move(f, k);
      if(first[k] > last[k])
        return;
    }
    if(!are_all)
      first[0] = (std::max)(first[0], 0.);
    // Invariant: m is the next offset, in lexicographical order.
    for(Fractions m = first; m[0] <= last[0] && moved.size() < max_near;) {
      const Fractions zero = {};
      if(are_all ? m != zero : m > zero)
        moved.push_back(moved_image(position, [&](int k) { return m[k] - cell[k]; }));
      int k = Dimension - 1;
      for(++m[k]; k > 0 && m[k] > last[k]; ++m[k]) {
        m[k] = first[k];
        --k;
      }
    }
  }

  // Returns the point at a position, moved by vectors(k) times vector k of the basis.
  template <class Vectors>
  Image<Dimension> moved_image(Place position, const Vectors& vectors) const
  {
    Image<Dimension> image = {position, {}};
    for(int i = 0; i < Dimension; ++i) {
      double sum = 0; // rounded only if it is refused
      for(int k = 0; k < basis_.rank(); ++k)
        sum += vectors(k) * static_cast<double>(basis_.steps(k)[i]);
      if(!(std::fabs(sum) < max_offset))
        throw std::length_error("An image of point " + std::to_string(position)
                                + " is too many periods away.");
      image.offset[i] = static_cast<int>(sum);
    }
    return image;
  }

  const Lattice_basis<Dimension>& basis_;
  const Boundary& boundary_;
  Image_list homes_;
  Image_list near_;
  std::size_t first_near_size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
