// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of features on a kernel, in one range and in two, against the oracle.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_FEATURES_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_FEATURES_H

#include "check_pairs.h"
#include "feature_scenes.h"
#include "kernel_types.h"
#include "parallel_pairs.h"
#include "scales.h"
#include "usual_kernels.h"

#include <CGAL/thick_feature_intersection_d.h>

namespace test_support {

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;

// The first set of two, of one feature in three.
inline std::size_t first_set_size(std::size_t size) { return size / 3; }

template <class Kernel, int Dimension>
auto scaled_point(const Lattice_point& p, Scale scale)
{
  return Kernel_types<Kernel, Dimension>::point([&](std::size_t axis) {
    return scaled<typename Kernel::FT>(static_cast<double>(p[axis]), scale);
  });
}

// The features of a kernel in the plane.
template <class Kernel>
struct Features_2
{
  static constexpr int dimension = 2;
  using Point = typename Kernel::Point_2;
  using Polyline = std::vector<Point>;
  using Polygon = CGAL::Polygon_2<Kernel>;
  using With_holes = CGAL::Polygon_with_holes_2<Kernel>;
  using Polygons = std::vector<Polygon>;
  using Feature = std::variant<Point, Polyline, Polygon, With_holes, Polygons>;

  static Point point(const Lattice_point& p, Scale scale)
  {
    return scaled_point<Kernel, 2>(p, scale);
  }

  static Polyline points(const Chain& chain, Scale scale)
  {
    Polyline points;
    for(const Lattice_point& p : chain)
      points.push_back(point(p, scale));
    return points;
  }

  static Feature make(const Lattice_feature& feature, Scale scale)
  {
    Polygons polygons;
    for(const Chain& chain : feature.chains) {
      const Polyline vertices = points(chain, scale);
      polygons.emplace_back(vertices.begin(), vertices.end());
    }
    switch(feature.kind) {
    case Feature_kind::POINT: return point(feature.chains[0][0], scale);
    case Feature_kind::POLYLINE: return points(feature.chains[0], scale);
    case Feature_kind::POLYGON: return polygons[0];
    case Feature_kind::WITH_HOLES:
      return With_holes(polygons[0], polygons.begin() + 1, polygons.end());
    default: return polygons;
    }
  }
};

// The same in space.
template <class Kernel>
struct Features_3
{
  static constexpr int dimension = 3;
  using Point = typename Kernel::Point_3;
  using Polyline = std::vector<Point>;
  using Feature = std::variant<Point, Polyline>;

  static Feature make(const Lattice_feature& feature, Scale scale)
  {
    Polyline points;
    for(const Lattice_point& p : feature.chains[0])
      points.push_back(scaled_point<Kernel, 3>(p, scale));
    if(feature.kind == Feature_kind::POINT)
      return points[0];
    return points;
  }
};

// Searches the features in one range and in two, of which the first has a third of them.
template <class ConcurrencyTag, class Features>
void check_features(const std::vector<typename Features::Feature>& all, const Pairs& expected,
                    const char* how)
{
  const auto ranges = split(all, first_set_size(all.size()));
  const Pairs of_one = collected([&](const Callback& callback) {
    BOOST_CHECK(CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(all, callback));
  });
  const Pairs of_two = collected([&](const Callback& callback) {
    BOOST_CHECK(CGAL::thick_feature_intersection_d<ConcurrencyTag>(ranges.first, ranges.second,
                                                                   callback));
  });
  check_pairs(how, expected, of_one, of_two, ranges.first.size());
}

// Where all boxes meet.
inline constexpr std::size_t few_features = 20;

// The first features of a scene, or all of them, and the pairs of these among all pairs.
template <class Features>
auto features_and_pairs(const Feature_scene& scene, const Pairs& all_pairs, Scale scale)
{
  const std::size_t size = scale == Scale::CLOSE ? (std::min)(scene.features.size(), few_features)
                                                 : scene.features.size();
  std::pair<std::vector<typename Features::Feature>, Pairs> result;
  for(std::size_t i = 0; i < size; ++i)
    result.first.push_back(Features::make(scene.features[i], scale));
  std::copy_if(all_pairs.begin(), all_pairs.end(), std::back_inserter(result.second),
               [&](const Pair& pair) { return pair.second < size; });
  return result;
}

// In parallel, the features are made again: numbers may be evaluated by several threads.
template <class Features, class Kernel>
void check_features_on_kernel(const Feature_scene& scene, const Pairs& all_pairs, Scale scale)
{
  if(!can_scale<typename Kernel::FT>(scale))
    return;
  const auto in_sequence = features_and_pairs<Features>(scene, all_pairs, scale);
  check_features<CGAL::Sequential_tag, Features>(in_sequence.first, in_sequence.second,
                                                 "in sequence");
  const auto in_parallel = features_and_pairs<Features>(scene, all_pairs, scale);
  check_features<CGAL::Parallel_tag, Features>(in_parallel.first, in_parallel.second,
                                               "in parallel");
}

// Every scene on each of the kernels, and on each of the scales.
template <template <class> class Features, class... Kernels>
void check_feature_scenes(int dimension, std::initializer_list<Scale> scales)
{
  std::size_t pairs = 0;
  for(const Feature_scene& scene : feature_scenes(dimension)) {
    const Pairs expected = intersecting_pairs(scene.features);
    pairs += expected.size();
    for(const Scale scale : scales)
      BOOST_TEST_CONTEXT(scene.name << ", scale " << static_cast<int>(scale))
      (check_features_on_kernel<Features<Kernels>, Kernels>(scene, expected, scale), ...);
  }
  BOOST_CHECK_GT(pairs, 100u);
}

// Pairs within a bound on the squared distance, closed or open, which is in the unit of the scale.
template <template <class> class Features, class Kernel>
void check_near_features_on_kernel(const Feature_scene& scene, const Pairs& all_pairs,
                                   std::int64_t r2, bool is_open, Scale scale)
{
  using FT = typename Kernel::FT;
  const FT unit(scaled<FT>(1, scale) - scaled<FT>(0, scale));
  const CGAL::Distance_bound<FT> bound(FT(FT(static_cast<int>(r2)) * FT(unit * unit)), true,
                                       is_open);
  const auto [all, expected] = features_and_pairs<Features<Kernel>>(scene, all_pairs, scale);
  const auto ranges = split(all, first_set_size(all.size()));
  const Pairs of_one = collected([&, &features = all](const Callback& callback) {
    BOOST_CHECK(CGAL::fixed_radius_near_features<CGAL::Parallel_tag>(features, bound, callback));
  });
  const Pairs of_two = collected([&](const Callback& callback) {
    BOOST_CHECK(
      CGAL::fixed_radius_near_features(ranges.first, ranges.second, bound, callback));
  });
  check_pairs(scene.name, expected, of_one, of_two, ranges.first.size());
}

// Every scene on each of the kernels, and on each of the scales.
template <template <class> class Features, class... Kernels>
void check_near_features(int dimension, std::int64_t r2, bool is_open,
                         std::initializer_list<Scale> scales = {Scale::ONE})
{
  for(const Feature_scene& scene : feature_scenes(dimension)) {
    const Pairs expected = near_feature_pairs(scene.features, r2, is_open);
    for(const Scale scale : scales)
      BOOST_TEST_CONTEXT("scale " << static_cast<int>(scale))
      (check_near_features_on_kernel<Features, Kernels>(scene, expected, r2, is_open, scale), ...);
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_FEATURES_H
