// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Kernel objects on several kernels and scales, against all pairs tested by the oracle of hulls,
// against CGAL::box_intersection_d() with the same test, and against the recursive route.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H

#include "check_pairs.h"
#include "hull_oracle.h"
#include "number_boxes.h"
#include "object_makers.h"
#include "object_scenes.h"
#include "parallel_pairs.h"
#include "usual_kernels.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_support {

// What is done to numbers, without rounding. The pairs stay the same.
enum class Scale {
  ONE,
  HUGE_POWER, // squares of such numbers are no doubles, or no integers
  DENORMAL,
  THIRD,      // few of these are doubles, but objects that touched do so still
  CLOSE       // no doubles are between these, so all boxes of doubles meet
};

template <class FT>
constexpr bool can_scale(Scale scale)
{
  return scale == Scale::ONE ? true
         : scale == Scale::THIRD || scale == Scale::CLOSE
           ? CGAL::Algebraic_structure_traits<FT>::Is_exact::value && !std::is_integral_v<FT>
         : scale == Scale::DENORMAL ? !std::is_same_v<FT, float> && !std::is_integral_v<FT>
                                    : !std::is_same_v<FT, float>;
}

template <class FT>
FT scaled(double x, Scale scale)
{
  if constexpr(internal::Is_quotient<FT>::value) {
    typename FT::NT numerator, denominator;
    CGAL::Fraction_traits<CGAL::Exact_rational>::Decompose()(
      scaled<CGAL::Exact_rational>(x, scale), numerator, denominator);
    return FT(numerator, denominator);
  }
  else {
    if constexpr(can_scale<FT>(Scale::THIRD)) {
      if(scale == Scale::THIRD)
        return FT(FT(x) / FT(3));
      if(scale == Scale::CLOSE)
        return FT(FT(1) + FT(std::ldexp(x, -80)));
    }
    return FT(scale == Scale::HUGE_POWER ? std::ldexp(x, std::is_integral_v<FT> ? 40 : 990)
              : scale == Scale::DENORMAL ? std::ldexp(x, -1074)
                                         : x);
  }
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

// Whether two objects intersect.
using Test = std::function<bool(std::size_t, std::size_t)>;

inline bool are_integers(const std::vector<Numbers>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](const Numbers& c) {
    return std::all_of(c.begin(), c.end(), [](double x) { return x == std::trunc(x); });
  });
}

// The vertices of an object in integers: coordinates times 2^27, if they are those of floats.
template <class Maker, class Integer>
Hull_vectors<Integer> hull_of(const Numbers& numbers, bool are_integers)
{
  const auto integer = [&](double x) {
    return Integer(static_cast<std::int64_t>(are_integers ? x : std::ldexp(x, 27)));
  };
  const std::size_t corners
    = Maker::are_boxes ? std::size_t(1) << Maker::dimension : std::size_t(Maker::points);
  Hull_vectors<Integer> hull(corners);
  for(std::size_t k = 0; k < corners; ++k)
    for(std::size_t axis = 0; axis < Maker::dimension; ++axis) {
      const std::size_t point = Maker::are_boxes ? k >> axis & 1 : k;
      hull[k][axis] = integer(numbers[point * Maker::dimension + axis]);
    }
  return hull;
}

template <class Maker, class Integer>
Test hull_test(const std::vector<Numbers>& numbers, bool are_integers)
{
  std::vector<Hull_vectors<Integer>> hulls;
  for(const Numbers& c : numbers)
    hulls.push_back(hull_of<Maker, Integer>(c, are_integers));
  // Each kernel asks again about the same pairs.
  std::vector<signed char> known(hulls.size() * hulls.size(), -1);
  return [hulls, known](std::size_t i, std::size_t j) mutable {
    signed char& answer = known[i * hulls.size() + j];
    if(answer < 0)
      answer = do_hulls_intersect(hulls[i], hulls[j]);
    return answer != 0;
  };
}

