// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "support/counting_allocator.h"

namespace thick_benchmark {

std::size_t peak_bytes_of(const std::function<void()>& job)
{
  const std::size_t before = test_support::current_bytes();
  test_support::reset_peak();
  job();
  return test_support::peak_bytes() - before;
}

} // namespace thick_benchmark
