// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of segments, triangles or tetrahedra whose coordinates are integers of b bits: drawn at
// random, or so that they touch in a point, or nearly so.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_CONTACTS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_CONTACTS_H

#include "object_questions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lab {

// ---- the least offset off a plane ---------------------------------------------------------------

// The greatest common divisor of a and b, which is a s + b t.
struct Bezout
{
  Integer divisor, s, t;

  Bezout(const Integer& a, const Integer& b)
  {
    mpz_gcdext(divisor.backend().data(), s.backend().data(), t.backend().data(),
               a.backend().data(), b.backend().data());
  }
};

using Integer_vector = test_support::Hull_vector<Integer>;

// Subtracts the multiple of u that leaves the least part of d along the direction of a vector.
inline void reduce(Integer_vector& d, const Integer_vector& u, const Integer_vector& direction)
{
  const Integer whole = dot(u, direction), part = dot(d, direction);
  if(whole != 0)
    for(std::size_t axis = 0; axis < 3; ++axis)
      d[axis] -= part / whole * u[axis];
}

// Returns the vector whose determinant with u and v is their greatest common divisor, mostly 1, and
// which is about as long as they are.
inline Place least_offset(const Place& u, const Place& v)
{
  const Integer_vector a = {u[0], u[1], u[2]}, b = {v[0], v[1], v[2]};
  const Integer_vector normal = cross(a, b);
  const Bezout first(normal[0], normal[1]), both(first.divisor, normal[2]);
  Integer_vector d = {first.s * both.s, first.t * both.s, both.t};
  reduce(d, a, cross(b, normal));
  reduce(d, b, cross(normal, a));
  return {d[0].convert_to<std::int64_t>(), d[1].convert_to<std::int64_t>(),
          d[2].convert_to<std::int64_t>()};
}

// ---- pairs --------------------------------------------------------------------------------------

class Contact_generator
{
public:
  Contact_generator(const Kind& kind, int bits, std::uint64_t seed)
    : kind_(kind), range_(std::int64_t(1) << bits), random_(seed)
  {}

  std::pair<Places, Places> random_pair() { return {random_object({}), random_object({})}; }

  // An edge of the first object, or a face, has a vertex of the second one, or crosses an edge of
  // it. Then this vertex, or an end of this edge, is moved as little off it as integers can be, or
  // not.
  std::pair<Places, Places> contact()
  {
    const bool are_edges = kind_.dimension == 3 && (kind_.vertices == 2 || below(2) == 0);
    const bool is_face = kind_.dimension == 3 && !are_edges;
    Places first, second;
    do {
      const Place x = random_place(), u = difference(random_place(), x);
      const Place v = kind_.dimension == 3 ? difference(random_place(), x) : Place{0, 0, 1};
      first = is_face ? face_around(x, u, v) : edge_around(x, u);
      second = are_edges ? edge_around(x, v) : Places{x};
      if(are_in_range(first) && are_in_range(second))
        second[0] = sum(second[0], static_cast<std::int64_t>(below(3)) - 1, least_offset(u, v));
    } while(!are_in_range(first) || !are_in_range(second));
    return {random_object(std::move(first)), random_object(std::move(second))};
  }

private:
  std::size_t below(std::size_t count) { return random_.below(count); }

  Place random_place()
  {
    Place place = {};
    for(int axis = 0; axis < kind_.dimension; ++axis)
      place[static_cast<std::size_t>(axis)]
        = static_cast<std::int64_t>(below(static_cast<std::size_t>(range_)));
    return place;
  }

  // An object that begins with the given vertices.
  Places random_object(Places object)
  {
    while(object.size() < static_cast<std::size_t>(kind_.vertices))
      object.push_back(random_place());
    return object;
  }

  static Place sum(const Place& p, std::int64_t factor, const Place& vector)
  {
    return {p[0] + factor * vector[0], p[1] + factor * vector[1], p[2] + factor * vector[2]};
  }

  Places edge_around(const Place& x, const Place& u)
  {
    return {sum(x, -1, u), sum(x, 1 + static_cast<std::int64_t>(below(2)), u)};
  }

  // x is the center of mass.
  static Places face_around(const Place& x, const Place& u, const Place& v)
  {
    return {sum(x, 1, u), sum(x, 1, v), sum(sum(x, -1, u), -1, v)};
  }

  bool are_in_range(const Places& places) const
  {
    return std::all_of(places.begin(), places.end(), [&](const Place& p) {
      return std::all_of(p.begin(), p.end(), [&](std::int64_t c) { return 0 <= c && c < range_; });
    });
  }

  Kind kind_;
  std::int64_t range_;
  Random random_;
};

// Adds the questions about the objects 2i and 2i + 1, and the answers.
inline void ask_about_neighbors(Object_questions& questions)
{
  const Exact_objects exact(questions.objects);
  for(std::size_t i = 0; i < questions.objects.size(); i += 2) {
    questions.pairs.emplace_back(i, i + 1);
    questions.answers.push_back(exact.do_intersect(i, i + 1));
  }
}

// Questions about the objects 2i and 2i + 1.
inline Object_questions contacts(const Kind& kind, int bits, bool is_near, std::size_t count)
{
  Contact_generator generator(kind, bits, static_cast<std::uint64_t>(bits));
  Object_questions questions = {{kind, is_near ? "contacts" : "random", {}}, {}, {}};
  for(std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = is_near ? generator.contact() : generator.random_pair();
    for(const Places* object : {&a, &b})
      for(const Place& p : *object)
        for(std::size_t axis = 0; axis < static_cast<std::size_t>(kind.dimension); ++axis)
          questions.objects.numbers.push_back(static_cast<double>(p[axis]));
  }
  ask_about_neighbors(questions);
  return questions;
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_CONTACTS_H
