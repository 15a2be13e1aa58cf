// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_H

// The steps that all distributed searches take: points are checked where they are, then
// distributed, and each process searches those that it has.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Carried_points.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Distributed_points.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Stop_signal.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <chrono>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Measures the phases of a search, one after another.
class Phase_clock
{
public:
  explicit Phase_clock(Distributed_profile& profile) : profile_(profile) {}

  void finish(Distributed_phase phase)
  {
    const auto now = std::chrono::steady_clock::now();
    profile_.set_seconds(phase, std::chrono::duration<double>(now - start_).count());
    start_ = now;
  }

private:
  Distributed_profile& profile_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The points of a kernel, in a form that can be sent.
template <class Point>
using Carried_point
  = std::conditional_t<is_held_by_double_v<Coordinate_t<Point>>,
                       Carried_doubles<dimension_or<Point>(0)>,
                       Carried_numbers<dimension_or<Point>(0)>>;

// Returns whether points can be sent.
template <class Elements, class NamedParameters>
constexpr bool check_sent_points()
{
  if constexpr(!check_points<Elements, NamedParameters>())
    return false;
  else {
    constexpr bool is_rational = Is_rational<Coordinate_t<typename Elements::value_type>>::value;
    static_assert(is_rational, "Points are sent to other processes as rational numbers: the "
                               "coordinates must be of a rational number type.");
    return is_rational;
  }
}

// Returns a text that is the same for the same bounds.
template <class NT>
std::string text_of_bound(const Distance_bound<NT>& bound)
{
  std::ostringstream text;
  text << bound.is_squared() << bound.is_open();
  if(is_finite_number(bound.value()))
    text << to_exact_rational(bound.value());
  return text.str();
}

// Checks the points and the bound on all processes, and distributes the points, so that each
// process has its own and those near them. Finishes all phases before the search. Forgets what the
// profile had of another search.
template <class Elements, class Sets, class NT>
auto distribute_points(const Communicator& comm, const Elements& elements, const Sets&,
                       const Distance_bound<NT>& bound, Distributed_profile& profile,
                       Phase_clock& clock, const Threads& threads)
{
  using Point = typename Elements::value_type;
  profile = Distributed_profile(profile.distribution());
  std::string text;
  double reach = 0;
  int dimension = 0;
  run_together(comm, [&] {
    text = text_of_bound(bound); // which makes a lazy bound exact, so that its reach stays
    reach = Squared_bound<Exact_number_t<Coordinate_t<Point>>>(bound).reach();
    dimension = scan_points(elements, "point", false, threads).dimension();
  });
  agree_on(comm, "The distance bound", text);
  Distributed_points<Carried_point<Point>> points(comm, reach, profile);
  points.read(elements, Sets::are_two ? 2 : 1, dimension);
  clock.finish(Distributed_phase::CHECK);
  if(profile.distribution() == Point_distribution::BALANCED && comm.size() > 1) {
    points.partition();
    clock.finish(Distributed_phase::PARTITION);
    points.migrate();
    clock.finish(Distributed_phase::MIGRATION);
  }
  points.add_halos();
  clock.finish(Distributed_phase::HALO);
  return points;
}

// Runs search(np) on all processes, which returns false iff it was stopped. Returns false on all of
// them iff the search was stopped on one. The progress also looks for messages of processes that
// have stopped.
template <class NamedParameters, class Search>
bool search_together(const Communicator& comm, const NamedParameters& np, const Search& search)
{
  std::optional<Stop_signal> signal;
  run_together(comm, [&] { signal.emplace(comm); });
  const auto go_on_always = [](double) { return true; };
  const auto& given = parameters::get_parameter(np, internal_np::callback);
  std::exception_ptr error;
  bool is_complete = false;
  try {
    auto go_on = parameters::choose_parameter(given, go_on_always); // a copy, as it may change
    const auto watch = [&](double done) { return !signal->has_arrived() && go_on(done); };
    is_complete = search(parameters::callback(watch));
  }
  catch(...) {
    error = std::current_exception();
  }
  if(error || (!is_complete && !signal->was_received()))
    signal->raise();
  const bool is_stopped = signal->finish();
  throw_together(comm, error);
  return !is_stopped;
}

// Reports the pairs of the points that this process has, as their places. Returns false iff the
// search was stopped.
template <class Carried, class Sets, class NT, class Report, class NamedParameters>
bool report_pairs_here(const std::vector<Part_points<Carried>>& points, const Sets&,
                       const Distance_bound<NT>& bound, Report& report, const NamedParameters& np,
                       const Threads& threads)
{
  const auto search = [&](const auto& elements, const auto& sets) {
    return report_pairs_of_points(elements, sets, bound, report, np, threads);
  };
  using Elements = Numbered_elements<std::vector<Carried>>;
  if constexpr(Sets::are_two)
    return with_sets(search, Elements(points.front().points), Elements(points.back().points));
  else
    return with_sets(search, Elements(points.front().points));
}

// Returns search(elements, sets) for the range of each process, or for its two ranges.
template <class NamedParameters, class Search, class... Ranges>
auto with_distributed_ranges(const Communicator& comm, const NamedParameters& np,
                             const Search& search, Ranges&... ranges)
{
  std::tuple<std::optional<Elements_of<Ranges, NamedParameters>>...> all;
  run_together(comm, [&] {
    std::apply([&](auto&... elements) { (elements.emplace(make_elements(ranges, np)), ...); }, all);
  });
  if constexpr(sizeof...(Ranges) == 1)
    return with_sets(search, *std::get<0>(all));
  else
    return with_sets(search, *std::get<0>(all), *std::get<1>(all));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_H
