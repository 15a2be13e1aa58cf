// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_THICK_INTERSECTION_D_COMPILED
#include "five_calls.cpp"
