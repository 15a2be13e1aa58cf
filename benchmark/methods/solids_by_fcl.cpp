// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "solid_methods.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <memory>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace {

using Tree = fcl::BVHModel<fcl::AABB<double>>;

struct Lists
{
  std::vector<fcl::Vector3d> points;
  std::vector<fcl::Triangle> faces;
};

std::vector<Lists> lists_of(const Solid_scene& scene)
{
  std::vector<Lists> all;
  for(const Mesh_scene& solid : scene.solids) {
    Lists& lists = all.emplace_back();
    for(const auto& p : solid.points)
      lists.points.emplace_back(p[0], p[1], p[2]);
    for(const auto& face : solid.faces)
      lists.faces.emplace_back(face[0], face[1], face[2]);
  }
  return all;
}

// Called for two objects whose boxes meet.
bool count_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* pairs)
{
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  if(fcl::collide(a, b, request, result) != 0)
    ++*static_cast<std::size_t*>(pairs);
  return false; // go on
}

std::size_t count_pairs(const std::vector<Lists>& solids)
{
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  for(const Lists& lists : solids) {
    const auto tree = std::make_shared<Tree>();
    tree->beginModel(static_cast<int>(lists.faces.size()), static_cast<int>(lists.points.size()));
    tree->addSubModel(lists.points, lists.faces);
    tree->endModel();
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(tree));
    manager.registerObject(objects.back().get());
  }
  manager.setup();
  std::size_t pairs = 0;
  manager.collide(&pairs, count_pair);
  return pairs;
}

} // namespace

Solid_method solids_by_fcl()
{
  return {"FCL", [](const Solid_scene& scene) {
            return [solids = std::make_shared<const std::vector<Lists>>(lists_of(scene))] {
              return count_pairs(*solids);
            };
          }};
}

} // namespace thick_benchmark
