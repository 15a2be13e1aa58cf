// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of no kernel: a class of the user with a box and a test.

#include "support/check_pairs.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/tags.h>
#include <CGAL/thick_intersection_d.h>

using namespace test_support;

namespace shapes {

// Numbers are small integers, so the test is exact.
struct Disk
{
  double x, y, radius;

  CGAL::Bbox_2 bbox() const { return {x - radius, y - radius, x + radius, y + radius}; }
};

bool do_intersect(const Disk& a, const Disk& b)
{
  const double radii = a.radius + b.radius;
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) <= radii * radii;
}

// The package has a function of this name for its own use, and is not to find this one.
void bounding_box(const Disk&);

} // namespace shapes

namespace {

using shapes::Disk;

double random_number(std::mt19937& random, unsigned int end)
{
  return static_cast<double>(random() % end);
}

std::vector<Disk> random_disks(std::size_t n)
{
  std::mt19937 random(1);
  std::vector<Disk> disks;
  for(std::size_t i = 0; i < n; ++i) {
    const double x = random_number(random, 200), y = random_number(random, 200);
    disks.push_back({x, y, random_number(random, 6)});
  }
  disks.front().radius = 80; // one giant
  return disks;
}

template <class Object, class Test>
Pairs all_pairs(const std::vector<Object>& objects, const Test& test)
{
  return pairs_where(objects.size(), [&](std::size_t i, std::size_t j) {
    return test(objects[i], objects[j]);
  });
}

template <class ConcurrencyTag, class Object>
Pairs found_pairs(const std::vector<Object>& objects)
{
  Pairs pairs;
  Locked_collector collect(pairs);
  CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, collect);
  return pairs;
}

template <class Object, class Test>
void check_objects(const std::vector<Object>& objects, const Test& test)
{
  const Pairs expected = all_pairs(objects, test);
  BOOST_REQUIRE_GT(expected.size(), objects.size() / 2);
  check_pairs("in sequence", expected, found_pairs<CGAL::Sequential_tag>(objects));
  check_pairs("in parallel", expected,
              found_pairs<CGAL::Parallel_if_available_tag>(objects));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_class_with_a_box_and_a_test_is_searched_without_traits)
{
  check_objects(random_disks(3000),
                [](const Disk& a, const Disk& b) { return do_intersect(a, b); });
}

// Traits like those of the package, without intervals: three predicates are left.
struct Traits_without_intervals : CGAL::Thick_object_traits_d<Disk>
{
  using CGAL::Thick_object_traits_d<Disk>::Thick_object_traits_d;
  Interval_d interval_d_object() const = delete;
};

BOOST_AUTO_TEST_CASE(derived_traits_without_intervals_take_the_recursive_route)
{
  const std::vector<Disk> disks = random_disks(300);
  const auto test = [](const Disk& a, const Disk& b) { return do_intersect(a, b); };
  check_pairs("disks", all_pairs(disks, test), reported([&](auto collect) {
    CGAL::thick_self_intersection_d(
      disks, collect, CGAL::parameters::geom_traits(Traits_without_intervals(disks)));
  }));
}
