// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes in four dimensions and more.

#include "box_intersection.h"
#include "object_methods.h"

#include <CGAL/thick_box_intersection_d.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace {

// A box whose ends lie in the scene: the lower ones, and behind them the upper ones.
struct Box_in_scene
{
  const double* ends;
  std::uint32_t position;
};

std::vector<Box_in_scene> boxes_in(const Object_scene& scene)
{
  std::vector<Box_in_scene> boxes;
  for(std::size_t i = 0; i < scene.size(); ++i)
    boxes.push_back({scene.object(i), static_cast<std::uint32_t>(i)});
  return boxes;
}

template <int Dimension>
struct Static_dimension
{
  static constexpr int dimension() { return Dimension; }
};

struct Dynamic_dimension
{
  int dimension_of_scene;
  int dimension() const { return dimension_of_scene; }
};

template <class Dimension>
struct Traits_of_boxes : Dimension
{
  double min_coord(const Box_in_scene& box, int axis) const { return box.ends[axis]; }
  double max_coord(const Box_in_scene& box, int axis) const
  {
    return box.ends[this->dimension() + axis];
  }
  std::uint32_t id(const Box_in_scene& box) const { return box.position; }
};

template <class Dimension>
Run<Tally> run_by_traits(const Object_scene& scene, const Traits_of_boxes<Dimension>& traits)
{
  return [boxes = boxes_in(scene), traits] {
    Tally tally;
    const auto report = [&](const Box_in_scene& a, const Box_in_scene& b) {
      tally(a.position, b.position);
    };
    CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(), report, traits);
    return tally;
  };
}

template <int Dimension>
Tally search_by_boxes(const Object_scene& scene, std::ptrdiff_t cutoff)
{
  std::vector<Numbered_box<Dimension>> boxes;
  boxes.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i) {
    double ends[2 * Dimension];
    std::copy_n(scene.object(i), 2 * Dimension, ends);
    boxes.emplace_back(ends, ends + Dimension, static_cast<std::uint32_t>(i));
  }
  Tally tally;
  const auto always = [](std::uint32_t, std::uint32_t) { return true; };
  box_intersection<CGAL::Sequential_tag>(std::move(boxes), always, tally, cutoff);
  return tally;
}

} // namespace

Search search_boxes_d(const Object_scene& scene, Dimension_kind kind)
{
  Search search;
  if(kind == Dimension_kind::DYNAMIC)
    search.sequential
      = run_by_traits(scene, Traits_of_boxes<Dynamic_dimension>{{scene.dimension}});
  else if(scene.dimension == 4)
    search.sequential = run_by_traits(scene, Traits_of_boxes<Static_dimension<4>>());
  else if(scene.dimension == 6)
    search.sequential = run_by_traits(scene, Traits_of_boxes<Static_dimension<6>>());
  else
    throw std::invalid_argument("boxes of a dimension that is not measured");
  return search;
}

Object_method boxes_d(std::ptrdiff_t cutoff)
{
  return {"boxes, cutoff " + std::to_string(cutoff),
          [=](const Object_scene& scene) -> Run<Tally> {
            return [&scene, cutoff] {
              return scene.dimension == 4 ? search_by_boxes<4>(scene, cutoff)
                                          : search_by_boxes<6>(scene, cutoff);
            };
          }};
}

} // namespace thick_benchmark
