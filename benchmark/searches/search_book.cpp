// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/book_route.h"
#include "../support/Search.h"

#include <CGAL/Simple_cartesian.h>

namespace thick_benchmark {

namespace {

template <int Dimension>
Tally tally_by_the_book_d(const Scene& scene)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const CGAL::Thick_point_traits_d<Point_t<Kernel, Dimension>> traits(
    CGAL::within_distance(scene.r));
  Tally tally;
  book_route(make_points<Kernel, Dimension>(scene), traits, Book_options(), tally);
  return tally;
}

} // namespace

Tally tally_by_the_book(const Scene& scene)
{
  return scene.dimension == 2 ? tally_by_the_book_d<2>(scene) : tally_by_the_book_d<3>(scene);
}

} // namespace thick_benchmark
