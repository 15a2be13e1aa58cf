// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicate for near ties is made once, when it is asked for.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_predicate.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Near_ties_on_demand.h>

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

BOOST_AUTO_TEST_SUITE(Near_ties_on_demand)

namespace internal = CGAL::Thick_intersection_d::internal;

internal::Near_tie_predicate within_5()
{
  const internal::Squared_bound<internal::Exact_number_t<double>> bound(CGAL::within_distance(5));
  return internal::Near_tie_predicate(bound, 2);
}

// Whether (x, 4) is within 5 of the origin.
bool decides(const internal::Near_tie_predicate& predicate, double x, bool is_within)
{
  internal::Decision_counts counts;
  return predicate.decide([&](int axis) { return axis == 0 ? x : 4; }, [](int) { return 0.; }, 2,
                          counts) == is_within;
}

BOOST_AUTO_TEST_CASE(nothing_is_made_unless_it_is_asked_for)
{
  int made = 0;
  const internal::Near_ties_on_demand near_ties([&] { return ++made, within_5(); });
  BOOST_CHECK_EQUAL(made, 0);
  BOOST_CHECK(decides(near_ties.get(), 3 - 0x1p-50, true));
  BOOST_CHECK(decides(near_ties.get(), 3 + 0x1p-50, false));
  BOOST_CHECK_EQUAL(made, 1);
}

// The others wait for the one that makes it.
BOOST_AUTO_TEST_CASE(several_threads_get_the_same_predicate)
{
  for(int repetition = 0; repetition < 50; ++repetition) {
    std::atomic<int> made = 0, right = 0, ready = 0;
    const internal::Near_ties_on_demand near_ties([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      ++made;
      return within_5();
    });
    const auto ask = [&] {
      ++ready;
      while(ready < 2)
        std::this_thread::yield();
      right += decides(near_ties.get(), 3 + 0x1p-50, false);
    };
    std::thread other(ask);
    ask();
    other.join();
    BOOST_CHECK_EQUAL(made.load(), 1);
    BOOST_CHECK_EQUAL(right.load(), 2);
  }
}

BOOST_AUTO_TEST_CASE(what_could_not_be_made_is_made_when_asked_for_again)
{
  int calls = 0;
  const internal::Near_ties_on_demand near_ties([&] {
    if(++calls == 1)
      throw std::runtime_error("no memory");
    return within_5();
  });
  BOOST_CHECK_THROW(near_ties.get(), std::runtime_error);
  BOOST_CHECK(decides(near_ties.get(), 3 + 0x1p-50, false));
  near_ties.get();
  BOOST_CHECK_EQUAL(calls, 2);
}

BOOST_AUTO_TEST_SUITE_END()
