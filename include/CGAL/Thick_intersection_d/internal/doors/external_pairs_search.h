// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_EXTERNAL_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_EXTERNAL_PAIRS_SEARCH_H

// The search behind external_fixed_radius_near_neighbors(): part after part, each by the search
// for points in memory.

#include <CGAL/Distance_bound.h>
#include <CGAL/Memory_budget.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/doors/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/external/External_parts.h>
#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Part_limits.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Streamed_sample.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/iterators.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The share of the progress when the points are on disk; the search has the rest.
constexpr double share_of_writing = .25;

// `Go_on` takes the progress and returns whether to go on.
template <class ConcurrencyTag, class Range, class Map, class NT, class Callback, class Go_on>
class External_search
{
  using Readable = Read_range<Range>;
  using Exact = Exact_number_t<double>;

  // Points in the plane get z = 0: the search neither stores nor searches an axis along which all
  // points are equal.
  using Point = Simple_cartesian<double>::Point_3;

public:
  External_search(Readable& range, const Map& map, const Distance_bound<NT>& bound,
                  const Memory_budget& budget, Callback& callback, const Go_on& go_on)
    : range_(range), map_(map), bound_(bound),
      parts_(budget, Squared_bound<Exact>(bound).reach()), callback_(callback), go_on_(go_on)
  {}

  // Returns false iff the search was stopped.
  bool run()
  {
    check_denormals();
    Streamed_sample sample(parts_.limits().points_per_sample());
    if(!visit_points([&](const Stored_point& point) { sample.add(point); }, [] { return 0.; }))
      return false;
    size_ = sample.count();
    return size_ <= parts_.limits().points_per_search() ? search_at_once() : search_parts(sample);
  }

private:
  // Passes over the range, which takes the progress from `done()`. Returns false iff the user
  // stopped it.
  template <class Visit, class Done>
  bool visit_points(const Visit& visit, const Done& done) const
  {
    constexpr std::uint64_t block = 1 << 16;
    std::uint64_t id = 0;
    const auto last = std::end(range_);
    for(auto it = std::begin(range_); it != last; ++it, ++id) {
      if(id % block == 0 && !go_on_(done()))
        return false;
      visit(stored_point(*it, id));
    }
    return true;
  }

  template <class Element>
  Stored_point stored_point(Element&& element, std::uint64_t id) const
  {
    if constexpr(!std::is_same_v<Map, No_map>)
      return read_point(get(map_, element), id);
    else
      return read_point(element, id);
  }

  template <class Point>
  static Stored_point read_point(const Point& point, std::uint64_t id)
  {
    constexpr int dimension = dimension_or<Point>(3);
    Stored_point stored = {{0, 0, 0}, id};
    bool is_finite = true;
    for(int axis = 0; axis < dimension; ++axis) {
      const double x = static_cast<double>(coordinate(point, axis));
      stored.x[static_cast<std::size_t>(axis)] = x;
      is_finite = is_finite && std::isfinite(x);
    }
    if(!is_finite)
      check_point(point, dimension, "point", static_cast<std::size_t>(id));
    return stored;
  }

  void check_second_pass(std::uint64_t size) const
  {
    if(size != size_)
      throw std::runtime_error("The range had other points when it was read again.");
  }

