// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PAIRS_SEARCH_H

// The search behind external_fixed_radius_near_neighbors(): part after part, each by the search
// for points in memory.

#include <CGAL/Distance_bound.h>
#include <CGAL/Memory_budget.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/External_parts.h>
#include <CGAL/Thick_intersection_d/internal/external/Searched_points.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The share of the progress when the points are on disk; the search has the rest.
constexpr double share_of_writing = .25;

// `Go_on` takes the progress and returns whether to go on.
template <int Dimension, class Range, class Map, class NT, class Callback, class Go_on>
class External_search
{
  using Readable = Read_range<Range>;
  using Iterator = Iterator_of<Readable>;
  using Exact = Exact_number_t<double>;
  using Point = Stored_point<Dimension>;
  using Points = Searched_points<Dimension>;

public:
  External_search(Readable& range, const Map& map, const Distance_bound<NT>& bound,
                  const Memory_budget& budget, Callback& callback, const Go_on& go_on,
                  const Threads& threads)
    : range_(range), map_(map), bound_(bound),
      parts_(budget, Squared_bound<Exact>(bound).reach()), callback_(callback), go_on_(go_on),
      threads_(threads)
  {}

  // Reads as many points as can be searched at once. Returns false iff the search was stopped.
  bool run()
  {
    check_denormals();
    const std::size_t most = parts_.limits().points_per_search();
    std::vector<Point>& points = loaded_.points;
    Iterator it = std::begin(range_);
    const auto last = std::end(range_);
    for(; points.size() < most && it != last; ++it) {
      if(!may_read_next())
        return false;
      if(points.size() == points.capacity())
        reserve_huge_pages(points, (std::min)(most, 2 * points.size() + (1 << 20)));
      points.push_back(stored_point(*it));
    }
    loaded_.owned = points.size();
    loaded_.begins = {0};
    return it == last ? search_loaded(0, 1) : search_parts(it);
  }

private:
  // Counts the points, and shows from time to time that there are more of them. Their number is not
  // known, so the progress only comes near to its share. Returns false iff the user stops the
  // search.
  bool may_read_next()
  {
    constexpr std::uint64_t block = 1 << 16;
    if(size_++ % block != 0)
      return true;
    const double most = static_cast<double>(parts_.limits().points_per_search());
    const double beyond = (std::max)(static_cast<double>(size_) - most, 0.);
    return go_on_(share_of_writing * beyond / static_cast<double>(size_));
  }

  // The element was counted.
  template <class Element>
  Point stored_point(Element&& element) const
  {
    const auto& point = look_up(map_, element);
    Point stored;
    stored.id = size_ - 1;
    bool is_finite = true;
    for(int axis = 0; axis < Dimension; ++axis) {
      const double x = static_cast<double>(coordinate(point, axis));
      stored.x[static_cast<std::size_t>(axis)] = x;
      is_finite = is_finite && std::isfinite(x);
    }
    if(!is_finite)
      check_point(point, Dimension, "point", static_cast<std::size_t>(stored.id));
    return stored;
  }

  // The points that were loaded come before the others.
  bool search_parts(Iterator it)
  {
    const std::vector<Point>& points = loaded_.points;
    const auto last = std::end(range_);
    const auto point_at = [&](std::uint64_t i) { return points[static_cast<std::size_t>(i)]; };
    parts_.make(points.size(), point_at, [&](const auto& visit) {
      std::for_each(points.begin(), points.end(), visit);
      for(; it != last && may_read_next(); ++it)
        visit(stored_point(*it));
    });
    return it == last && search_each_part();
  }

  bool search_each_part()
  {
    for(std::uint64_t done = 0; parts_.find_next();) {
      parts_.take_next(loaded_);
      const double start = progress_after(done);
      done += loaded_.owned;
      if(!search_loaded(start, progress_after(done)))
        return false;
    }
    return true;
  }

  // The progress when so many points have been searched: exactly 1 after all of them.
  double progress_after(std::uint64_t done) const
  {
    return share_of_writing
           + (1 - share_of_writing) * (static_cast<double>(done) / static_cast<double>(size_));
  }

