// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H

// The search behind distributed_fixed_radius_near_neighbors(). Each process searches its own points
// and those near them that it receives from other processes, as one set or two. Of each pair it has
// at least one point itself, so that no other process reports the pair.

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
#include <CGAL/Thick_intersection_d/internal/doors/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Carried_doubles.h>
#include <CGAL/Thick_intersection_d/internal/parts/Carried_numbers.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
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

// Returns whether points can be sent, and the callback can take the ids of remote points.
template <class Elements, class Callback>
constexpr bool check_distributed_search()
{
  if constexpr(!check_points<Elements>())
    return false;
  else {
    constexpr bool is_rational = Is_rational<Coordinate_t<typename Elements::value_type>>::value;
    constexpr bool takes_ids
      = !Pair_target<Callback, Elements, Elements>::takes_elements;
    static_assert(is_rational, "Points are sent to other processes as rational numbers: the "
                               "coordinates are to be of a rational number type.");
    static_assert(takes_ids, "The elements of other processes are not here: the callback is to "
                             "take two ids (std::uint64_t i, std::uint64_t j).");
    return is_rational && takes_ids;
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

// Hands pairs of ids to the user's callback, the lesser id first. A pair whose points were both
// received belongs to another process.
template <class Callback>
bool call_with_ids(Callback& callback, std::uint64_t i, std::uint64_t j)
{
  if constexpr(std::is_void_v<std::invoke_result_t<Callback&, std::size_t, std::size_t>>) {
    callback(i, j);
    return true;
  }
  else
    return static_cast<bool>(callback(i, j));
}

template <class ConcurrencyTag, class Carried, class NT, class Callback, class NamedParameters>
bool report_own_pairs(const std::vector<Distributed_set<Carried>>& sets, One_set,
                      const Distance_bound<NT>& bound, Callback& callback,
                      const NamedParameters& np)
{
  const Distributed_set<Carried>& set = sets[0];
  const auto report = [&](std::size_t i, std::size_t j) {
    if(i >= set.own_size) // and so is j
      return true;
    const std::uint64_t id_i = set.id(i), id_j = set.id(j);
    return call_with_ids(callback, (std::min)(id_i, id_j), (std::max)(id_i, id_j));
  };
  const auto elements = make_elements(set.part.points, parameters::default_values());
  return report_near_pairs<ConcurrencyTag>(elements, One_set(), bound, report, np);
}

template <class ConcurrencyTag, class Carried, class NT, class Callback, class NamedParameters>
bool report_own_pairs(const std::vector<Distributed_set<Carried>>& sets, Two_sets,
                      const Distance_bound<NT>& bound, Callback& callback,
                      const NamedParameters& np)
{
  const auto report = [&](std::size_t i, std::size_t j) {
    if(i >= sets[0].own_size && j >= sets[1].own_size)
      return true;
    return call_with_ids(callback, sets[0].id(i), sets[1].id(j));
  };
  const auto first = make_elements(sets[0].part.points, parameters::default_values());
  const auto second = make_elements(sets[1].part.points, parameters::default_values());
  const Joined_elements elements(first, second);
  return report_near_pairs<ConcurrencyTag>(elements, Two_sets{first.size()}, bound, report, np);
}

// Searches on all processes. Returns false on all of them iff the search was stopped on one.
template <class ConcurrencyTag, class Carried, class Sets, class NT, class Callback,
          class NamedParameters>
bool search_together(const Communicator& comm, const std::vector<Distributed_set<Carried>>& points,
                     const Sets& sets, const Distance_bound<NT>& bound, Callback& callback,
                     const NamedParameters& np)
{
  std::optional<Stop_signal> signal;
  run_together(comm, [&] { signal.emplace(comm); });
  std::exception_ptr error;
  bool is_complete = false;
  try {
    const Watched_signal<NamedParameters> watch(*signal, np);
    is_complete = report_own_pairs<ConcurrencyTag>(points, sets, bound, callback,
                                                   parameters::callback(watch));
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

template <class ConcurrencyTag, class Elements, class Sets, class NT, class Callback,
          class NamedParameters>
bool report_distributed_pairs(const Communicator& comm, const Elements& elements, const Sets& sets,
                              const Distance_bound<NT>& bound, Callback& callback,
                              Distributed_profile& profile, const NamedParameters& np)
{
  using Point = typename Elements::value_type;
  Phase_clock clock(profile);
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
  const bool is_complete
    = search_together<ConcurrencyTag>(comm, points.sets(), sets, bound, callback, np);
  clock.finish(Distributed_phase::SEARCH);
  return is_complete;
}

// Searches one range on each process.
template <class ConcurrencyTag, class Range, class NT, class Callback, class NamedParameters>
bool search_distributed_range(const Communicator& comm, Range& range,
                              const Distance_bound<NT>& bound, Callback& callback,
                              Distributed_profile& profile, const NamedParameters& np)
{
  if constexpr(!check_pair_search<ConcurrencyTag, Range, Range, Callback, NamedParameters>())
    return false;
  else {
    using Elements = Elements_of_range<Range, NamedParameters>;
    if constexpr(!check_distributed_search<Elements, Callback>())
      return false;
    else {
      std::optional<Elements> elements;
      run_together(comm, [&] { elements.emplace(make_elements(range, np)); });
      auto&& report = pair_output<ConcurrencyTag>(*elements, *elements, callback);
      return report_distributed_pairs<ConcurrencyTag>(comm, *elements, One_set(), bound, report,
                                                      profile, np);
    }
  }
}

// Searches two ranges on each process.
template <class ConcurrencyTag, class RangeA, class RangeB, class NT, class Callback,
          class NamedParameters>
bool search_distributed_ranges(const Communicator& comm, RangeA& range_a, RangeB& range_b,
                               const Distance_bound<NT>& bound, Callback& callback,
                               Distributed_profile& profile, const NamedParameters& np)
{
  if constexpr(!check_pair_search<ConcurrencyTag, RangeA, RangeB, Callback, NamedParameters>())
    return false;
  else {
    using Elements_a = Elements_of_range<RangeA, NamedParameters>;
    using Elements_b = Elements_of_range<RangeB, NamedParameters>;
    if constexpr(!check_distributed_search<Elements_a, Callback>())
      return false;
    else {
      std::optional<Elements_a> a;
      std::optional<Elements_b> b;
      run_together(comm, [&] {
        a.emplace(make_elements(range_a, np));
        b.emplace(make_elements(range_b, np));
      });
      const Joined_elements elements(*a, *b);
      auto&& report = pair_output<ConcurrencyTag>(*a, *b, callback);
      return report_distributed_pairs<ConcurrencyTag>(comm, elements, Two_sets{a->size()}, bound,
                                                      report, profile, np);
    }
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H
