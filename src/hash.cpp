// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The seed of all hash tables, in the library that programs link if they define
// CGAL_THICK_INTERSECTION_D_COMPILED.

#include <CGAL/Thick_intersection_d/internal/arrays/seed_of_process.inc>

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template std::uint64_t seed_of_process<std::uint64_t>();

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
