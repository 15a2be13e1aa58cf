// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rounding modes of a processor, and one of them for as long as an object lives.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_ROUNDING_MODE_H
#define THICK_INTERSECTION_TEST_SUPPORT_ROUNDING_MODE_H

#include "standard_library.h"

namespace test_support {

constexpr int rounding_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

class Rounding_mode
{
public:
  explicit Rounding_mode(int mode) { std::fesetround(mode); }
  ~Rounding_mode() { std::fesetround(FE_TONEAREST); }
  Rounding_mode(const Rounding_mode&) = delete;
  Rounding_mode& operator=(const Rounding_mode&) = delete;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_ROUNDING_MODE_H
