// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Faults at every place of a search: memory runs out, a callback or a predicate throws, the search
// is stopped or cancelled, and callbacks search themselves. After a fault nothing is lost, and the
// next search finds all pairs.

#include "support/counting_allocator.h"
#include "support/pairs.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <cmath>
#include <functional>
#include <mutex>
#include <new>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace test_support;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Parallel = CGAL::Parallel_if_available_tag;
using On_pair = std::function<bool(std::size_t, std::size_t)>;
using On_progress = std::function<bool(double)>;

// Returns whether the search went to its end.
struct Search
{
  std::string name;
  std::function<bool(const On_pair&, const On_progress&)> run;
};

struct Fault : std::runtime_error
{
  Fault() : std::runtime_error("a fault of the test") {}
};

// ---- objects ------------------------------------------------------------------------------------

double random_number(std::mt19937& random) { return double(random()) / double(random.max()); }

std::vector<Point_2> points_2(std::size_t n)
{
  std::mt19937 random(1);
  std::vector<Point_2> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double x = random_number(random);
    points.emplace_back(x, random_number(random));
  }
  return points;
}

std::vector<Point_3> points_3(std::size_t n)
{
  std::mt19937 random(2);
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double x = random_number(random), y = random_number(random);
    points.emplace_back(x, y, random_number(random));
  }
  return points;
}

std::vector<CGAL::Bbox_3> boxes(std::size_t n)
{
  std::mt19937 random(3);
  std::vector<CGAL::Bbox_3> boxes;
  for(const Point_3& p : points_3(n)) {
    const double side = .02 / (random_number(random) + .02);
    boxes.emplace_back(p.x(), p.y(), p.z(), p.x() + side, p.y() + .1, p.z() + .1);
  }
  return boxes;
}

std::vector<std::pair<Point_2, double>> disks(std::size_t n)
{
  std::mt19937 random(4);
  std::vector<std::pair<Point_2, double>> disks;
  for(const Point_2& p : points_2(n))
    disks.emplace_back(p, .03 * random_number(random));
  return disks;
}

// How many calls of predicates are left before one throws.
std::atomic<std::size_t> predicate_calls_left{static_cast<std::size_t>(-1)};

template <class T>
T unless_it_throws(const T& value)
{
  if(predicate_calls_left-- == 0)
    throw Fault();
  return value;
}

// Boxes by their intervals. All functors may throw.
struct Interval_traits
{
  using Object_d = CGAL::Bbox_3;
  using Dimension = CGAL::Dimension_tag<3>;

  struct Interval_d
  {
    std::pair<double, double> operator()(const Object_d& a, int i) const
    {
      return unless_it_throws(std::make_pair((a.min)(i), (a.max)(i)));
    }
  };
  struct Do_intersect_d
  {
    bool operator()(const Object_d& a, const Object_d& b) const
    {
      return unless_it_throws(CGAL::do_overlap(a, b));
    }
  };

  int dimension() const { return 3; }
  Interval_d interval_d_object() const { return {}; }
  Do_intersect_d do_intersect_d_object() const { return {}; }
};

// Points in the plane at most .05 apart along both axes.
struct Predicate_traits
{
  using Object_d = Point_2;

  struct Less_coordinate_d
  {
    bool operator()(const Point_2& a, const Point_2& b, int i) const
    {
      return unless_it_throws(a[i] < b[i]);
    }
  };
  struct Is_close_along_axis_d
  {
    bool operator()(const Point_2& a, const Point_2& b, int i) const
    {
      return unless_it_throws(std::fabs(a[i] - b[i]) <= .05);
    }
  };
  struct Do_intersect_d
  {
    bool operator()(const Point_2& a, const Point_2& b) const
    {
      const Is_close_along_axis_d is_close;
      return is_close(a, b, 0) && is_close(a, b, 1);
    }
  };

