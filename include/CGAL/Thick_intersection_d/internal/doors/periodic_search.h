// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_SEARCH_H

// The search behind the functions for periodic domains: a search of the points without periods, and
// one of the few images beyond a boundary of the domain, for points near them.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/doors/joined_profile.h>
#include <CGAL/Thick_intersection_d/internal/doors/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_boundary.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Scene_images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/check_in_box.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/reports/Image_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/parameters_of_part.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag, class Elements, class Sets, class Domain, class NT>
class Periodic_search
{
  using Point = typename Elements::value_type;
  using Lattice = decltype(lattice_of(std::declval<const Domain&>()));

public:
  static constexpr int dimension = Lattice::dimension;
  using Exact = Common_exact_t<Coordinate_t<Point>, typename Lattice::FT>;
  using Offsets = Offset<dimension>;

  // Checks the bound, the domain and the points.
  CGAL_RARELY_CALLED
  Periodic_search(const Elements& points, const Sets& sets, const Domain& domain,
                  const Distance_bound<NT>& bound, bool is_profiled)
    : points_(points), sets_(sets), bound_(bound), reach_(finite_reach(bound)),
      search_of_points_(points, bound, is_profiled), periods_(lattice_of(domain)),
      basis_(lattice_of(domain))
  {
    if(points.size() == 0)
      return;
    check_size(points.size());
    if constexpr(!is_lattice_v<Domain>)
      check_in_box(points, search_of_points_.scene(), domain);
    const Cell_boundary<dimension> boundary(basis_, search_of_points_.scene(), reach_,
                                            is_lattice_v<Domain>);
    images_.emplace(ConcurrencyTag(), points, sets, basis_, boundary);
  }

  // Calls report(i, j, offset) for each pair of images once. Returns false iff the search was
  // stopped. Replaces the profile unless it is null.
  template <class Report, class NamedParameters>
  bool report(Report& report, const NamedParameters& np, Scene_profile* profile)
  {
    if(!images_)
      return report_points(report, np, profile);
    const auto np_of_homes = parameters_of_part(np, 0, share_of_homes());
    const auto np_of_near = parameters_of_part(np, share_of_homes(), 1);
    if(profile == nullptr)
      return report_homes(report, np_of_homes, nullptr)
             && report_near(report, np_of_near, nullptr);

    // The profile does not change if a callback throws.
    Scene_profile of_homes = *profile;
    const Moved near(points_, periods_, images_->near());
    Scene_profile of_near(scan_points<ConcurrencyTag>(near, "image"), reach_);
    if(const std::optional<Arithmetic_tier> forced = profile->forced_tier())
      of_near.force_tier(*forced); // refused before anything is reported
    const bool is_complete = report_homes(report, np_of_homes, &of_homes)
                             && report_near(report, np_of_near, &of_near);
    *profile = images_->have_near()
                 ? joined_profile(points_.size(), dimension, reach_, of_homes, of_near)
                 : of_homes;
    return is_complete;
  }

  // Reports the pairs of a home and a moved home: all but those that no offset between homes moves.
  template <class Report, class NamedParameters>
  bool report_near(Report& report, const NamedParameters& np, Scene_profile* profile) const
  {
    if(!images_ || !images_->have_near())
      return true;
    const auto& images = images_->near();
    const Two_sets sets{images_->first_near_size()};
    return search(Moved(points_, periods_, images), sets, [&](std::size_t i, std::size_t j) {
      return report_images(report, images[i], images[sets.first_size + j]);
    }, np, profile);
  }

  // How much of the work, about, is the search of the homes.
  double share_of_homes() const
  {
    const std::size_t size = points_.size();
    return !images_ || !images_->have_near()
             ? 1
             : static_cast<double>(size) / static_cast<double>(size + images_->near().size());
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
        return task(Moved(points_, periods_, images_->homes()));
    task(points_);
  }

  // Whether the home of a point is not the point itself.
  bool are_homes_moved() const { return images_ && images_->are_moved(); }

  // Returns the offset of the second of two points whose homes are not moved.
  Offsets offset_of_homes(std::size_t i, std::size_t j) const
  {
    return are_homes_moved()
             ? offset_between(images_->homes()[i].offset, images_->homes()[j].offset)
             : Offsets{};
  }

