// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search and the closest pair in a scene that repeats. Coordinates are doubles, and the vectors
// of the cell exact numbers.

#include "rational.h"
#include "search_with_kernel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Periodic_lattice_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>

#include <array>
#include <tuple>

namespace near_pairs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;
using Vector = CGAL::Simple_cartesian<CGAL::Exact_rational>::Vector_3;
using Lattice = CGAL::Periodic_lattice_d<Vector>;
using Clock = std::chrono::steady_clock;

// In the unit of the coordinates of the scene. Nothing repeats along the third axis of the plane.
Lattice lattice_of(const Scene& scene)
{
  const CGAL::Exact_rational unit = power_of_ten(scene.scale);
  std::array<Vector, 3> vectors;
  std::array<bool, 3> repeats = {false, false, false};
  for(std::size_t k = 0; k < scene.cell->vectors.size(); ++k) {
    std::array<CGAL::Exact_rational, 3> v;
    for(std::size_t axis = 0; axis < scene.cell->vectors[k].size(); ++axis)
      v[axis] = scene.cell->vectors[k][axis]->value * unit;
    vectors[k] = Vector(v[0], v[1], v[2]);
    repeats[k] = scene.cell->repeats[k];
  }
  return Lattice(vectors, repeats);
}

// Searches by one thread or by several.
class Periodic_search
{
public:
  Periodic_search(const Scene& scene, const Search_options& options)
    : scene_(scene), options_(options), points_(points_of<Kernel>(scene)),
      lattice_(lattice_of(scene))
  {}

  // Describes the scene in `profile`, unless there are two sets. Throws Error if it is stopped.
  void report(const Exact_bound& bound, const Pair_sink& sink, CGAL::Scene_profile& profile,
              bool shows_progress) const
  {
    std::mutex mutex; // the library may call from several threads
    const auto callback = [&, second = scene_.first_size.value_or(0)](
                            std::size_t i, std::size_t j, const Offset& offset) {
      const std::lock_guard<std::mutex> lock(mutex);
      sink(i, second + j, offset);
    };
    const auto go_on = progress_functor(shows_progress);
#ifdef CGAL_LINKED_WITH_TBB
    const bool is_complete
      = options_.parallel ? report_by<CGAL::Parallel_tag>(bound, callback, profile, go_on)
                          : report_by<CGAL::Sequential_tag>(bound, callback, profile, go_on);
#else
    const bool is_complete = report_by<CGAL::Sequential_tag>(bound, callback, profile, go_on);
#endif
    if(!is_complete)
      throw Error("stopped");
  }

  // Throws Error if it is stopped.
  std::tuple<std::size_t, std::size_t, Offset> closest() const
  {
#ifdef CGAL_LINKED_WITH_TBB
    const auto pair = options_.parallel ? closest_by<CGAL::Parallel_tag>()
                                        : closest_by<CGAL::Sequential_tag>();
#else
    const auto pair = closest_by<CGAL::Sequential_tag>();
#endif
    if(stop_requested)
      throw Error("stopped");
    return pair;
  }

private:
  template <class ConcurrencyTag>
  std::tuple<std::size_t, std::size_t, Offset> closest_by() const
  {
    const auto go_on = progress_functor(options_.progress);
    return CGAL::periodic_closest_pair<ConcurrencyTag>(points_, lattice_,
                                                       CGAL::parameters::callback(go_on));
  }

  template <class ConcurrencyTag, class Callback, class Go_on>
  bool report_by(const Exact_bound& bound, const Callback& callback, CGAL::Scene_profile& profile,
                 const Go_on& go_on) const
  {
    const auto parameters = CGAL::parameters::callback(go_on);
    if(!scene_.first_size)
      return CGAL::periodic_fixed_radius_near_neighbors<ConcurrencyTag>(
        points_, lattice_, bound, callback, profile, parameters);
    const auto [first, second] = ranges_of(points_, *scene_.first_size);
    return CGAL::periodic_fixed_radius_near_neighbors<ConcurrencyTag>(
      first, second, lattice_, bound, callback, parameters);
  }

  const Scene& scene_;
  const Search_options& options_;
  const Points points_;
  const Lattice lattice_;
};

} // namespace

// The pairs that the closed bound has, and the open one has not, are those at the distance. Of
// those that the longer bound has, most are so close that doubles can tell.
Search_result search_periodic(const Scene& scene, const Search_options& options,
                              const Pair_sink& sink, const Pair_sink& lost)
{
  const Periodic_search search(scene, options);
  const Exact_bound typed_bound = bound_of(options, scene.scale);
  const double excess = excess_of_longer_bound(options, scene.rounding);
  const Exact_bound bound = excess == 0 ? typed_bound : longer_bound_of(options, excess);
  const double clearly_near = 0.999 * reach_of(options);
  Search_result result;
  CGAL::Scene_profile profile, ignored;
  const auto start = Clock::now();
  search.report(bound, [&](std::size_t i, std::size_t j, const Offset& offset) {
    const bool is_clear = excess == 0 || scene.distance(i, j, offset) <= clearly_near;
    const int order = is_clear ? -1 : compare_with_typed(scene, options, i, j, offset);
    if(order > 0)
      return lost(i, j, offset);
    if(order == 0 && options.open)
      return;
    ++result.pairs;
    result.crossing += offset != Offset{};
    sink(i, j, offset);
  }, profile, options.progress);
  if(!options.open) {
    result.on_boundary = result.pairs;
    search.report(typed_bound.open(), [&](std::size_t, std::size_t, const Offset&) {
      --result.on_boundary;
    }, ignored, false);
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if(!scene.first_size)
    describe(profile, result);
  return result;
}

Closest_result closest_periodic(const Scene& scene, const Search_options& options)
{
  const Periodic_search search(scene, options);
  Closest_result result;
  const auto start = Clock::now();
  const auto [i, j, offset] = search.closest();
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  result.pair = {i, j};
  result.offset = offset;
  CGAL::Exact_rational squared(0);
  for(int axis = 0; axis < scene.dimension; ++axis) {
    const Exact_number difference = scene.exact_difference(i, j, offset, axis);
    squared += difference->value * difference->value;
  }
  result.squared_distance = Exact_number(Rational{squared});
  return result;
}

} // namespace near_pairs