  int dimension() const { return 2; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const { return {}; }
  Do_intersect_d do_intersect_d_object() const { return {}; }
};

// ---- searches -----------------------------------------------------------------------------------

template <class ConcurrencyTag, class Point>
Search near_points(const std::string& name, const std::vector<Point>& points, double distance)
{
  return {name, [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(
      points, CGAL::within_distance(distance), on_pair, CGAL::parameters::callback(on_progress));
  }};
}

template <class ConcurrencyTag, class Object, class Traits>
Search objects_of(const std::string& name, const std::vector<Object>& objects,
                  const Traits& traits)
{
  return {name, [=](const On_pair& on_pair, const On_progress& on_progress) {
    return CGAL::thick_self_intersection_d<ConcurrencyTag>(
      objects, on_pair, CGAL::parameters::geom_traits(traits).callback(on_progress));
  }};
}

template <class ConcurrencyTag>
std::vector<Search> searches_with_throwing_predicates()
{
  return {objects_of<ConcurrencyTag>("intervals", boxes(600), Interval_traits()),
          objects_of<ConcurrencyTag>("three predicates", points_2(400), Predicate_traits())};
}

template <class ConcurrencyTag>
std::vector<Search> searches(std::size_t n)
{
  const auto balls = disks(n);
  std::vector<Search> all = searches_with_throwing_predicates<ConcurrencyTag>();
  all.push_back(near_points<ConcurrencyTag>("points in the plane", points_2(n), .02));
  all.push_back(near_points<ConcurrencyTag>("points in space", points_3(n), .08));
  all.push_back(objects_of<ConcurrencyTag>("boxes", boxes(n),
                                           CGAL::Thick_object_traits_d<CGAL::Bbox_3>()));
  all.push_back(objects_of<ConcurrencyTag>("balls", balls,
                                           CGAL::Thick_ball_traits_d<Point_2>(balls)));
  return all;
}

bool go_on(double) { return true; }

// The pairs of a search, and whether it went to its end.
std::pair<Pairs, bool> found_pairs(const Search& search, const On_progress& on_progress = go_on)
{
  Pairs pairs;
  std::mutex mutex;
  const bool is_complete = search.run(
    [&](std::size_t i, std::size_t j) {
      const std::lock_guard<std::mutex> lock(mutex);
      pairs.emplace_back(i, j);
      return true;
    },
    on_progress);
  return {sorted(pairs), is_complete};
}

// For each search, in sequence and in parallel: task(search, its pairs). The next search is right,
// and no bytes are lost.
template <class Task>
void for_each_search(const std::vector<std::vector<Search>>& kinds, const Task& task)
{
  for(std::size_t kind = 0; kind < kinds.size(); ++kind)
    for(const Search& search : kinds[kind])
      BOOST_TEST_CONTEXT(search.name << (kind == 0 ? " in sequence" : " in parallel"))
      {
        const auto expected = found_pairs(search);
        BOOST_REQUIRE(expected.second && expected.first.size() > 50);
        const std::size_t bytes = current_bytes();
        task(search, expected.first);
        BOOST_CHECK_EQUAL(current_bytes(), bytes);
        BOOST_CHECK(found_pairs(search) == expected);
      }
}

template <class Task>
void for_each_search(std::size_t n, const Task& task)
{
  for_each_search({searches<CGAL::Sequential_tag>(n), searches<Parallel>(n)}, task);
}

// The numbers up to 20, and then one in ten, up to `count`.
template <class Task>
void for_some(std::size_t count, const Task& task)
{
  for(std::size_t k = 0; k < count; k += 1 + k / 20)
    task(k);
}

} // namespace

BOOST_AUTO_TEST_CASE(memory_may_run_out_at_any_allocation)
{
  for_each_search(3000, [](const Search& search, const Pairs& expected) {
    bool is_complete = false;
    std::size_t failures = 0;
    for(std::size_t allocations = 0; !is_complete; ++allocations) {
      std::atomic<std::size_t> count{0};
      const On_pair on_pair = [&](std::size_t, std::size_t) { return ++count != 0; };
      const On_progress on_progress = go_on;
      const Memory_that_runs_out memory(allocations);
      try {
        is_complete = search.run(on_pair, on_progress);
      }
      catch(const std::bad_alloc&) {
        ++failures;
        continue;
      }
      BOOST_CHECK_EQUAL(count.load(), expected.size());
    }
    BOOST_CHECK_GT(failures, 0u);
  });
}

BOOST_AUTO_TEST_CASE(memory_may_run_out_in_searches_without_pairs)
{
  const auto plane = points_2(3000);
  const auto space = points_3(3000);
  const std::vector<std::function<double()>> searches = {
    [&] { return CGAL::closest_pair(plane).first + 1.; },
    [&] { return CGAL::closest_pair(space).first + 1.; },
    [&] { return CGAL::closest_pair<Parallel>(space).first + 1.; },
    [&] {
      const auto bound = CGAL::within_distance(.02);
      return double(CGAL::fixed_radius_neighbor_lists(plane, bound).number_of_pairs());
    },
    [&] {
      const auto bound = CGAL::within_distance(.05);
      const auto lists = CGAL::fixed_radius_neighbor_lists<Parallel>(space, bound);
      return double(lists.number_of_pairs());
    }};
  for(std::size_t s = 0; s < searches.size(); ++s)
    BOOST_TEST_CONTEXT("search " << s)
    {
      const double expected = searches[s]();
      const std::size_t bytes = current_bytes();
      double found = 0;
      std::size_t failures = 0;
      for(std::size_t allocations = 0; found == 0; ++allocations) {
        const Memory_that_runs_out memory(allocations);
        try {
          found = searches[s]();
        }
        catch(const std::bad_alloc&) {
          ++failures;
        }
      }
      BOOST_CHECK_EQUAL(found, expected);
      BOOST_CHECK_GT(failures, 2u);
      BOOST_CHECK_EQUAL(current_bytes(), bytes);
    }
}

