// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the degree is measured on: points of Degree_number, traits whose predicates are call sites,
// and traits of balls that are stored with the square of their radius.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H
#define THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H

#include "Degree_number.h"
#include "paper_traits.h"

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

// Solid balls that are stored with the square of their radius, as Circle_2 and Sphere_3 are: two
// intersect iff d^2 <= (sqrt R1 + sqrt R2)^2, which without roots is
//   d^2 - R1 - R2 <= 0   or   (d^2 - R1 - R2)^2 <= 4 R1 R2.
// The squares are of degree 2 in the radii, so the second polynomial is of degree 4. The reach is
// given, for it needs a root.
template <class Sphere, int Dimension>
class Squared_radius_traits
{
  struct Position
  {
    decltype(auto) operator()(const Sphere& s, int i) const { return s.center()[i]; }
  };

public:
  using Object_d = Sphere;
  using Less_coordinate_d = typename Paper_order<Sphere, Position>::Less_coordinate_d;
  using Is_close_along_axis_d = typename Paper_order<Sphere, Position>::Is_close_along_axis_d;
  struct Do_intersect_d
  {
    bool operator()(const Sphere& a, const Sphere& b) const
    {
      const Degree_number excess = CGAL::squared_distance(a.center(), b.center())
                                   - a.squared_radius() - b.squared_radius();
      return excess <= 0 || excess * excess <= 4 * a.squared_radius() * b.squared_radius();
    }
  };

  explicit Squared_radius_traits(const Degree_number& reach) : reach_(reach) {}

  int dimension() const { return Dimension; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const { return {reach_}; }
  Do_intersect_d do_intersect_d_object() const { return {}; }

private:
  Degree_number reach_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DEGREE_TRAITS_H
