// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes in domains that repeat, full of ties: iso-boxes and lattices with short or
// long vectors, of which some repeat, and bounds at the distance of a pair of images. All numbers
// of a scene are integers that its kernel holds, times one unit; those of the domain may be in
// another unit than those of points.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_FUZZ_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_FUZZ_SCENES_H

#include "fuzz_scenes.h"
#include "periodic_oracle.h"

namespace test_support {

// A bound in units of the points: a distance, or only a squared one.
struct Periodic_fuzz_bound
{
  std::optional<double> distance;
  Rational square;
  bool is_open;
};

template <int Dimension>
struct Periodic_fuzz_scene
{
  using Offset = Offset_of<Dimension>;

  int exponent = 0; // the unit is 2^exponent
  std::vector<Lattice_place> places;
  std::array<Lattice_place, 3> vectors = {}; // as the user gives them, in units of the domain
  std::array<bool, Dimension> repeats = {};
  bool is_box = false; // whose vectors are its sides
  Lattice_place low = {}, high = {};
  Periodic_fuzz_bound bound = {};
  Lattice_scene<Dimension> exact; // of the same lattice, by other vectors, in units of the points

  // Takes a pair of images of the exact scene to that of the given vectors.
  Image_pair<Dimension> given(const Image_pair<Dimension>& pair) const
  {
    auto [i, j, o] = pair;
    for(const auto& [from, to, times] : steps)
      o[to] -= times * o[from];
    Offset offset;
    for(std::size_t k = 0; k < offset.size(); ++k)
      offset[k] = o[order[k]];
    if(i == j && offset < Offset{})
      for(int& x : offset)
        x = -x;
    return {i, j, offset};
  }

  // Given vector k is vector order[k], after the steps: vector `from` += times * vector `to`.
  std::vector<std::tuple<std::size_t, std::size_t, int>> steps;
  std::array<std::size_t, Dimension> order = {};
};

template <int Dimension>
class Periodic_fuzz_drawer
{
  using Scene = Periodic_fuzz_scene<Dimension>;

public:
  // The domain is in units of `domain_unit` units of the points.
  Periodic_fuzz_drawer(std::uint64_t seed, const Number_range& range, bool is_exact,
                       const Rational& domain_unit)
    : random_(seed), range_(range), is_exact_(is_exact), domain_unit_(domain_unit)
  {}

  Random& random() { return random_; }
  bool is_chance(std::size_t one_in) { return random_.below(one_in) == 0; }

  Scene scene()
  {
    Scene scene;
    scene.exponent = exponent();
    step_ = step();
    is_skewed_by_many_ = is_chance(4);
    draw_axes();
    scene.is_box = is_chance(3);
    if(scene.is_box)
      draw_box(scene);
    else
      draw_vectors(scene);
    const std::size_t size = random_.below(is_chance(8) ? 24 : 9);
    for(std::size_t i = 0; i < size; ++i)
      scene.places.push_back(i > 0 && is_chance(10) ? scene.places[random_.below(i)]
                        : scene.is_box                    ? place_in_box(scene)
                                                          : place_in_lattice());
    if(is_chance(4) && (!scene.is_box || domain_unit_ == 1))
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        move_far(scene, axis);
    set_exact(scene);
    scene.bound = bound(scene);
    scene.exact.square = scene.bound.square;
    scene.exact.is_open = scene.bound.is_open;
    return scene;
  }

private:
  std::int64_t below(std::int64_t count)
  {
    return static_cast<std::int64_t>(random_.below(static_cast<std::size_t>(count)));
  }
  // From -count to count.
  std::int64_t around_zero(std::int64_t count) { return below(2 * count + 1) - count; }

  // The nearest number that the kernel holds.
  std::int64_t rounded(double x) const
  {
    return range_.digits < 53 ? static_cast<std::int64_t>(static_cast<float>(x))
                              : static_cast<std::int64_t>(x);
  }

  // Whether the kernel holds a number. A cast to double and back would not tell on each platform:
  // on x86 of 32 bits, g++ leaves both out.
  bool is_held(std::int64_t number) const
  {
    while(number != 0 && number % 2 == 0)
      number /= 2;
    return std::abs(number) < (std::int64_t(1) << range_.digits);
  }

  // The number next to another one, or a little further up or down.
  std::int64_t next(std::int64_t place, int direction) const
  {
    const int bits = place == 0 ? 0 : std::ilogb(static_cast<double>(place)) + 1;
    return rounded(static_cast<double>(
      place + direction * (std::int64_t(1) << (std::max)(0, bits - range_.digits))));
  }