  // Searches the points in memory, with the progress from `start` to `end`. Most pairs have two
  // ids. For them, nothing is stored and nothing is looked up. This makes short callbacks fast.
  bool search_loaded(double start, double end)
  {
    const Points points(loaded_);
    const Part_of_progress<Go_on&> go_on{go_on_, start, end, nullptr};
    const auto report = [&, &callback = callback_](std::size_t i, std::size_t j) {
      return Points::is_id(i & j)
               ? goes_on_after(callback, Points::short_id(i), Points::short_id(j))
               : report_looked_up(points, i, j);
    };
    return report_pairs_of_points(points, One_set(), bound_, report, parameters::callback(go_on),
                                  threads_);
  }

  // Reports the lesser id first. Drops a pair of two points that were given: it is found elsewhere.
  BOOST_NOINLINE bool report_looked_up(const Points& points, std::size_t i, std::size_t j)
  {
    if(!points.is_owned(i) && !points.is_owned(j))
      return true;
    const auto [low, high] = std::minmax({points.id(i), points.id(j)});
    return goes_on_after(callback_, low, high);
  }

  Readable& range_;
  const Map map_;
  const Distance_bound<NT>& bound_;
  External_parts<Dimension> parts_;
  Callback& callback_;
  Go_on go_on_;
  const Threads threads_;
  Loaded_points<Dimension> loaded_; // some, or a part
  std::uint64_t size_ = 0; // of the points that were read
};

// Usual scenes would exceed smaller budgets by more than a tenth: buffers of a search have sizes of
// their own.
inline void check_budget(std::size_t bytes)
{
  constexpr std::size_t least = std::size_t(1) << 22;
  if(bytes < least)
    throw std::invalid_argument("The memory budget of " + std::to_string(bytes)
                                + " bytes is too small: take at least 4 MiB.");
}

template <class Callback>
constexpr bool check_callback_of_ids()
{
  constexpr bool is_callback = std::is_invocable_v<Callback&, std::uint64_t, std::uint64_t>;
  static_assert(is_callback, "The callback must take two positions of the type std::uint64_t.");
  if constexpr(is_callback) {
    constexpr bool tells
      = is_void_or_bool<std::invoke_result_t<Callback&, std::uint64_t, std::uint64_t>>;
    static_assert(tells, "The callback must return void, or bool to tell whether the search "
                         "goes on.");
    return tells;
  }
  else
    return false;
}

template <class Range, class Callback, class NamedParameters>
constexpr bool check_external_search()
{
  if constexpr(!check_range_of_points<Range, NamedParameters>())
    return false;
  else {
    using Point = typename Elements_of<Range, NamedParameters>::value_type;
    constexpr bool is_stored = is_held_by_double_v<Coordinate_t<Point>>
                               && (dimension_or<Point>(0) == 2 || dimension_or<Point>(0) == 3);
    static_assert(is_stored, "The points must be points in the plane or in space whose "
                             "coordinates are doubles, or numbers that doubles hold.");
    return check_callback_of_ids<Callback>() && is_stored;
  }
}

template <class Range, class NT, class Callback, class NamedParameters>
bool search_externally(Range& range, const Distance_bound<NT>& bound, const Memory_budget& budget,
                       Callback& callback, const NamedParameters& np, const Threads& threads)
{
  if constexpr(check_external_search<Range, Callback, NamedParameters>()) {
    check_budget(budget.bytes());
    const auto go_on_always = [](double) { return true; };
    const auto& given = parameters::get_parameter(np, internal_np::callback);
    const auto& go_on = parameters::choose_parameter(given, go_on_always);
    using Map = std::decay_t<decltype(element_map(range, np))>;
    using Point = typename Elements_of<Range, NamedParameters>::value_type;
    using Search = External_search<dimension_or<Point>(0), std::remove_const_t<Range>, Map, NT,
                                   Callback, std::decay_t<decltype(go_on)>>;
    return Search(range, element_map(range, np), bound, budget, callback, go_on, threads)
      .run();
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PAIRS_SEARCH_H