  bool search_at_once()
  {
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(size_));
    const auto add = [&](const Stored_point& p) { points.emplace_back(p.x[0], p.x[1], p.x[2]); };
    if(!visit_points(add, [] { return 0.; }))
      return false;
    check_second_pass(points.size());
    return search(points, 0, 1, [&](std::size_t i, std::size_t j) { return put(i, j); });
  }

  bool search_parts(const Streamed_sample& sample)
  {
    std::uint64_t written = 0;
    bool is_complete = true;
    parts_.make(sample, [&](const auto& visit) {
      is_complete = visit_points([&](const Stored_point& point) { visit(point); ++written; },
                                 [&] { return share_of_writing * part_of_all(written); });
    });
    if(!is_complete)
      return false;
    check_second_pass(written);
    for(std::uint64_t done = 0; parts_.find_next(); ) {
      const auto loaded = parts_.template take_next<Point>();
      const double share = (1 - share_of_writing) * part_of_all(loaded.owned);
      const double start = share_of_writing + (1 - share_of_writing) * part_of_all(done);
      if(!search(loaded.points, start, share,
                 [&](std::size_t i, std::size_t j) { return put_of_part(loaded, i, j); }))
        return false;
      done += loaded.owned;
    }
    return true;
  }

  double part_of_all(std::uint64_t count) const
  {
    return static_cast<double>(count) / static_cast<double>(size_);
  }

  // Searches points in memory, and calls report(i, j) with positions among them. The search has a
  // share of the progress, from `start` on.
  template <class Report>
  bool search(const std::vector<Point>& points, double start, double share, const Report& report)
  {
    const auto go_on = [&](double done) { return go_on_(start + share * done); };
    return report_near_pairs<ConcurrencyTag>(
      make_elements(points, parameters::default_values()), One_set(), bound_, report,
      parameters::callback(go_on));
  }

  bool put_of_part(const Loaded_points<Point>& loaded, std::size_t i, std::size_t j)
  {
    if(i >= loaded.owned && j >= loaded.owned)
      return true;
    const std::uint64_t a = loaded.ids[i], b = loaded.ids[j];
    const std::uint64_t swapped = (a ^ b) & -std::uint64_t(b < a); // a branch is mispredicted
    return put(a ^ swapped, b ^ swapped);
  }

  // Returns false iff the callback stops the search.
  bool put(std::uint64_t i, std::uint64_t j)
  {
    if constexpr(std::is_void_v<std::invoke_result_t<Callback&, std::uint64_t, std::uint64_t>>) {
      callback_(i, j);
      return true;
    }
    else
      return static_cast<bool>(callback_(i, j));
  }

  Readable& range_;
  const Map map_;
  const Distance_bound<NT>& bound_;
  External_parts parts_;
  Callback& callback_;
  const Go_on& go_on_;
  std::uint64_t size_ = 0;
};

template <class Point>
constexpr bool check_stored_points()
{
  constexpr bool is_stored = is_held_by_double_v<Coordinate_t<Point>>
                             && (dimension_or<Point>(0) == 2 || dimension_or<Point>(0) == 3);
  static_assert(is_stored, "The points are to be points in the plane or in space whose coordinates "
                           "are doubles, or numbers that doubles hold.");
  return is_stored;
}

template <class Callback>
constexpr bool check_callback_of_ids()
{
  constexpr bool is_callback = std::is_invocable_v<Callback&, std::uint64_t, std::uint64_t>;
  static_assert(is_callback, "The callback is to take two positions of the type std::uint64_t.");
  return is_callback;
}

template <class ConcurrencyTag, class Range, class Callback, class NamedParameters>
constexpr bool check_external_search()
{
  if constexpr(!check_range_of_points<ConcurrencyTag, Range, NamedParameters>())
    return false;
  else if constexpr(!check_callback_of_ids<Callback>())
    return false;
  else
    return check_stored_points<typename decltype(make_elements(
      std::declval<Range&>(), std::declval<const NamedParameters&>()))::value_type>();
}

template <class ConcurrencyTag, class Range, class NT, class Callback, class NamedParameters>
bool search_externally(Range& range, const Distance_bound<NT>& bound, const Memory_budget& budget,
                       Callback& callback, const NamedParameters& np)
{
  if constexpr(check_external_search<ConcurrencyTag, Range, Callback, NamedParameters>()) {
    const auto go_on = [&]([[maybe_unused]] double done) {
      if constexpr(parameters::is_default_parameter<NamedParameters,
                                                    internal_np::callback_t>::value)
        return true;
      else
        return parameters::get_parameter(np, internal_np::callback)(done);
    };
    using Map = std::decay_t<decltype(element_map(range, np))>;
    using Search = External_search<ConcurrencyTag, std::remove_const_t<Range>, Map, NT, Callback,
                                   decltype(go_on)>;
    return Search(range, element_map(range, np), bound, budget, callback, go_on).run();
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_EXTERNAL_PAIRS_SEARCH_H
