// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A value is made once, when it is asked for.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <chrono>
#include <thread>

BOOST_AUTO_TEST_SUITE(On_demand)

using namespace test_support;

BOOST_AUTO_TEST_CASE(nothing_is_made_unless_it_is_asked_for)
{
  int made = 0;
  const auto make = [&] { return ++made, 5; };
  internal::On_demand<int> value;
  BOOST_CHECK_EQUAL(made, 0);
  BOOST_CHECK_EQUAL(value.get(make), 5);
  BOOST_CHECK_EQUAL(value.get(make), 5);
  BOOST_CHECK_EQUAL(made, 1);
}

BOOST_AUTO_TEST_CASE(a_copy_makes_a_value_of_its_own)
{
  internal::On_demand<int> value;
  BOOST_CHECK_EQUAL(value.get([] { return 5; }), 5);
  internal::On_demand<int> copy = value;
  BOOST_CHECK_EQUAL(copy.get([] { return 6; }), 6);
  copy = value;
  BOOST_CHECK_EQUAL(copy.get([] { return 7; }), 7);
  BOOST_CHECK_EQUAL(value.get([] { return 8; }), 5);
}

// The others wait for the one that makes it.
BOOST_AUTO_TEST_CASE(several_threads_get_the_same_value)
{
  for(int repetition = 0; repetition < 50; ++repetition) {
    std::atomic<int> made = 0, right = 0, ready = 0;
    internal::On_demand<int> value;
    const auto ask = [&] {
      ++ready;
      while(ready < 2)
        std::this_thread::yield();
      right += value.get([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        ++made;
        return 5;
      }) == 5;
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
  internal::On_demand<int> value;
  const auto make = [&] {
    if(++calls == 1)
      throw std::runtime_error("no memory");
    return 5;
  };
  BOOST_CHECK_THROW(value.get(make), std::runtime_error);
  BOOST_CHECK_EQUAL(value.get(make), 5);
  value.get(make);
  BOOST_CHECK_EQUAL(calls, 2);
}

BOOST_AUTO_TEST_SUITE_END()
