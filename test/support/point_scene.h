// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A scene: points as doubles, a radius that is never rounded, and, where it is known from
// elsewhere, how many pairs there are.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_POINT_SCENE_H
#define THICK_INTERSECTION_TEST_SUPPORT_POINT_SCENE_H

#include "standard_library.h"

namespace test_support {

using Coordinates = std::vector<double>;
using Points = std::vector<Coordinates>;

// Either a length, which is exactly that double, or the square of one, as the text of an integer
// or a fraction ("13", "25/16"): the length itself need not be rational then.
class Radius
{
public:
  static Radius of_length(double length) { return Radius(length, std::string()); }
  static Radius of_square(std::string square) { return Radius(std::nullopt, std::move(square)); }

  const std::optional<double>& length() const { return length_; }
  const std::string& square_text() const { return square_; } // empty if a length was given

private:
  Radius(std::optional<double> length, std::string square)
    : length_(length), square_(std::move(square)) {}

  std::optional<double> length_;
  std::string square_;
};

struct Expected_count
{
  std::size_t pairs;       // at distance at most the radius
  std::size_t on_boundary; // those of them at exactly the radius
};

struct Point_scene
{
  std::string name;
  int dimension;
  Points points;
  Radius radius;
  std::optional<Expected_count> expected; // nothing: brute force has the last word
};

using Scenes = std::vector<Point_scene>;

inline std::ostream& operator<<(std::ostream& out, const Point_scene& scene)
{
  return out << scene.name << " (" << scene.dimension << "D, n = " << scene.points.size() << ')';
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_POINT_SCENE_H
