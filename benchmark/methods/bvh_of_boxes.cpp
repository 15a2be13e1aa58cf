// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// ArborX's linear bounding volume hierarchy, traversed from each leaf to those behind it, so that
// each pair is found once.

#include "object_methods.h"

#include <ArborX_LinearBVH.hpp>
#include <detail/ArborX_HalfTraversal.hpp>

#include <Kokkos_Core.hpp>

namespace thick_benchmark {

namespace {

using Space = Kokkos::Serial;

template <int Dimension>
using Box = ArborX::Box<Dimension, double>;
template <int Dimension>
using Numbered_box = ArborX::PairValueIndex<Box<Dimension>, unsigned>;

template <int Dimension>
ArborX::Point<Dimension, double> point_at(const double* x)
{
  if constexpr(Dimension == 2)
    return {x[0], x[1]};
  else
    return {x[0], x[1], x[2]};
}

template <int Dimension>
struct Meets_box
{
  auto operator()(const Numbered_box<Dimension>& box) const
  {
    return ArborX::intersects(box.value);
  }
};

template <int Dimension>
struct Report
{
  Tally* tally;

  void operator()(const Numbered_box<Dimension>& a, const Numbered_box<Dimension>& b) const
  {
    (*tally)(a.index, b.index);
  }
};

template <int Dimension>
Tally search(const Object_scene& scene)
{
  using Boxes = Kokkos::View<Numbered_box<Dimension>*, Space>;
  const Boxes boxes(Kokkos::view_alloc("boxes", Kokkos::WithoutInitializing), scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i) {
    const double* x = scene.object(i);
    boxes(i) = {{point_at<Dimension>(x), point_at<Dimension>(x + Dimension)},
                static_cast<unsigned>(i)};
  }
  const Space space;
  const ArborX::BoundingVolumeHierarchy tree(space, boxes);
  Tally tally;
  ArborX::Details::HalfTraversal(space, tree, Report<Dimension>{&tally}, Meets_box<Dimension>());
  return tally;
}

} // namespace

Object_method bvh_of_boxes()
{
  return {"ArborX", [](const Object_scene& scene) -> Run<Tally> {
            static const Kokkos::ScopeGuard guard;
            return [&scene] { return scene.dimension == 2 ? search<2>(scene) : search<3>(scene); };
          }};
}

} // namespace thick_benchmark
