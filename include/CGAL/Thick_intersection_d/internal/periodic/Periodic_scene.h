// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SCENE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SCENE_H

// The points of a search in a domain that repeats: their homes, the images that are needed, and how
// the progress is shared.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_boundary.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Scene_images.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if a point of the scene is not in [min, max) along all axes of an iso-box.
template <class Elements, class Iso_box>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
void check_in_box(const Elements& points, const Scene& scene, const Iso_box& box)
{
  using Exact = Common_exact_t<Coordinate_t<typename Elements::value_type>,
                               std::decay_t<decltype(box.min_coord(0))>>;
  for(int axis = 0; axis < scene.dimension(); ++axis) {
    const Exact low = to_exact<Exact>(box.min_coord(axis));
    const Exact high = to_exact<Exact>(box.max_coord(axis));
    const Interval& interval = scene.box[static_cast<std::size_t>(axis)];
    if(interval.low >= bounds(low).second && interval.high < bounds(high).first)
      continue;
    for(std::size_t position = 0; position < points.size(); ++position) {
      const Exact x = to_exact<Exact>(coordinate(points[position], axis));
      if(x < low || x >= high)
        throw std::invalid_argument("Point " + std::to_string(position)
                                    + " is not in the domain along axis " + std::to_string(axis)
                                    + ". A Periodic_lattice_d of the domain takes it.");
    }
  }
}

template <class Elements, class Sets, class Domain>
class Periodic_scene
{
  using Point = typename Elements::value_type;
  using Lattice = decltype(lattice_of(std::declval<const Domain&>()));

public:
  static constexpr int dimension = Lattice::dimension;
  using Exact = Common_exact_t<Coordinate_t<Point>, typename Lattice::FT>;
  using Offsets = Offset<dimension>;
  using Moved = Images<Elements, dimension, Exact>;
  using Image_list = typename Scene_images<dimension>::Image_list;

  // The progress when the homes are found, and when the images were read for a profile.
  static constexpr double share_of_finding = 0.0625;
  static constexpr double share_of_scan = 0.125;

  // Checks the domain, and whether points are in it. `scene` is that of the points.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Periodic_scene(const Elements& points, const Sets& sets, const Domain& domain,
                 const Scene& scene, double reach, const Threads& threads)
    : points_(points), sets_(sets), threads_(threads), periods_(lattice_of(domain)),
      basis_(lattice_of(domain))
  {
    if(points.size() == 0)
      return;
    check_size(points.size());
    if constexpr(!is_lattice_v<Domain>)
      check_in_box(points, scene, domain);
    const Cell_boundary<dimension> boundary(threads, basis_, points, scene, reach,
                                            is_lattice_v<Domain>);
    if(have_pairs())
      images_.emplace(basis_, boundary, Sets::are_two);
  }

  Periodic_scene(const Periodic_scene&) = delete; // the images know the basis
  Periodic_scene& operator=(const Periodic_scene&) = delete;

  // Finds the homes, and counts their images: before anything else. The progress goes up to
  // share_of_finding. Returns false iff it was cancelled.
  template <class NamedParameters>
  bool find_images(const NamedParameters& np)
  {
    if(!images_)
      return true;
    auto progress = make_progress(parameters_of_part(np, 0, share_of_finding), points_.size());
    return images_->find(threads_, points_, sets_, progress);
  }

  // Keeps images of the first of equal homes alone.
  void keep_first_of_equal_homes()
  {
    const auto less = [this](const Image<dimension>& a, const Image<dimension>& b) {
      for(int axis = 0; axis < dimension; ++axis) {
        const Exact x = periods_.moved(coordinate(points_[a.position], axis), a.offset, axis);
        const Exact y = periods_.moved(coordinate(points_[b.position], axis), b.offset, axis);
        if(x != y)
          return x < y;
      }
      return false;
    };
    if(images_)
      images_->keep_first_of_equal_homes(points_, less);
  }

  // Calls task(batch, first, last) with the images, as Scene_images does.
  template <class Task>
  bool for_each_batch(const Task& task) const
  {
    return !images_ || images_->for_each_batch(points_, task);
  }

  Moved moved(const Image_list& images) const { return {points_, periods_, images}; }

  std::size_t size() const { return points_.size(); }
  std::size_t near_home_count() const { return images_ ? images_->near_home_count() : 0; }
  double image_count() const { return images_ ? images_->count() : 0; }
  bool are_images_of_first() const { return images_->are_of_first(); }

  // The progress when the homes and so many images are searched, about.
  double share_of_images(double count) const
  {
    const double size = static_cast<double>(points_.size());
    const double all = size + image_count();
    return share_of_scan + (1 - share_of_scan) * (all == 0 ? 1 : (size + count) / all);
  }

  // Returns the named parameters of the search of the homes.
  template <class NamedParameters>
  auto parameters_of_homes(const NamedParameters& np) const
  {
    return parameters_of_part(np, share_of_scan, share_of_images(0));
  }

  // The number of vectors of the basis.
  int rank() const { return basis_.rank(); }

  // Returns the offset by a vector of the basis, or the opposite one if that is positive.
  Offsets basis_offset(int k) const
  {
    Offsets offset;
    for(std::size_t i = 0; i < offset.size(); ++i)
      offset[i] = static_cast<int>(basis_.steps(k)[i]);
    return (std::max)(offset, offset_between(offset, Offsets{}));
  }

  // Calls task(elements) with the homes of the points.
  template <class Task>
  void with_homes(const Task& task) const
  {
    if constexpr(is_lattice_v<Domain>)
      if(are_homes_moved())
        return task(moved(homes()));
    task(points_);
  }

  // Whether the home of a point is not the point itself. Only then there are homes.
  bool are_homes_moved() const { return images_ && images_->are_moved(); }

  const Image_list& homes() const { return images_->homes(); }

  // Returns the offset of the second of two points whose homes are not moved.
  Offsets offset_of_homes(std::size_t i, std::size_t j) const
  {
    return are_homes_moved()
             ? offset_between(images_->homes()[i].offset, images_->homes()[j].offset)
             : Offsets{};
  }

  // The position of the first point of the second set.
  std::size_t first_of_second() const { return sets_.first_of_second(); }

  // The number of points of the first set.
  std::size_t first_size() const
  {
    if constexpr(Sets::are_two)
      return sets_.first_size;
    else
      return points_.size();
  }

  Exact squared_distance(std::size_t i, std::size_t j, const Offsets& offset) const
  {
    Exact sum(0);
    for(int axis = 0; axis < dimension; ++axis) {
      const Exact difference = to_exact<Exact>(coordinate(points_[i], axis))
                               - periods_.moved(coordinate(points_[j], axis), offset, axis);
      sum += difference * difference;
    }
    return sum;
  }

private:
  // Whether there may be pairs: where one of two sets is empty, no image is needed.
  bool have_pairs() const
  {
    if constexpr(Sets::are_two)
      return sets_.first_size != 0 && sets_.first_size != points_.size();
    else
      return points_.size() != 0;
  }

  const Elements& points_;
  const Sets sets_;
  const Threads threads_;
  const Periods<dimension, Exact> periods_;
  const Lattice_basis<dimension> basis_;
  std::optional<Scene_images<dimension>> images_; // none if there is no pair
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SCENE_H
