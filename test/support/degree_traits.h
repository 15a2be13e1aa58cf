// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the degree is measured on: points of Degree_number, and traits whose predicates are call
// sites.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H
#define THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H

#include "Degree_number.h"

#include <CGAL/Simple_cartesian.h>

namespace test_support {

using Degree_kernel = CGAL::Simple_cartesian<Degree_number>;

// n points of integer coordinates with at most `bits` bits, on a coarse lattice near the upper end
// of that range, so that small distances and ties are frequent.
template <class Point, int Dimension>
std::vector<Point> degree_points(std::size_t n, int bits, unsigned int seed)
{
  std::mt19937 random(seed);
  const double step = std::ldexp(1., (std::max)(bits - 5, 0));
  const auto coordinate = [&] {
    const double x = static_cast<double>(random() % 32) * step;
    return Degree_number::input((std::min)(x, std::ldexp(1., bits) - 1));
  };
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i) {
    const Degree_number x = coordinate(), y = coordinate();
    if constexpr(Dimension == 2)
      points.emplace_back(x, y);
    else
      points.emplace_back(x, y, coordinate());
  }
  return points;
}

// A predicate of any signature whose signs are noted under a name.
template <class Predicate>
class Predicate_at_site : public Predicate
{
public:
  Predicate_at_site(const Predicate& predicate, const char* name)
    : Predicate(predicate), name_(name)
  {}

  template <class... Arguments>
  decltype(auto) operator()(const Arguments&... arguments) const
  {
    const Call_site site(name_);
    return Predicate::operator()(arguments...);
  }

private:
  const char* name_;
};

// Traits as given, with their three predicates as call sites.
template <class Traits>
class Traits_with_sites
{
public:
  using Object_d = typename Traits::Object_d;
  using Less_coordinate_d = Predicate_at_site<typename Traits::Less_coordinate_d>;
  using Is_close_along_axis_d = Predicate_at_site<typename Traits::Is_close_along_axis_d>;
  using Do_intersect_d = Predicate_at_site<typename Traits::Do_intersect_d>;

  explicit Traits_with_sites(const Traits& traits) : traits_(traits) {}

  int dimension() const { return traits_.dimension(); }
  Less_coordinate_d less_coordinate_d_object() const
  {
    return {traits_.less_coordinate_d_object(), "Less_coordinate_d"};
  }
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return {traits_.is_close_along_axis_d_object(), "Is_close_along_axis_d"};
  }
  Do_intersect_d do_intersect_d_object() const
  {
    return {traits_.do_intersect_d_object(), "Do_intersect_d"};
  }

private:
  Traits traits_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H
