// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "overlap_methods.h"

#include <geos_c.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace thick_benchmark {

namespace {

// The polygons, which are freed with it.
class Geos_polygons
{
public:
  explicit Geos_polygons(const Rings& rings)
  {
    for(const Ring& ring : rings) {
      GEOSCoordSequence* const points
        = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(ring.size() + 1), 2);
      for(std::size_t k = 0; k <= ring.size(); ++k)
        GEOSCoordSeq_setXY_r(context_, points, static_cast<unsigned>(k), ring[k % ring.size()][0],
                             ring[k % ring.size()][1]);
      polygons_.push_back(GEOSGeom_createPolygon_r(
        context_, GEOSGeom_createLinearRing_r(context_, points), nullptr, 0));
    }
  }
  Geos_polygons(const Geos_polygons&) = delete;
  Geos_polygons& operator=(const Geos_polygons&) = delete;
  ~Geos_polygons()
  {
    for(GEOSGeometry* polygon : polygons_)
      GEOSGeom_destroy_r(context_, polygon);
    GEOS_finish_r(context_);
  }

  Tally overlaps() const
  {
    GEOSSTRtree* const tree = GEOSSTRtree_create_r(context_, 10);
    for(GEOSGeometry* const& polygon : polygons_)
      GEOSSTRtree_insert_r(context_, tree, polygon, const_cast<GEOSGeometry**>(&polygon));
    Search search = {*this, 0, nullptr, {}};
    for(; search.i < polygons_.size(); ++search.i) {
      search.prepared = GEOSPrepare_r(context_, polygons_[search.i]);
      GEOSSTRtree_query_r(context_, tree, polygons_[search.i], &ask, &search);
      GEOSPreparedGeom_destroy_r(context_, search.prepared);
    }
    GEOSSTRtree_destroy_r(context_, tree);
    return search.tally;
  }

private:
  struct Search
  {
    const Geos_polygons& all;
    std::size_t i;
    const GEOSPreparedGeometry* prepared;
    Tally tally;
  };

  // Polygons that intersect are related in their interiors, or touch.
  static void ask(void* item, void* user)
  {
    Search& search = *static_cast<Search*>(user);
    const Geos_polygons& all = search.all;
    const auto j = static_cast<std::size_t>(static_cast<GEOSGeometry**>(item)
                                            - all.polygons_.data());
    if(j > search.i
       && GEOSPreparedIntersects_r(all.context_, search.prepared, all.polygons_[j]) == 1
       && GEOSRelatePattern_r(all.context_, all.polygons_[search.i], all.polygons_[j],
                              "T********") == 1)
      search.tally(search.i, j);
  }

  GEOSContextHandle_t context_ = GEOS_init_r();
  std::vector<GEOSGeometry*> polygons_;
};

} // namespace

Overlap_search overlaps_by_geos(const Rings& rings)
{
  return [polygons = std::make_shared<const Geos_polygons>(rings)] { return polygons->overlaps(); };
}

} // namespace thick_benchmark
