// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The instruction sets of the processor, and one of them for as long as an object lives.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_INSTRUCTION_SETS_H
#define THICK_INTERSECTION_TEST_SUPPORT_INSTRUCTION_SETS_H

#include "unit_test.h"

#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_plain.h>
#include <CGAL/Thick_intersection_d/internal/lanes/with_lanes.h>

namespace test_support {

// The best one first.
inline std::vector<CGAL::Thick_intersection_d::internal::Instruction_set> instruction_sets()
{
  using CGAL::Thick_intersection_d::internal::Instruction_set;
  const Instruction_set best = CGAL::Thick_intersection_d::internal::best_instruction_set();
  if(best == Instruction_set::AVX512)
    return {best, Instruction_set::AVX2, Instruction_set::SSE2};
  if(best == Instruction_set::AVX2)
    return {best, Instruction_set::SSE2};
  return {best};
}

class Forced_instruction_set
{
public:
  explicit Forced_instruction_set(CGAL::Thick_intersection_d::internal::Instruction_set set)
  {
    CGAL::Thick_intersection_d::internal::instruction_set() = set;
  }
  ~Forced_instruction_set()
  {
    CGAL::Thick_intersection_d::internal::instruction_set()
      = CGAL::Thick_intersection_d::internal::best_instruction_set();
  }
  Forced_instruction_set(const Forced_instruction_set&) = delete;
  Forced_instruction_set& operator=(const Forced_instruction_set&) = delete;
};

// Calls task(lanes) for the plain lanes, and for each instruction set of the processor.
template <class Task>
void with_all_lanes(const Task& task)
{
  task(internal::lanes_plain::Lanes());
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    BOOST_TEST_CONTEXT("instruction set " << static_cast<int>(set)) { internal::with_lanes(task); }
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_INSTRUCTION_SETS_H
