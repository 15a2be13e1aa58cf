// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_VALUES_ON_DEMAND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_VALUES_ON_DEMAND_H

// What positions have, made when it is first asked for: several threads ask at once.

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A thread that asks locks some of the positions until the value is there.
template <class Value>
class Values_on_demand
{
public:
  Values_on_demand(std::size_t size, const Threads& threads)
    : are_threads_many_(threads.are_many()), values_(size)
  {}

  // Returns the value of a position, which make() makes.
  template <class Make>
  const Value& get(std::size_t position, const Make& make) const
  {
    std::unique_lock<std::mutex> lock(mutexes_[position % mutexes_.size()], std::defer_lock);
    if(are_threads_many_)
      lock.lock();
    std::unique_ptr<const Value>& value = values_[position];
    if(!value)
      value = std::make_unique<const Value>(make());
    return *value;
  }

private:
  const bool are_threads_many_;
  mutable std::array<std::mutex, 256> mutexes_;
  mutable std::vector<std::unique_ptr<const Value>> values_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_VALUES_ON_DEMAND_H
