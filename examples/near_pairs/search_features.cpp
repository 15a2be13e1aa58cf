// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of features; see feature_pairs.h.

#include "feature_pairs.h"

#include "bound.h"
#include "decimal.h"
#include "error.h"
#include "locked_functor.h"
#include "progress.h"
#include "search_solids.h"
#include "stop.h"
#include "text.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/interiors.h>
#include <CGAL/tags.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
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

Polygon polygon_of(const std::vector<Vertices>& rings)
{
  Polygon polygon(ring_of(rings.front()));
  for(std::size_t hole = 1; hole < rings.size(); ++hole)
    polygon.add_hole(ring_of(rings[hole]));
  return polygon;
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
    for(const std::vector<Vertices>& rings : feature.polygons)
      parts.emplace_back(polygon_of(rings));
    all.push_back(std::move(parts));
  }
  return all;
}

// The polygons of the features of a file, which have nothing else.
std::vector<std::vector<Polygon>> polygons_of(const std::vector<Feature>& features,
                                              const std::string& file)
{
  std::vector<std::vector<Polygon>> all;
  for(const Feature& feature : features) {
    if(!feature.lines.empty())
      throw Error(file + ": feature " + std::to_string(all.size()) + " has points or lines, and "
                  "--overlap is for polygons");
    all.emplace_back();
    for(const std::vector<Vertices>& rings : feature.polygons)
      all.back().push_back(polygon_of(rings));
  }
  return all;
}

template <class ConcurrencyTag>
bool report_pairs_by(const std::vector<std::vector<Feature>>& files, const Exact_bound& bound,
                     const Options& options, const Pair_functor& functor)
{
  Locked_functor callback(functor);
  const auto go_on = progress_functor(options.progress);
  const auto parameters = CGAL::parameters::callback(go_on);
  const std::vector<Parts> first = parts_of(files.front());
  if(files.size() == 1)
    return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, bound, callback, parameters);
  return CGAL::fixed_radius_near_features<ConcurrencyTag>(first, parts_of(files.back()), bound,
                                                          callback, parameters);
}

template <class ConcurrencyTag>
bool report_overlaps_by(const std::vector<std::vector<Feature>>& files, const Options& options,
                        const Pair_functor& functor)
{
  Locked_functor callback(functor);
  const auto go_on = progress_functor(options.progress);
  const auto parameters = CGAL::parameters::callback(go_on);
  const auto first = polygons_of(files.front(), options.files.front());
  if(files.size() == 1)
    return CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(CGAL::interiors(first),
                                                                   callback, parameters);
  return CGAL::thick_feature_intersection_d<ConcurrencyTag>(
    CGAL::interiors(first), CGAL::interiors(polygons_of(files.back(), options.files.back())),
    callback, parameters);
}

bool report_overlaps(const std::vector<std::vector<Feature>>& files, const Options& options,
                     const Pair_functor& functor)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    return report_overlaps_by<CGAL::Parallel_tag>(files, options, functor);
#endif
  return report_overlaps_by<CGAL::Sequential_tag>(files, options, functor);
}

// Returns false iff the search was stopped.
bool report_pairs(const std::vector<std::vector<Feature>>& files, const Exact_bound& bound,
                  const Options& options, const Pair_functor& functor)
{
  if(options.solids)
    return report_solid_pairs(files, bound, options, functor);
#ifdef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    return report_pairs_by<CGAL::Parallel_tag>(files, bound, options, functor);
#endif
  return report_pairs_by<CGAL::Sequential_tag>(files, bound, options, functor);
}

// What a distance of features may be wrong by because decimals are rounded to doubles.
double rounding_in(const std::vector<std::vector<Feature>>& files)
{
  double largest = 0;
  bool has_rounded = false;
  const auto look_at = [&](const auto& vertices) {
    for(const auto& vertex : vertices)
      for(double coordinate : vertex) {
        largest = std::max(largest, std::abs(coordinate));
        has_rounded = has_rounded || is_rounded(*parse_decimal(shortest_text(coordinate)));
      }
  };
  for(const std::vector<Feature>& features : files)
    for(const Feature& feature : features) {
      std::for_each(feature.lines.begin(), feature.lines.end(), look_at);
      for(const std::vector<Vertices>& rings : feature.polygons)
        std::for_each(rings.begin(), rings.end(), look_at);
      look_at(feature.mesh.points);
    }
  return has_rounded ? rounding_of(largest) : 0;
}

} // namespace

void search_features(const std::vector<std::vector<Feature>>& files, const Options& options,
                     const Feature_pair_sink& sink)
{
  const auto add_pair = [&](std::size_t i, std::size_t j) {
    sink(i, j);
    return !stop_requested;
  };
  if(!(options.overlap ? report_overlaps(files, options, add_pair)
                       : report_pairs(files, bound_of(options), options, add_pair)))
    throw Error("stopped");
}

bool has_moved_ties(const std::vector<std::vector<Feature>>& files, const Options& options,
                    std::size_t pairs)
{
  if(options.overlap)
    return false;
  const double excess = excess_of_longer_bound(options, rounding_in(files));
  if(excess == 0)
    return false;
  const Exact_bound moved = longer_bound_of(options, options.open ? -excess : excess);
  Options quietly = options; // the search has shown its progress
  quietly.progress = false;
  std::size_t count = 0;
  report_pairs(files, moved, quietly, [&](std::size_t, std::size_t) {
    return ++count <= pairs && !stop_requested;
  });
  return count != pairs && !stop_requested;
}

} // namespace near_pairs
