// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H

// Which method finds the closest pair, or a close one. In the plane and in space it is a join of
// points in common cells. What doubles are too coarse for, or too crowded, and points of higher
// dimension go to the algorithms of [L].

#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Close_pair_buckets.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_cells.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_coordinates.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>

#include <mutex>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The closest pair of so few points is not worth a join.
constexpr std::size_t greatest_small_size = 1000;

// Throws if there are more points than positions of 32 bits.
inline void check_size(std::size_t size)
{
  if(size >= (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error("There are too many points: " + std::to_string(size) + ".");
}

// What a search knows of its points before it begins: all of them have been checked.
struct Checked_scene
{
  Scene_profile profile;
  double error; // of two doubles around a coordinate: how far apart they are at most
};

// Throws if there are too many points, or if one is not like the others or not finite.
template <class ConcurrencyTag, class Elements, class Exact>
Checked_scene check_scene(const Elements& points, const Squared_bound<Exact>& bound)
{
  check_size(points.size());
  const Coordinate_scan scan = scan_coordinates<ConcurrencyTag>(points, "point");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {make_profile(points.size(), scan, bound),
          scan.error == 0 ? 0 : std::nextafter(scan.error, infinity)}; // it was rounded
}

// Calls f(std::integral_constant<int, D>) for the dimension D of the points if it is 2 or 3; else
// otherwise().
template <class Point, class Function, class Otherwise>
auto for_plane_and_space(int dimension, const Function& f, const Otherwise& otherwise)
{
  using Dimension = typename Ambient_dimension<Point>::type;
  constexpr bool is_dynamic = std::is_same_v<Dimension, Dynamic_dimension_tag>;
  if constexpr(is_dynamic || std::is_same_v<Dimension, Dimension_tag<2>>)
    if(dimension == 2)
      return f(std::integral_constant<int, 2>());
  if constexpr(is_dynamic || std::is_same_v<Dimension, Dimension_tag<3>>)
    if(dimension == 3)
      return f(std::integral_constant<int, 3>());
  return otherwise();
}

// Returns how long the cells of a join are: so that one in 64 would have a point in it if the
// points were uniform, to give few pairs, but not so much longer than the distance that a cluster
// is in one of them, and long enough for points to be in few of them.
inline double join_cell_side(const Scene_profile& profile, std::size_t size, double distance)
{
  double volume = 1 / (64. * static_cast<double>(size)); // in cubes of the distance
  for(int axis = 0; axis < profile.dimension(); ++axis) {
    const std::pair<double, double>& range = profile.range(axis);
    volume *= (std::max)((range.second - range.first) / distance, 16.);
  }
  return distance * (std::min)((std::max)(std::pow(volume, 1. / profile.dimension()), 2.), 16.);
}

// How many pairs a join of so many points may visit. Cells of twice the distance with points that
// far apart in them, a lattice in space, give about 50 each; clusters give more, and are left to
// others.
inline std::size_t greatest_visit_count(std::size_t size) { return 100 * size; }

// Offers the closest pairs of the first `size` points to `minimum`, by the divide and conquer of
// [L].
template <class ConcurrencyTag, class Minimum, class Progress>
void divide_and_conquer(std::size_t size, int dimension, Minimum& minimum, Progress& progress)
{
  std::vector<std::size_t> positions(size);
  std::iota(positions.begin(), positions.end(), 0);
  Closest_pair_divide<ConcurrencyTag, Minimum>(std::move(positions), dimension)
    .search(minimum, progress);
}

template <class ConcurrencyTag, class Elements, class Progress>
class Closest_pair_search
{
  using Point = typename Elements::value_type;
  using Minimum = Pair_minimum<Elements>;
  using Positions = std::vector<std::uint32_t>;

public:
  // Of two points or more.
  Closest_pair_search(const Elements& points, const Checked_scene& scene, std::uint64_t seed,
                      Progress& progress)
    : points_(points), profile_(scene.profile), dimension_(profile_.dimension()),
      error_(scene.error), random_(seed), progress_(progress)
  {}

  // Returns the closest pair; if it is cancelled, the closest one of those that were seen, of which
  // the first one is (0, 1).
  Position_pair find()
  {
    Minimum minimum(points_, profile_);
    minimum.offer(0, 1);
    const bool is_found
      = for_plane_and_space<Point>(dimension_, [&](auto dimension) {
          return search<decltype(dimension)::value>(All_positions(points_.size()), 0, minimum);
        }, [] { return false; });
    if(is_found || progress_.is_cancelled())
      return minimum.pair();
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(minimum.is_zero())
        return *first_equal_pair(points_, dimension_);
    divide_and_conquer<ConcurrencyTag>(points_.size(), dimension_, minimum, progress_);
    return minimum.pair();
  }

private:
  // Offers the closest pairs of some points to `minimum`, in expected linear time. Returns false if
  // points are equal or doubles are too coarse. So many others come later.
  //
  // The closest pair of an eighth of the points, by the same method, gives the join a distance that
  // few pairs of all points are within: 8^2 of them, if it were for independent pairs.
  template <int Dimension, class Some_positions>
  bool search(const Some_positions& positions, std::size_t later, Minimum& minimum)
  {
    if(positions.size() <= greatest_small_size)
      return search_grid<Dimension>(positions, later, minimum);
    return search<Dimension>(draw_sample(positions), later + positions.size(), minimum)
           && minimum.has_tight_reach() && Grid_cells<Dimension>::fits(minimum.reach(), error_)
           && (join<Dimension>(positions, later, minimum)
               || search_grid<Dimension>(positions, later, minimum));
  }

  // Offers the pairs that a join visits to a minimum of its own, and that one to the result.
  struct Visitor
  {
    bool operator()(std::size_t i, std::size_t j)
    {
      minimum.offer(i, j);
      return ++count != greatest_count;
    }

    void finish()
    {
      const std::lock_guard<std::mutex> lock(mutex);
      result.offer_pair_of(minimum);
      is_complete = is_complete && count != greatest_count;
    }

    Minimum& result;
    std::mutex& mutex;
    bool& is_complete;
    std::size_t greatest_count;
    Minimum minimum;
    std::size_t count = 0;
  };

  // Returns false if cells are so crowded that it was given up.
  template <int Dimension, class Some_positions>
  bool join(const Some_positions& positions, std::size_t later, Minimum& minimum) const
  {
    progress_.restart(2 * (positions.size() + later));
    const double distance = minimum.reach();
    const Cell_join<ConcurrencyTag, Dimension, Elements> join_cells(
      points_, distance, join_cell_side(profile_, positions.size(), distance));
    std::mutex mutex;
    bool is_complete = true;
    join_cells(positions, [&, start = minimum] {
      return Visitor{minimum, mutex, is_complete, greatest_visit_count(positions.size()), start};
    }, progress_);
    return is_complete;
  }

  template <int Dimension, class Some_positions>
  bool search_grid(const Some_positions& positions, std::size_t later, Minimum& minimum)
  {
    progress_.restart(positions.size() + later);
    Positions all(positions.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = positions[i];
    return Closest_pair_grid<Dimension, Elements>(points_, std::move(all), dimension_, error_,
                                                  random_()).search(minimum, progress_);
  }

  // Takes each position with a probability of 1/8, by steps of 1 to 15.
  template <class Some_positions>
  Positions draw_sample(const Some_positions& positions)
  {
    Positions sample;
    for(std::size_t i = random_() % 15; i < positions.size(); i += 1 + random_() % 15)
      sample.push_back(positions[i]);
    return sample;
  }

  const Elements& points_;
  const Scene_profile& profile_;
  int dimension_;
  double error_;
  std::mt19937_64 random_;
  Progress& progress_;
};

template <class ConcurrencyTag, class Elements, class Progress>
class Close_pair_search
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  using Found = std::optional<Position_pair>;

public:
  Close_pair_search(const Elements& points, const Squared_bound<Exact>& bound,
                    const Checked_scene& scene, Progress& progress)
    : points_(points), all_(points.size()), bound_(bound), profile_(scene.profile),
      error_(scene.error),
      is_within_(bound, make_distance_filter(bound, profile_.dimension()), profile_.dimension()),
      grid_(points, bound, profile_, error_), progress_(progress)
  {}

  // Returns a close pair, if there is one and if it was found before the search was cancelled.
  Found find() const
  {
    if(!bound_.holds_for(Exact(0))) // nothing is closer than zero
      return std::nullopt;
    if(profile_.dimension() > greatest_grid_dimension)
      return test_closest_pair();
    // Where cells are heavy, a few points will do.
    if(const Found pair = find_by_grid(All_positions(all_.size() / 128), 2 * all_.size()))
      return pair;
    return for_plane_and_space<Point>(profile_.dimension(), [&](auto dimension) {
      return find_by_join<decltype(dimension)::value>();
    }, [&] { return find_by_grid(all_, 0); });
  }

private:
  // A cell has 3^5 - 1 neighbours in dimension 5.
  static constexpr int greatest_grid_dimension = 5;

  Found test_closest_pair() const
  {
    if(points_.size() < 2)
      return std::nullopt;
    Pair_minimum<Elements> minimum(points_, profile_);
    minimum.offer(0, 1);
    divide_and_conquer<ConcurrencyTag>(points_.size(), profile_.dimension(), minimum, progress_);
    const Position_pair& pair = minimum.pair();
    return is_within_(points_[pair.first], points_[pair.second]) ? Found(pair) : std::nullopt;
  }

  // `later` is the progress that is left for what comes later.
  Found find_by_grid(const All_positions& positions, std::size_t later) const
  {
    const std::size_t rounds = static_cast<std::size_t>(profile_.dimension()) + 1;
    progress_.restart(rounds * positions.size() + later);
    return grid_.find(positions, progress_);
  }

  // Tests the pairs that a join visits.
  struct Visitor
  {
    bool operator()(std::size_t i, std::size_t j)
    {
      if(search.is_within_(search.points_[i], search.points_[j]))
        pair = Position_pair(std::minmax(i, j));
      return !pair && ++count != greatest_count;
    }

    void finish()
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if(pair)
        result = pair;
      is_complete = is_complete && count != greatest_count;
    }

    const Close_pair_search& search;
    Found& result;
    std::mutex& mutex;
    bool& is_complete;
    std::size_t greatest_count;
    Found pair = std::nullopt;
    std::size_t count = 0;
  };

  template <int Dimension>
  Found find_by_join() const
  {
    const double reach = bound_.reach();
    if(!Grid_cells<Dimension>::fits(reach, error_))
      return find_by_grid(all_, 0);
    progress_.restart(2 * all_.size());
    const Cell_join<ConcurrencyTag, Dimension, Elements> join_cells(
      points_, reach, join_cell_side(profile_, all_.size(), reach));
    Found result;
    std::mutex mutex;
    bool is_complete = true;
    join_cells(all_, [&] {
      return Visitor{*this, result, mutex, is_complete, greatest_visit_count(all_.size())};
    }, progress_);
    return result || is_complete ? result : find_by_grid(all_, 0);
  }

  const Elements& points_;
  const All_positions all_;
  const Squared_bound<Exact>& bound_;
  const Scene_profile& profile_;
  double error_;
  Is_within_distance<Point> is_within_;
  Close_pair_grid<ConcurrencyTag, Elements> grid_;
  Progress& progress_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
