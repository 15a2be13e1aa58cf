// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "Near_scene.h"

#include "support/point_generators.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace thick_benchmark {

namespace {

using Place = std::array<std::size_t, 3>;

Place random_place(test_support::Random& random, const Place& low, std::size_t side, int dimension)
{
  Place place = low;
  for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    place[axis] += random.below(side);
  return place;
}

// Whether the places p and q, or p, q and r, are on one line, or equal.
bool are_degenerate(const std::vector<Place>& corners)
{
  const auto difference = [&](std::size_t k, std::size_t axis) {
    return static_cast<int>(corners[k][axis]) - static_cast<int>(corners[0][axis]);
  };
  if(corners.size() == 2)
    return corners[0] == corners[1];
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    if(difference(1, axis) * difference(2, next) != difference(1, next) * difference(2, axis))
      return false;
  }
  return true;
}

} // namespace

Near_scene lattice_scene(Shape shape, int dimension, std::size_t n, double step)
{
  test_support::Random random(17);
  const double places = 2 * static_cast<double>(n);
  const auto side = static_cast<std::size_t>(std::ceil(std::pow(places, 1. / dimension)));
  Near_scene scene = {step == 1 ? "lattice" : "lattice of decimals", {"", shape, dimension, {}},
                      step};
  while(scene.objects.size() < n) {
    std::vector<Place> corners = {random_place(random, {}, side, dimension)};
    while(corners.size() < corners_of(shape))
      corners.push_back(random_place(random, corners.front(), 3, dimension));
    if(are_degenerate(corners))
      continue;
    for(const Place& corner : corners)
      for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
        scene.objects.numbers.push_back(step * static_cast<double>(corner[axis]));
  }
  return scene;
}

} // namespace thick_benchmark
