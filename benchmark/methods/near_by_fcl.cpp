// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_methods.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

using Collision_object = fcl::CollisionObject<double>;
using Collision_objects = std::vector<std::unique_ptr<Collision_object>>;

// FCL has no distance of its shapes for triangles, but one of meshes.
Collision_objects triangles_of(const Object_scene& scene)
{
  if(scene.shape != Shape::TRIANGLE || scene.dimension != 3)
    throw std::invalid_argument("FCL has triangles in space.");
  Collision_objects objects;
  for(std::size_t i = 0; i < scene.size(); ++i) {
    const double* x = scene.object(i);
    const fcl::Vector3d a(x[0], x[1], x[2]), b(x[3], x[4], x[5]), c(x[6], x[7], x[8]);
    const auto mesh = std::make_shared<fcl::BVHModel<fcl::RSS<double>>>();
    mesh->beginModel(1, 3);
    mesh->addTriangle(a, b, c);
    mesh->endModel();
    objects.push_back(std::make_unique<Collision_object>(mesh));
    objects.back()->setUserData(reinterpret_cast<void*>(std::uintptr_t(i)));
  }
  return objects;
}

std::size_t position(const Collision_object& object)
{
  return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(object.getUserData()));
}

struct Query
{
  double r;
  Pair_list& pairs;
};

// The tree then goes on with pairs of boxes that are closer than `limit`.
bool report(Collision_object* a, Collision_object* b, void* data, double& limit)
{
  const Query& query = *static_cast<const Query*>(data);
  limit = std::nextafter(query.r, std::numeric_limits<double>::infinity());
  fcl::DistanceResult<double> result;
  if(fcl::distance(a, b, fcl::DistanceRequest<double>(), result) <= query.r)
    query.pairs((std::min)(position(*a), position(*b)), (std::max)(position(*a), position(*b)));
  return false;
}

Pair_list search(const Collision_objects& objects, double r)
{
  Pair_list pairs;
  Query query = {r, pairs};
  std::vector<Collision_object*> addresses;
  for(const auto& object : objects)
    addresses.push_back(object.get());
  fcl::DynamicAABBTreeCollisionManager<double> tree;
  tree.registerObjects(addresses);
  tree.setup();
  tree.distance(&query, report);
  return pairs;
}

} // namespace

Near_method near_by_fcl()
{
  return {"FCL", [](const Near_scene& scene) -> Run<Pair_list> {
            const auto objects
              = std::make_shared<const Collision_objects>(triangles_of(scene.objects));
            return [objects, r = scene.r] { return search(*objects, r); };
          }};
}

} // namespace thick_benchmark
