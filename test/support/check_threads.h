// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a search by several threads promises: a stop is obeyed, exceptions come out, the progress is
// told in order and may cancel.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_THREADS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_THREADS_H

#include "parallel_pairs.h"
#include "unit_test.h"

#include <tbb/global_control.h>

namespace test_support {

// Calls search(callback, watch) with functors of pairs and of progress.
template <class Search>
void check_stop_throw_and_cancel(const Search& search_with)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  std::atomic<std::size_t> calls = 0;
  double last = 0, limit = 2;
  std::size_t stop_at = never, throw_at = never;
  const std::function<bool(double)> watch = [&](double done) {
    BOOST_CHECK_GE(done, last);
    last = done;
    return done < limit;
  };
  const auto callback = [&](std::size_t, std::size_t) {
    const std::size_t call = ++calls;
    if(call == throw_at)
      throw std::runtime_error("enough");
    return call < stop_at;
  };
  const auto search = [&] {
    calls = 0;
    last = 0;
    return search_with(callback, watch);
  };
  BOOST_CHECK(search());
  BOOST_CHECK_EQUAL(last, 1);
  const std::size_t all = calls;
  stop_at = 100;
  BOOST_CHECK(!search());
  BOOST_CHECK_GE(calls, 100u);
  BOOST_CHECK_LE(calls, 100u + thread_count - 1); // each thread is told at its next pair
  stop_at = never;
  throw_at = 1000;
  BOOST_CHECK_THROW(search(), std::runtime_error);
  throw_at = never;
  limit = 0.3;
  BOOST_CHECK(!search());
  BOOST_CHECK_LT(calls, all);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_THREADS_H
