// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of features; see feature_pairs.h.

#include "feature_pairs.h"

#include "error.h"
#include "rational.h"
#include "stop.h"

#include <CGAL/Distance_bound.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/tags.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <cstddef>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

namespace near_pairs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Ring = CGAL::Polygon_2<Kernel>;
using Polygon = CGAL::Polygon_with_holes_2<Kernel>;
using Parts = std::vector<std::variant<std::vector<Point>, Polygon>>;

Point point_of(const Vertex& vertex)
{
  return Point(vertex[0], vertex[1]);
}

Ring ring_of(const Vertices& vertices)
{
  Ring ring;
  for(const Vertex& vertex : vertices)
    ring.push_back(point_of(vertex));
  return ring;
}

std::vector<Parts> parts_of(const std::vector<Feature>& features)
{
  std::vector<Parts> all;
  for(const Feature& feature : features) {
    Parts parts;
    for(const Vertices& line : feature.lines) {
      std::vector<Point> points;
      for(const Vertex& vertex : line)
        points.push_back(point_of(vertex));
      parts.emplace_back(std::move(points));
    }
    for(const std::vector<Vertices>& rings : feature.polygons) {
      Polygon polygon(ring_of(rings.front()));
      for(std::size_t hole = 1; hole < rings.size(); ++hole)
        polygon.add_hole(ring_of(rings[hole]));
      parts.emplace_back(std::move(polygon));
    }
    all.push_back(std::move(parts));
  }
  return all;
}

// Returns false iff the search was stopped.
template <class ConcurrencyTag, class Bound>
bool report_pairs(const std::vector<std::vector<Feature>>& files, const Bound& bound,
                  const Feature_pair_sink& sink)
{
  std::mutex mutex; // several threads may call
  const auto callback = [&](std::size_t i, std::size_t j) {
    const std::lock_guard<std::mutex> lock(mutex);
    sink(i, j);
    return !stop_requested;
  };
  const std::vector<Parts> first = parts_of(files.front());
  if(files.size() == 1)
    return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, bound, callback);
  return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, parts_of(files.back()), bound,
                                                          callback);
}

} // namespace

void search_features(const std::vector<std::vector<Feature>>& files, const Options& options,
                     const Feature_pair_sink& sink)
{
  const CGAL::Exact_rational& distance = options.distance->value;
  auto bound = options.squared ? CGAL::within_squared_distance(distance)
                               : CGAL::within_distance(distance);
  if(options.open)
    bound = bound.open();
#ifdef CGAL_LINKED_WITH_TBB
  const bool is_complete = options.parallel
    ? report_pairs<CGAL::Parallel_tag>(files, bound, sink)
    : report_pairs<CGAL::Sequential_tag>(files, bound, sink);
#else
  const bool is_complete = report_pairs<CGAL::Sequential_tag>(files, bound, sink);
#endif
  if(!is_complete)
    throw Error("stopped");
}

} // namespace near_pairs
