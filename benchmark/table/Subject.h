// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A search whose pairs have been checked, and what all rows are made of.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_SUBJECT_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_SUBJECT_H

#include "rows.h"

#include "measuring/timing.h"
#include "methods/ours.h"

namespace thick_benchmark {

inline Goal at_most(double target) { return {Goal::AT_MOST, target, std::nullopt}; }
inline Goal at_most(double target, double good) { return {Goal::AT_MOST, target, good}; }

inline double milliseconds_of_first(const Seconds& s) { return 1000 * s[0]; }

// Throws unless they are equal.
void check_equal(const std::string& name, const Tally& expected, const Tally& found);

struct Subject
{
  std::string name;
  std::size_t n;
  std::uint64_t k;
  Search search;
};

// After all ways of the search have found the same pairs.
Subject make_subject(const std::string& name, std::size_t n, const Search& search,
                     const Tally& expected);

#ifdef CGAL_LINKED_WITH_TBB
// With the same callback on both sides.
Row measure_two_threads(const Subject& subject);
#endif

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_SUBJECT_H
