// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The wish to end a search early.

#ifndef NEAR_PAIRS_STOP_H
#define NEAR_PAIRS_STOP_H

#include <atomic>

namespace near_pairs {

// Set this, also from a signal handler, to end a search early: it then throws Error.
inline std::atomic<bool> stop_requested = false;

} // namespace near_pairs

#endif // NEAR_PAIRS_STOP_H
