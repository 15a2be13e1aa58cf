// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches that have no target for many processors.

#include "make_search.h"
#include "searches.h"

#include "scenes/generators.h"
#include "scenes/object_generators.h"
#include "scenes/polygon_generators.h"
#include "scenes/solid_generators.h"
#include "scenes/track_generators.h"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/fixed_radius_neighbor_lists.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace thick_benchmark {

namespace {

// ---- points -------------------------------------------------------------------------------------

// The points of a scene in two sets, one of which has every second point.
template <int Dimension>
auto shared_halves(const Scene& scene)
{
  using Points = std::vector<Point_t<Epick, Dimension>>;
  auto halves = std::make_shared<std::array<Points, 2>>();
  const Points all = make_points<Epick, Dimension>(scene);
  for(std::size_t i = 0; i < all.size(); ++i)
    (*halves)[i % 2].push_back(all[i]);
  return halves;
}

template <int Dimension>
Many_search near_pairs_of_two_sets(const Scene& scene)
{
  return search_of_pairs([sets = shared_halves<Dimension>(scene), r = scene.r](
                           auto tag, const auto& callback) {
    CGAL::fixed_radius_near_neighbors<decltype(tag)>((*sets)[0], (*sets)[1],
                                                     CGAL::within_distance(r), callback);
  });
}

template <int Dimension>
Many_search lists_of_two_sets(const Scene& scene)
{
  return search_of_lists([sets = shared_halves<Dimension>(scene), r = scene.r](auto tag,
                                                                               auto& lists) {
    lists = CGAL::fixed_radius_neighbor_lists<decltype(tag)>((*sets)[0], (*sets)[1],
                                                             CGAL::within_distance(r));
  });
}

template <int Dimension>
Many_search lists_in_old_memory(const Scene& scene)
{
  const auto points = shared_points<Dimension>(scene);
  const auto lists = std::make_shared<CGAL::Neighbor_lists>();
  const auto search = [=, r = scene.r](auto tag) {
    CGAL::fixed_radius_neighbor_lists<decltype(tag)>(*points, CGAL::within_distance(r), *lists);
  };
  return {[=] { search(CGAL::Sequential_tag()); }, [=] { search(CGAL::Parallel_tag()); },
          [=] { return tally_of(*lists); }};
}

Many_search periodic_pairs(const Scene& scene)
{
  return search_of_pairs([points = shared_points<3>(scene), r = scene.r](auto tag,
                                                                         const auto& callback) {
    CGAL::periodic_fixed_radius_near_neighbors<decltype(tag)>(
      *points, Epick::Iso_cuboid_3(0, 0, 0, 1, 1, 1), CGAL::within_distance(r),
      [&](std::size_t i, std::size_t j, const auto&) { callback(i, j); });
  });
}

Many_search periodic_lists(const Scene& scene)
{
  return search_of_lists([points = shared_points<3>(scene), r = scene.r](auto tag, auto& lists) {
    lists = CGAL::periodic_fixed_radius_neighbor_lists<decltype(tag)>(
              *points, Epick::Iso_cuboid_3(0, 0, 0, 1, 1, 1), CGAL::within_distance(r)).lists();
  });
}

// ---- objects ------------------------------------------------------------------------------------

template <class Maker>
Many_search boxes(const Object_scene& scene)
{
  using Object = decltype(Maker::make(nullptr));
  using Box = CGAL::Box_intersection_d::Box_d<double, CGAL::Ambient_dimension<Object>::value>;
  const auto all = std::make_shared<std::vector<Box>>();
  for(std::size_t i = 0; i < scene.size(); ++i)
    all->emplace_back(Maker::make(scene.object(i)).bbox());
  return search_of_pairs([all](auto tag, const auto& callback) {
    const auto position = [&](const Box& box) {
      return static_cast<std::size_t>(&box - all->data());
    };
    CGAL::thick_box_self_intersection_d<decltype(tag)>(
      all->cbegin(), all->cend(),
      [&](const Box& a, const Box& b) { callback(position(a), position(b)); });
  });
}

Many_search balls(const Object_scene& scene)
{
  const auto all = shared_objects<Ball_from_numbers>(scene);
  return search_of_pairs([all](auto tag, const auto& callback) {
    CGAL::thick_self_intersection_d<decltype(tag)>(
      *all, callback,
      CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Epick::Point_3>(*all)));
  });
}

template <class Maker>
Many_search near_objects(const Object_scene& scene, double r)
{
  return search_of_pairs([all = shared_objects<Maker>(scene), r](auto tag, const auto& callback) {
    CGAL::fixed_radius_near_neighbors<decltype(tag)>(*all, CGAL::within_distance(r), callback);
  });
}