// By an oracle that takes degenerate objects as the sets that they are.
template <class Maker>
Test exact_test(const std::vector<Numbers>& numbers)
{
  return are_integers(numbers) ? hull_test<Maker, std::int64_t>(numbers, true)
                               : hull_test<Maker, boost::multiprecision::int128_t>(numbers, false);
}

inline Number_box box_of(const Numbers& object, int dimension)
{
  Number_box box;
  for(std::size_t k = 0; k < object.size(); ++k)
    box[k % static_cast<std::size_t>(dimension)].add(object[k]);
  return box;
}

// What a scene has, found out without the package.
struct Object_truth
{
  Test do_intersect;
  Pairs pairs;
};

template <class Maker>
Object_truth truth_of(const std::vector<Numbers>& numbers)
{
  Number_boxes boxes;
  for(const Numbers& c : numbers)
    boxes.push_back(box_of(c, Maker::dimension));
  Object_truth truth = {exact_test<Maker>(numbers), {}};
  for(const Pair& p : all_meeting_pairs(boxes, Maker::dimension))
    if(truth.do_intersect(p.first, p.second))
      truth.pairs.push_back(p);
  return truth;
}

// The first set of two, of one object in three.
inline std::size_t first_set_size(std::size_t size) { return size / 3; }

template <int Dimension>
using Cgal_boxes = std::vector<CGAL::Box_intersection_d::Box_with_info_d<double, Dimension,
                                                                         std::size_t>>;

// The truth by CGAL, with the boxes that objects say they have.
template <int Dimension>
void check_truth_by_boxes(const Cgal_boxes<Dimension>& boxes, const Object_truth& truth)
{
  using Box = typename Cgal_boxes<Dimension>::value_type;
  Pairs found;
  const auto report = [&](const Box& a, const Box& b) {
    const Pair p = std::minmax(a.info(), b.info());
    if(truth.do_intersect(p.first, p.second))
      found.push_back(p);
  };
  const std::size_t first_size = first_set_size(boxes.size());
  auto [a, b] = split(boxes, first_size);
  CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), report);
  const Pairs two_sets = std::exchange(found, {});
  a = boxes;
  CGAL::box_self_intersection_d(a.begin(), a.end(), report);
  check_pairs("by CGAL, one set", truth.pairs, found);
  check_pairs("by CGAL, two sets", between_sets(truth.pairs, first_size), two_sets);
}

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;

// Searches the objects as one set and as two.
template <class ConcurrencyTag, class Object>
void check_search(const std::vector<Object>& objects, const Object_truth& truth, const char* how)
{
  const auto sets = split(objects, first_set_size(objects.size()));
  const Pairs one_set = collected([&](const Callback& callback) {
    CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, callback);
  });
  const Pairs two_sets = collected([&](const Callback& callback) {
    CGAL::thick_intersection_d<ConcurrencyTag>(sets.first, sets.second, callback);
  });
  check_pairs(how, truth.pairs, one_set, two_sets, sets.first.size());
}

// The recursive route, as public functions call it: so it is not compiled once more.
template <class Object>
void check_recursive_route(const std::vector<Object>& objects, const Object_truth& truth)
{
  const auto sets = split(objects, first_set_size(objects.size()));
  const CGAL::Thick_object_traits_d<Object> traits(objects);
  const auto& np = CGAL::parameters::default_values();
  internal::Unwatched_progress progress;
  const Pairs one_set = collected([&](const Callback& callback) {
    internal::search_recursively(internal::make_elements(objects, np), internal::One_set(), traits,
                                 callback, progress, internal::Threads());
  });
  const Pairs two_sets = collected([&](const Callback& callback) {
    const auto report = [&](const auto& elements, const auto& sets_of_two) {
      internal::search_recursively(elements, sets_of_two, traits, callback, progress,
                                   internal::Threads());
    };
    internal::with_sets(report, internal::make_elements(sets.first, np),
                        internal::make_elements(sets.second, np));
  });
  check_pairs("by recursion", truth.pairs, one_set, two_sets, sets.first.size());
}

