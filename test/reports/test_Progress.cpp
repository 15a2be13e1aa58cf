// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the functor of a watched search is told.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

BOOST_AUTO_TEST_SUITE(Progress)

using namespace test_support;

BOOST_AUTO_TEST_CASE(parts_of_a_search_share_what_is_left_of_the_progress)
{
  std::vector<double> told;
  const auto note = [&](double done) {
    told.push_back(done);
    return done < 2;
  };
  internal::Watched_progress<decltype(note)> progress(note, 4);
  for(const std::size_t total : {4, 2}) {
    progress.restart(total);
    progress.advance(1);
    progress.advance(1);
  }
  BOOST_CHECK((told == std::vector<double>{0.25, 0.5, 0.75, 1}));
}

BOOST_AUTO_TEST_CASE(who_has_cancelled_is_not_called_again)
{
  int calls = 0;
  const auto cancel = [&](double) {
    ++calls;
    return false;
  };
  internal::Watched_progress<decltype(cancel)> progress(cancel, 2);
  BOOST_CHECK(!progress.is_cancelled());
  BOOST_CHECK(!progress.advance(1));
  BOOST_CHECK(!progress.advance(1));
  BOOST_CHECK(progress.is_cancelled());
  progress.finish();
  BOOST_CHECK_EQUAL(calls, 1);
}

// As if the thread that calls the functor took another task of the search before the call returned.
BOOST_AUTO_TEST_CASE(search_may_advance_while_the_functor_is_called)
{
  internal::Watched_progress<std::function<bool(double)>>* running = nullptr;
  std::vector<double> told;
  const auto note = [&](double done) {
    told.push_back(done);
    if(told.size() == 1)
      BOOST_CHECK(running->advance(1));
    return true;
  };
  internal::Watched_progress<std::function<bool(double)>> progress(note, 4);
  running = &progress;
  BOOST_CHECK(progress.advance(1));
  BOOST_CHECK((told == std::vector<double>{0.25, 0.5})); // one call after the other
  BOOST_CHECK(progress.advance(2));
  BOOST_CHECK_EQUAL(told.back(), 1);
}

// Searches that nobody watches have nothing to keep or to count.
static_assert(std::is_empty_v<internal::Unwatched_progress>);
static_assert(std::is_same_v<decltype(internal::make_progress(CGAL::parameters::default_values(),
                                                              1)),
                             internal::Unwatched_progress>);

BOOST_AUTO_TEST_SUITE_END()
