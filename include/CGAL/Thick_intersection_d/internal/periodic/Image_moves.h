// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_MOVES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_MOVES_H

// Which offsets move a home to where homes may be.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_boundary.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

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
class Image_moves
{
  using Boundary = Cell_boundary<Dimension>;
  using Fractions = typename Boundary::Fractions;

public:
  // `basis` must live as long as this. Takes all moves of homes in two sets, and positive ones in
  // one set.
  Image_moves(const Lattice_basis<Dimension>& basis, const Boundary& boundary, bool are_two_sets)
    : basis_(basis), boundary_(boundary), are_two_sets_(are_two_sets)
  {
    if(boundary_.is_moved_once())
      set_offsets();
  }

  const Boundary& boundary() const { return boundary_; }

  // How many images of a home may be near homes. Throws if one of them is too many periods away.
  double count(const Fractions& f, unsigned sides, Place position) const
  {
    if(boundary_.is_moved_once())
      return static_cast<double>(first_offsets_[sides + 1] - first_offsets_[sides]);
    const auto [first, last] = moves(f);
    check_moves(first, last, position);
    double all = 1, positive = 0; // of the moves along the axes from k on
    for(int k = Dimension - 1; k >= 0; --k) {
      positive += last[k] * all;
      all *= last[k] - first[k] + 1;
    }
    return are_two_sets_ ? all - 1 : positive;
  }

  // Calls task(image) for the images of a home that may be near homes, until it returns false.
  // Returns what it returned.
  template <class Elements, class Task>
  bool for_each_image(const Elements& points, const Image<Dimension>& home, unsigned sides,
                      const Task& task) const
  {
    if(boundary_.is_moved_once()) {
      for(std::size_t i = first_offsets_[sides]; i != first_offsets_[sides + 1]; ++i)
        if(!task(moved(home, offsets_[i])))
          return false;
      return true;
    }
    Fractions cell;
    const auto [first, last] = moves(boundary_.fractions_in_cell(points[home.position], cell));
    return for_each_move(first, last, [&](const Fractions& move) {
      return task(moved(home, steps_of(move, home.position)));
    });
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
      check_steps(std::fabs(sum), position);
      offset[i] = static_cast<int>(sum);
    }
    return offset;
  }

private:
  // Returns how many times each vector may move a home: from the first number to the last, between
  // which is zero.
  std::pair<Fractions, Fractions> moves(const Fractions& f) const
  {
    std::pair<Fractions, Fractions> ends = {};
    for(int k = 0; k < basis_.rank(); ++k) {
      ends.first[k] = (std::min)(boundary_.first_move(f, k), 0.);
      ends.second[k] = (std::max)(boundary_.last_move(f, k), 0.);
    }
    return ends;
  }

  // Sets the offsets that are needed where no home is moved by a vector more than once. The homes
  // near the same sides are moved by the same offsets.
  void set_offsets()
  {
    for(unsigned sides = 0; sides <= Boundary::all_sides; ++sides) {
      first_offsets_[sides] = offsets_.size();
      Fractions first = {}, last = {};
      for(int k = 0; k < basis_.rank(); ++k) {
        first[k] = (sides & Boundary::high_side(k)) != 0 ? -1 : 0;
        last[k] = (sides & Boundary::low_side(k)) != 0 ? 1 : 0;
      }
      for_each_move(first, last, [this](const Fractions& move) {
        offsets_.push_back(steps_of(move, 0));
        return true;
      });
    }
    first_offsets_.back() = offsets_.size();
  }

  // Calls task(move) with how many times each vector moves a home, from first to last, until the
  // task returns false: positive moves, or of two sets all that are not zero. Returns what the task
  // returned.
  template <class Task>
  bool for_each_move(Fractions first, const Fractions& last, const Task& task) const
  {
    if(!are_two_sets_)
      first[0] = 0;
    const Fractions zero = {};
    // Invariant: m is the next move, in lexicographical order.
    for(Fractions m = first; m[0] <= last[0];) {
      if((are_two_sets_ ? m != zero : m > zero) && !task(m))
        return false;
      int k = Dimension - 1;
      for(++m[k]; k > 0 && m[k] > last[k]; ++m[k]) {
        m[k] = first[k];
        --k;
      }
    }
    return true;
  }

  // Throws if steps_of() would throw for one of the moves from first to last, or nearly so.
  void check_moves(const Fractions& first, const Fractions& last, Place position) const
  {
    for(int i = 0; i < Dimension; ++i) {
      double sum = 0;
      for(int k = 0; k < basis_.rank(); ++k)
        sum += (std::max)(-first[k], last[k])
               * std::fabs(static_cast<double>(basis_.steps(k)[i]));
      check_steps(sum, position);
    }
  }

  static void check_steps(double steps, Place position)
  {
    if(!(steps < max_offset / 2))
      throw std::length_error("An image of point " + std::to_string(position) + " is "
                              + count_text(steps) + " periods away, and these must be less than "
                              + count_text(max_offset / 2) + ".");
  }

  static Image<Dimension> moved(const Image<Dimension>& home, const Offset<Dimension>& offset)
  {
    Image<Dimension> image = home;
    for(int i = 0; i < Dimension; ++i)
      image.offset[i] += offset[i];
    return image;
  }

  const Lattice_basis<Dimension>& basis_;
  const Boundary boundary_;
  const bool are_two_sets_;
  std::vector<Offset<Dimension>> offsets_; // of homes near the same sides, one after another
  std::array<std::size_t, Boundary::all_sides + 2> first_offsets_ = {};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_MOVES_H
