// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Interiors of polygons on a kernel, with each other and with closed features, against the oracle.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_INTERIORS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_INTERIORS_H

#include "check_features.h"
#include "interior_oracle.h"
#include "interior_scenes.h"

#include <CGAL/interiors.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace test_support {

template <class Kernel>
using Polygon_variant
  = std::variant<typename Features_2<Kernel>::Polygon, typename Features_2<Kernel>::With_holes,
                 typename Features_2<Kernel>::Polygons>;

// The same feature, which is no point and no polyline.
template <class Kernel>
Polygon_variant<Kernel> as_polygon(const typename Features_2<Kernel>::Feature& feature)
{
  return std::visit(
    [](const auto& kind) {
      using Kind = std::decay_t<decltype(kind)>;
      if constexpr(std::is_same_v<Kind, typename Features_2<Kernel>::Point>
                   || std::is_same_v<Kind, typename Features_2<Kernel>::Polyline>)
        return Polygon_variant<Kernel>();
      else
        return Polygon_variant<Kernel>(kind);
    },
    feature);
}

// Polygons and other features, and the pairs of them.
struct Interior_scene
{
  Lattice_features polygons;
  Lattice_features others;
  Pairs open_pairs;   // of polygons
  Pairs closed_pairs; // of a polygon and another feature, which is closed
  Pairs halves;       // of polygons of the first half and of the second half
};

inline Interior_scene interior_scene(std::uint64_t seed, std::size_t size, std::int64_t side)
{
  Interior_scene scene;
  scene.polygons = any_polygons(seed, size, side);
  scene.others = any_features(seed + 1000, size, side);
  scene.open_pairs = pairs_of_interiors(scene.polygons);
  scene.closed_pairs = pairs_of_interiors(scene.polygons, true, scene.others, false);
  scene.halves = of_two_sets(scene.open_pairs, size / 2);
  return scene;
}

template <class ConcurrencyTag, class Kernel>
void check_interiors(const Interior_scene& scene, Scale scale)
{
  using Features = Features_2<Kernel>;
  std::vector<Polygon_variant<Kernel>> polygons;
  std::vector<typename Features::Feature> others;
  for(const Lattice_feature& feature : scene.polygons)
    polygons.push_back(as_polygon<Kernel>(Features::make(feature, scale)));
  for(const Lattice_feature& feature : scene.others)
    others.push_back(Features::make(feature, scale));
  const auto check = [](const char* how, const Pairs& expected, const auto& search) {
    const Pairs_difference difference = compare(expected, collected(search));
    BOOST_CHECK_MESSAGE(difference.empty(), how << ": " << difference);
  };
  check("one range", scene.open_pairs, [&](const Callback& callback) {
    CGAL::thick_feature_self_intersection_d<ConcurrencyTag>(CGAL::interiors(polygons), callback);
  });
  const auto halves = split(polygons, polygons.size() / 2);
  check("two ranges", scene.halves, [&](const Callback& callback) {
    CGAL::thick_feature_intersection_d<ConcurrencyTag>(
      CGAL::interiors(halves.first), CGAL::interiors(halves.second), callback);
  });
  check("the first range", scene.closed_pairs, [&](const Callback& callback) {
    CGAL::thick_feature_intersection_d<ConcurrencyTag>(CGAL::interiors(polygons), others, callback);
  });
  check("the second range", scene.closed_pairs, [&](const Callback& callback) {
    CGAL::thick_feature_intersection_d<ConcurrencyTag>(
      others, CGAL::interiors(polygons),
      [&](std::size_t i, std::size_t j) { callback(j, i); });
  });
}

// Scenes of a few polygons on a small lattice, and of many on a larger one, on each of the kernels
// and of the scales.
template <class... Kernels>
void check_interior_scenes(std::uint64_t seed, std::size_t count, std::size_t size,
                           std::initializer_list<Scale> scales)
{
  std::size_t pairs = 0;
  for(std::size_t k = 0; k < count; ++k) {
    const std::int64_t side = 2 + static_cast<std::int64_t>(k % 6);
    const Interior_scene scene = interior_scene(seed + k, size, side);
    pairs += scene.open_pairs.size() + scene.closed_pairs.size();
    const auto check_on = [&](const auto* kernel, Scale scale) {
      using Kernel = std::decay_t<decltype(*kernel)>;
      if(can_scale<typename Kernel::FT>(scale)) {
        check_interiors<CGAL::Sequential_tag, Kernel>(scene, scale);
        check_interiors<CGAL::Parallel_tag, Kernel>(scene, scale);
      }
    };
    for(const Scale scale : scales)
      BOOST_TEST_CONTEXT("seed " << seed + k << ", scale " << static_cast<int>(scale))
        (check_on(static_cast<const Kernels*>(nullptr), scale), ...);
  }
  BOOST_CHECK_GT(pairs, count * size / 4);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_INTERIORS_H
