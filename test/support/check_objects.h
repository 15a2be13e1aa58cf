// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Kernel objects on several kernels, against all pairs tested in exact rational numbers.
//
// A maker of a type of objects has the `dimension` and the number of `points` that they are made
// of, and make<Kernel>(numbers).

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H

#include "pairs.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <random>

namespace test_support {

using Double_kernel = CGAL::Simple_cartesian<double>;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// Objects as lists of numbers: n random ones on a lattice of a unit, so that many of them touch.
using Numbers = std::vector<float>; // which doubles hold too

inline std::vector<Numbers> random_numbers(std::size_t n, std::size_t per_object, int dimension,
                                    float unit, unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::vector<Numbers> objects(n);
  for(Numbers& object : objects) {
    Numbers corner;
    for(int i = 0; i < dimension; ++i)
      corner.push_back(static_cast<float>(random() % (dimension == 2 ? 40 : 12)));
    for(std::size_t k = 0; k < per_object; ++k)
      object.push_back(unit * (corner[k % dimension] + static_cast<float>(random() % 6)));
  }
  return objects;
}

template <class Maker, class Kernel>
auto make_objects(const std::vector<Numbers>& numbers)
{
  std::vector<decltype(Maker::template make<Kernel>(numbers.front()))> objects;
  for(const Numbers& c : numbers)
    objects.push_back(Maker::template make<Kernel>(c));
  return objects;
}

// Those that are not degenerate in the exact kernel.
template <class Maker>
std::vector<Numbers> proper_objects(float unit)
{
  std::vector<Numbers> proper;
  for(const Numbers& c :
      random_numbers(250, Maker::points * Maker::dimension, Maker::dimension, unit, 7))
    if(!Maker::template make<Rational_kernel>(c).is_degenerate())
      proper.push_back(c);
  return proper;
}

template <class Object>
Pairs all_intersecting_pairs(const std::vector<Object>& objects)
{
  Pairs pairs;
  for(std::size_t i = 0; i < objects.size(); ++i)
    for(std::size_t j = i + 1; j < objects.size(); ++j)
      if(CGAL::do_intersect(objects[i], objects[j]))
        pairs.emplace_back(i, j);
  return pairs;
}

template <class Object>
Pairs reported_pairs(const std::vector<Object>& objects)
{
  Pairs pairs;
  CGAL::thick_self_intersection_d(
    objects, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

template <class Object>
Pairs reported_pairs(const std::vector<Object>& objects, std::size_t first_set_size)
{
  const auto middle = objects.begin() + static_cast<std::ptrdiff_t>(first_set_size);
  const std::vector<Object> a(objects.begin(), middle), b(middle, objects.end());
  Pairs pairs;
  CGAL::thick_intersection_d(a, b, [&](std::size_t i, std::size_t j) {
    pairs.emplace_back(i, first_set_size + j);
  });
  return pairs;
}

inline Pairs between_sets(const Pairs& pairs, std::size_t first_set_size)
{
  Pairs result;
  for(const Pair& p : pairs)
    if(p.first < first_set_size && p.second >= first_set_size)
      result.push_back(p);
  return result;
}

template <class Maker, class Kernel>
void check_objects(const std::vector<Numbers>& numbers, const Pairs& expected)
{
  const auto objects = make_objects<Maker, Kernel>(numbers);
  const Pairs_difference one_set = compare(expected, reported_pairs(objects));
  BOOST_CHECK_MESSAGE(one_set.empty(), "one set: " << one_set);
  const Pairs_difference two_sets
    = compare(between_sets(expected, 100), reported_pairs(objects, 100));
  BOOST_CHECK_MESSAGE(two_sets.empty(), "two sets: " << two_sets);
}

// On each of the kernels: each costs half a minute of compilation for objects in space.
template <class Maker, class... Kernels>
void check_type_of_object()
{
  for(const float unit : {1.f, 0.1f}) {
    const std::vector<Numbers> numbers = proper_objects<Maker>(unit);
    const Pairs expected = all_intersecting_pairs(make_objects<Maker, Rational_kernel>(numbers));
    BOOST_REQUIRE_GT(expected.size(), 50u);
    (check_objects<Maker, Kernels>(numbers, expected), ...);
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
