// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SEARCH_H

// The search behind the functions for periodic domains: a search of the points without periods, and
// one of the few images beyond a boundary of the domain, for points near them.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periodic_scene.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_sets.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

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

// Returns the profile of `size` points, from those of the points and of their images elsewhere.
inline Scene_profile joined_profile(std::size_t size, int dimension, double reach,
                                    const Scene_profile& points, const Scene_profile& images)
{
  std::vector<std::pair<double, double>> box;
  for(int axis = 0; axis < dimension; ++axis)
    box.emplace_back((std::min)(points.range(axis).first, images.range(axis).first),
                     (std::max)(points.range(axis).second, images.range(axis).second));
  std::optional<int> grid_exponent;
  if(points.has_grid() && images.has_grid())
    grid_exponent = (std::min)(points.grid_exponent(), images.grid_exponent());
  Scene_profile profile(size, box, reach, grid_exponent);
  if(points.forced_tier())
    profile.force_tier(*points.forced_tier());
  profile.add_counts(points);
  profile.add_counts(images);
  profile.set_coordinates(points.coordinate_bits(), points.are_coordinates_rounded());
  return profile;
}

template <class Elements, class Sets, class Domain, class NT>
class Periodic_search
{
  using Periodic_scene = internal::Periodic_scene<Elements, Sets, Domain>;

public:
  static constexpr int dimension = Periodic_scene::dimension;
  using Exact = typename Periodic_scene::Exact;
  using Offsets = typename Periodic_scene::Offsets;

  // Checks the bound, the domain and the points.
  Periodic_search(const Elements& points, const Sets& sets, const Domain& domain,
                  const Distance_bound<NT>& bound, bool is_profiled, const Threads& threads)
    : sets_(sets), bound_(bound), threads_(threads), reach_(finite_reach(bound)),
      search_of_points_(points, bound, is_profiled, threads),
      scene_(points, sets, domain, search_of_points_.scene(), reach_, threads)
  {}

  Periodic_scene& scene() { return scene_; }
  const Periodic_scene& scene() const { return scene_; }

  // Calls report(i, j, offset) for each pair of images once. Returns false iff the search was
  // stopped. Replaces the profile unless it is null.
  template <class Report, class NamedParameters>
  bool report(Report& report, const NamedParameters& np, Scene_profile* profile)
  {
    if(!scene_.find_images(np))
      return false;
    if(profile == nullptr)
      return report_homes(report, np, nullptr) && report_near(report, np, nullptr);

    // The profile does not change if a callback throws.
    Scene_profile of_homes = *profile;
    std::optional<Scene_profile> of_near; // none without images
    if(!scan_near(of_near, np))
      return false;
    if(of_near && profile->forced_tier())
      force_tier(*profile->forced_tier(), *of_near); // refused before anything is reported
    const bool is_complete = report_homes(report, np, &of_homes)
                             && report_near(report, np, of_near ? &*of_near : nullptr);
    *profile = of_near ? joined_profile(scene_.size(), dimension, reach_, of_homes, *of_near)
                       : of_homes;
    return is_complete;
  }

  // Reports the pairs of equal images that an offset between homes moves, but of equal homes the
  // first one alone. So there are O(n) of them, however many points are equal.
  template <class Report, class NamedParameters>
  bool report_equal(Report& report, const NamedParameters& np)
  {
    if(!scene_.find_images(np))
      return false;
    scene_.keep_first_of_equal_homes();
    auto progress = make_progress(scene_.parameters_of_homes(np), scene_.size());
    return progress.advance(scene_.size()) && report_near(report, np, nullptr);
  }

  // Reports the pairs of a home and a moved home: all but those that no offset between homes moves.
  // Adds the decisions to the profile unless it is null.
  template <class Report, class NamedParameters>
  bool report_near(Report& report, const NamedParameters& np, Scene_profile* profile) const
  {
    const Two_sets sets{scene_.near_home_count()};
    const auto report_batch = [&](const Image_list& batch, double first, double last) {
      const auto report_pair = [&](std::size_t i, std::size_t j) {
        return report_images(report, batch[i], batch[sets.first_size + j]);
      };
      const auto np_of_batch = parameters_of_part(np, scene_.share_of_images(first),
                                                  scene_.share_of_images(last));
      const Moved images = scene_.moved(batch);
      if(profile == nullptr)
        return search(images, sets, report_pair, np_of_batch, nullptr);
      Scene_profile of_batch;
      if(profile->forced_tier())
        of_batch.force_tier(*profile->forced_tier());
      const bool is_complete = search(images, sets, report_pair, np_of_batch, &of_batch);
      profile->add_counts(of_batch);
      return is_complete;
    };
    return scene_.for_each_batch(report_batch);
  }

private:
  using Moved = typename Periodic_scene::Moved;
  using Image_list = typename Periodic_scene::Image_list;