// The box route with many cuts, in another way for each seed.
template <class Object>
void check_cuts(const std::vector<Object>& objects, const Object_truth& truth,
                std::initializer_list<unsigned int> seeds)
{
  using Traits = CGAL::Thick_object_traits_d<Object>;
  using Elements = internal::Numbered_elements<std::vector<Object>>;
  const Elements elements(objects);
  const Traits traits;
  const internal::Traits_boxes<Elements, Traits> boxes(elements, traits);
  for(const unsigned int seed : seeds) {
    Generator random(seed);
    const Pairs found = collected([&](const Callback& callback) {
      internal::Unwatched_progress progress;
      search_boxes<decltype(boxes)::static_dimension>(boxes, small_tuning(random), std::nullopt,
                                                      callback, progress);
    });
    check_pairs("many cuts, seed " + std::to_string(seed), truth.pairs, found);
  }
}

// In parallel, two kernels are enough: one that computes when it is asked, one that does not.
template <class Maker, class Kernel>
void check_objects(const std::vector<Numbers>& numbers, Scale scale, const Object_truth& truth)
{
  const auto objects = make_objects<Maker, Kernel>(numbers, scale);
  check_search<CGAL::Sequential_tag>(objects, truth, "in sequence");
  check_recursive_route(objects, truth);
  if(std::is_same_v<Kernel, Double_kernel>)
    check_cuts(objects, truth, {0, 1, 2, 3});
  else
    check_cuts(objects, truth, {4});
  Cgal_boxes<Maker::dimension> boxes;
  for(std::size_t i = 0; i < objects.size(); ++i)
    boxes.emplace_back(objects[i].bbox(), i);
  check_truth_by_boxes<Maker::dimension>(boxes, truth);
  if constexpr(std::is_same_v<Kernel, Epeck> || std::is_same_v<Kernel, Double_kernel>)
    check_search<CGAL::Parallel_tag>(make_objects<Maker, Kernel>(numbers, scale), truth,
                                     "in parallel");
}

// The first objects of a scene on the scales that the numbers of a kernel have. Returns the number
// of pairs.
template <class Maker, class... Kernels>
std::size_t check_first(const Object_scene& scene, std::size_t max_size,
                        std::initializer_list<Scale> scales)
{
  const std::size_t size = (std::min)(scene.objects.size(), max_size);
  const auto end = scene.objects.begin() + static_cast<std::ptrdiff_t>(size);
  const std::vector<Numbers> numbers(scene.objects.begin(), end);
  const Object_truth truth = truth_of<Maker>(numbers);
  const auto check = [&](const auto& kernel, Scale scale) {
    using Kernel = std::decay_t<decltype(kernel)>;
    using FT = typename Kernel::FT;
    if(can_scale<FT>(scale) && (!std::is_integral_v<FT> || are_integers(numbers)))
      check_objects<Maker, Kernel>(numbers, scale, truth);
  };
  for(const Scale scale : scales)
    BOOST_TEST_CONTEXT(scene.name << ", scale " << static_cast<int>(scale))
    (check(Kernels(), scale), ...);
  return truth.pairs.size();
}

// Every scene on each of the kernels, and the first objects of it on scales where most predicates
// need exact numbers. Predicates of tetrahedra are the slowest ones.
template <class Maker, class... Kernels>
void check_scenes_of_objects(std::size_t max_size = Maker::points == 4 ? 200 : 1000)
{
  constexpr bool are_slow = Maker::points == 4;
  constexpr std::size_t few = are_slow ? 24 : 60;
  std::size_t pairs = 0;
  for(const Object_scene& scene : object_scenes(object_kind<Maker>())) {
    pairs += check_first<Maker, Kernels...>(scene, max_size, {Scale::ONE});
    check_first<Maker, Kernels...>(scene, are_slow ? few : max_size, {Scale::THIRD});
    check_first<Maker, Kernels...>(scene, 16, {Scale::CLOSE}); // of which all pairs are tested
    if(are_integers(scene.objects))
      check_first<Maker, Kernels...>(scene, few, {Scale::HUGE_POWER, Scale::DENORMAL});
  }
  BOOST_CHECK_GT(pairs, 1800u); // more than those of identical objects
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_OBJECTS_H
