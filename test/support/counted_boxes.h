// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes that count what the box route looks at: those that are swept, and their candidates. What
// the tree looks at is not counted.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_COUNTED_BOXES_H
#define THICK_INTERSECTION_TEST_SUPPORT_COUNTED_BOXES_H

#include "number_boxes.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Found_pairs.h>

namespace test_support {

template <int Axes>
struct Counted_boxes : internal::Boxed_objects<Axes, Number_objects>
{
  using Base = internal::Boxed_objects<Axes, Number_objects>;
  using typename Base::Box;
  using typename Base::Run;
  using Base::Base;

  template <class Flush>
  void collect_between(const Run& a, const Run& b, internal::Found_pairs& found,
                       const Flush& flush) const
  {
    for(internal::Place i = a.first; i < a.last; ++i)
      candidates += a.ends[i] - a.begins[i];
    swept += a.last - a.first;
    Base::collect_between(a, b, found, flush);
  }

  mutable double candidates = 0;
  mutable double swept = 0;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_COUNTED_BOXES_H