  // The position of the first point of the second set.
  std::size_t first_of_second() const
  {
    if constexpr(Sets::are_two)
      return sets_.first_size;
    else
      return 0;
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
  using Moved = Images<Elements, dimension, Exact>;

  // Reports the pairs that no offset between homes moves.
  template <class Report, class NamedParameters>
  bool report_homes(Report& report, const NamedParameters& np, Scene_profile* profile)
  {
    if constexpr(is_lattice_v<Domain>)
      if(images_->are_moved()) {
        const std::size_t second = first_of_second();
        return search(Moved(points_, periods_, images_->homes()), sets_,
                      [&, &homes = images_->homes()](std::size_t i, std::size_t j) {
                        return report_images(report, homes[i], homes[second + j]);
                      }, np, profile);
      }
    return report_points(report, np, profile);
  }

  template <class Report, class NamedParameters>
  bool report_points(Report& report, const NamedParameters& np, Scene_profile* profile)
  {
    const auto report_pair = [&](std::size_t i, std::size_t j) {
      return report(i, j, Offsets{});
    };
    return search_of_points_.report_profiled(sets_, report_pair, np, profile);
  }

  // Reports two images in the order of their points. Those of one point are ordered by the offset.
  // The order is chosen without a jump, which no processor could foresee.
  template <class Report>
  auto report_images(Report& report, const Image<dimension>& a, const Image<dimension>& b) const
  {
    if constexpr(Sets::are_two)
      return report(a.position, b.position - sets_.first_size, offset_between(a.offset, b.offset));
    else {
      const bool is_in_order
        = a.position != b.position ? a.position < b.position : a.offset < b.offset;
      const Image<dimension>* const ends[] = {&a, &b};
      const Image<dimension>&first = *ends[!is_in_order], &second = *ends[is_in_order];
      return report(first.position, second.position, offset_between(first.offset, second.offset));
    }
  }

  template <class Some_sets, class Callback, class NamedParameters>
  bool search(const Moved& images, const Some_sets& sets, const Callback& callback,
              const NamedParameters& np, Scene_profile* profile) const
  {
    Near_pairs_search<ConcurrencyTag, Moved> search(images, bound_, profile != nullptr);
    return search.report_profiled(sets, callback, np, profile);
  }

  static double finite_reach(const Distance_bound<NT>& bound)
  {
    const double reach = Squared_bound<Exact>(bound).reach();
    if(!std::isfinite(reach))
      throw std::invalid_argument("The bound of a periodic search is infinite.");
    return reach;
  }

  const Elements& points_;
  const Sets sets_;
  const Distance_bound<NT>& bound_;
  const double reach_;
  Near_pairs_search<ConcurrencyTag, Elements> search_of_points_;
  const Periods<dimension, Exact> periods_;
  const Lattice_basis<dimension> basis_;
  std::optional<Scene_images<dimension>> images_; // none without points
};

// Returns search(elements, sets) for the points of one range, or of two. Explains to the compiler's
// user what cannot be searched.
template <class ConcurrencyTag, class Domain, class NamedParameters, class Search, class... Ranges>
auto with_periodic_sets(const NamedParameters& np, const Search& search, Ranges&... ranges)
{
  const auto checked = [&](const auto& elements, const auto& sets) {
    using Point = typename std::decay_t<decltype(elements)>::value_type;
    constexpr int dimension = dimension_or<Point>(0);
    constexpr bool fits = dimension == decltype(lattice_of(std::declval<Domain>()))::dimension;
    static_assert(fits, "The domain is to be an Iso_rectangle_2 for points in the plane, an "
                        "Iso_cuboid_3 in space, or a Periodic_lattice_d of this dimension.");
    return search(elements, sets);
  };
  static_assert((check_range_of_points<ConcurrencyTag, Ranges, NamedParameters>() && ...));
  return with_sets(checked, make_elements(ranges, np)...);
}

template <class ConcurrencyTag, class Domain, class NT, class Callback, class NamedParameters,
          class... Ranges>
bool report_periodic_pairs(const Domain& domain, const Distance_bound<NT>& bound,
                           Callback& callback, Scene_profile* profile, const NamedParameters& np,
                           Ranges&... ranges)
{
  const auto search_sets = [&](const auto& elements, const auto& sets) {
    Periodic_search<ConcurrencyTag, std::decay_t<decltype(elements)>,
                    std::decay_t<decltype(sets)>, Domain, NT>
      search(elements, sets, domain, bound, profile != nullptr);
    auto&& report
      = image_output<ConcurrencyTag, Offset<decltype(lattice_of(domain))::dimension>>(
        elements.first(), elements.second(), callback);
    return search.report(report, np, profile);
  };
  return with_periodic_sets<ConcurrencyTag, Domain>(np, search_sets, ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_SEARCH_H
