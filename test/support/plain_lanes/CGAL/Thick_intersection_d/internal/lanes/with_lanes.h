// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Takes the place of a header of the library: the lanes that every processor has.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_WITH_LANES_H
#define THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_WITH_LANES_H

#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_plain.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Task>
void with_lanes(const Task& task)
{
  task(lanes_plain::Lanes());
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_WITH_LANES_H
