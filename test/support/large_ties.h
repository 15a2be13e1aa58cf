// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact ties whose squares are too long for doubles.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_LARGE_TIES_H
#define THICK_INTERSECTION_TEST_SUPPORT_LARGE_TIES_H

#include "standard_library.h"

namespace test_support {

// Triples a^2 + b^2 = c^2, times an odd number of 20 bits: ties whose squares take 60 bits.
struct Tie
{
  double a, b, c;
};

inline std::vector<Tie> large_ties()
{
  std::vector<Tie> ties;
  std::mt19937_64 random(3);
  while(ties.size() < 4096) {
    const double m = static_cast<double>(2 + random() % 30);
    const double n = static_cast<double>(1 + random() % 30);
    const double h = static_cast<double>((random() % (1 << 20)) | (1 << 19) | 1);
    if(m > n)
      ties.push_back({h * (m * m - n * n), h * 2 * m * n, h * (m * m + n * n)});
  }
  return ties;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_LARGE_TIES_H