  // Some steps, rounded, and now and then the number next to them; or any number.
  std::int64_t number(std::int64_t steps)
  {
    if(is_chance(8))
      return rounded(step_ * (static_cast<double>(steps) + random_.uniform() - 0.5));
    const std::int64_t place = rounded(static_cast<double>(steps) * step_);
    return is_chance(8) ? next(place, is_chance(2) ? 1 : -1) : place;
  }

  // The step of the lattice that most numbers are on: a power of two, or the double next to a tenth
  // or a third of one, whose multiples are rounded.
  double step()
  {
    const int digits = range_.digits - 3;
    const int shifts[] = {0, 0, 2, digits / 2, digits};
    const double parts[] = {1, 1, 0.1, 1 / 3., 0.7};
    const double part = parts[random_.below(5)];
    const int shift = part == 1 ? shifts[random_.below(5)] : digits;
    return (std::max)(1., static_cast<double>(rounded(std::ldexp(part, shift))));
  }

  int exponent()
  {
    if(is_exact_)
      return static_cast<int>(around_zero(is_chance(8) ? 300 : 20));
    const int high = range_.max_exponent + range_.digits - 64;
    const int exponents[] = {0, 0, 0, -range_.digits, range_.min_exponent / 2,
                             high / 2, range_.min_exponent, high};
    return exponents[random_.below(8)];
  }

  void draw_axes()
  {
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      axes_[axis] = axis;
      std::swap(axes_[axis], axes_[random_.below(axis + 1)]);
    }
  }

  // Sides are at least three units of the domain, so that a point of whole units has a place, even
  // if one of its units is three of these: a number is up to a unit away from its steps.
  void draw_box(Scene& scene)
  {
    for(std::size_t k = 0; k < Dimension; ++k) {
      const std::int64_t steps = around_zero(3);
      scene.low[k] = number(steps);
      scene.high[k] = number(steps + 5 + below(3));
      scene.vectors[k][k] = scene.high[k] - scene.low[k];
      scene.repeats[k] = true;
      scene.order[k] = k;
      axes_[k] = k;
    }
    first_vectors_ = scene.vectors;
  }

  // Vectors of which number k has no component along axes after k, in a random order of axes. Then
  // multiples of some are added to others, which changes the vectors and not the lattice.
  void draw_vectors(Scene& scene)
  {
    const std::int64_t shear = is_skewed_by_many_ ? 60 : 3;
    for(std::size_t k = 0; k < Dimension; ++k) {
      scene.repeats[k] = !is_chance(4);
      scene.order[k] = k;
      for(std::size_t axis = 0; axis < k; ++axis)
        scene.vectors[k][axes_[axis]] = number(is_chance(3) ? 0 : around_zero(shear));
      scene.vectors[k][axes_[k]]
        = (is_chance(2) ? -1 : 1) * (std::max)(number(1 + below(6)), std::int64_t(1));
      if(!scene.repeats[k] && is_chance(3))
        scene.vectors[k] = {};
    }
    first_vectors_ = scene.vectors;
    for(std::size_t count = is_chance(2) ? 0 : 1 + random_.below(4); count > 0; --count)
      add_vector(scene);
    for(std::size_t k = 0; k < Dimension; ++k)
      std::swap(scene.order[k], scene.order[random_.below(k + 1)]);
    const auto vectors = scene.vectors;
    const auto repeats = scene.repeats;
    for(std::size_t k = 0; k < Dimension; ++k) {
      scene.vectors[k] = vectors[scene.order[k]];
      scene.repeats[k] = repeats[scene.order[k]];
    }
  }

