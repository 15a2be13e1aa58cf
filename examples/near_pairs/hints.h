// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the user may want to be told besides the answer, because another option may have been meant.

#ifndef NEAR_PAIRS_HINTS_H
#define NEAR_PAIRS_HINTS_H

#include "options.h"
#include "scene.h"

#include <cstddef>
#include <ostream>

namespace near_pairs {

// Counts the pairs whose distance is the bound but for the rounding of their coordinates to
// doubles. Those that are at exactly the bound count as well.
class Tie_watch
{
public:
  Tie_watch(const Scene& scene, const Options& options);

  void add_pair(std::size_t i, std::size_t j, const Offset& offset);

  // How many of the pairs only rounding keeps from being at exactly the bound, where some are.
  std::size_t rounded(std::size_t exact_ties) const { return is_on_ ? count_ - exact_ties : 0; }

private:
  const Scene& scene_;
  double reach_;
  bool is_on_; // whether --decimal could see other ties
  std::size_t count_ = 0;
};

// Prints a line for each hint. `rounded_ties` are the pairs that only rounding keeps from being at
// the bound.
void print_hints(std::ostream& out, const Scene& scene, const Options& options,
                 std::size_t rounded_ties);

} // namespace near_pairs

#endif // NEAR_PAIRS_HINTS_H
