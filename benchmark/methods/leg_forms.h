// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Do two points that move uniformly come within a distance, as one would write it down?

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_LEG_FORMS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_LEG_FORMS_H

#include <algorithm>
#include <array>
#include <cstddef>

namespace thick_benchmark {

template <class Number, std::size_t N>
struct Plain_leg
{
  using Vector = std::array<Number, N>;

  std::array<Number, 2> times;
  std::array<Vector, 2> ends;

  Vector at(const Number& time) const
  {
    const Number share
      = times[0] == times[1] ? Number(0) : Number((time - times[0]) / (times[1] - times[0]));
    Vector place;
    for(std::size_t axis = 0; axis < N; ++axis)
      place[axis] = Number(ends[0][axis] + (ends[1][axis] - ends[0][axis]) * share);
    return place;
  }
};

template <class Number, std::size_t N>
std::array<Number, N> difference(const std::array<Number, N>& p, const std::array<Number, N>& q)
{
  std::array<Number, N> vector;
  for(std::size_t axis = 0; axis < N; ++axis)
    vector[axis] = Number(p[axis] - q[axis]);
  return vector;
}

template <class Number, std::size_t N>
Number product(const std::array<Number, N>& u, const std::array<Number, N>& v)
{
  Number sum(0);
  for(std::size_t axis = 0; axis < N; ++axis)
    sum += u[axis] * v[axis];
  return sum;
}

// The distance of the origin from the way of one point as the other one sees it. In doubles,
// ST_CPAWithin of PostGIS takes much the same steps.
template <class Number, std::size_t N>
bool come_within(const Plain_leg<Number, N>& a, const Plain_leg<Number, N>& b, const Number& r)
{
  const Number first = (std::max)(a.times[0], b.times[0]);
  const Number last = (std::min)(a.times[1], b.times[1]);
  if(first > last)
    return false;
  auto v = difference(b.at(first), a.at(first));
  const auto way = difference(difference(b.at(last), a.at(last)), v);
  const Number along(-product(v, way)), square(product(way, way));
  Number share(0);
  if(along > Number(0))
    share = along >= square ? Number(1) : Number(along / square);
  for(std::size_t axis = 0; axis < N; ++axis)
    v[axis] += share * way[axis];
  return product(v, v) <= Number(r * r);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_LEG_FORMS_H
