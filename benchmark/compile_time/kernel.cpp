// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The kernel alone: what all other files are compared with.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

int main()
{
  const CGAL::Epick::Point_2 point(0, 0);
  return point.x() == 0 ? 0 : 1;
}
