// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The recursive route, which is [V03] as written, with the choices that the paper discusses. No
// other file of the benchmarks knows how the library calls it.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H

#include <CGAL/Thick_point_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>

#include <optional>

namespace thick_benchmark {

using CGAL::Thick_intersection_d::internal::Base_case;
using CGAL::Thick_intersection_d::internal::Pivot;
using Recursion_options = CGAL::Thick_intersection_d::internal::Book_options;

// The traits of points with the reach that [V03] allows for any choice of reference points: twice
// the diameter D of the balls, where the centres of equal balls need D only.
template <class Point>
class Literal_reach_traits : public CGAL::Thick_point_traits_d<Point>
{
  using Base = CGAL::Thick_point_traits_d<Point>;

public:
  explicit Literal_reach_traits(double r)
    : Base(CGAL::within_distance(r)), wide_(CGAL::within_distance(2 * r))
  {}

  typename Base::Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return wide_.is_close_along_axis_d_object();
  }

private:
  Base wide_;
};

template <class Objects, class Traits, class Answer>
void recursive_route(const Objects& objects, const Traits& traits,
                     const Recursion_options& options, Answer& answer)
{
  namespace internal = CGAL::Thick_intersection_d::internal;
  using Elements = internal::Elements<Objects>;
  const Elements elements(objects);
  const internal::Book_scene<Elements, Traits> scene(elements, std::nullopt, traits);
  internal::No_progress progress;
  internal::search_by_the_book<CGAL::Sequential_tag>(scene, options, answer, progress);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H