// ---- features and tracks ------------------------------------------------------------------------

template <class Feature>
Many_search features(std::vector<Feature> features)
{
  const auto all = std::make_shared<const std::vector<Feature>>(std::move(features));
  return search_of_pairs([all](auto tag, const auto& callback) {
    CGAL::thick_feature_self_intersection_d<decltype(tag)>(*all, callback);
  });
}

template <class Feature>
std::vector<Feature> features_of(const Rings& rings)
{
  std::vector<Feature> features;
  for(const Ring& ring : rings) {
    features.emplace_back();
    for(const auto& p : ring)
      features.back().push_back(Epick::Point_2(p[0], p[1]));
  }
  return features;
}

auto soups_of(const Solid_scene& scene)
{
  using Soup = std::pair<std::vector<Epick::Point_3>, std::vector<std::array<std::uint32_t, 3>>>;
  std::vector<Soup> soups;
  for(const Mesh_scene& solid : scene.solids) {
    soups.push_back({{}, solid.faces});
    for(const auto& p : solid.points)
      soups.back().first.emplace_back(p[0], p[1], p[2]);
  }
  return soups;
}

template <int Dimension>
Many_search near_tracks(const Track_scene& scene)
{
  using Point = Point_t<Epick, Dimension>;
  const auto tracks = std::make_shared<std::vector<std::vector<std::pair<double, Point>>>>();
  for(const Track& track : scene.tracks) {
    tracks->emplace_back();
    for(const Place_at_time& fix : track)
      tracks->back().emplace_back(fix.time, point_at<Point>(fix.place.data()));
  }
  return search_of_pairs([tracks, r = scene.r](auto tag, const auto& callback) {
    CGAL::fixed_radius_near_tracks<decltype(tag)>(*tracks, CGAL::within_distance(r), callback);
  });
}

} // namespace

std::vector<Many_row> other_rows()
{
  using Segment_2 = From_corners<Epick::Segment_2, Epick::Point_2, 2>;
  using Segment_3 = From_corners<Epick::Segment_3, Epick::Point_3, 2>;
  using Polyline = std::vector<Epick::Point_2>;
  const auto dense = [](int dimension, std::size_t n) {
    return uniform(dimension, n, 10 * static_cast<double>(n));
  };
  return {
    {"2D near pairs of two sets", 0,
     [=](auto n) { return near_pairs_of_two_sets<2>(dense(2, n)); }},
    {"3D near pairs of two sets", 0,
     [=](auto n) { return near_pairs_of_two_sets<3>(dense(3, n)); }},
    {"2D lists of two sets", 0, [=](auto n) { return lists_of_two_sets<2>(dense(2, n)); }},
    {"2D lists in old memory", 0, [=](auto n) { return lists_in_old_memory<2>(dense(2, n)); }},
    {"3D lists in old memory", 0, [=](auto n) { return lists_in_old_memory<3>(dense(3, n)); }},
    {"3D periodic pairs", 0, [=](auto n) { return periodic_pairs(dense(3, n)); }},
    {"3D periodic lists", 0, [=](auto n) { return periodic_lists(dense(3, n)); }},
    {"2D boxes", 0,
     [](auto n) { return boxes<Rectangle_from_numbers>(uniform_boxes(2, n, double(n))); }},
    {"3D boxes", 0,
     [](auto n) { return boxes<Cuboid_from_numbers>(uniform_boxes(3, n, double(n))); }},
    {"3D cuboids", 0,
     [](auto n) { return objects<Cuboid_from_numbers>(uniform_boxes(3, n, double(n))); }},
    {"3D balls", 0, [](auto n) { return balls(power_law_balls(n, double(n))); }},
    {"2D segments", 0,
     [](auto n) { return objects<Segment_2>(uniform_segments(2, n, double(n))); }},
    {"3D near segments", 0,
     [](auto n) {
       return near_objects<Segment_3>(uniform_segments(3, n, double(n)),
                                      0.2 / std::cbrt(double(n)));
     }},
    {"2D polygons", 0,
     [](auto n) { return features(features_of<CGAL::Polygon_2<Epick>>(stars(n))); }},
    {"2D polylines", 0, [](auto n) { return features(features_of<Polyline>(stars(n))); }},
    {"3D solids", 0, [](auto n) { return features(soups_of(machine_parts(n / 200))); }},
    {"2D tracks", 0, [](auto n) { return near_tracks<2>(short_legs(2, n, false)); }},
    {"3D tracks", 0, [](auto n) { return near_tracks<3>(short_legs(3, n, false)); }},
  };
}

} // namespace thick_benchmark
