// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the user may want to be told besides the answer, because another option may have been meant.

#ifndef NEAR_PAIRS_HINTS_H
#define NEAR_PAIRS_HINTS_H

#include "options.h"
#include "scene.h"

#include <algorithm>
#include <cstddef>
#include <ostream>

namespace near_pairs {

// Counts the pairs whose distance is the bound but for the rounding of their coordinates to
// doubles.
class Tie_watch
{
public:
  Tie_watch(const Scene& scene, const Options& options);

  // Those that are at exactly the bound count as well.
  void add_found(std::size_t i, std::size_t j, const Offset& offset);

  // Of a pair that is beyond the bound. An open bound has none of these with --decimal, either.
  void add_lost(std::size_t i, std::size_t j, const Offset& offset);

  // How many of the pairs that were found only rounding keeps from being at exactly the bound,
  // where some are.
  std::size_t found(std::size_t exact_ties) const { return found_ - std::min(found_, exact_ties); }
  std::size_t lost() const { return lost_; }

private:
  bool is_tie(std::size_t i, std::size_t j, const Offset& offset) const;

  const Scene& scene_;
  double reach_;
  bool is_open_;
  bool is_on_; // whether --decimal could see other ties
  std::size_t found_ = 0, lost_ = 0;
};

// Prints a line for each hint about degrees.
void print_degree_hints(std::ostream& out, const Options& options, bool has_degrees);

// Prints a line for each hint. With --closest, the options have the distance that was found. Of
// ties that rounding moved to one of the sides of the bound, some were found, and some lost.
void print_hints(std::ostream& out, const Scene& scene, const Options& options,
                 std::size_t found_ties, std::size_t lost_ties);

} // namespace near_pairs

#endif // NEAR_PAIRS_HINTS_H
