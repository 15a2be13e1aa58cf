// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_SEARCH_H

// The steps that all distributed searches take: points are checked where they are, then
// distributed, and each process searches those that it has.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Stop_signal.h>
#include <CGAL/Thick_intersection_d/internal/distributed/agree_on.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/doors/Distributed_points.h>
#include <CGAL/Thick_intersection_d/internal/doors/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Carried_doubles.h>
#include <CGAL/Thick_intersection_d/internal/parts/Carried_numbers.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <chrono>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
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
template <class Elements>
constexpr bool check_sent_points()
{
  if constexpr(!check_points<Elements>())
    return false;
  else {
    constexpr bool is_rational = Is_rational<Coordinate_t<typename Elements::value_type>>::value;
    static_assert(is_rational, "Points are sent to other processes as rational numbers: the "
                               "coordinates are to be of a rational number type.");
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

// Checks the points and the bound on all processes, and returns the points in a form that can be
// sent.
template <class ConcurrencyTag, class Point, class Elements, class Sets, class NT>
Distributed_points<Carried_point<Point>, Sets>
read_distributed_points(const Communicator& comm, const Elements& elements, const Sets& sets,
                        const Distance_bound<NT>& bound, Distributed_profile& profile)
{
  std::string text;
  double reach = 0;
  int dimension = 0;
  run_together(comm, [&] {
    reach = Squared_bound<Exact_number_t<Coordinate_t<Point>>>(bound).reach();
    text = text_of_bound(bound);
    dimension = scan_points<ConcurrencyTag>(elements, "point", false).dimension();
  });
  agree_on(comm, "The distance bound", text);
  Distributed_points<Carried_point<Point>, Sets> points(comm, reach, profile);
  points.read(elements, sets, dimension);
  return points;
}

// Distributes the points, so that each process has its own and those near them. Finishes all phases
// before the search.
template <class ConcurrencyTag, class Elements, class Sets, class NT>
auto distribute_points(const Communicator& comm, const Elements& elements, const Sets& sets,
                       const Distance_bound<NT>& bound, Distributed_profile& profile,
                       Phase_clock& clock)
{
  using Point = typename Elements::value_type;
  auto points
    = read_distributed_points<ConcurrencyTag, Point>(comm, elements, sets, bound, profile);
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

// The progress of a search, which also looks for messages of processes that have stopped.
template <class NamedParameters>
class Watched_signal
{
public:
  Watched_signal(Stop_signal& signal, const NamedParameters& np) : signal_(&signal), np_(&np) {}

  bool operator()(double progress) const
  {
    if(signal_->has_arrived())
      return false;
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::callback_t>::value)
      return true;
    else
      return parameters::get_parameter(*np_, internal_np::callback)(progress);
  }

private:
  Stop_signal* signal_;
  const NamedParameters* np_;
};

// Runs search(np) on all processes, which returns false iff it was stopped. Returns false on all of
// them iff the search was stopped on one.
template <class NamedParameters, class Search>
bool search_together(const Communicator& comm, const NamedParameters& np, const Search& search)
{
  std::optional<Stop_signal> signal;
  run_together(comm, [&] { signal.emplace(comm); });
  std::exception_ptr error;
  bool is_complete = false;
  try {
    const Watched_signal<NamedParameters> watch(*signal, np);
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
template <class ConcurrencyTag, class Carried, class NT, class Report, class NamedParameters>
bool report_pairs_here(const std::vector<Distributed_set<Carried>>& points, One_set,
                       const Distance_bound<NT>& bound, Report& report, const NamedParameters& np)
{
  const auto elements = make_elements(points[0].part.points, parameters::default_values());
  return report_near_pairs<ConcurrencyTag>(elements, One_set(), bound, report, np);
}

template <class ConcurrencyTag, class Carried, class NT, class Report, class NamedParameters>
bool report_pairs_here(const std::vector<Distributed_set<Carried>>& points, Two_sets,
                       const Distance_bound<NT>& bound, Report& report, const NamedParameters& np)
{
  const auto first = make_elements(points[0].part.points, parameters::default_values());
  const auto second = make_elements(points[1].part.points, parameters::default_values());
  const Joined_elements elements(first, second);
  return report_near_pairs<ConcurrencyTag>(elements, Two_sets{first.size()}, bound, report, np);
}

// Returns search(elements, sets) for the range of each process.
template <class Range, class NamedParameters, class Search>
auto with_distributed_range(const Communicator& comm, Range& range, const NamedParameters& np,
                            const Search& search)
{
  std::optional<decltype(make_elements(range, np))> elements;
  run_together(comm, [&] { elements.emplace(make_elements(range, np)); });
  return search(*elements, One_set());
}

// Returns search(elements, sets) for the two ranges of each process.
template <class RangeA, class RangeB, class NamedParameters, class Search>
auto with_distributed_ranges(const Communicator& comm, RangeA& range_a, RangeB& range_b,
                             const NamedParameters& np, const Search& search)
{
  std::optional<decltype(make_elements(range_a, np))> a;
  std::optional<decltype(make_elements(range_b, np))> b;
  run_together(comm, [&] {
    a.emplace(make_elements(range_a, np));
    b.emplace(make_elements(range_b, np));
  });
  const Joined_elements elements(*a, *b);
  return search(elements, Two_sets{a->size()});
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_SEARCH_H
