// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A functor that several threads may call at once.

#ifndef NEAR_PAIRS_LOCKED_FUNCTOR_H
#define NEAR_PAIRS_LOCKED_FUNCTOR_H

#include <cstddef>
#include <functional>
#include <mutex>

namespace near_pairs {

// Receives each pair, and returns whether the search is to go on.
using Pair_functor = std::function<bool(std::size_t, std::size_t)>;

class Locked_functor
{
public:
  explicit Locked_functor(const Pair_functor& functor) : functor_(functor) {}

  bool operator()(std::size_t i, std::size_t j)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return functor_(i, j);
  }

private:
  const Pair_functor& functor_;
  std::mutex mutex_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_LOCKED_FUNCTOR_H
