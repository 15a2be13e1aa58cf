// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The route of [V03] as written, with the choices that the paper discusses.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_BOOK_ROUTE_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_BOOK_ROUTE_H

#include <CGAL/Thick_point_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>

#include <vector>

namespace thick_benchmark {

using CGAL::Thick_intersection_d::internal::Base_case;
using CGAL::Thick_intersection_d::internal::Book_options;
using CGAL::Thick_intersection_d::internal::Pivot;

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

template <class ConcurrencyTag = CGAL::Sequential_tag, class Point, class Traits, class Callback>
void book_route(const std::vector<Point>& points, const Traits& traits,
                const Book_options& options, Callback& callback)
{
  namespace internal = CGAL::Thick_intersection_d::internal;
  using Elements = internal::Elements<std::vector<Point>>;
  const Elements elements(points);
  const internal::Book_scene<Elements, Traits> scene(elements, std::nullopt, traits);
  internal::No_progress progress;
  internal::search_by_the_book<ConcurrencyTag>(scene, options, callback, progress);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_BOOK_ROUTE_H
