// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PROGRESS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PROGRESS_H

// Calls the user's functor bool(double) with the fraction of the work that is done. The functor may
// cancel the search.

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The progress of a search without a functor.
struct Unwatched_progress
{
  void restart(std::size_t) {}
  bool advance(std::size_t) { return true; }
  bool is_cancelled() const { return false; }
  void finish() {}
};

// Calls the functor about a thousand times, one call at a time, with growing values up to 1. No
// lock is held in a call. The functor may search in parallel itself. Then the thread that calls it
// may take another task of this search, which advances, before the call returns.
template <class Functor>
class Watched_progress
{
public:
  Watched_progress(const Functor& functor, std::size_t total) : functor_(functor), total_(total) {}

  // Begins another part of the search. Its `total` objects share the progress that is left.
  void restart(std::size_t total)
  {
    start_ = share_done();
    total_ = total;
    done_ = 0;
  }

  // Counts `finished` more objects as done. Returns false iff the functor has cancelled the search.
  bool advance(std::size_t finished)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    done_ += finished;
    while(!is_telling_ && !cancelled_ && is_news(share_done())) // again if others have advanced
      tell(share_done(), lock);
    return !cancelled_;
  }

  bool is_cancelled()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return cancelled_;
  }

  // Calls the functor with 1, unless this was done before.
  void finish()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    if(last_ < 1 && !cancelled_)
      tell(1, lock);
  }

private:
  static constexpr double step = 0.001;

  double share_done() const
  {
    if(done_ >= total_)
      return 1;
    return start_ + (1 - start_) * (static_cast<double>(done_) / static_cast<double>(total_));
  }

  bool is_news(double value) const { return value >= last_ + step || (value == 1 && last_ < 1); }

  // A functor that has cancelled the search is not called again. One that throws is not, either: it
  // leaves is_telling_ behind.
  void tell(double value, std::unique_lock<std::mutex>& lock)
  {
    last_ = value;
    is_telling_ = true;
    lock.unlock();
    const bool goes_on = functor_(value);
    lock.lock();
    is_telling_ = false;
    cancelled_ = !goes_on;
  }

  Functor functor_;
  std::size_t total_;    // of this part of the search
  std::size_t done_ = 0;
  double start_ = 0;     // the fraction that was done before this part
  double last_ = -step;  // the last value that the functor got
  bool is_telling_ = false;
  bool cancelled_ = false;
  std::mutex mutex_;
};

// Returns the progress that the named parameter `callback` asks for.
template <class NamedParameters>
auto make_progress(const NamedParameters& np, std::size_t total)
{
  if constexpr(parameters::is_default_parameter<NamedParameters,
                                                internal_np::callback_t>::value)
    return Unwatched_progress();
  else {
    const auto& functor = parameters::get_parameter(np, internal_np::callback);
    return Watched_progress<std::decay_t<decltype(functor)>>(functor, total);
  }
}

// Tells the functor of a search how far one part of the search is.
template <class Functor>
struct Part_of_progress
{
  Functor functor;
  double start;
  double end;
  bool* is_cancelled; // null, or becomes true if the functor cancels the part

  bool operator()(double done)
  {
    const bool goes_on = functor(done == 1 ? end : start + (end - start) * done); // not rounded
    if(is_cancelled != nullptr && !goes_on)
      *is_cancelled = true;
    return goes_on;
  }
};

// A functor that its copies share: what it keeps, it keeps from one part of a search to the next.
template <class Functor>
struct Shared_functor
{
  std::shared_ptr<Functor> functor;

  bool operator()(double done) { return (*functor)(done); }
};

// Returns the named parameters of a search whose parts call one functor.
template <class NamedParameters>
auto parameters_for_parts([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::callback_t>::value)
    return parameters::default_values();
  else {
    const auto& functor = parameters::get_parameter(np, internal_np::callback);
    using Functor = std::decay_t<decltype(functor)>;
    return parameters::callback(Shared_functor<Functor>{std::make_shared<Functor>(functor)});
  }
}

// Returns the named parameters of a part of a search, from those for parts.
template <class NamedParameters>
auto parameters_of_part([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] double start,
                        [[maybe_unused]] double end,
                        [[maybe_unused]] bool* is_cancelled = nullptr)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::callback_t>::value)
    return parameters::default_values();
  else {
    const auto& functor = parameters::get_parameter(np, internal_np::callback);
    using Part = Part_of_progress<std::decay_t<decltype(functor)>>;
    return parameters::callback(Part{functor, start, end, is_cancelled});
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PROGRESS_H
