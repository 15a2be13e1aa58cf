// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of features on a kernel, in one range and in two, against the oracle.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_FEATURES_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_FEATURES_H

#include "check_objects.h"
#include "feature_oracle.h"
#include "feature_scenes.h"
#include "pairs.h"
#include "parallel_pairs.h"

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

namespace test_support {

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
    using FT = typename Kernel::FT;
    return Point(scaled<FT>(static_cast<double>(p[0]), scale),
                 scaled<FT>(static_cast<double>(p[1]), scale));
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
    using FT = typename Kernel::FT;
    Polyline points;
    for(const Lattice_point& p : feature.chains[0])
      points.emplace_back(scaled<FT>(static_cast<double>(p[0]), scale),
                          scaled<FT>(static_cast<double>(p[1]), scale),
                          scaled<FT>(static_cast<double>(p[2]), scale));
    if(feature.kind == Feature_kind::POINT)
      return points[0];
    return points;
  }
};

// Compares the pairs expected with those of one range, and with those of two ranges, of which the
// first has a third of the features.
template <class One, class Two>
void check_feature_pairs(const Pairs& expected, std::size_t size, const One& search_one,
                         const Two& search_two, const char* how)
{
  const std::size_t middle = first_set_size(size);
  const Pairs_difference of_one = compare(expected, collected([&](const Callback& callback) {
    BOOST_CHECK(search_one(callback));
  }));
  BOOST_CHECK_MESSAGE(of_one.empty(), how << ", one range: " << of_one);
  const Pairs two = collected([&](const Callback& callback) {
    const Callback callback_of_two
      = [&](std::size_t i, std::size_t j) { callback(i, middle + j); };
    BOOST_CHECK(search_two(callback_of_two));
  });
  const Pairs_difference of_two = compare(between_sets(expected, middle), two);
  BOOST_CHECK_MESSAGE(of_two.empty(), how << ", two ranges: " << of_two);
}

template <class ConcurrencyTag, class Features>
void check_features(const std::vector<typename Features::Feature>& all, const Pairs& expected,
                    const char* how)
{
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(first_set_size(all.size()));
  const std::vector<typename Features::Feature> a(all.begin(), middle), b(middle, all.end());
  check_feature_pairs(
    expected, all.size(),
    [&](const Callback& callback) {
      return CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(all, callback);
    },
    [&](const Callback& callback) {
      return CGAL::thick_feature_intersection_d<ConcurrencyTag>(a, b, callback);
    },
    how);
}

// Where all boxes meet.
inline constexpr std::size_t few_features = 20;

// In parallel, two kernels are enough: one that computes when it is asked, one that does not.
template <class Features, class Kernel>
void check_features_on_kernel(const Feature_scene& scene, const Pairs& all_pairs, Scale scale)
{
  if(!can_scale<typename Kernel::FT>(scale))
    return;
  const std::size_t size = scale == Scale::CLOSE ? (std::min)(scene.features.size(), few_features)
                                                 : scene.features.size();
  const auto make = [&] {
    std::vector<typename Features::Feature> features;
    for(std::size_t i = 0; i < size; ++i)
      features.push_back(Features::make(scene.features[i], scale));
    return features;
  };
  Pairs expected;
  std::copy_if(all_pairs.begin(), all_pairs.end(), std::back_inserter(expected),
               [&](const Pair& pair) { return pair.second < size; });
  check_features<CGAL::Sequential_tag, Features>(make(), expected, "in sequence");
  check_features<CGAL::Parallel_tag, Features>(make(), expected, "in parallel");
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
  using Feature = typename Features<Kernel>::Feature;
  const FT unit(scaled<FT>(1, scale) - scaled<FT>(0, scale));
  const CGAL::Distance_bound<FT> bound(FT(FT(static_cast<int>(r2)) * FT(unit * unit)), true,
                                       is_open);
  const std::size_t size = scale == Scale::CLOSE ? (std::min)(scene.features.size(), few_features)
                                                 : scene.features.size();
  std::vector<Feature> all;
  for(std::size_t i = 0; i < size; ++i)
    all.push_back(Features<Kernel>::make(scene.features[i], scale));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(first_set_size(all.size()));
  const std::vector<Feature> a(all.begin(), middle), b(middle, all.end());
  Pairs expected;
  std::copy_if(all_pairs.begin(), all_pairs.end(), std::back_inserter(expected),
               [&](const Pair& pair) { return pair.second < size; });
  check_feature_pairs(
    expected, all.size(),
    [&](const Callback& callback) {
      return CGAL::fixed_radius_near_features<CGAL::Parallel_tag>(all, bound, callback);
    },
    [&](const Callback& callback) {
      return CGAL::fixed_radius_near_features(a, b, bound, callback);
    },
    scene.name.c_str());
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
