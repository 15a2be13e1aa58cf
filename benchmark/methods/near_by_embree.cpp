// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "on_near_objects.h"

#include <CGAL/squared_distance_3.h>

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

float float_below(double x)
{
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}
float float_above(double x) { return -float_below(-x); }

// What the tree of Embree asks for and tells.
template <class Object>
struct Collisions
{
  const std::vector<Object>& objects;
  double r;
  Pair_list& pairs;

  // The box of an object, grown by half of the distance.
  static void bound(const RTCBoundsFunctionArguments* arguments)
  {
    const auto& self = *static_cast<const Collisions*>(arguments->geometryUserPtr);
    const CGAL::Bbox_3 box = grown(self.objects[arguments->primID].bbox(), self.r / 2);
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = float_below(box.xmin());
    bounds.lower_y = float_below(box.ymin());
    bounds.lower_z = float_below(box.zmin());
    bounds.upper_x = float_above(box.xmax());
    bounds.upper_y = float_above(box.ymax());
    bounds.upper_z = float_above(box.zmax());
  }

  // Each pair is told twice.
  static void report(void* pointer, RTCCollision* collisions, unsigned count)
  {
    const auto& self = *static_cast<const Collisions*>(pointer);
    for(unsigned k = 0; k < count; ++k) {
      const std::size_t i = collisions[k].primID0, j = collisions[k].primID1;
      if(i < j && CGAL::squared_distance(self.objects[i], self.objects[j]) <= self.r * self.r)
        self.pairs(i, j);
    }
  }
};

template <class Object>
void search(RTCDevice device, const std::vector<Object>& objects, double r, Pair_list& pairs)
{
  Collisions<Object> collisions = {objects, r, pairs};
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(objects.size()));
  rtcSetGeometryUserData(geometry, &collisions);
  rtcSetGeometryBoundsFunction(geometry, Collisions<Object>::bound, nullptr);
  rtcCommitGeometry(geometry);
  const RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  rtcCollide(scene, scene, Collisions<Object>::report, &collisions);
  rtcReleaseScene(scene);
}

} // namespace

Near_method near_by_embree()
{
  return {"Embree collisions", on_near_objects([](const auto& objects, double r, Pair_list& pairs) {
            using Object = typename std::decay_t<decltype(objects)>::value_type;
            static const RTCDevice device = rtcNewDevice("threads=1");
            if constexpr(CGAL::Ambient_dimension<Object>::value == 3)
              search(device, objects, r, pairs);
            else
              throw std::invalid_argument("Embree works in space.");
          })};
}

} // namespace thick_benchmark
