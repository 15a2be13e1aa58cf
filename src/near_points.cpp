// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches for near points by slabs in the library that programs link if they define
// CGAL_THICK_INTERSECTION_D_COMPILED, for all kernels. The library does not depend on oneTBB: a
// program that has it hands its threads to the searches.

#include <CGAL/Thick_intersection_d/internal/slabs/near_search.inc>

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template class Narrow_scale<2>;
template bool search_near<2, double, true>(
  Near_points<2>&, const Near_task<2>&, Result_taker&);
template bool search_near<2, std::int32_t, true>(
  Near_points<2>&, const Near_task<2>&, Result_taker&);
template void collect_few_pairs<2>(
  const Run<2, double>&, const Run<2, double>*, const Near_question<double>&, Near_pairs&,
  const Flush&);
template class Narrow_scale<3>;
template bool search_near<3, double, true>(
  Near_points<3>&, const Near_task<3>&, Result_taker&);
template bool search_near<3, std::int32_t, true>(
  Near_points<3>&, const Near_task<3>&, Result_taker&);
template void collect_few_pairs<3>(
  const Run<3, double>&, const Run<3, double>*, const Near_question<double>&, Near_pairs&,
  const Flush&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
