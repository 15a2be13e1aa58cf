// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes of objects of all kinds, full of ties.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KIND_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_KIND_SCENES_H

#include "kinds.h"
#include "point_generators.h"

namespace test_support {

// All numbers are doubles, and so are their products with the unit.
class Kind_drawer
{
public:
  Kind_drawer(std::uint64_t seed, int dimension, bool have_radii)
    : random_(seed), dimension_(dimension), have_radii_(have_radii)
  {}

  Random& random() { return random_; }
  bool is_chance(std::size_t one_in) { return random_.below(one_in) == 0; }
  std::int64_t below(std::int64_t count)
  {
    return static_cast<std::int64_t>(random_.below(static_cast<std::size_t>(count)));
  }

  Kind_scene scene()
  {
    Kind_scene scene = is_chance(3) ? scene_of_contacts() : scene_of_lattice();
    if(is_chance(3))
      draw_bound_of_pair(scene);
    scene.bound.is_open = is_chance(3);
    return scene;
  }

private:
  // ---- on lattices ----

  // Objects with vertices on a lattice of few places: many are degenerate or parallel, in one plane
  // or within others. A step of the lattice is a power of two, or a decimal up to rounding. Some
  // vertices are moved by a unit.
  Kind_scene scene_of_lattice()
  {
    choose_lattice();
    Kind_scene scene = {dimension_, is_decimal_ ? -decimal_digits_ : exponent(), {},
                        {0, false, false}};
    const std::size_t size = 2 + random_.below(is_chance(32) ? 60 : 12);
    for(std::size_t i = 0; i < size; ++i)
      scene.objects.push_back(i > 0 && is_chance(12) ? with_other_kind(scene.objects[i - 1])
                                                     : lattice_object());
    scene.bound.value = length(is_chance(2) ? 3 : 2 * side_);
    return scene;
  }

  void choose_lattice()
  {
    side_ = 2 + below(1 + below(9));
    is_decimal_ = is_chance(6);
    decimal_digits_ = is_chance(2) ? 56 : 33;
    const int shifts[] = {0, 0, 0, 2, 20, 45};
    shift_ = is_decimal_ ? 0 : shifts[random_.below(6)];
    move_one_in_ = shift_ == 0 && !is_decimal_ ? 1000 : is_chance(2) ? 6 : 60;
    flat_axis_ = is_chance(8) ? static_cast<std::size_t>(below(dimension_)) : 3;
    const std::int64_t offsets[]
      = {0, 0, 0, -(side_ << shift_), 1000000, std::int64_t(1) << 51, -(std::int64_t(1) << 51)};
    for(std::int64_t& x : offset_)
      x = is_decimal_ ? 0 : offsets[random_.below(7)];
  }

  std::int64_t coordinate(std::size_t axis, std::int64_t count) const
  {
    if(is_decimal_ && decimal_digits_ == 33)
      return decimal(1e6 + 0.1 * static_cast<double>(count));
    return offset_[axis] + steps(count);
  }

  // A multiple of the step: a power of two, or the double that is next to a decimal.
  std::int64_t steps(std::int64_t count) const
  {
    return is_decimal_ ? decimal(0.1 * static_cast<double>(count)) : count << shift_;
  }

  // Without the digits that numbers of a million do not have.
  std::int64_t decimal(double x) const
  {
    return static_cast<std::int64_t>(std::ldexp(x, decimal_digits_));
  }

  // Of decimals, the last digit of the largest of them.
  std::int64_t unit() const { return is_decimal_ && decimal_digits_ == 56 ? 1 << 7 : 1; }

  std::int64_t length(std::int64_t count)
  {
    const std::int64_t move = is_chance(4) ? unit() * (below(3) - 1) : 0;
    return (std::max)(std::int64_t(0), steps(below(count)) + move);
  }

  Place lattice_place(const Place& low, std::int64_t side)
  {
    Place p = {};
    for(std::size_t axis = 0; axis < axes(); ++axis) {
      p[axis] = coordinate(axis, low[axis] + (axis == flat_axis_ ? 0 : below(side)));
      if(is_chance(move_one_in_))
        p[axis] += unit() * (below(3) - 1);
    }
    return p;
  }

  Kind_object lattice_object()
  {
    Kind_object object = {kind(), {}, 0};
    Place low = {};
    const std::int64_t side = is_chance(3) ? side_ : 1 + below(side_);
    for(std::size_t axis = 0; axis < axes(); ++axis)
      low[axis] = axis == flat_axis_ ? 0 : below(side_ - side + 1);
    for(std::size_t k = 0; k < points_of(object.kind); ++k)
      object.points.push_back(k > 0 && is_chance(12) ? object.points[k - 1]
                                                     : lattice_place(low, side));
    if(has_radius(object.kind))
      object.radius = length(side_);
    return object;
  }

  // Of the same points, as far as it goes, so that the objects meet.
  Kind_object with_other_kind(const Kind_object& other)
  {
    Kind_object object = {kind(), other.points, 0};
    object.points.resize(points_of(object.kind), other.points.front());
    return object;
  }

  // ---- contacts ----

