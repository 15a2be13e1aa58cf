// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Checks of random scenes, each drawn from a seed.
//
//   <program> [<option of Boost.Test>...] [-- <seconds> [<first seed>]]
//
// Without arguments, each test draws a fixed number of scenes. With seconds, it goes on until they
// are over, each test for itself. With 0 seconds and the seed of a failure, it begins with that.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SEEDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SEEDS_H

#include "unit_test.h"

#include <chrono>

namespace test_support {

// Calls check(seed) `count` times, or as long as the arguments of the program ask for. Returns how
// often: what is expected of `count` scenes need not hold for fewer.
template <class Check>
std::uint64_t check_seeds(std::uint64_t count, const Check& check)
{
  const auto& program = boost::unit_test::framework::master_test_suite();
  const double seconds = program.argc > 1 ? std::stod(program.argv[1]) : 0;
  const std::uint64_t first = program.argc > 2 ? std::stoull(program.argv[2]) : 1;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::uint64_t checked = 0;
  for(; seconds > 0 ? std::chrono::steady_clock::now() < end : checked < count; ++checked)
    check(first + checked);
  BOOST_TEST_MESSAGE(checked << " scenes from seed " << first);
  return checked;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SEEDS_H
