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

// A thread that asks locks some of the positions until the value is there. To make it, functions of
// the user may be called, which may use oneTBB. So the thread takes no other task meanwhile: that
// could ask for one of these positions, and the thread would wait for itself.
template <class Value>
class Values_on_demand
{
public:
  Values_on_demand(std::size_t size, const Threads& threads)
    : threads_(threads), values_(size)
  {}

  // Returns the value of a position, which make() makes.
  template <class Make>
  const Value& get(std::size_t position, const Make& make) const
  {
    std::unique_lock<std::mutex> lock(mutexes_[position % mutexes_.size()], std::defer_lock);
    if(threads_.are_many())
      lock.lock();
    std::unique_ptr<const Value>& value = values_[position];
    if(!value)
      threads_.run_isolated([&] { value = std::make_unique<const Value>(make()); });
    return *value;
  }

private:
  const Threads threads_;
  mutable std::array<std::mutex, 256> mutexes_;
  mutable std::vector<std::unique_ptr<const Value>> values_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_VALUES_ON_DEMAND_H
