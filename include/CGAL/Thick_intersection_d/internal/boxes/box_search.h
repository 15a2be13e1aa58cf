// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SEARCH_H

// The search by boxes, as those see it who know the types of the user.
//
// A program compiles it, unless it defines CGAL_THICK_INTERSECTION_D_COMPILED. Then it links the
// library that has src/boxes.cpp.

#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#ifndef CGAL_THICK_INTERSECTION_D_COMPILED
#include <CGAL/Thick_intersection_d/internal/boxes/box_search.inc>
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Gives the pairs of boxes that meet to the client. Returns false iff the search was stopped.
template <int Axes>
bool search_boxes(Box_client<Axes>& client, const Threads& threads);

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template bool search_boxes(Box_client<2>&, const Threads&);
extern template bool search_boxes(Box_client<3>&, const Threads&);
extern template bool search_boxes(Box_client<4>&, const Threads&);
extern template bool search_boxes(Box_client<5>&, const Threads&);
extern template bool search_boxes(Box_client<6>&, const Threads&);
extern template bool search_boxes(Box_client<7>&, const Threads&);
extern template bool search_boxes(Box_client<8>&, const Threads&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SEARCH_H
