// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_POINTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_POINTS_SEARCH_H

// The search for near points, behind fixed_radius_near_neighbors() and others. Chooses the
// arithmetic and the route by the scene.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_point_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene_sample.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Element_points.h>
#include <CGAL/Thick_intersection_d/internal/near_points/few_near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/near_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Near_pairs_search
{
  using Point = typename Elements::value_type;
  using Bound = Squared_bound<Exact_number_t<Coordinate_t<Point>>>;

  // Whether slabs or boxes take all points that were checked, by their type. Then the recursive
  // route is not compiled.
  static constexpr bool are_doubles
    = is_held_by_double_v<Coordinate_t<Point>> && dimension_or<Point>(0) != 0;

public:
  // Checks the bound and the points. Finds the grid of the scene if `needs_grid`, or if the grid
  // may decide all pairs.
  template <class NT>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Near_pairs_search(const Elements& points, const Distance_bound<NT>& bound, bool needs_grid,
                    const Threads& threads)
    : points_(points), threads_(threads), bound_(bound), doubles_(points), sample_(points),
      scene_(scan_points(
        points, "point", needs_grid || may_grid_decide_all(),
        [&](std::size_t position, int axis, double x) { doubles_.set(position, axis, x); },
        threads)),
      profile_(scene_, bound_.reach())
  {}

  const Scene& scene() const { return scene_; }

  // Reports the pairs. Returns false iff the search was stopped. Counts in `counts` which
  // arithmetic decides, unless `counts` is null.
  template <class Sets, class Callback, class NamedParameters>
  bool report(const Sets& sets, Callback& callback, const NamedParameters& np,
              Shared_decision_counts* counts)
  {
    auto progress = make_progress(np, points_.size());
    if(points_.size() == 0)
      return progress.advance(0);
    const Is_within_distance<Point> is_within = make_predicate(counts);
    if constexpr(dimension_or<Point>(2) == 2 || dimension_or<Point>(3) == 3)
      if(takes_slabs())
        return report_by_slabs(is_within, sets, callback, progress);
    if constexpr(dimension_or<Point>(0) != 2 && dimension_or<Point>(0) != 3)
      if(are_finite_doubles() && scene_.dimension() > 0)
        return report_by_boxes_of(is_within, sets, callback, progress);
    if constexpr(are_doubles) // and finite, so there are too many of them
      throw std::length_error("There are too many points: " + std::to_string(points_.size()) + ".");
    else {
      const Thick_point_traits_d<Point> traits(is_within);
      const auto report = reporter_of(callback);
      return search_recursively(points_, sets, traits, report, progress, threads_);
    }
  }

  // The same. Takes the tier that is forced in `profile`, and sets `profile` to the profile of the
  // scene, unless it is null.
  template <class Sets, class Callback, class NamedParameters>
  bool report_profiled(const Sets& sets, Callback& callback, const NamedParameters& np,
                       Scene_profile* profile)
  {
    if(profile == nullptr)
      return report(sets, callback, np, nullptr);
    if(const std::optional<Arithmetic_tier> forced = profile->forced_tier())
      profile_.force_tier(*forced);
    Shared_decision_counts counts;
    const bool is_complete = report(sets, callback, np, &counts);
    profile_.set_counts(counts.total());
    *profile = profile_;
    return is_complete;
  }

  // Whether report() takes the slab route.
  bool takes_slabs() const
  {
    return are_finite_doubles() && (scene_.dimension() == 2 || scene_.dimension() == 3);
  }

private:
  // Whether doubles may compute all squared distances up to the bound without error.
  bool may_grid_decide_all() const
  {
    return sample_.may_have_grid()
           && first_exact_tier(bound_.reach(), sample_.grid_exponent(),
                               sample_.extended_axis_count()) == Arithmetic_tier::DOUBLE;
  }

  // Where no tier is forced, integers decide the near ties that they can.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Is_within_distance<Point> make_predicate(Shared_decision_counts* counts) const
  {
    const Arithmetic_tier tier = profile_.tier();
    return {bound_, scene_,
            profile_.forced_tier() ? tier : (std::min)(tier, Arithmetic_tier::INT128), counts};
  }

  // Whether finite doubles enclose the coordinates, as slabs and boxes need. Places have 32 bits;
  // runs need up to as many places again as there are points, for their ends.
  bool are_finite_doubles() const
  {
    for(const Interval& interval : scene_.box)
      if(!std::isfinite(interval.low) || !std::isfinite(interval.high))
        return false;
    return points_.size() < max_place / 2;
  }

  template <class Sets, class Callback, class Progress>
  bool report_by_boxes_of(const Is_within_distance<Point>& is_within, const Sets& sets,
                          Callback& callback, Progress& progress)
  {
    using Boxes = Near_object_boxes<dimension_or<Point>(0), Elements, Is_within_distance<Point>>;
    return report_meeting_boxes(Boxes(points_, is_within), sets, callback, progress, threads_);
  }

  template <class Sets, class Callback, class Progress>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  bool report_by_slabs(const Is_within_distance<Point>& is_within, const Sets& sets,
                       Callback& callback, Progress& progress)
  {
    for(int axis = 0; axis < scene_.dimension(); ++axis)
      if(!scene_.is_extended_along(axis))
        doubles_.share(axis, scene_.box[static_cast<std::size_t>(axis)].low);
    return for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
      Element_points<dimension, Elements, Progress> points(points_, doubles_, is_within, progress);
      Near_task<dimension> task = make_task<dimension>(is_within, sets);
      task.scale = narrow_scale<dimension>(task, is_within);
      profile_.set_coordinates(task.scale.is_usable() ? 32 : 64,
                               task.scale.is_usable() && !task.scale.is_exact());
      return search_slabs(points, task, sets, callback);
    }, [] { return false; }); // no other dimension takes slabs
  }

  template <int Dimension, class Sets>
  Near_task<Dimension> make_task(const Is_within_distance<Point>& is_within,
                                 [[maybe_unused]] const Sets& sets) const
  {
    Near_task<Dimension> task;
    std::copy_n(scene_.box.begin(), Dimension, task.box.begin());
    task.near = is_within.filter_of_doubles();
    if constexpr(Sets::are_two)
      task.sets.first_size = static_cast<Place>(sets.first_size);
    task.threads = threads_;
    task.counts = is_within.shared_counts();
    return task;
  }

  // Returns a scale without ties, or one that leaves few of them; none if there are many.
  template <int Dimension>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Narrow_scale<Dimension> narrow_scale(const Near_task<Dimension>& task,
                                       const Is_within_distance<Point>& is_within) const
  {
    std::array<Interval, Dimension> box = task.box;
    for(Interval& interval : box)
      interval = {interval.low * task.near.scale, interval.high * task.near.scale};
    if(profile_.tier() == Arithmetic_tier::DOUBLE) {
      const int exponent = profile_.grid_exponent();
      const Narrow_scale<Dimension> scale(box, exponent, profile_.units(),
                                          is_within.first_square_beyond(exponent));
      if(scale.is_usable())
        return scale;
    }
    return sample_.is_repetitive() ? Narrow_scale<Dimension>()
                                   : Narrow_scale<Dimension>(box, task.near.filter);
  }

  template <int Dimension, class Sets, class Callback>
  static bool search_slabs(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                           const Sets& sets, Callback& callback)
  {
    auto taker = taker_of(sets, callback);
    return task.scale.is_usable()
             ? search_near<Dimension, std::int32_t, may_share_slabs>(points, task, taker)
             : search_near<Dimension, double, may_share_slabs>(points, task, taker);
  }

  const Elements& points_;
  const Threads threads_;
  const Bound bound_;
  Doubles<Elements> doubles_;
  const Scene_sample sample_;
  const Scene scene_;
  Scene_profile profile_;
};

// Reports the near pairs of points of a kernel, whatever traits are given.
template <class Elements, class Sets, class NT, class Callback, class NamedParameters>
bool report_pairs_of_points(const Elements& points, const Sets& sets,
                            const Distance_bound<NT>& bound, Callback& callback,
                            const NamedParameters& np, const Threads& threads)
{
  if constexpr(takes_few_points<Elements, Sets, NT, Callback>)
    if(points.size() <= max_few_points)
      if(const std::optional<bool> is_complete
         = report_few_near_pairs(points, sets, bound, callback, np))
        return *is_complete;
  Near_pairs_search<Elements> search(points, bound, false, threads);
  return search.report(sets, callback, np, nullptr);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_POINTS_SEARCH_H
