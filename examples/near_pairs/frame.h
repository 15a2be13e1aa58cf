// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which part of a file was read, if the file has several frames, as of a molecule that moves, or
// several models of it.

#ifndef NEAR_PAIRS_FRAME_H
#define NEAR_PAIRS_FRAME_H

#include <cstddef>

namespace near_pairs {

struct Frame
{
  std::size_t number = 1; // from 1
  std::size_t count = 1;  // in the file
};

} // namespace near_pairs

#endif // NEAR_PAIRS_FRAME_H