  // Throws if the tier is not exact for all homes and images.
  void force_tier(Arithmetic_tier tier, Scene_profile& of_near) const
  {
    const auto scene_of_homes = [&] {
      return scene_.are_homes_moved()
               ? scan_points(scene_.moved(scene_.homes()), "home", true, threads_)
               : search_of_points_.scene();
    };
    Scene_profile of_homes(scene_of_homes(), reach_);
    of_homes.force_tier(tier);
    of_near.force_tier(tier);
    joined_profile(scene_.size(), dimension, reach_, of_homes, of_near);
  }

  // Sets the profile to that of the homes near images, and of these images, if there are some.
  // Returns false iff the progress was cancelled.
  template <class NamedParameters>
  bool scan_near(std::optional<Scene_profile>& profile, const NamedParameters& np) const
  {
    auto progress = make_progress(
      parameters_of_part(np, Periodic_scene::share_of_finding, Periodic_scene::share_of_scan),
      static_cast<std::size_t>(scene_.image_count()));
    const auto scan = [&](const Image_list& batch, double first, double last) {
      const Scene_profile of_batch(scan_points(scene_.moved(batch), "image", true, threads_),
                                   reach_);
      profile = profile ? joined_profile(scene_.size(), dimension, reach_, *profile, of_batch)
                        : of_batch;
      return progress.advance(static_cast<std::size_t>(last - first));
    };
    return scene_.for_each_batch(scan);
  }

  // Reports the pairs that no offset between homes moves.
  template <class Report, class NamedParameters>
  bool report_homes(Report& report, const NamedParameters& np, Scene_profile* profile)
  {
    const auto np_of_homes = scene_.parameters_of_homes(np);
    if constexpr(is_lattice_v<Domain>)
      if(scene_.are_homes_moved()) {
        const std::size_t second = scene_.first_of_second();
        return search(scene_.moved(scene_.homes()), sets_,
                      [&, &homes = scene_.homes()](std::size_t i, std::size_t j) {
                        return report_in_order(report, homes[i], homes[second + j]);
                      }, np_of_homes, profile);
      }
    const auto report_pair = [&](std::size_t i, std::size_t j) {
      return report(i, j, Offsets{});
    };
    return search_of_points_.report_profiled(sets_, report_pair, np_of_homes, profile);
  }

  // Reports a home that stays and an image that is moved.
  template <class Report>
  auto report_images(Report& report, const Image<dimension>& staying,
                     const Image<dimension>& moved) const
  {
    if constexpr(Sets::are_two)
      if(scene_.are_images_of_first())
        return report_in_order(report, moved, staying);
    return report_in_order(report, staying, moved);
  }

  // Reports two images in the order of their points. Those of one point are ordered by the offset.
  // The order is chosen without a jump, which no processor could foresee. Of two sets, the first
  // image is of the first one.
  template <class Report>
  auto report_in_order(Report& report, const Image<dimension>& a, const Image<dimension>& b) const
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
    Near_pairs_search<Moved> search(images, bound_, profile != nullptr, threads_);
    return search.report_profiled(sets, callback, np, profile);
  }

  static double finite_reach(const Distance_bound<NT>& bound)
  {
    const double reach = Squared_bound<Exact>(bound).reach();
    if(!std::isfinite(reach))
      throw std::invalid_argument("The distance of a periodic search is infinite, or beyond the "
                                  "largest double.");
    return reach;
  }

  const Sets sets_;
  const Distance_bound<NT>& bound_;
  const Threads threads_;
  const double reach_;
  Near_pairs_search<Elements> search_of_points_;
  Periodic_scene scene_;
};

template <class Domain, class NT, class Callback, class NamedParameters, class... Ranges>
bool report_periodic_pairs(const Domain& domain, const Distance_bound<NT>& bound,
                           Callback& callback, Scene_profile* profile, const NamedParameters& np,
                           const Threads& threads, Ranges&... ranges)
{
  const auto search_sets = [&](const auto& elements, const auto& sets) {
    Periodic_search<std::decay_t<decltype(elements)>, std::decay_t<decltype(sets)>, Domain, NT>
      search(elements, sets, domain, bound, profile != nullptr, threads);
    using First = std::decay_t<decltype(elements.first())>;
    using Second = std::decay_t<decltype(elements.second())>;
    using Offsets = Offset<domain_dimension_v<Domain>>;
    if constexpr(check_callback<Callback, First, Second, Offsets>()) {
      auto&& report
        = pair_output<Offsets>(elements.first(), elements.second(), callback, threads);
      return search.report(report, parameters_for_parts(np), profile);
    }
    else
      return false;
  };
  return with_periodic_sets<Domain>(np, search_sets, ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SEARCH_H
