// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What stand-ins for oneTBB have in common. Each has, before it includes this file,
//
//   std::size_t tbb::stand_in::block_count();  // into how many blocks a range is divided
//   void tbb::stand_in::run(count, task);      // calls task(b) for the numbers below `count`

#ifndef THICK_INTERSECTION_TEST_SUPPORT_TBB_BY_BLOCKS_H
#define THICK_INTERSECTION_TEST_SUPPORT_TBB_BY_BLOCKS_H

#include <algorithm>
#include <cstddef>
#include <memory>

namespace tbb {

template <class T>
class blocked_range
{
public:
  blocked_range(T first, T last) : first_(first), last_(last) {}
  T begin() const { return first_; }
  T end() const { return last_; }

private:
  T first_, last_;
};

template <class T, class Body>
void parallel_for(const blocked_range<T>& range, const Body& body)
{
  const T size = range.end() - range.begin();
  const T blocks = (std::min)(size, static_cast<T>(stand_in::block_count()));
  stand_in::run(blocks, [&](std::size_t b) {
    body(blocked_range<T>(range.begin() + size * b / blocks,
                          range.begin() + size * (b + 1) / blocks));
  });
}

// Each block has one number.
struct simple_partitioner
{};

template <class T, class Body>
void parallel_for(const blocked_range<T>& range, const Body& body, simple_partitioner)
{
  stand_in::run(range.end() - range.begin(), [&](std::size_t b) {
    body(blocked_range<T>(range.begin() + b, range.begin() + b + 1));
  });
}

template <class T>
using cache_aligned_allocator = std::allocator<T>;

enum ets_key_usage_type { ets_key_per_instance, ets_no_key };

} // namespace tbb

#endif // THICK_INTERSECTION_TEST_SUPPORT_TBB_BY_BLOCKS_H
