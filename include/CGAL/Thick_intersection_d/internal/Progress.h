// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PROGRESS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PROGRESS_H

// Tells the user's functor bool(double) how much of the scene is done; it may cancel.

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// For searches that nobody watches.
struct No_progress
{
  bool advance(std::size_t) { return true; }
};

// Calls the functor about a thousand times, one call at a time, with growing values up to 1.
template <class Functor>
class Progress
{
public:
  Progress(const Functor& functor, std::size_t total)
    : functor_(functor), total_(total), step_((std::max)(total / 1000, std::size_t(1)))
  {}

  // Counts `finished` more objects as done; returns false iff the functor says to cancel.
  bool advance(std::size_t finished)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += finished;
    if(done_ < next_ && done_ < total_)
      return !cancelled_;
    next_ = done_ + step_;
    cancelled_ = !functor_(static_cast<double>(done_) / static_cast<double>(total_)) || cancelled_;
    return !cancelled_;
  }

private:
  Functor functor_;
  std::size_t total_;
  std::size_t step_;
  std::size_t done_ = 0;
  std::size_t next_ = 0;
  bool cancelled_ = false;
  std::mutex mutex_;
};

// Returns the progress that the named parameter `callback` asks for.
template <class NamedParameters>
auto make_progress(const NamedParameters& np, std::size_t total)
{
  if constexpr(parameters::is_default_parameter<NamedParameters,
                                                internal_np::callback_t>::value)
    return No_progress();
  else {
    const auto& functor = parameters::get_parameter(np, internal_np::callback);
    return Progress<std::decay_t<decltype(functor)>>(functor, total);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PROGRESS_H
