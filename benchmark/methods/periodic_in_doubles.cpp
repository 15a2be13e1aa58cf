// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What programs do that have only doubles. These methods try all pairs, because their pairs are
// what matters, and not their times. Cells would give the same pairs.

#include "periodic_methods.h"

#include <cmath>

namespace thick_benchmark {

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

double product(const Vector& v, const Vector& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }

Vector cross(const Vector& v, const Vector& w)
{
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

// Computes how many times each vector goes into a point, and the point from that.
class Fractions
{
public:
  explicit Fractions(const Matrix& vectors) : vectors_(vectors)
  {
    for(std::size_t k = 0; k < 3; ++k) {
      duals_[k] = cross(vectors[(k + 1) % 3], vectors[(k + 2) % 3]);
      const double volume = product(duals_[k], vectors[k]);
      for(double& x : duals_[k])
        x /= volume;
    }
  }

  Vector of(const Vector& x) const
  {
    return {product(duals_[0], x), product(duals_[1], x), product(duals_[2], x)};
  }

  Vector point(const Vector& f) const
  {
    Vector x;
    for(std::size_t axis = 0; axis < 3; ++axis)
      x[axis] = f[0] * vectors_[0][axis] + f[1] * vectors_[1][axis] + f[2] * vectors_[2][axis];
    return x;
  }

private:
  Matrix vectors_;
  Matrix duals_;
};

Vector difference(const Vector& x, const Vector& y)
{
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}

Image_pairs pairs_by_minimum_image(const Periodic_scene& scene)
{
  const Fractions fractions(scene.vectors);
  Image_pairs pairs;
  for(std::size_t i = 0; i < scene.points.size(); ++i)
    for(std::size_t j = i + 1; j < scene.points.size(); ++j) {
      Vector f = fractions.of(difference(scene.points[i], scene.points[j]));
      Image_pair pair = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), {}};
      for(std::size_t k = 0; k < 3; ++k) {
        const double periods = std::nearbyint(f[k]);
        f[k] -= periods;
        pair.offset[k] = static_cast<std::int32_t>(periods);
      }
      const Vector d = fractions.point(f);
      if(product(d, d) <= scene.r * scene.r)
        pairs.push_back(pair);
    }
  return pairs;
}

std::array<std::int32_t, 3> sum(const std::array<std::int32_t, 3>& a,
                                const std::array<std::int32_t, 3>& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// Points moved into the cell, and their images: by adding periods to coordinates.
class Moved_by_periods
{
public:
  explicit Moved_by_periods(const Periodic_scene& scene)
    : points_(scene.points), vectors_(scene.vectors)
  {
    const Fractions fractions(scene.vectors);
    for(const Vector& x : scene.points) {
      const Vector f = fractions.of(x);
      offsets_.push_back({});
      for(std::size_t k = 0; k < 3; ++k)
        offsets_.back()[k] = -static_cast<std::int32_t>(std::floor(f[k]));
    }
  }

  const std::array<std::int32_t, 3>& offset(std::size_t i) const { return offsets_[i]; }

  // The image of a point moved by an offset from the cell.
  Vector image(std::size_t i, const std::array<std::int32_t, 3>& offset) const
  {
    Vector x = points_[i];
    const auto periods = sum(offsets_[i], offset);
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t axis = 0; axis < 3; ++axis)
        x[axis] += periods[k] * vectors_[k][axis];
    return x;
  }

private:
  std::vector<Vector> points_;
  Matrix vectors_;
  std::vector<std::array<std::int32_t, 3>> offsets_;
};

// The same by fractions: those of an image are those of the point and whole numbers.
class Moved_by_fractions
{
public:
  explicit Moved_by_fractions(const Periodic_scene& scene) : cell_(scene.vectors)
  {
    for(const Vector& x : scene.points) {
      fractions_.push_back(cell_.of(x));
      offsets_.push_back({});
      for(std::size_t k = 0; k < 3; ++k) {
        const double periods = std::floor(fractions_.back()[k]);
        fractions_.back()[k] -= periods;
        offsets_.back()[k] = -static_cast<std::int32_t>(periods);
      }
    }
  }

  const std::array<std::int32_t, 3>& offset(std::size_t i) const { return offsets_[i]; }

  Vector image(std::size_t i, const std::array<std::int32_t, 3>& offset) const
  {
    const Vector& f = fractions_[i];
    return cell_.point({f[0] + offset[0], f[1] + offset[1], f[2] + offset[2]});
  }

private:
  Fractions cell_;
  std::vector<Vector> fractions_;
  std::vector<std::array<std::int32_t, 3>> offsets_;
};

// Whether an image is above a point: of the two images that make a pair, one is.
bool is_above(const Vector& image, const Vector& point)
{
  for(const std::size_t axis : {2, 1, 0})
    if(image[axis] != point[axis])
      return image[axis] > point[axis];
  return false;
}

template <class Moved_points>
Image_pairs pairs_with_ghosts(const Periodic_scene& scene)
{
  const Moved_points moved(scene);
  const auto are_near = [&](const Vector& x, const Vector& y) {
    const Vector d = difference(x, y);
    return product(d, d) <= scene.r * scene.r;
  };
  const auto size = static_cast<std::int32_t>(scene.points.size());
  std::vector<Vector> own;
  for(std::size_t i = 0; i < scene.points.size(); ++i)
    own.push_back(moved.image(i, {}));
  Image_pairs pairs;
  Image_pair pair = {}; // of points in the cell
  const auto add = [&] {
    const auto& [x, y, z] = moved.offset(static_cast<std::size_t>(pair.i));
    const auto offset = sum(pair.offset, moved.offset(static_cast<std::size_t>(pair.j)));
    pairs.push_back(ordered({pair.i, pair.j, sum(offset, {-x, -y, -z})}));
  };
  auto& [a, b, c] = pair.offset;
  for(a = -1; a <= 1; ++a)
    for(b = -1; b <= 1; ++b)
      for(c = -1; c <= 1; ++c)
        for(pair.j = 0; pair.j < size; ++pair.j) {
          const bool is_ghost = a != 0 || b != 0 || c != 0;
          const Vector image = moved.image(static_cast<std::size_t>(pair.j), pair.offset);
          for(pair.i = 0; pair.i < size; ++pair.i) {
            const Vector& x = own[static_cast<std::size_t>(pair.i)];
            if((is_ghost ? is_above(image, x) : pair.i < pair.j) && are_near(x, image))
              add();
          }
        }
  return pairs;
}

Periodic_method method(const char* name, Image_pairs (*pairs)(const Periodic_scene&))
{
  return {name, false, [=](const Periodic_scene& scene) {
            return Periodic_run{[=, &scene] { return pairs(scene).size(); },
                                [=, &scene] { return pairs(scene); }};
          }};
}

} // namespace

Periodic_method minimum_image() { return method("minimum image", pairs_by_minimum_image); }
Periodic_method ghosts_by_periods()
{
  return method("ghosts by periods", pairs_with_ghosts<Moved_by_periods>);
}
Periodic_method ghosts_by_fractions()
{
  return method("ghosts by fractions", pairs_with_ghosts<Moved_by_fractions>);
}

} // namespace thick_benchmark