  // Pairs of objects at exactly one distance, of which some are moved by a unit. The nearest points
  // are in features of all dimensions.
  Kind_scene scene_of_contacts()
  {
    const Place directions[] = {{1, 0, 0}, {3, 4, 0}, {5, 12, 0}, {1, 2, 2}, {2, 3, 6}, {1, 4, 8}};
    Place w = directions[random_.below(dimension_ == 2 ? 3 : 6)];
    for(std::size_t axis = axes() - 1; axis > 0; --axis)
      std::swap(w[axis], w[random_.below(axis + 1)]);
    for(std::int64_t& x : w)
      x = is_chance(2) ? x : -x;
    const auto norm = static_cast<std::int64_t>(std::sqrt(static_cast<double>(dot(w, w))));
    const std::int64_t factors[] = {1, 1, 5, 1 << 20, 1000003, std::int64_t(1) << 36};
    const std::int64_t factor = factors[random_.below(6)], gap = below(4);
    Kind_scene scene = {dimension_, exponent(), {}, {gap * norm * factor, false, false}};
    const std::size_t move_one_in = factor == 1 ? 1000 : 4;
    for(std::size_t pairs = 1 + random_.below(5); pairs > 0; --pairs) {
      const Place shift = tangent_to({0, 0, 0}, 40);
      for(const std::int64_t side : {1, -1}) {
        Kind_object object = object_below(w, norm);
        for(Place& p : object.points)
          for(std::size_t axis = 0; axis < axes(); ++axis)
            p[axis] = factor * (shift[axis] + side * p[axis] + (side < 0 ? gap * w[axis] : 0))
                      + (is_chance(move_one_in) ? below(3) - 1 : 0);
        object.radius *= factor;
        scene.objects.push_back(object);
      }
    }
    return scene;
  }

  // An object that has the origin, and otherwise only points x with <w, x> at most zero.
  Kind_object object_below(const Place& w, std::int64_t norm)
  {
    Kind_object object = {kind(), {}, 0};
    object.points = is_box(object.kind) ? box_below(w) : hull_below(w, points_of(object.kind));
    const std::int64_t radius = has_radius(object.kind) ? below(4) : 0;
    object.radius = radius * norm;
    for(Place& p : object.points)
      for(std::size_t axis = 0; axis < axes(); ++axis)
        p[axis] -= radius * w[axis];
    return object;
  }

  std::vector<Place> hull_below(const Place& w, std::size_t size)
  {
    std::vector<Place> points
      = feature_at_origin(w, 1 + random_.below((std::min)(size, axes())));
    while(points.size() < size) {
      Place p = tangent_to({0, 0, 0}, 5);
      if(dot(p, w) > 0)
        p = {-p[0], -p[1], -p[2]};
      points.push_back(p);
    }
    std::swap(points.front(), points[random_.below(points.size())]);
    return points;
  }

  std::vector<Place> box_below(const Place& w)
  {
    std::vector<Place> corners(2, Place{});
    for(std::size_t axis = 0; axis < axes(); ++axis) {
      if(w[axis] >= 0)
        corners[0][axis] = -below(4);
      if(w[axis] <= 0)
        corners[1][axis] = below(4);
    }
    return corners;
  }

  // A vertex, edge or face with the origin, on the line or plane through it with the normal w.
  std::vector<Place> feature_at_origin(const Place& w, std::size_t vertices)
  {
    std::vector<Place> feature(1, Place{});
    Place sum = {};
    for(std::size_t k = 1; k < vertices; ++k) {
      feature.push_back(tangent_to(w, 3));
      const std::int64_t weight = below(3);
      for(std::size_t axis = 0; axis < axes(); ++axis)
        sum[axis] -= weight * feature.back()[axis];
    }
    feature.front() = sum;
    return feature;
  }

  // A vector that is orthogonal to w, which may be null.
  Place tangent_to(const Place& w, std::int64_t size)
  {
    Place t = {};
    for(std::size_t axis = 0; axis < axes(); ++axis)
      t[axis] = below(2 * size + 1) - size;
    if(is_null(w))
      return t;
    return dimension_ == 2 ? Place{t[0] * w[1], -t[0] * w[0], 0} : cross(w, t);
  }

  // ---- bounds and units ----

  // The distance of two objects, or next to it.
  void draw_bound_of_pair(Kind_scene& scene)
  {
    const Rational square
      = squared_distance(scene.objects[random_.below(scene.objects.size())],
                         scene.objects[random_.below(scene.objects.size())]);
    if(is_chance(2)) {
      const Rational tiny = Rational(1) / (std::int64_t(1) << 62);
      const Rational factors[] = {1, 1 + tiny, 1 - tiny};
      scene.bound = {square * factors[is_chance(2) ? 0 : random_.below(3)], true, false};
    }
    else {
      const double root = std::sqrt(static_cast<double>(square));
      scene.bound = {Rational(is_chance(2) ? root : std::nextafter(root, is_chance(2) ? 0 : 1e300)),
                     false, false};
    }
  }

  // Squares that overflow or vanish, numbers that do, and others.
  int exponent()
  {
    const int exponents[] = {0, 0, 0, 0, -20, -300, -500, -560, -1074, 300, 480, 500, 900};
    return exponents[random_.below(13)];
  }

  // Whether to give an object a radius, which may be zero.
  bool has_radius(Kind kind) { return kind == Kind::BALL || (have_radii_ && !is_chance(4)); }

  Kind kind()
  {
    return static_cast<Kind>(random_.below(number_of_kinds(dimension_)));
  }

  std::size_t axes() const { return static_cast<std::size_t>(dimension_); }

  Random random_;
  int dimension_;
  bool have_radii_; // or only balls

  // The lattice.
  std::int64_t side_ = 0; // in steps
  int shift_ = 0;
  bool is_decimal_ = false;
  int decimal_digits_ = 0;
  std::size_t move_one_in_ = 0;
  std::size_t flat_axis_ = 0; // along which there is one place, if it is an axis
  Place offset_ = {};
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KIND_SCENES_H