  void add_vector(Scene& scene)
  {
    const std::size_t from = random_.below(Dimension), to = random_.below(Dimension);
    const std::int64_t times = around_zero(is_skewed_by_many_ ? 9 : 2);
    if(from == to || !scene.repeats[from] || !scene.repeats[to])
      return;
    Lattice_place sum = scene.vectors[from];
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      sum[axis] += times * scene.vectors[to][axis];
      if(!is_held(sum[axis]) || std::abs(sum[axis]) > (std::int64_t(1) << 60))
        return;
    }
    scene.vectors[from] = sum;
    scene.steps.emplace_back(from, to, static_cast<int>(times));
  }

  // A place in a box, often the first or the last one along an axis.
  Lattice_place place_in_box(const Scene& scene)
  {
    Lattice_place p = {};
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      const Rational low = scene.low[axis] * domain_unit_, high = scene.high[axis] * domain_unit_;
      std::int64_t& x = p[axis];
      x = rounded(static_cast<double>(low) + static_cast<double>(number(below(8))));
      if(low <= x && x < high && !is_chance(6))
        continue;
      const bool is_first = is_chance(2);
      x = rounded(static_cast<double>(is_first ? low : high));
      while(x < low)
        x = next(x, 1);
      while(x >= high)
        x = next(x, -1);
    }
    return p;
  }

  // A place up to ten periods from one near the origin.
  Lattice_place place_in_lattice()
  {
    const std::int64_t most[] = {0, 1, 10};
    const std::int64_t cells = most[random_.below(3)];
    std::array<Rational, Dimension> sum;
    for(Rational& x : sum)
      x = number(around_zero(6));
    for(std::size_t k = 0; k < Dimension; ++k) {
      const std::int64_t times = around_zero(cells);
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        sum[axis] += domain_unit_ * first_vectors_[k][axis] * times;
    }
    Lattice_place p = {};
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      p[axis] = rounded(static_cast<double>(sum[axis]));
    return p;
  }

  // Moves a scene along an axis, by a power of two up to the largest for which the kernel holds all
  // numbers.
  void move_far(Scene& scene, std::size_t axis)
  {
    std::vector<std::int64_t*> numbers;
    if(scene.is_box)
      numbers = {&scene.low[axis], &scene.high[axis]};
    for(Lattice_place& place : scene.places)
      numbers.push_back(&place[axis]);
    const bool is_negative = is_chance(2);
    for(std::int64_t shift = std::int64_t(1) << below(61); shift > 0; shift /= 2) {
      const std::int64_t step = is_negative ? -shift : shift;
      if(std::all_of(numbers.begin(), numbers.end(), [&](const std::int64_t* number) {
           return is_held(*number + step);
         })) {
        for(std::int64_t* number : numbers)
          *number += step;
        return;
      }
    }
  }

  // The exact scene has the vectors that were drawn first, and its axes are in the order of these.
  void set_exact(Scene& scene) const
  {
    for(const Lattice_place& place : scene.places) {
      scene.exact.points.emplace_back();
      for(const std::size_t axis : axes_)
        scene.exact.points.back().push_back(static_cast<double>(place[axis]));
    }
    for(std::size_t k = 0; k < Dimension; ++k) {
      scene.exact.repeats[scene.order[k]] = scene.repeats[k];
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        scene.exact.vectors[k][axis] = domain_unit_ * first_vectors_[k][axes_[axis]];
    }
  }

  // Mostly the distance of a pair of images, or next to it; or some steps. The images are less far
  // apart if there would be too many within the bound.
  Periodic_fuzz_bound bound(const Scene& scene)
  {
    const bool is_open = is_chance(3);
    const int farthest[] = {0, 1, 1, 3, 10};
    for(int most = farthest[random_.below(5)]; most > 0; most /= 2) {
      const Periodic_fuzz_bound bound = this->bound(scene, most, is_open);
      if(images_to_try(scene, bound) < max_images_to_try)
        return bound;
    }
    const Periodic_fuzz_bound bound = this->bound(scene, 0, is_open);
    return images_to_try(scene, bound) < max_images_to_try ? bound
                                                           : by_distance(step_, is_open);
  }

  Periodic_fuzz_bound bound(const Scene& scene, int most, bool is_open)
  {
    const std::size_t size = scene.places.size();
    if(size == 0 || is_chance(5))
      return by_distance(static_cast<double>(std::abs(number(below(8)))), is_open);
    Offset_of<Dimension> offset;
    for(std::size_t k = 0; k < Dimension; ++k)
      offset[k] = scene.exact.repeats[k] ? static_cast<int>(around_zero(most)) : 0;
    const Rational square = Periodic_oracle<Dimension>(scene.exact)
                              .square({random_.below(size), random_.below(size), offset});
    if(is_chance(3))
      return {std::nullopt, square, is_open};
    if(square >= 1 && is_chance(4))
      return {std::nullopt, square + (is_chance(2) ? 1 : -1), is_open};
    const double root = std::sqrt(static_cast<double>(square));
    return by_distance(is_chance(3) ? std::nextafter(root, is_chance(2) ? 0 : 2 * root) : root,
                       is_open);
  }

  static Periodic_fuzz_bound by_distance(double distance, bool is_open)
  {
    return {distance, Rational(distance) * Rational(distance), is_open};
  }

  // About how many images the oracle tries.
  static double images_to_try(const Scene& scene, const Periodic_fuzz_bound& bound)
  {
    const double size = static_cast<double>(scene.places.size());
    double images = size * size;
    for(std::size_t k = 0; k < Dimension; ++k)
      if(scene.exact.repeats[k])
        images *= 1 + 2 * std::sqrt(static_cast<double>(bound.square))
                        / std::fabs(static_cast<double>(scene.exact.vectors[k][k]));
    return images;
  }

  static constexpr double max_images_to_try = 3000;

  Random random_;
  const Number_range range_;
  const bool is_exact_;
  const Rational domain_unit_;
  double step_ = 1;
  bool is_skewed_by_many_ = false;
  std::array<std::size_t, Dimension> axes_;
  std::array<Lattice_place, 3> first_vectors_ = {};
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_FUZZ_SCENES_H
