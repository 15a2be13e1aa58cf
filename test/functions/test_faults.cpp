// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Faults at every place of a search: memory runs out, a callback or a predicate throws, the search
// is stopped or cancelled, and callbacks search themselves. After a fault nothing is lost, no
// callback is called that need not, and the next search finds all pairs, in the same order.

#include "support/counting_allocator.h"
#include "support/searches.h"
#include "support/unit_test.h"

#include <CGAL/closest_pair.h>

#include <tbb/global_control.h>

#include <thread>

using namespace test_support;

namespace {

using Point_2 = Searched_kernel::Point_2;
using Parallel = CGAL::Parallel_tag;

// More than processors, so that they interrupt each other.
constexpr std::size_t thread_count = 4;
const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);

struct Fault : std::runtime_error
{
  Fault() : std::runtime_error("a fault of the test") {}
};

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

template <class ConcurrencyTag>
std::vector<Search> searches_with_throwing_predicates()
{
  return {
    search_by_traits<ConcurrencyTag>("intervals", searched_boxes(2000), Interval_traits()),
    search_by_traits<ConcurrencyTag>("three predicates", searched_points<2>(400),
                                     Predicate_traits())};
}

template <class ConcurrencyTag>
std::vector<Search> searches(std::size_t n)
{
  std::vector<Search> all = pair_searches<ConcurrencyTag>(n);
  all.push_back(near_search<ConcurrencyTag>("few points", .2, searched_points<2>(100)));
  for(const Search& search : searches_with_throwing_predicates<ConcurrencyTag>())
    all.push_back(search);
  return all;
}

bool go_on(double) { return true; }

// The pairs of a search, and whether it went to its end.
std::pair<Pairs, bool> found_pairs(const Search& search, const On_progress& on_progress = go_on)
{
  Pairs pairs;
  Locked_collector collect(pairs);
  const bool is_complete = search.run(
    [&](std::size_t i, std::size_t j) {
      collect(i, j);
      return true;
    },
    on_progress);
  return {pairs, is_complete};
}

// The sorted pairs of a search that goes to its end.
Pairs all_pairs(const Search& search)
{
  const auto [pairs, is_complete] = found_pairs(search);
  BOOST_CHECK(is_complete);
  return sorted(pairs);
}

// For each search, in sequence and in parallel: task(search, its pairs, how many calls of a
// callback may follow that which stops it). The next search is right, and no bytes are lost.
template <class Task>
void for_each_search(const std::vector<std::vector<Search>>& kinds, const Task& task)
{
  for(std::size_t kind = 0; kind < kinds.size(); ++kind)
    for(const Search& search : kinds[kind])
      BOOST_TEST_CONTEXT(search.name << (kind == 0 ? " in sequence" : " in parallel"))
      {
        const Pairs expected = all_pairs(search);
        BOOST_REQUIRE(expected.size() > 50);
        const std::size_t bytes = current_bytes();
        task(search, expected, kind == 0 ? 0 : thread_count - 1);
        BOOST_CHECK_EQUAL(current_bytes(), bytes);
        BOOST_CHECK(all_pairs(search) == expected);
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
  for_each_search(3000, [](const Search& search, const Pairs& expected, std::size_t) {
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
    BOOST_CHECK_EQUAL(failures == 0, search.name == "few points"); // which are on the stack
  });
}

BOOST_AUTO_TEST_CASE(memory_may_run_out_in_searches_without_pairs)
{
  const auto plane = searched_points<2>(3000);
  const auto space = searched_points<3>(3000);
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
  for_each_search(3000, [](const Search& search, const Pairs& expected, std::size_t others) {
    for_some(expected.size(), [&](std::size_t k) {
      std::atomic<std::size_t> calls{0};
      const On_pair on_pair = [&](std::size_t, std::size_t) -> bool {
        if(calls++ >= k)
          throw Fault();
        return true;
      };
      BOOST_CHECK_THROW(search.run(on_pair, go_on), Fault);
      BOOST_CHECK_LE(calls.load(), k + 1 + others);
    });
  });
}

BOOST_AUTO_TEST_CASE(predicate_may_throw_at_any_call)
{
  for_each_search({searches_with_throwing_predicates<CGAL::Sequential_tag>(),
                   searches_with_throwing_predicates<Parallel>()},
                  [](const Search& search, const Pairs&, std::size_t) {
    const std::size_t start = predicate_calls_left;
    all_pairs(search);
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
  for_each_search(3000, [](const Search& search, const Pairs& expected, std::size_t others) {
    for_some(expected.size(), [&](std::size_t k) {
      std::atomic<std::size_t> calls{0};
      const On_pair on_pair = [&](std::size_t, std::size_t) { return calls++ < k; };
      BOOST_CHECK(!search.run(on_pair, go_on));
      BOOST_CHECK_GE(calls.load(), k + 1);
      BOOST_CHECK_LE(calls.load(), k + 1 + others);
    });
  });
}

BOOST_AUTO_TEST_CASE(search_is_cancelled_or_fails_at_any_progress)
{
  for_each_search(3000, [](const Search& search, const Pairs&, std::size_t) {
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
  });
}

// A thread that waits in a search of the callback may take a task of the search that called it.
BOOST_AUTO_TEST_CASE(callbacks_may_search_themselves)
{
  const std::vector<Search> inner = searches<Parallel>(300);
  std::vector<Pairs> inner_pairs;
  for(const Search& search : inner)
    inner_pairs.push_back(all_pairs(search));
  for_each_search(6000, [&](const Search& search, const Pairs& expected, std::size_t) {
    std::atomic<std::size_t> calls{0};
    std::atomic<bool> are_right{true};
    const auto search_again = [&](std::size_t k) {
      const std::size_t s = k % inner.size();
      are_right = are_right && all_pairs(inner[s]) == inner_pairs[s];
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
  for_each_search(6000, [](const Search& search, const Pairs& expected, std::size_t) {
    std::atomic<std::size_t> right{0};
    const auto search_and_compare = [&] { right += all_pairs(search) == expected; };
    std::thread other(search_and_compare);
    search_and_compare();
    other.join();
    BOOST_CHECK_EQUAL(right.load(), 2u);
  });
}

BOOST_AUTO_TEST_CASE(order_of_reports_is_a_function_of_the_input)
{
  std::vector<Search> all = searches<CGAL::Sequential_tag>(3000);
  std::vector<Point_2> points = searched_points<2>(300);
  for(int i = 0; i < 300; ++i)
    points.push_back(points[i]);
  all.push_back(near_search<CGAL::Sequential_tag>("points twice", .1, points));
  for(const Search& search : all)
    BOOST_CHECK_MESSAGE(found_pairs(search) == found_pairs(search), search.name);
}