BOOST_AUTO_TEST_CASE(callback_may_throw_at_any_pair)
{
  for_each_search(3000, [](const Search& search, const Pairs& expected) {
    for_some(expected.size(), [&](std::size_t k) {
      std::atomic<std::size_t> calls{0};
      const On_pair on_pair = [&](std::size_t, std::size_t) -> bool {
        if(calls++ >= k)
          throw Fault();
        return true;
      };
      BOOST_CHECK_THROW(search.run(on_pair, go_on), Fault);
    });
  });
}

BOOST_AUTO_TEST_CASE(predicate_may_throw_at_any_call)
{
  for_each_search({searches_with_throwing_predicates<CGAL::Sequential_tag>(),
                   searches_with_throwing_predicates<Parallel>()},
                  [](const Search& search, const Pairs&) {
    const std::size_t start = predicate_calls_left;
    found_pairs(search);
    const std::size_t calls = start - predicate_calls_left;
    for_some(calls, [&](std::size_t k) {
      predicate_calls_left = k;
      BOOST_CHECK_THROW(found_pairs(search), Fault);
      predicate_calls_left = static_cast<std::size_t>(-1);
    });
  });
}

BOOST_AUTO_TEST_CASE(search_stops_at_any_pair)
{
  for_each_search(3000, [](const Search& search, const Pairs& expected) {
    for_some(expected.size(), [&](std::size_t k) {
      std::atomic<std::size_t> calls{0};
      const On_pair on_pair = [&](std::size_t, std::size_t) { return calls++ < k; };
      BOOST_CHECK(!search.run(on_pair, go_on));
    });
  });
}

BOOST_AUTO_TEST_CASE(search_is_cancelled_or_fails_at_any_progress)
{
  for_each_search(3000, [](const Search& search, const Pairs& expected) {
    std::size_t tells = 0;
    found_pairs(search, [&](double) { return ++tells != 0; });
    for_some(tells, [&](std::size_t k) {
      // Another run in parallel may tell the progress fewer times, and then end.
      std::size_t told = 0;
      const bool is_complete = found_pairs(search, [&](double) { return told++ < k; }).second;
      BOOST_CHECK_EQUAL(is_complete, told <= k);
      told = 0;
      const On_progress fail = [&](double) { return told++ < k ? true : throw Fault(); };
      bool has_failed = false;
      try {
        found_pairs(search, fail);
      }
      catch(const Fault&) {
        has_failed = true;
      }
      BOOST_CHECK_EQUAL(has_failed, told > k);
    });
    BOOST_CHECK(!expected.empty());
  });
}

// A thread that waits in a search of the callback may take a task of the search that called it.
BOOST_AUTO_TEST_CASE(callbacks_may_search_themselves)
{
  const std::vector<Search> inner = searches<Parallel>(300);
  std::vector<Pairs> inner_pairs;
  for(const Search& search : inner)
    inner_pairs.push_back(found_pairs(search).first);
  for_each_search(6000, [&](const Search& search, const Pairs& expected) {
    std::atomic<std::size_t> calls{0};
    std::atomic<bool> are_right{true};
    const auto search_again = [&](std::size_t k) {
      const std::size_t s = k % inner.size();
      are_right = are_right && found_pairs(inner[s]).first == inner_pairs[s];
      return true;
    };
    const On_pair on_pair = [&](std::size_t, std::size_t) {
      const std::size_t k = calls++;
      return k % 100 != 0 || search_again(k / 100);
    };
    std::size_t tells = 0;
    const On_progress on_progress
      = [&](double) { return ++tells % 20 != 0 || search_again(tells); };
    BOOST_CHECK(search.run(on_pair, on_progress));
    BOOST_CHECK_EQUAL(calls.load(), expected.size());
    BOOST_CHECK(are_right);
  });
}

BOOST_AUTO_TEST_CASE(threads_may_search_the_same_objects)
{
  for_each_search(6000, [](const Search& search, const Pairs& expected) {
    std::atomic<std::size_t> right{0};
    const auto search_and_compare = [&] { right += found_pairs(search).first == expected; };
    std::thread other(search_and_compare);
    search_and_compare();
    other.join();
    BOOST_CHECK_EQUAL(right.load(), 2u);
  });
}
