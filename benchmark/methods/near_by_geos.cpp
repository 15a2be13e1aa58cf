// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The C interface of GEOS, whose C++ interface promises nothing from one version to the next.

#include "on_near_objects.h"

#include <geos_c.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

class Geometries
{
public:
  explicit Geometries(const Object_scene& scene) : context_(GEOS_init_r())
  {
    if(scene.dimension != 2)
      throw std::invalid_argument("GEOS works in the plane.");
    for(std::size_t i = 0; i < scene.size(); ++i)
      geometries_.push_back(geometry(scene, i));
  }
  ~Geometries()
  {
    for(GEOSGeometry* geometry : geometries_)
      GEOSGeom_destroy_r(context_, geometry);
    GEOS_finish_r(context_);
  }
  Geometries(const Geometries&) = delete;
  Geometries& operator=(const Geometries&) = delete;

  void search(double r, Pair_list& pairs) const;

private:
  // A line, or a polygon with a ring that is closed.
  GEOSGeometry* geometry(const Object_scene& scene, std::size_t i) const
  {
    const std::size_t corners = corners_of(scene.shape);
    const bool is_polygon = corners > 2;
    const auto size = static_cast<unsigned>(corners + (is_polygon ? 1 : 0));
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, size, 2);
    for(unsigned k = 0; k < size; ++k) {
      const double* corner = scene.object(i) + k % corners * 2;
      GEOSCoordSeq_setXY_r(context_, sequence, k, corner[0], corner[1]);
    }
    return is_polygon
             ? GEOSGeom_createPolygon_r(context_, GEOSGeom_createLinearRing_r(context_, sequence),
                                        nullptr, 0)
             : GEOSGeom_createLineString_r(context_, sequence);
  }

  GEOSContextHandle_t context_;
  std::vector<GEOSGeometry*> geometries_;
};

// What a query of the tree is about.
struct Query
{
  GEOSContextHandle_t context;
  const std::vector<GEOSGeometry*>& geometries;
  GEOSGeometry* const* first;
  double r;
  Pair_list& pairs;
};

void report(void* item, void* data)
{
  const Query& query = *static_cast<const Query*>(data);
  GEOSGeometry* const* second = static_cast<GEOSGeometry* const*>(item);
  if(query.first < second
     && GEOSDistanceWithin_r(query.context, *query.first, *second, query.r) == 1)
    query.pairs(static_cast<std::size_t>(query.first - query.geometries.data()),
                static_cast<std::size_t>(second - query.geometries.data()));
}

void Geometries::search(double r, Pair_list& pairs) const
{
  GEOSSTRtree* tree = GEOSSTRtree_create_r(context_, 10);
  for(GEOSGeometry* const& geometry : geometries_)
    GEOSSTRtree_insert_r(context_, tree, geometry, const_cast<GEOSGeometry**>(&geometry));
  for(GEOSGeometry* const& geometry : geometries_) {
    Query query = {context_, geometries_, &geometry, r, pairs};
    double low[2], high[2];
    GEOSGeom_getExtent_r(context_, geometry, low, low + 1, high, high + 1);
    GEOSCoordSequence* ends = GEOSCoordSeq_create_r(context_, 2, 2);
    GEOSCoordSeq_setXY_r(context_, ends, 0, below(low[0] - r), below(low[1] - r));
    GEOSCoordSeq_setXY_r(context_, ends, 1, above(high[0] + r), above(high[1] + r));
    GEOSGeometry* diagonal = GEOSGeom_createLineString_r(context_, ends);
    GEOSSTRtree_query_r(context_, tree, diagonal, report, &query);
    GEOSGeom_destroy_r(context_, diagonal);
  }
  GEOSSTRtree_destroy_r(context_, tree);
}

} // namespace

Near_method near_by_geos()
{
  return {"GEOS STRtree", [](const Near_scene& scene) -> Run<Pair_list> {
            const auto geometries = std::make_shared<const Geometries>(scene.objects);
            return [geometries, r = scene.r] {
              Pair_list pairs;
              geometries->search(r, pairs);
              return pairs;
            };
          }};
}

} // namespace thick_benchmark
