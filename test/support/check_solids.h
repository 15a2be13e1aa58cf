// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of meshes and polylines on a kernel, in one range and in two, against the oracle.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_SOLIDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_SOLIDS_H

#include "check_features.h"
#include "solid_oracle.h"
#include "solid_scenes.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace test_support {

// Where a lattice is: at the origin, or elsewhere in other units.
struct Placement
{
  Scale scale = Scale::ONE;
  double origin = 0;
  double unit = 1;
};

template <class Kernel>
typename Kernel::Point_3 placed_point(const Lattice_point& p, const Placement& placement)
{
  return Kernel_types<Kernel, 3>::point([&](std::size_t axis) {
    return scaled<typename Kernel::FT>(
      placement.origin + placement.unit * static_cast<double>(p[axis]), placement.scale);
  });
}

template <class Kernel>
using Soup = std::pair<std::vector<typename Kernel::Point_3>,
                       std::vector<std::array<std::size_t, 3>>>;

// A soup of points that are all different, or one in which no two faces have a point in common.
template <class Kernel>
Soup<Kernel> soup_of(const Lattice_mesh& mesh, const Placement& placement, bool is_shared)
{
  Soup<Kernel> soup;
  std::map<Lattice_point, std::size_t> indices;
  for(const Lattice_face& face : mesh) {
    soup.second.emplace_back();
    for(std::size_t k = 0; k < 3; ++k) {
      std::size_t& index = soup.second.back()[k] = soup.first.size();
      if(is_shared)
        index = indices.emplace(face[k], index).first->second;
      if(index == soup.first.size())
        soup.first.push_back(placed_point<Kernel>(face[k], placement));
    }
  }
  return soup;
}

// A mesh, if the faces of the soup are one: if each edge has at most two, which are turned alike.
template <class Kernel>
std::optional<CGAL::Surface_mesh<typename Kernel::Point_3>> mesh_of(const Soup<Kernel>& soup)
{
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
  std::vector<typename CGAL::Surface_mesh<typename Kernel::Point_3>::Vertex_index> vertices;
  for(const auto& p : soup.first)
    vertices.push_back(mesh.add_vertex(p));
  for(const auto& [p, q, r] : soup.second)
    if(p == q || q == r || r == p
       || mesh.add_face(vertices[p], vertices[q], vertices[r]) == mesh.null_face())
      return std::nullopt;
  return mesh;
}

// Meshes of all forms.
template <class Kernel>
struct Solids
{
  static constexpr bool have_chains = false;
  using Point = typename Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Member = std::variant<Soup<Kernel>, Mesh>;
  using Feature = std::vector<Member>;

  static Member member(const Lattice_mesh& mesh, const Placement& placement, bool is_shared)
  {
    const Soup<Kernel> soup = soup_of<Kernel>(mesh, placement, is_shared);
    if(auto surface = mesh_of<Kernel>(soup))
      return std::move(*surface);
    return soup;
  }

  static Feature make(const Lattice_solid& solid, const Placement& placement, bool is_shared)
  {
    Feature feature;
    for(const Lattice_mesh& mesh : solid.meshes)
      feature.push_back(member(mesh, placement, is_shared));
    return feature;
  }
};

// The same with polylines.
template <class Kernel>
struct Solids_and_polylines
{
  static constexpr bool have_chains = true;
  using Point = typename Kernel::Point_3;
  using Member = std::variant<typename Solids<Kernel>::Member, std::vector<Point>>;
  using Feature = std::vector<Member>;

  static Feature make(const Lattice_solid& solid, const Placement& placement, bool is_shared)
  {
    Feature feature;
    for(const Lattice_mesh& mesh : solid.meshes)
      feature.push_back(Solids<Kernel>::member(mesh, placement, is_shared));
    for(const Chain& chain : solid.chains) {
      feature.push_back(std::vector<Point>());
      for(const Lattice_point& p : chain)
        std::get<1>(feature.back()).push_back(placed_point<Kernel>(p, placement));
    }
    return feature;
  }
};

template <class Features>
std::vector<typename Features::Feature> features_of(const Lattice_solids& solids,
                                                    const Placement& placement)
{
  std::vector<typename Features::Feature> features;
  for(std::size_t i = 0; i < solids.size(); ++i)
    features.push_back(Features::make(solids[i], placement, i % 3 != 0));
  return features;
}

template <class Features, class Kernel>
void check_solids_on_kernel(const Solid_scene& scene, const Pairs& expected,
                            const Placement& placement)
{
  if(!can_scale<typename Kernel::FT>(placement.scale))
    return;
  const auto in_sequence = features_of<Features>(scene.solids, placement);
  check_features<CGAL::Sequential_tag, Features>(in_sequence, expected, "in sequence");
  const auto in_parallel = features_of<Features>(scene.solids, placement);
  check_features<CGAL::Parallel_tag, Features>(in_parallel, expected, "in parallel");
}

// Scenes on each of the kernels, at each of the places.
template <template <class> class Features, class... Kernels>
void check_solids(const std::vector<Solid_scene>& scenes, const std::vector<Placement>& placements)
{
  std::size_t pairs = 0;
  for(Solid_scene scene : scenes) {
    if(!Features<Epick>::have_chains)
      scene = without_chains(scene);
    const Pairs expected = pairs_of_solids(scene.solids);
    pairs += expected.size();
    for(std::size_t place = 0; place < placements.size(); ++place)
      BOOST_TEST_CONTEXT(scene.name << ", placement " << place)
      (check_solids_on_kernel<Features<Kernels>, Kernels>(scene, expected, placements[place]), ...);
  }
  BOOST_CHECK_GT(pairs, 10u);
}

// Pairs within a bound on the squared distance, in the unit of the lattice.
template <class Features, class Kernel>
void check_near_solids(const std::vector<Solid_scene>& scenes, const Lattice_bound& r2)
{
  using FT = typename Kernel::FT;
  const CGAL::Distance_bound<FT> bound(FT(static_cast<int>(r2.r2)), true, r2.is_open);
  for(const Solid_scene& scene : scenes) {
    const Pairs expected = pairs_of_solids(scene.solids, r2);
    const auto features = features_of<Features>(scene.solids, Placement());
    const auto ranges = split(features, first_set_size(features.size()));
    const Pairs of_one = collected([&](const Callback& callback) {
      BOOST_CHECK(CGAL::fixed_radius_near_features<CGAL::Parallel_tag>(features, bound, callback));
    });
    const Pairs of_two = collected([&](const Callback& callback) {
      BOOST_CHECK(
        CGAL::fixed_radius_near_features(ranges.first, ranges.second, bound, callback));
    });
    check_pairs(scene.name, expected, of_one, of_two, ranges.first.size());
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_SOLIDS_H
