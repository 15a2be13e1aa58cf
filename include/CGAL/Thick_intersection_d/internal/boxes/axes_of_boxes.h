// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXES_OF_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXES_OF_BOXES_H

// Chooses the axes that boxes have, if objects have more.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Axis_profile.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the share of pairs of objects that meet along an axis, by a sample of the objects: a
// random one of each step, because objects at equal steps may be of one kind.
template <class Objects>
double meeting_share_along(const Objects& objects, int axis)
{
  std::vector<Piece_box<1>> boxes;
  const std::size_t step = objects.size() / box_sample + 1;
  Random_numbers random;
  for(std::size_t first = 0; first < objects.size(); first += step) {
    const std::size_t position = first + random.below((std::min)(step, objects.size() - first));
    const Interval interval = objects.intervals(position)(axis);
    boxes.push_back({{interval.low}, {interval.high}, static_cast<Place>(position), 0});
  }
  std::vector<const Piece_box<1>*> sample;
  for(const Piece_box<1>& box : boxes)
    sample.push_back(&box);
  Axis_profile profile;
  profile.set(sample, 0);
  return profile.meeting_share();
}

// Returns all axes. The first `Axes` of them, which boxes have, are those along which the fewest
// objects meet.
template <int Axes, class Objects>
std::vector<int> axes_of_boxes(const Objects& objects)
{
  std::vector<int> axes(static_cast<std::size_t>(objects.dimension()));
  std::iota(axes.begin(), axes.end(), 0);
  if constexpr(Objects::static_dimension == 0 || Objects::static_dimension > Axes)
    if(objects.dimension() > Axes) {
      std::vector<double> shares;
      for(const int axis : axes)
        shares.push_back(meeting_share_along(objects, axis));
      std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
        return shares[static_cast<std::size_t>(a)] < shares[static_cast<std::size_t>(b)];
      });
    }
  return axes;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXES_OF_BOXES_H
