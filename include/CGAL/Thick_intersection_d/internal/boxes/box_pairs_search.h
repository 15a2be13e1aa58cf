// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H

// The search of objects by their boxes, for objects of any type that have intervals.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_route.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/axes_of_boxes.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_reporter.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

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

// Returns search(report) for what reports pairs in one numbering to a callback of positions in each
// set.
template <class Sets, class Callback, class Search>
bool with_reporter([[maybe_unused]] const Sets& sets, Callback& callback, const Search& search)
{
  if constexpr(Sets::are_two) {
    const auto callback_of_two_sets
      = [&](std::size_t i, std::size_t j) { return callback(i, j - sets.first_size); };
    Pair_reporter<decltype(callback_of_two_sets)> report(callback_of_two_sets);
    return search(report);
  }
  else {
    Pair_reporter<Callback> report(callback);
    return search(report);
  }
}

// Reports the pairs of objects by boxes with `Axes` axes.
template <class ConcurrencyTag, int Axes, class Objects, class Sets, class Report, class Progress>
bool report_by_boxes(const Objects& objects, const Sets& sets, Report& report,
                     Progress& progress)
{
  using Test = Boxed_objects<Axes, Objects>;
  const Test test(objects, axes_of_boxes(objects, Axes));
  using Box_of_test = typename Test::Box;
  const std::unique_ptr<Box_of_test[]> boxes = make_uninitialized<Box_of_test>(objects.size());
  for_each_block<ConcurrencyTag>(objects.size(), [&](std::size_t i, std::size_t last) {
    for(; i != last; ++i)
      test.put(i, boxes[i]);
  });
  Box_of_test* const first = boxes.get();
  Box_of_test* const last = first + objects.size();
  Box_route<ConcurrencyTag, Test, Report, Progress> route(test, report, progress);
  if constexpr(Sets::are_two) {
    Box_of_test* const middle = first + sets.first_size;
    return route.search(Piece<Box_of_test>({first, middle}, {middle, last}));
  }
  else
    return route.search(Piece<Box_of_test>({first, last}));
}

// Reports the pairs of objects. `Objects` is as for Boxed_objects, with a constant static_dimension
// that is 0 if only the objects know their dimension. Returns false iff the search was stopped.
template <class ConcurrencyTag, class Objects, class Sets, class Callback, class Progress>
bool report_meeting_boxes(const Objects& objects, const Sets& sets, Callback& callback,
                          Progress& progress)
{
  if(!fits_box_route(objects.size()))
    throw_too_many_objects(objects.size());
  const auto search = [&](auto& report) {
    constexpr int dimension = Objects::static_dimension;
    constexpr int many_axes = max_box_axes(dimension);
    if constexpr(dimension == 0 || dimension > 3)
      if(dimension > 3 || objects.dimension() > 3)
        return report_by_boxes<ConcurrencyTag, many_axes>(objects, sets, report, progress);
    if constexpr(dimension == 0 || dimension == 3)
      if(dimension == 3 || objects.dimension() == 3)
        return report_by_boxes<ConcurrencyTag, 3>(objects, sets, report, progress);
    if constexpr(dimension < 3)
      return report_by_boxes<ConcurrencyTag, 2>(objects, sets, report, progress);
  };
  return with_reporter(sets, callback, search);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PAIRS_SEARCH_H
