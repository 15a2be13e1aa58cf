// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H

// Hands each pair to the user's callback, and remembers whether the callback stopped the search.

#include <atomic>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Calls callback(values...). Returns whether the search goes on: unless the callback returns false.
template <class Callback, class... Values>
bool goes_on_after(Callback& callback, const Values&... values)
{
  if constexpr(std::is_void_v<std::invoke_result_t<Callback&, const Values&...>>) {
    callback(values...);
    return true;
  }
  else
    return static_cast<bool>(callback(values...));
}

template <class Callback>
class Pair_reporter
{
public:
  explicit Pair_reporter(Callback& callback) : callback_(callback) {}

  // Calls callback(i, j). Returns false to stop the search. A callback that returns void
  // never stops the search. A callback that returns bool stops the search by false, and this thread
  // does not call it again. What a callback throws stops the other threads.
  bool operator()(std::size_t i, std::size_t j)
  {
    try {
      return call(i, j);
    }
    catch(...) {
      stop();
      throw;
    }
  }

  void stop() { stopped_.store(true, std::memory_order_relaxed); }
  bool is_stopped() const { return stopped_.load(std::memory_order_relaxed); }

private:
  bool call(std::size_t i, std::size_t j)
  {
    const bool goes_on = goes_on_after(callback_, i, j);
    if(!goes_on)
      stop();
    return goes_on;
  }

  Callback& callback_;
  std::atomic<bool> stopped_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_REPORTER_H
