// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H

// The last station of a pair: hands it to the user's callback, and remembers if that said stop.

#include <atomic>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Callback>
class Pair_reporter
{
public:
  explicit Pair_reporter(Callback& callback) : callback_(callback) {}

  // Calls callback(i, j); returns false iff the search is to stop. A callback that returns void
  // never stops it; one that returns bool stops it by returning false, and is then not called again
  // by this thread.
  bool operator()(std::size_t i, std::size_t j)
  {
    if constexpr(std::is_void_v<std::invoke_result_t<Callback&, std::size_t, std::size_t>>) {
      callback_(i, j);
      return true;
    }
    else {
      const bool goes_on = static_cast<bool>(callback_(i, j));
      if(!goes_on)
        stop();
      return goes_on;
    }
  }

  void stop() { stopped_.store(true, std::memory_order_relaxed); }
  bool is_stopped() const { return stopped_.load(std::memory_order_relaxed); }

private:
  Callback& callback_;
  std::atomic<bool> stopped_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H
