// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the error says that a call throws.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_ERROR_MESSAGES_H
#define THICK_INTERSECTION_TEST_SUPPORT_ERROR_MESSAGES_H

#include "standard_library.h"

namespace test_support {

// Returns nothing if the call throws no error. An error of another type is passed on.
template <class Error = std::invalid_argument, class Call>
std::string error_message(const Call& call)
{
  try {
    call();
  }
  catch(const Error& error) {
    return error.what();
  }
  return "";
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_ERROR_MESSAGES_H
