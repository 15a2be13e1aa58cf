// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where test/test_degree.cpp looks for it.

#include "../laboratory/degree_traits.h"
