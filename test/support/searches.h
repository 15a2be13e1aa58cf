// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches that report pairs, of random points, objects and features: what they promise of
// callbacks and progress is the same.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SEARCHES_H
#define THICK_INTERSECTION_TEST_SUPPORT_SEARCHES_H

#include "kernels.h"
#include "point_generators.h"

#include <CGAL/Polygon_2.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/interiors.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

namespace test_support {

using On_pair = std::function<bool(std::size_t, std::size_t)>;

// It may change itself: its operator() is not const.
struct On_progress
{
  template <class Functor>
  On_progress(Functor functor) : functor(std::move(functor)) {}

  bool operator()(double done) { return functor(done); }

  std::function<bool(double)> functor;
};

// Returns whether the search went to its end.
struct Search
{
  std::string name;
  std::function<bool(const On_pair&, const On_progress&)> run;
};

using Searched_kernel = CGAL::Simple_cartesian<double>;
using Searched_segment = Searched_kernel::Segment_2;

template <int Dimension>
auto searched_points(std::size_t n, std::uint64_t seed = 1)
{
  return make_points<Cartesian_points<Searched_kernel, Dimension>>(
    uniform_points(Dimension, n, 0, 1, seed));
}

inline std::vector<CGAL::Bbox_3> searched_boxes(std::size_t n)
{
  Random random(3);
  std::vector<CGAL::Bbox_3> boxes;
  for(const auto& p : searched_points<3>(n)) {
    const double side = .02 / (random.uniform() + .02);
    boxes.emplace_back(p.x(), p.y(), p.z(), p.x() + side, p.y() + .1, p.z() + .1);
  }
  return boxes;
}

inline auto searched_disks(std::size_t n)
{
  Random random(4);
  std::vector<std::pair<Searched_kernel::Point_2, double>> disks;
  for(const auto& p : searched_points<2>(n))
    disks.emplace_back(p, .03 * random.uniform());
  return disks;
}

// In two directions.
inline std::vector<Searched_segment> searched_segments(std::size_t n, double length)
{
  std::vector<Searched_segment> segments;
  for(const auto& p : searched_points<2>(n))
    segments.emplace_back(p, p + Searched_kernel::Vector_2(
                                   length, segments.size() % 2 == 0 ? length / 2 : -length));
  return segments;
}

// Of one range, or of two.
template <class ConcurrencyTag, class... Ranges>
Search near_search(const std::string& name, double distance, const Ranges&... ranges)
{
  return {name, [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(
      ranges..., CGAL::within_distance(distance), on_pair, CGAL::parameters::callback(on_progress));
  }};
}

template <class ConcurrencyTag, class Objects, class Traits>
Search search_by_traits(const std::string& name, const Objects& objects, const Traits& traits)
{
  return {name, [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::thick_self_intersection_d<ConcurrencyTag>(
      objects, on_pair, CGAL::parameters::geom_traits(traits).callback(on_progress));
  }};
}

template <class ConcurrencyTag, class A, class B>
Search search_of_two(const std::string& name, const A& a, const B& b)
{
  return {name, [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::thick_intersection_d<ConcurrencyTag>(a, b, on_pair,
                                                      CGAL::parameters::callback(on_progress));
  }};
}

template <class ConcurrencyTag>
Search search_of_features(std::size_t n)
{
  std::vector<std::vector<Searched_kernel::Point_2>> features;
  for(const Searched_segment& s : searched_segments(n, .05))
    features.push_back({s.source(), s.target()});
  return {"features", [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(
      features, on_pair, CGAL::parameters::callback(on_progress));
  }};
}

template <class ConcurrencyTag>
Search search_of_interiors(std::size_t n)
{
  std::vector<CGAL::Polygon_2<Searched_kernel>> triangles;
  for(const Searched_segment& s : searched_segments(n, .05)) {
    const Searched_kernel::Point_2 corners[]
      = {s.source(), s.target(), {s.source().x(), s.target().y()}};
    triangles.emplace_back(corners, corners + 3);
  }
  return {"interiors", [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(
      CGAL::interiors(triangles), on_pair, CGAL::parameters::callback(on_progress));
  }};
}

template <class ConcurrencyTag>
Search search_of_tracks(std::size_t n)
{
  std::vector<std::vector<std::pair<double, Searched_kernel::Point_2>>> tracks;
  for(const Searched_segment& s : searched_segments(n, .05))
    tracks.push_back({{0, s.source()}, {1, s.target()}});
  return {"tracks", [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::fixed_radius_near_tracks<ConcurrencyTag>(
      tracks, CGAL::within_distance(.02), on_pair, CGAL::parameters::callback(on_progress));
  }};
}

// Of so many points or objects.
template <class ConcurrencyTag>
std::vector<Search> pair_searches(std::size_t n)
{
  using Tag = ConcurrencyTag;
  const auto points = searched_points<2>(n);
  const auto segments = searched_segments(n, .05);
  const auto disks = searched_disks(n);
  const CGAL::Thick_object_traits_d<CGAL::Bbox_3> of_boxes;
  const CGAL::Thick_ball_traits_d<Searched_kernel::Point_2> of_disks(disks);
  return {near_search<Tag>("points in the plane", .02, points),
          near_search<Tag>("points in space", .08, searched_points<3>(n)),
          near_search<Tag>("points of two ranges", .02, points, searched_points<2>(n / 2 + 1, 2)),
          near_search<Tag>("near segments", .002, segments),
          near_search<Tag>("near objects of two types", .002, segments, disks),
          search_by_traits<Tag>("boxes", searched_boxes(n), of_boxes),
          search_by_traits<Tag>("balls", disks, of_disks),
          search_of_two<Tag>("objects of two types", segments, disks),
          search_of_two<Tag>("long objects", searched_segments(n / 30 + 1, .9), segments),
          search_of_features<Tag>(n),
          search_of_interiors<Tag>(n),
          search_of_tracks<Tag>(n)};
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SEARCHES_H
