// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Kernel objects on several kernels, against all pairs tested in exact rational numbers, and
// against CGAL::box_self_intersection_d() with the same test.
//
// A maker of a type of objects has the `dimension` and the number of `points` that they are made
// of, and make<Kernel>(numbers).

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H

#include "number_boxes.h"
#include "pairs.h"

#include <CGAL/Thick_intersection_d/internal/doors/Traits_boxes.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

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
  const std::size_t first_set_size = objects.size() / 3;
  const Pairs_difference two_sets
    = compare(between_sets(expected, first_set_size), reported_pairs(objects, first_set_size));
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

// Scenes of objects whose boxes are of all sizes, on a lattice.

struct Object_scene
{
  std::string name;
  std::vector<Numbers> objects;
};

// Makes an object of random places in the box of a corner and extents.
template <class Maker>
Numbers object_in_box(Generator& random, const std::array<std::uint64_t, 3>& corner,
                      const std::array<std::uint64_t, 3>& extents)
{
  Numbers object;
  for(int k = 0; k < Maker::points * Maker::dimension; ++k) {
    const std::size_t axis = static_cast<std::size_t>(k % Maker::dimension);
    object.push_back(static_cast<float>(corner[axis] + random() % (extents[axis] + 1)));
  }
  return object;
}

// Calls box(i, corner, extents) for n objects, and makes each in its box, if it is not degenerate.
template <class Maker, class Box>
Object_scene object_scene(const std::string& name, std::size_t n, const Box& box)
{
  Object_scene scene = {name, {}};
  Generator random(n);
  for(std::size_t i = 0; i < n; ++i) {
    std::array<std::uint64_t, 3> corner, extents;
    box(random, i, corner, extents);
    const Numbers object = object_in_box<Maker>(random, corner, extents);
    if(!Maker::template make<Rational_kernel>(object).is_degenerate())
      scene.objects.push_back(object);
  }
  return scene;
}

template <class Maker>
std::vector<Object_scene> object_scenes()
{
  using Triple = std::array<std::uint64_t, 3>;
  const std::uint64_t side = Maker::dimension == 2 ? 120 : 24;
  const std::size_t n = Maker::dimension == 2 ? 600 : 300;
  const auto anywhere = [=](Generator& random, Triple& corner) {
    for(std::uint64_t& c : corner)
      c = random() % side;
  };
  std::vector<Object_scene> scenes;
  const auto power_law = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    const double u = static_cast<double>(1 + random() % 1000) / 1000;
    for(std::uint64_t& e : extents)
      e = 1 + (std::min)(side, static_cast<std::uint64_t>(3 / u)) / (1 + random() % 2);
  };
  scenes.push_back(object_scene<Maker>("power law", n, power_law));
  const auto one_giant = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(5);
    if(i == 77) {
      corner.fill(0);
      extents.fill(side);
    }
  };
  scenes.push_back(object_scene<Maker>("one giant", n, one_giant));
  const auto beams = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(1);
    corner[i % Maker::dimension] = 0;
    extents[i % Maker::dimension] = side;
  };
  scenes.push_back(object_scene<Maker>("beams", 300, beams));
  const auto nested = [&](Generator&, std::size_t i, Triple& corner, Triple& extents) {
    corner.fill(i);
    extents.fill(400 - 2 * i);
  };
  scenes.push_back(object_scene<Maker>("nested", 80, nested));
  const auto touching = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    const std::uint64_t cell = random() % 4 == 0 ? 8 : 4;
    anywhere(random, corner);
    for(std::uint64_t& c : corner)
      c = c / cell * cell;
    extents.fill(cell);
  };
  scenes.push_back(object_scene<Maker>("touching cells", n, touching));
  const auto clusters = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = 100000 * (i % 10) + random() % 20;
    extents.fill(i % 10 == 0 ? 1 : 3);
  };
  scenes.push_back(object_scene<Maker>("clusters", 300, clusters));
  scenes.push_back({"identical", std::vector<Numbers>(60, scenes[0].objects.front())});
  return scenes;
}

// The pairs by the boxes of CGAL, tested in exact rational numbers.
template <class Maker>
Pairs pairs_by_box_intersection(const std::vector<Numbers>& numbers)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<float, Maker::dimension, std::size_t>;
  const auto objects = make_objects<Maker, Rational_kernel>(numbers);
  std::vector<Box> boxes;
  for(const Numbers& c : numbers) {
    float low[Maker::dimension], high[Maker::dimension];
    for(std::size_t axis = 0; axis < Maker::dimension; ++axis) {
      low[axis] = high[axis] = c[axis];
      for(std::size_t k = axis; k < c.size(); k += Maker::dimension) {
        low[axis] = (std::min)(low[axis], c[k]);
        high[axis] = (std::max)(high[axis], c[k]);
      }
    }
    boxes.emplace_back(low, high, boxes.size());
  }
  Pairs pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if(CGAL::do_intersect(objects[a.info()], objects[b.info()]))
      pairs.push_back(std::minmax(a.info(), b.info()));
  });
  return pairs;
}

// By the other routes: the box route with many cuts, and the recursive route.
template <class Object>
void check_other_routes(const std::vector<Object>& objects, const Pairs& expected)
{
  using Traits = CGAL::Thick_object_traits_d<Object>;
  using Elements = internal::Numbered_elements<std::vector<Object>>;
  const Elements elements(objects);
  const Traits traits(objects);
  const internal::Traits_boxes<Elements, Traits> boxes(elements, traits);
  for(unsigned int seed = 0; seed < 4; ++seed) {
    Generator random(seed);
    const Pairs_difference by_boxes
      = compare(expected, pairs_by_boxes<decltype(boxes)::static_dimension>(
                            boxes, small_tuning(random)));
    BOOST_CHECK_MESSAGE(by_boxes.empty(), "many cuts, seed " << seed << ": " << by_boxes);
  }
  Pairs found;
  const auto callback = [&](std::size_t i, std::size_t j) { found.emplace_back(i, j); };
  internal::report_recursively<CGAL::Sequential_tag>(elements, internal::One_set(), traits,
                                                     callback,
                                                     CGAL::parameters::default_values());
  const Pairs_difference by_recursion = compare(expected, found);
  BOOST_CHECK_MESSAGE(by_recursion.empty(), "by recursion: " << by_recursion);
}

template <class Maker, class... Kernels>
void check_scenes_of_objects()
{
  std::size_t pairs = 0;
  for(const Object_scene& scene : object_scenes<Maker>())
    BOOST_TEST_CONTEXT(scene.name)
    {
      const Pairs expected = pairs_by_box_intersection<Maker>(scene.objects);
      pairs += expected.size();
      (check_objects<Maker, Kernels>(scene.objects, expected), ...);
      check_other_routes(make_objects<Maker, Double_kernel>(scene.objects), expected);
    }
  BOOST_CHECK_GT(pairs, 1800u); // more than those of identical objects
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
