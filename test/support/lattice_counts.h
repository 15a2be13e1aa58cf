// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How many pairs of an m^d lattice are within a squared threshold T, in closed form: the
// difference vector v occurs (m - |v_1|) ... (m - |v_d|) times, and v and -v are the same pair.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_LATTICE_COUNTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_LATTICE_COUNTS_H

#include "standard_library.h"

namespace test_support {

struct Lattice_count
{
  std::uint64_t pairs;        // |v|^2 <= T
  std::uint64_t at_threshold; // |v|^2 == T
};

// Ordered pairs, each point with itself included. The caller sees to it that m^(2d) < 2^64, or
// that the count itself fits: no partial sum exceeds it.
inline std::uint64_t ordered_lattice_pairs(std::uint64_t m, int dimension, std::int64_t threshold)
{
  if(threshold < 0)
    return 0;
  if(dimension == 0)
    return 1;
  std::uint64_t count = 0;
  for(std::int64_t v = 0; v < static_cast<std::int64_t>(m) && v * v <= threshold; ++v) {
    const std::uint64_t places = m - static_cast<std::uint64_t>(v);
    const std::uint64_t signs = v == 0 ? 1 : 2;
    count += signs * places * ordered_lattice_pairs(m, dimension - 1, threshold - v * v);
  }
  return count;
}

inline Lattice_count lattice_count(std::uint64_t m, int dimension, std::int64_t threshold)
{
  const std::uint64_t within = ordered_lattice_pairs(m, dimension, threshold);
  const std::uint64_t closer = ordered_lattice_pairs(m, dimension, threshold - 1);
  const std::uint64_t selves = ordered_lattice_pairs(m, dimension, 0);
  if(threshold == 0)
    return {0, 0};
  return {(within - selves) / 2, (within - closer) / 2};
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_LATTICE_COUNTS_H
