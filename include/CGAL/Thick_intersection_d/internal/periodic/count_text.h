// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_COUNT_TEXT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_COUNT_TEXT_H

// A count that may be too large for an integer, in the words of a message.

#include <ios>
#include <sstream>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

inline std::string count_text(double count)
{
  std::ostringstream text;
  if(count < 0x1p53)
    text << std::fixed;
  text.precision(count < 0x1p53 ? 0 : 3);
  text << count;
  return text.str();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_COUNT_TEXT_H
