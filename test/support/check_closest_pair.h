// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair of a scene on one kernel, by every method.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H

#include "brute_force.h"
#include "closest_pair_oracle.h"
#include "kernels.h"
#include "scenes.h"
#include "unit_test.h"
#include "usual_kernels.h"

#include <CGAL/closest_pair.h>

namespace test_support {

template <int Dimension>
using Epick_points = Cartesian_points<Epick, Dimension>;

template <class Point>
using Elements_of = internal::Numbered_elements<std::vector<Point>>;

template <class Point>
using Exact_of = internal::Exact_number_t<internal::Coordinate_t<Point>>;

template <class Elements>
internal::Scene scene_of(const Elements& elements)
{
  return internal::scan_points(elements, "point");
}

// Counts how many searches for near pairs the search for the closest pair needs. These are the
// parts of the search behind the join. A part is one search, or two that have all points each.
class Counting_progress
{
public:
  explicit Counting_progress(std::size_t size) : size_(size) {}

  void restart(std::size_t) { finished_.push_back(0); }
  bool advance(std::size_t finished)
  {
    finished_.back() += finished;
    return true;
  }
  bool is_cancelled() const { return false; }

  std::size_t near_searches() const
  {
    std::size_t count = 0;
    for(std::size_t part = 1; part < finished_.size(); ++part)
      count += finished_[part] > size_ ? 2 : 1;
    return count;
  }

private:
  std::size_t size_;
  std::vector<std::size_t> finished_; // points, in each part
};

// The closest pair as the search for many points finds it.
template <class Elements, class Progress>
Pair closest_of_many(const Elements& elements, const internal::Scene& scene, Progress& progress)
{
  return internal::Closest_pair_search<Elements, Progress>(elements, scene, 1, progress,
                                                           internal::Threads()).find();
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class Point>
Pair closest_by_division(const std::vector<Point>& points)
{
  const Elements_of<Point> elements(points);
  const internal::Scene scene = scene_of(elements);
  internal::Pair_minimum<Elements_of<Point>> minimum(elements, scene);
  internal::Unwatched_progress progress;
  internal::divide_and_conquer(points.size(), scene.dimension(),
                               internal::Threads(ConcurrencyTag()), minimum, progress);
  return minimum.pair();
}

template <class Point, class NT>
std::optional<Pair> close_by_buckets(const std::vector<Point>& points,
                                     const CGAL::Distance_bound<NT>& bound)
{
  const Elements_of<Point> elements(points);
  const internal::Scene scene = scene_of(elements);
  const internal::Is_within_distance<Point> is_within(
    internal::Squared_bound<Exact_of<Point>>(bound), scene.dimension());
  internal::Unwatched_progress progress;
  return internal::Close_pair_buckets<Elements_of<Point>>(
    elements, points.size(), scene, is_within)
    .find(progress);
}

inline const Closest& known_closest(const Points& points)
{
  static std::map<Points, Closest> known;
  auto found = known.find(points);
  if(found == known.end())
    found = known.emplace(points, closest_of_doubles(points)).first;
  return found->second;
}

inline void check_pair(const std::string& method, const Pair& expected, const Pair& found)
{
  BOOST_CHECK_MESSAGE(expected == found, method << ": (" << found.first << ", " << found.second
                                                << ") instead of (" << expected.first << ", "
                                                << expected.second << ')');
}

template <class Maker>
void check_closest_pair(const Points& scene)
{
  const auto points = make_points<Maker>(scene);
  const Pair expected = known_closest(scene).pair;
  check_pair("default", expected, CGAL::closest_pair(points));
  check_pair("another seed", expected,
             CGAL::closest_pair(points, CGAL::parameters::random_seed(7)));
  check_pair("division", expected, closest_by_division(points));
}

// A pair was found if there is one, and it is one of them.
inline void check_close_pair(const std::string& method, const Pairs& all,
                             const std::optional<Pair>& found)
{
  if(!found)
    BOOST_CHECK_MESSAGE(all.empty(), method << ": none found of " << all.size());
  else
    BOOST_CHECK_MESSAGE(std::binary_search(all.begin(), all.end(), *found),
                        method << ": (" << found->first << ", " << found->second << ")");
}

template <class Maker, class NT>
void check_close_pair(const std::vector<typename Maker::Point>& points,
                      const CGAL::Distance_bound<NT>& bound, const Pairs& all)
{
  check_close_pair("default", all, CGAL::find_close_pair(points, bound));
  check_close_pair("buckets", all, close_by_buckets(points, bound));
}

// The closest pair, and whether there is a pair at its distance, and none below.
template <class Maker>
void check_closest_and_close_pair(const Points& scene)
{
  check_closest_pair<Maker>(scene);
  const auto points = make_points<Maker>(scene);
  const Closest& closest = known_closest(scene);
  const auto bound = CGAL::within_squared_distance(
    internal::exact_squared_distance(points[closest.pair.first], points[closest.pair.second],
                                     points.front().dimension()));
  const auto found = CGAL::find_close_pair(points, bound);
  BOOST_REQUIRE(found);
  const Scaled_points both = scaled_points({scene[found->first], scene[found->second]});
  BOOST_CHECK(squared_distance(both[0], both[1]) == closest.square);
  BOOST_CHECK(!CGAL::has_close_pair(points, bound.open()));
  BOOST_CHECK(close_by_buckets(points, bound));
  BOOST_CHECK(!close_by_buckets(points, bound.open()));
}

// At the distance of the closest pair, and at that of the scene, closed and open.
template <class Maker>
void check_closest_scene(const Point_scene& scene)
{
  BOOST_TEST_CONTEXT(scene)
  {
    const auto points = make_points<Maker>(scene.points);
    const Truth& truth = truth_of(scene);
    with_bound(scene.radius, [&](const auto& bound) {
      check_close_pair<Maker>(points, bound, truth.pairs);
      check_close_pair<Maker>(points, bound.open(), truth.open_pairs);
    });
    if(points.size() >= 2)
      check_closest_pair<Maker>(scene.points);
  }
}

inline Points moved(Points points, double scale, double offset)
{
  for(Coordinates& c : points)
    for(double& x : c)
      x = x * scale + offset;
  return points;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H
