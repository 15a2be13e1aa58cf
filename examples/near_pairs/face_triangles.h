// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Faces of files, which may have any number of corners, to triangles.

#ifndef NEAR_PAIRS_FACE_TRIANGLES_H
#define NEAR_PAIRS_FACE_TRIANGLES_H

#include <array>
#include <cstddef>
#include <vector>

namespace near_pairs {

using Corners = std::vector<std::array<double, 3>>; // of a face, in order

// Whether all corners are in a plane, exactly.
bool are_in_plane(const Corners& corners);

// Cuts a face of three or more corners along diagonals, and returns the positions of the corners of
// each triangle. Each edge of the face is one of a triangle, and each diagonal one of two, so that
// closed faces stay so. A face in a plane that does not cross itself is the union of its triangles.
// Returns an empty list if a face in a plane has no diagonals inside, because it crosses itself.
std::vector<std::array<std::size_t, 3>> triangles_of(const Corners& corners);

} // namespace near_pairs

#endif // NEAR_PAIRS_FACE_TRIANGLES_H
