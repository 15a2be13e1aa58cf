// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The headers of the standard library that the tests and what supports them use every day.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_STANDARD_LIBRARY_H
#define THICK_INTERSECTION_TEST_SUPPORT_STANDARD_LIBRARY_H

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#endif // THICK_INTERSECTION_TEST_SUPPORT_STANDARD_LIBRARY_H
