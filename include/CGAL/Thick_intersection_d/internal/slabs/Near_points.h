// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_POINTS_H

// Points within a distance, as the slab route sees them: the points that it moves into slabs, the
// lanes that find pairs, and the test that decides the found pairs.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether elements have numbers that they are reported by, instead of their positions. Then
// place(number) finds the position; that of a position is itself.
template <class Elements, class = void>
inline constexpr bool have_numbers = false;

template <class Elements>
inline constexpr bool have_numbers<Elements, std::void_t<decltype(&Elements::number)>> = true;

// `Dimension` is that of the points, 2 or 3.
template <int Dimension, class Elements>
class Near_points
{
  using Element = typename Elements::value_type;

public:
  using Point = Slab_point<Dimension, double>;
  using Run = typename Point::Run;

  Near_points(const Elements& points, const Scene& scene, const Doubles<Elements>& doubles,
              const Is_within_distance<Element>& is_within)
    : points_(points), scene_(scene), doubles_(doubles), is_within_(is_within),
      near_(is_within.filter_of_doubles())
  {}

  // Whether numbers are other ones than the positions.
  static constexpr bool has_numbers = have_numbers<Elements>;

  std::size_t size() const { return points_.size(); }
  double reach() const { return near_.reach; }

  Interval interval(int axis) const
  {
    const Interval& interval = scene_.box[static_cast<std::size_t>(axis)];
    return {interval.low * near_.scale, interval.high * near_.scale};
  }
  double coordinate(std::size_t position, int axis) const
  {
    return doubles_.at(position, axis) * near_.scale;
  }
  void put(std::size_t position, Point& place) const
  {
    place.x = doubles_.template at<Dimension>(position);
    for(double& x : place.x)
      x *= near_.scale;
    place.position = number(position);
  }

  // What the search reports the point at a position by.
  Place number(std::size_t position) const
  {
    if constexpr(have_numbers<Elements>)
      return points_.number(position);
    else
      return static_cast<Place>(position);
  }

  // Whether all pairs of points of the scene are certainly within the bound.
  bool are_all_pairs() const
  {
    double s = 0;
    for(int axis = 0; axis < Dimension; ++axis)
      s += interval(axis).length() * interval(axis).length();
    return s <= near_.filter.inside;
  }

  Near_question<double> question() const
  {
    return {near_.reach, near_.filter.inside, near_.filter.outside};
  }

  // What is_pair() reads of the runs is in the cache.
  void ask_for(Place) const {}

  // Decides about two points of runs, which are at the positions `at`.
  bool is_pair(const Run& a, const Run& b, Found_pair pair, Found_pair at,
               Decision_counts& counts) const
  {
    return decide([&](int axis) { return a.x[axis][pair.i]; },
                  [&](int axis) { return b.x[axis][pair.j]; }, at.i, at.j, counts);
  }

  // Asks for the memory that is_pair() of positions reads.
  void ask_for_doubles([[maybe_unused]] Place number) const
  {
    if constexpr(!have_numbers<Elements>) // it takes longer to find the point than to read it
      doubles_.ask_for(number);
  }

  // The same of points at positions, which 32-bit integers leave undecided (Narrow_points.h).
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool is_pair(Found_pair at, Decision_counts& counts) const
  {
    const Place p = place_of(at.i), q = place_of(at.j);
    return decide([&](int axis) { return coordinate(p, axis); },
                  [&](int axis) { return coordinate(q, axis); }, p, q, counts);
  }

  void publish(const Decision_counts& counts) const { is_within_.publish(counts); }

  const Distance_filter& filter() const { return near_.filter; }

private:
  Place place_of(Place number) const
  {
    if constexpr(have_numbers<Elements>)
      return static_cast<Place>(points_.place(number));
    else
      return number;
  }

  // Decides about the points at the positions p and q, which have the doubles x(axis) and y(axis).
  template <class X, class Y>
  bool decide(const X& x, const Y& y, Place p, Place q, Decision_counts& counts) const
  {
    double s = 0;
    for(int axis = 0; axis < Dimension; ++axis)
      s += (x(axis) - y(axis)) * (x(axis) - y(axis));
    if(s <= near_.filter.inside) {
      counts.add(Arithmetic_tier::DOUBLE);
      return true;
    }
    if(s > near_.filter.outside)
      return false;
    std::array<double, Dimension> x_of_p, y_of_q;
    for(int axis = 0; axis < Dimension; ++axis) {
      x_of_p[axis] = x(axis);
      y_of_q[axis] = y(axis);
    }
    return decide_near_tie(x_of_p, y_of_q, p, q, counts);
  }

  // Decides about a near tie. This does not depend on where the doubles come from, so it is
  // compiled once.
  bool decide_near_tie(std::array<double, Dimension>& x, std::array<double, Dimension>& y, Place p,
                       Place q, Decision_counts& counts) const
  {
    if(near_.scale != 1)
      take_back_scale(x, y, p, q);
    if(const std::optional<bool> is
       = is_within_.decide_near_tie([&](int axis) { return x[axis]; },
                                    [&](int axis) { return y[axis]; }, Dimension, counts))
      return *is;
    return is_within_.decide_undecided(points_[place_of(p)], points_[place_of(q)], counts);
  }

  // Sets the scaled doubles of two points to their doubles. They are read again if one of them may
  // have underflowed: those of both, because runs may have the axes in another order.
  void take_back_scale(std::array<double, Dimension>& x, std::array<double, Dimension>& y, Place p,
                       Place q) const
  {
    bool are_normal = true;
    for(int axis = 0; axis < Dimension; ++axis) {
      are_normal = are_normal && std::isnormal(x[axis]) && std::isnormal(y[axis]);
      x[axis] /= near_.scale;
      y[axis] /= near_.scale;
    }
    if(!are_normal) {
      x = doubles_.template at<Dimension>(place_of(p));
      y = doubles_.template at<Dimension>(place_of(q));
    }
  }

  const Elements& points_;
  const Scene& scene_;
  const Doubles<Elements>& doubles_;
  const Is_within_distance<Element>& is_within_;
  const Scaled_filter near_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_POINTS_H
