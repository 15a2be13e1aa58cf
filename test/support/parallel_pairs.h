// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PARALLEL_PAIRS_H
#define THICK_INTERSECTION_TEST_SUPPORT_PARALLEL_PAIRS_H

#include "pairs.h"

#include <tbb/enumerable_thread_specific.h>

namespace test_support {

// More than processors, so that they interrupt each other.
inline constexpr std::size_t thread_count = 4;

// The pairs that search(callback) reports from several threads.
template <class Search>
Pairs collected(const Search& search)
{
  tbb::enumerable_thread_specific<Pairs> found;
  search([&](std::size_t i, std::size_t j) { found.local().emplace_back(i, j); });
  Pairs all;
  for(const Pairs& some : found)
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PARALLEL_PAIRS_H
