// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H

// The search of objects by their boxes, for objects of any type that have intervals.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Axis_profile.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_search.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether places can number `size` objects with a copy of each.
inline bool fits_box_route(std::size_t size) { return size < max_place / 2; }

// Appends the parts of the text, as coordinates.h does.
[[noreturn]] CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline void throw_too_many_objects(std::size_t size)
{
  std::string message("There are too many objects: ");
  throw std::length_error(message.append(std::to_string(size)).append("."));
}

// How many axes the boxes of objects have, in more than three dimensions. Up to eight axes are
// worth their memory: points in six dimensions take 0.45 times as long with six axes as with four.
// If only the objects know their dimension, one number of axes serves all, because each takes a
// while to compile.
constexpr int max_box_axes(int static_dimension)
{
  return static_dimension == 0 ? 4 : (std::min)(static_dimension, 8);
}

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

// Reports the pairs of objects by boxes with `Axes` axes.
template <int Axes, class Objects, class Sets, class Callback, class Progress>
bool report_by_boxes(const Objects& objects, [[maybe_unused]] const Sets& sets, Callback& callback,
                     Progress& progress, const Threads& threads)
{
  Boxed_objects<Axes, Objects, Callback, Progress> client(objects, axes_of_boxes<Axes>(objects),
                                                          callback, progress);
  if constexpr(Sets::are_two)
    client.divide(sets.first_size);
  return search_boxes<Axes>(client, threads);
}

// Reports the pairs of objects, which are Objects_in_boxes. Returns false iff the search was
// stopped.
template <class Objects, class Sets, class Callback, class Progress>
bool report_meeting_boxes(const Objects& objects, const Sets& sets, Callback& callback,
                          Progress& progress, const Threads& threads)
{
  if(!fits_box_route(objects.size()))
    throw_too_many_objects(objects.size());
  constexpr int dimension = Objects::static_dimension;
  constexpr int many_axes = max_box_axes(dimension);
  if constexpr(dimension == 0 || dimension > 3)
    if(dimension > 3 || objects.dimension() > 3)
      return report_by_boxes<many_axes>(objects, sets, callback, progress, threads);
  if constexpr(dimension == 0 || dimension == 3)
    if(dimension == 3 || objects.dimension() == 3)
      return report_by_boxes<3>(objects, sets, callback, progress, threads);
  if constexpr(dimension < 3)
    return report_by_boxes<2>(objects, sets, callback, progress, threads);
}

// Reports the pairs of groups of such objects, which are in the order of their groups. The sets are
// those of groups. The second one, if there is one, begins with the object at `second`.
template <class Objects, class Sets, class Report, class Progress>
bool report_meeting_groups(const Objects& objects, const Sets& sets, std::size_t second,
                           Report& report, Progress& progress, const Threads& threads)
{
  const auto take = [&](std::size_t i, std::size_t j) {
    return report(objects.group_of(i), objects.group_of(second + j) - sets.first_of_second());
  };
  Sets sets_of_objects = sets;
  if constexpr(Sets::are_two)
    sets_of_objects.first_size = second;
  return report_meeting_boxes(objects, sets_of_objects, take, progress, threads);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H
