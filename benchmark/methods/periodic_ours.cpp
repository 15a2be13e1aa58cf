// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "periodic_methods.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>

#include <memory>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Lattice = CGAL::Periodic_lattice_d<Kernel::Vector_3>;

// The scene in the types of the kernel, and the domain: an iso-box if the vectors are its sides.
struct Kernel_scene
{
  std::vector<Kernel::Point_3> points;
  Lattice lattice;
  Kernel::Iso_cuboid_3 box;
  bool is_box;
  CGAL::Distance_bound<double> bound;

  explicit Kernel_scene(const Periodic_scene& scene)
    : lattice(vector(scene.vectors[0]), vector(scene.vectors[1]), vector(scene.vectors[2])),
      box(0, 0, 0, scene.vectors[0][0], scene.vectors[1][1], scene.vectors[2][2]), is_box(true),
      bound(CGAL::within_distance(scene.r))
  {
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t axis = 0; axis < 3; ++axis)
        is_box = is_box && (k == axis || scene.vectors[k][axis] == 0);
    for(const auto& p : scene.points) {
      points.emplace_back(p[0], p[1], p[2]);
      for(std::size_t axis = 0; axis < 3; ++axis)
        is_box = is_box && p[axis] >= 0 && p[axis] < scene.vectors[axis][axis];
    }
  }

  static Kernel::Vector_3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

  template <class Callback>
  void search(Callback& callback) const
  {
    if(is_box)
      CGAL::periodic_fixed_radius_near_neighbors(points, box, bound, callback);
    else
      CGAL::periodic_fixed_radius_near_neighbors(points, lattice, bound, callback);
  }

  Image_pairs pairs() const
  {
    Image_pairs pairs;
    const auto store = [&pairs](std::size_t i, std::size_t j, const Offset& offset) {
      pairs.emplace_back(i, j, offset);
    };
    search(store);
    return pairs;
  }
};

// Makes a method of count(kernel scene).
template <class Count>
Periodic_method method(const char* name, const Count& count)
{
  return {name, false, [=](const Periodic_scene& scene) {
            const auto own = std::make_shared<const Kernel_scene>(scene);
            return Periodic_run{[=] { return count(*own); }, [=] { return own->pairs(); }};
          }};
}

volatile std::size_t sink; // keeps the compiler from leaving out what is not looked at

} // namespace

Periodic_method periodic_counted()
{
  return method("Thick_intersection_d, pairs counted", [](const Kernel_scene& scene) {
    std::size_t count = 0, sum = 0;
    const auto add = [&](std::size_t i, std::size_t j, const Offset& offset) {
      ++count;
      sum ^= i ^ j ^ static_cast<std::size_t>(offset[0] + offset[1] + offset[2]);
    };
    scene.search(add);
    sink = sum;
    return count;
  });
}

Periodic_method periodic_stored()
{
  return method("Thick_intersection_d, pairs stored",
                [](const Kernel_scene& scene) { return scene.pairs().size(); });
}

Periodic_method periodic_lists()
{
  return method("Thick_intersection_d, lists", [](const Kernel_scene& scene) {
    const auto lists
      = scene.is_box
          ? CGAL::periodic_fixed_radius_neighbor_lists(scene.points, scene.box, scene.bound)
          : CGAL::periodic_fixed_radius_neighbor_lists(scene.points, scene.lattice, scene.bound);
    return lists.offsets().size();
  });
}

Periodic_method points_without_periods()
{
  return method("the same without periods, pairs counted", [](const Kernel_scene& scene) {
    std::size_t count = 0, sum = 0;
    CGAL::fixed_radius_near_neighbors(scene.points, scene.bound, [&](std::size_t i, std::size_t j) {
      ++count;
      sum ^= i ^ j;
    });
    sink = sum;
    return count;
  });
}

} // namespace thick_benchmark
