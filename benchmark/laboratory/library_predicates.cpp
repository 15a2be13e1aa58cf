// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A library: the predicates of GEOS in the plane, in twice as many bits.

#include "predicate_columns.h"

#ifdef THICK_BENCHMARK_HAS_GEOS
#include <geos_c.h>

#include <memory>
#include <stdexcept>
#include <utility>
#endif

namespace lab {
namespace {

#ifdef THICK_BENCHMARK_HAS_GEOS
using Geos = std::unique_ptr<GEOSContextHandle_HS, void (*)(GEOSContextHandle_t)>;
using Geos_object = std::shared_ptr<const GEOSGeometry>;

// A line, or a polygon with its first vertex repeated.
Geos_object geos_object(GEOSContextHandle_t geos, const double* x, const Kind& kind)
{
  const auto vertices = static_cast<unsigned int>(kind.vertices);
  const unsigned int size = vertices == 2 ? 2 : 4;
  GEOSCoordSequence* const sequence = GEOSCoordSeq_create_r(geos, size, 2);
  for(unsigned int k = 0; k < size; ++k)
    GEOSCoordSeq_setXY_r(geos, sequence, k, x[2 * (k % vertices)], x[2 * (k % vertices) + 1]);
  GEOSGeometry* const object
    = size == 2 ? GEOSGeom_createLineString_r(geos, sequence)
                : GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, sequence),
                                           nullptr, 0);
  return {object, [geos](const GEOSGeometry* g) {
            GEOSGeom_destroy_r(geos, const_cast<GEOSGeometry*>(g));
          }};
}

Answers ask_geos(const Object_questions& questions, double milliseconds)
{
  const Geos geos(GEOS_init_r(), GEOS_finish_r);
  std::vector<Geos_object> objects;
  for(std::size_t i = 0; i < questions.objects.size(); ++i)
    objects.push_back(
      geos_object(geos.get(), questions.objects.object(i), questions.objects.kind));
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    const char answer = GEOSIntersects_r(geos.get(), objects[i].get(), objects[j].get());
    return answer > 1 ? UNDECIDED : answer == 1 ? YES : NO; // 2 is an exception
  });
}
#endif

} // namespace

Predicate_columns library_predicates()
{
  return {
#ifdef THICK_BENCHMARK_HAS_GEOS
    {"GEOS", "library", [](const Kind& kind) { return knows_closed(kind) && kind.dimension == 2; },
     ask_geos},
#endif
  };
}

} // namespace lab
