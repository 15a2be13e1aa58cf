// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The main function of all programs with Boost.Test.

#define BOOST_TEST_MODULE Thick_intersection_d
#include <boost/test/unit_test.hpp>
