// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search by boxes in the library that programs link if they define
// CGAL_THICK_INTERSECTION_D_COMPILED, for all objects.

#include <CGAL/Thick_intersection_d/internal/boxes/box_search.inc>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template bool search_boxes(Box_client<2>&, const Threads&);
template bool search_boxes(Box_client<3>&, const Threads&);
template bool search_boxes(Box_client<4>&, const Threads&);
template bool search_boxes(Box_client<5>&, const Threads&);
template bool search_boxes(Box_client<6>&, const Threads&);
template bool search_boxes(Box_client<7>&, const Threads&);
template bool search_boxes(Box_client<8>&, const Threads&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
