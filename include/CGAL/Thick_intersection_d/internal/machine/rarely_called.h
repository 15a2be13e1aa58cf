// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_RARELY_CALLED_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_RARELY_CALLED_H

// Marks a function that a search calls a few times only. The compiler makes it short instead of
// fast, which takes less time: exact numbers that are expanded in each place compile slowly.

#ifdef __GNUC__
#define CGAL_THICK_INTERSECTION_D_RARELY_CALLED __attribute__((noinline, cold))
#else
#define CGAL_THICK_INTERSECTION_D_RARELY_CALLED
#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_RARELY_CALLED_H
