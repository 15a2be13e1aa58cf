// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
#define CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H

// All pairs of points or objects within a distance, and lists of neighbors.

#include <CGAL/fixed_radius_near_points.h>
#include <CGAL/fixed_radius_neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/objects/near_objects_search.h>

#endif // CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
