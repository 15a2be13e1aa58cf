// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a set of objects is. Do two of them intersect?

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_SETS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_SETS_H

#include <cstddef>
#include <string>
#include <vector>

namespace lab {

// What objects are, of which the vertices are given.
enum class Meaning {
  CLOSED, // closed sets
  THICK,  // closed sets with a radius each
  OPEN,   // sets without their boundaries
  SOLID,  // closed meshes
  MOVING  // points that go from one vertex to another, within a bound: the sum of their radii
};

struct Kind
{
  std::string name; // that of CGAL's class, if objects are closed sets
  int dimension;
  int vertices;
  Meaning meaning = Meaning::CLOSED;
};

inline std::vector<Kind> kinds()
{
  return {{"Segment_2", 2, 2},
          {"Triangle_2", 2, 3},
          {"Segment_3", 3, 2},
          {"Triangle_3", 3, 3},
          {"Tetrahedron_3", 3, 4}};
}

// The same objects with another meaning.
inline std::vector<Kind> thick_kinds()
{
  return {{"capsules, plane", 2, 2, Meaning::THICK},
          {"capsules, space", 3, 2, Meaning::THICK},
          {"open triangles", 2, 3, Meaning::OPEN},
          {"open tetrahedra", 3, 4, Meaning::OPEN},
          {"solids", 3, 4, Meaning::SOLID}};
}

// Objects are the coordinates of their vertices.
struct Object_set
{
  Kind kind;
  std::string family;
  std::vector<double> numbers;
  std::vector<double> radii = {}; // of the objects, if they have some
  std::vector<double> times = {}; // of the vertices, if objects move

  std::size_t numbers_of_object() const
  {
    return static_cast<std::size_t>(kind.dimension * kind.vertices);
  }
  std::size_t size() const { return numbers.size() / numbers_of_object(); }
  const double* object(std::size_t i) const { return &numbers[i * numbers_of_object()]; }
  double radius(std::size_t i) const { return radii.empty() ? 0 : radii[i]; }
};

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_SETS_H
