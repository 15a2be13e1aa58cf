// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Kernel objects on several kernels, against all pairs tested in exact rational numbers, and
// against CGAL::box_self_intersection_d() with the same test.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H

#include "number_boxes.h"
#include "object_scenes.h"
#include "pairs.h"
#include "parallel_pairs.h"

#include <CGAL/Thick_intersection_d/internal/doors/Traits_boxes.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <type_traits>
#include <vector>

namespace test_support {

using Double_kernel = CGAL::Simple_cartesian<double>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// n random objects on a lattice of a unit, so that many of them touch.
inline std::vector<Numbers> random_numbers(std::size_t n, std::size_t per_object, int dimension,
                                           float unit, unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::vector<Numbers> objects(n);
  for(Numbers& object : objects) {
    Numbers corner;
    for(int i = 0; i < dimension; ++i)
      corner.push_back(static_cast<double>(random() % (dimension == 2 ? 40 : 12)));
    for(std::size_t k = 0; k < per_object; ++k) {
      const double steps = corner[k % dimension] + static_cast<double>(random() % 6);
      object.push_back(unit * static_cast<float>(steps)); // rounded as kernels of floats need it
    }
  }
  return objects;
}

// What integers are multiplied by, without rounding. The pairs stay the same.
enum class Scale {
  ONE,
  HUGE_POWER, // squares of such numbers are no doubles
  DENORMAL,
  THIRD       // few of these are doubles, so the boxes are larger than the objects
};

template <class FT>
FT scaled(double x, Scale scale)
{
  if constexpr(CGAL::Algebraic_structure_traits<FT>::Is_exact::value)
    if(scale == Scale::THIRD)
      return FT(x) / FT(3);
  return FT(scale == Scale::HUGE_POWER ? std::ldexp(x, 990)
            : scale == Scale::DENORMAL ? std::ldexp(x, -1074)
                                       : x);
}

template <class Maker, class Kernel>
auto make_objects(const std::vector<Numbers>& numbers, Scale scale = Scale::ONE)
{
  std::vector<decltype(Maker::template make<Kernel>(numbers.front()))> objects;
  for(const Numbers& c : numbers) {
    std::vector<typename Kernel::FT> coordinates;
    for(const double x : c)
      coordinates.push_back(scaled<typename Kernel::FT>(x, scale));
    objects.push_back(Maker::template make<Kernel>(coordinates));
  }
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

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;

// The pairs that are reported in sequence or in parallel.
template <class ConcurrencyTag, class Object>
Pairs reported_pairs(const std::vector<Object>& objects)
{
  return collected([&](const Callback& callback) {
    CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, callback);
  });
}

template <class ConcurrencyTag, class Object>
Pairs reported_pairs(const std::vector<Object>& objects, std::size_t first_set_size)
{
  const auto middle = objects.begin() + static_cast<std::ptrdiff_t>(first_set_size);
  const std::vector<Object> a(objects.begin(), middle), b(middle, objects.end());
  Pairs pairs = collected([&](const Callback& callback) {
    CGAL::thick_intersection_d<ConcurrencyTag>(a, b, callback);
  });
  for(Pair& p : pairs)
    p.second += first_set_size;
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

template <class ConcurrencyTag, class Object>
void check_pairs(const std::vector<Object>& objects, const Pairs& expected, const char* how)
{
  const Pairs_difference one_set = compare(expected, reported_pairs<ConcurrencyTag>(objects));
  BOOST_CHECK_MESSAGE(one_set.empty(), how << ", one set: " << one_set);
  const std::size_t first_set_size = objects.size() / 3;
  const Pairs_difference two_sets
    = compare(between_sets(expected, first_set_size),
              reported_pairs<ConcurrencyTag>(objects, first_set_size));
  BOOST_CHECK_MESSAGE(two_sets.empty(), how << ", two sets: " << two_sets);
}

// In parallel, two kernels are enough: one that computes when it is asked, one that does not.
template <class Maker, class Kernel>
void check_objects(const std::vector<Numbers>& numbers, const Pairs& expected,
                   Scale scale = Scale::ONE)
{
  const auto objects = make_objects<Maker, Kernel>(numbers, scale);
  check_pairs<CGAL::Sequential_tag>(objects, expected, "in sequence");
  if constexpr(std::is_same_v<Kernel, Epeck> || std::is_same_v<Kernel, Double_kernel>)
    check_pairs<CGAL::Parallel_tag>(make_objects<Maker, Kernel>(numbers, scale), expected,
                                    "in parallel");
}

// The first objects, of any magnitude, because most predicates need exact numbers for these.
template <class Maker, class Kernel>
void check_scales(const std::vector<Numbers>& numbers, const Pairs& expected)
{
  using FT = typename Kernel::FT;
  const std::size_t size = (std::min)(numbers.size(), std::size_t(60));
  const std::vector<Numbers> first(numbers.begin(), numbers.begin() + size);
  Pairs expected_of_first;
  for(const Pair& p : expected)
    if(p.second < size)
      expected_of_first.push_back(p);
  for(const Scale scale : {Scale::HUGE_POWER, Scale::DENORMAL, Scale::THIRD})
    BOOST_TEST_CONTEXT("scale " << static_cast<int>(scale))
    {
      const bool is_possible = scale == Scale::THIRD
                                 ? CGAL::Algebraic_structure_traits<FT>::Is_exact::value
                                 : !std::is_same_v<FT, float>;
      if(is_possible)
        check_objects<Maker, Kernel>(first, expected_of_first, scale);
    }
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

// The pairs by the boxes of CGAL, tested in exact rational numbers.
template <class Maker>
Pairs pairs_by_box_intersection(const std::vector<Numbers>& numbers)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Maker::dimension, std::size_t>;
  const auto objects = make_objects<Maker, Rational_kernel>(numbers);
  std::vector<Box> boxes;
  for(const Numbers& c : numbers) {
    double low[Maker::dimension], high[Maker::dimension];
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
      (check_scales<Maker, Kernels>(scene.objects, expected), ...);
      check_other_routes(make_objects<Maker, Double_kernel>(scene.objects), expected);
    }
  BOOST_CHECK_GT(pairs, 1800u); // more than those of identical objects
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
