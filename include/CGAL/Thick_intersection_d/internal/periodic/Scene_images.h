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

template <int Dimension>
class Scene_images
{
  using Boundary = Cell_boundary<Dimension>;
  using Fractions = typename Boundary::Fractions;
  using Image_list = std::vector<Image<Dimension>>;

public:
  // Throws std::length_error if a point is too many periods away.
  template <class ConcurrencyTag, class Elements, class Sets>
  CGAL_RARELY_CALLED
  Scene_images(ConcurrencyTag, const Elements& points, const Sets& sets,
               const Lattice_basis<Dimension>& basis, const Boundary& boundary)
    : basis_(basis), boundary_(boundary)
  {
    if(boundary.is_moved_once())
      set_offsets(Sets::are_two);
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
  // The points are still in the cache when the few near the boundary are read again.
  static constexpr std::size_t points_at_once = 1024;

  // Images of so many points, each of which is written down, and kept or not.
  struct Kept_images
  {
    std::array<Image<Dimension>, points_at_once> images;
    std::size_t count = 0;

    void put(const Image<Dimension>& image, bool is_kept)
    {
      images[count] = image;
      count += is_kept;
    }
    void move_to(Image_list& list)
    {
      list.insert(list.end(), images.begin(), images.begin() + count);
      count = 0;
    }
  };

  struct Found
  {
    Image_list moved_homes; // those that are not the points themselves
    Image_list near_homes;
    Image_list near_others;
    Kept_images next_homes; // which follow in the two lists
    Kept_images next_others;
  };

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
      found.next_homes.move_to(found.near_homes);
      found.next_others.move_to(found.near_others);
      if(found.near_homes.size() + found.near_others.size() >= max_near)
        throw_too_many();
    }
  }

  // Adds the home of a point, and images of it, where others may be near them. No processor could
  // foresee which sides a home is near, so there are few jumps.
  template <class Point, class Sets>
  BOOST_NOINLINE
  void add(const Point& point, Place position, const Sets& sets, Found& found) const
  {
    Fractions cell;
    const Fractions f = boundary_.fractions_in_cell(point, cell);
    const unsigned sides = boundary_.sides(f);
    Image<Dimension> home = {position, {}};
    if(cell != Fractions{}) {
      for(double& x : cell)
        x = -x;
      home.offset = steps_of(cell, position);
      found.moved_homes.push_back(home);
    }
    constexpr unsigned sides_of_near = Sets::are_two ? Boundary::all_sides : Boundary::high_sides;
    found.next_homes.put(home, is_of_first(sets, position) && (sides & sides_of_near) != 0);
    const bool is_moved = is_of_second(sets, position);
    if(boundary_.is_moved_once()) {
      const unsigned moving_sides = is_moved ? sides : 0;
      const Offset<Dimension>* offset = offsets_.data() + first_offsets_[moving_sides];
      const Offset<Dimension>* const end = offsets_.data() + first_offsets_[moving_sides + 1];
      found.next_others.put(moved(home, *offset), offset != end);
      while(offset + 1 < end)
        found.near_others.push_back(moved(home, *++offset));
    }
    else if(is_moved)
      add_moved(f, home, Sets::are_two, found.near_others);
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

  // Appends the images of a home that may be within the bound of homes.
  void add_moved(const Fractions& f, const Image<Dimension>& home, bool are_all,
                 Image_list& images) const
  {
    Fractions first = {}, last = {};
    for(int k = 0; k < basis_.rank(); ++k) {
      first[k] = boundary_.first_move(f, k);
      last[k] = boundary_.last_move(f, k);
    }
    for_each_move(first, last, are_all, [&](const Fractions& move) {
      images.push_back(moved(home, steps_of(move, home.position)));
      return images.size() < max_near;
    });
  }

  // Sets the offsets that are needed where no home is moved by a vector more than once. The homes
  // near the same sides are moved by the same offsets.
  void set_offsets(bool are_all)
  {
    for(unsigned sides = 0; sides <= Boundary::all_sides; ++sides) {
      first_offsets_[sides] = offsets_.size();
      Fractions first = {}, last = {};
      for(int k = 0; k < basis_.rank(); ++k) {
        first[k] = (sides & Boundary::high_side(k)) != 0 ? -1 : 0;
        last[k] = (sides & Boundary::low_side(k)) != 0 ? 1 : 0;
      }
      for_each_move(first, last, are_all, [this](const Fractions& move) {
        offsets_.push_back(steps_of(move, 0));
        return true;
      });
    }
    first_offsets_.back() = offsets_.size();
    offsets_.push_back({}); // which is read, and not kept, where there are none
  }

  // Calls task(move) with how many times each vector moves a home, from first to last, until the
  // task returns false: positive moves, or all that are not zero.
  template <class Task>
  static void for_each_move(Fractions first, const Fractions& last, bool are_all, const Task& task)
  {
    if(!are_all)
      first[0] = (std::max)(first[0], 0.);
    const Fractions zero = {};
    // Invariant: m is the next move, in lexicographical order.
    for(Fractions m = first; m[0] <= last[0];) {
      if((are_all ? m != zero : m > zero) && !task(m))
        return;
      int k = Dimension - 1;
      for(++m[k]; k > 0 && m[k] > last[k]; ++m[k]) {
        m[k] = first[k];
        --k;
      }
    }
  }

  // Returns how many times each period is in a sum of multiples of the vectors, which moves the
  // point at a position.
  Offset<Dimension> steps_of(const Fractions& multiples, Place position) const
  {
    Offset<Dimension> offset;
    for(int i = 0; i < Dimension; ++i) {
      double sum = 0; // rounded only if it is refused
      for(int k = 0; k < basis_.rank(); ++k)
        sum += multiples[k] * static_cast<double>(basis_.steps(k)[i]);
      if(!(std::fabs(sum) < max_offset / 2))
        throw std::length_error("An image of point " + std::to_string(position)
                                + " is too many periods away.");
      offset[i] = static_cast<int>(sum);
    }
    return offset;
  }

  static Image<Dimension> moved(const Image<Dimension>& home, const Offset<Dimension>& offset)
  {
    Image<Dimension> image = home;
    for(int i = 0; i < Dimension; ++i)
      image.offset[i] += offset[i];
    return image;
  }

  const Lattice_basis<Dimension>& basis_;
  const Boundary& boundary_;
  Image_list homes_;
  Image_list near_;
  std::size_t first_near_size_ = 0;
  std::vector<Offset<Dimension>> offsets_; // of homes near the same sides, one after another
  std::array<std::size_t, Boundary::all_sides + 2> first_offsets_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
