// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_CALLBACK_TAKER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_CALLBACK_TAKER_H

// Hands the pairs that a search by slabs finds to a callback of positions in each set.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns what takes the pairs of this thread: the callback itself, unless its class has an
// overload of its own.
template <class Callback>
Callback& part_of_thread(Callback& callback)
{
  return callback;
}

// `Taker` is Result_taker, or List_taker.
template <class Sets, class Callback, class Taker = Result_taker>
class Callback_taker : public Taker
{
public:
  Callback_taker(const Sets& sets, Callback& callback)
    : callback_(callback), first_of_second_(sets.first_of_second())
  {}

  // The loop itself stores nothing. This makes short callbacks fast.
  bool take(const Found_pair* pairs, std::size_t count) override
  {
    auto&& callback = part_of_thread(callback_);
    const std::size_t second = first_of_second_;
    for(const Found_pair* const end = pairs + count; pairs != end; ++pairs)
      if(!goes_on_after(callback, std::size_t(pairs->i), std::size_t(pairs->j) - second))
        return false;
    return true;
  }

  bool take_row(Place i, Place first, Place last) override
  {
    const std::size_t second = first_of_second_;
    for(std::size_t j = first; j < last; ++j)
      if(!goes_on_after(callback_, std::size_t(i), j - second))
        return false;
    return true;
  }

protected:
  Callback& callback_;

private:
  const std::size_t first_of_second_;
};

// Returns what hands pairs to a callback, unless its class has an overload of its own.
template <class Sets, class Callback>
Callback_taker<Sets, Callback> taker_of(const Sets& sets, Callback& callback)
{
  return {sets, callback};
}

// Whether a callback takes the lists of the points of a set, instead of pairs.
template <class Sets, class Callback>
inline constexpr bool takes_lists_v
  = std::is_base_of_v<List_taker, decltype(taker_of(std::declval<const Sets&>(),
                                                    std::declval<Callback&>()))>;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_CALLBACK_TAKER_H
