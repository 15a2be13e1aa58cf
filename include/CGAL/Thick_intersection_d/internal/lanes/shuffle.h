// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_SHUFFLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_SHUFFLE_H

// A vector of the elements of two others: those with the given numbers, where the elements of the
// second one follow those of the first. GCC has had the function of Clang since version 12.

#if defined(__clang__) || __GNUC__ >= 12
#define CGAL_THICK_INTERSECTION_D_SHUFFLE(Vector, a, b, ...) \
  __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define CGAL_THICK_INTERSECTION_D_SHUFFLE(Vector, a, b, ...) \
  __builtin_shuffle(a, b, Vector{__VA_ARGS__})
#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_SHUFFLE_H
