// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_OUTPUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_OUTPUT_H

// Hands pairs of positions, with the offset of the second point, to what the user passed: a functor
// of positions or of elements, or an output iterator.

#include <CGAL/Element_callback.h>

#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>

#include <cstddef>
#include <mutex>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Output, class Triple, class = void>
struct Takes_triples : std::false_type {};
template <class Output, class Triple>
struct Takes_triples<Output, Triple,
                     std::void_t<decltype(*std::declval<Output&>()++ = std::declval<Triple>())>>
  : std::true_type {};

template <class ConcurrencyTag, class OffsetArray, class Target, class First, class Second>
class Image_output
{
  using A = typename Target::A;
  using B = typename Target::B;
  using Triple = std::tuple<std::decay_t<A>, std::decay_t<B>, OffsetArray>;
  static constexpr bool is_functor
    = std::is_invocable_v<typename Target::type&, A, B, const OffsetArray&>;

public:
  // Whether the target takes what it gets. Explains to the compiler's user what is wrong if not.
  static constexpr bool check()
  {
    constexpr bool takes = is_functor || Takes_triples<typename Target::type, Triple>::value;
    static_assert(takes, "The callback must take two positions and an offset: (std::size_t i, "
                         "std::size_t j, std::array<int, d> offset); or, in CGAL::with_elements(), "
                         "two elements and an offset.");
    if constexpr(is_functor) {
      constexpr bool tells = is_void_or_bool<
        std::invoke_result_t<typename Target::type&, A, B, const OffsetArray&>>;
      static_assert(tells, "The callback must return void, or bool to tell whether the search "
                           "goes on.");
      return tells;
    }
    else
      return takes;
  }

  Image_output(const First& first, const Second& second, typename Target::type& target)
    : first_(first), second_(second), target_(target)
  {}

  auto operator()(std::size_t i, std::size_t j, const OffsetArray& offset)
  {
    if constexpr(Target::takes_elements)
      return put(first_.element(i), second_.element(j), offset);
    else
      return put(i, j, offset);
  }

private:
  // Functors take pairs from several threads, output iterators from one thread at a time.
  auto put(A a, B b, const OffsetArray& offset)
  {
    if constexpr(is_functor)
      return target_(std::forward<A>(a), std::forward<B>(b), offset);
    else if constexpr(is_parallel_v<ConcurrencyTag>) {
      const std::lock_guard<std::mutex> lock(mutex_);
      *target_++ = Triple(a, b, offset);
    }
    else
      *target_++ = Triple(a, b, offset);
  }

  const First& first_;
  const Second& second_;
  typename Target::type& target_;
  std::mutex mutex_;
};

// Returns a functor of positions in two ranges and an offset.
template <class ConcurrencyTag, class OffsetArray, class First, class Second, class Callback>
auto image_output(const First& first, const Second& second, Callback& callback)
{
  using Target = Pair_target<Callback, First, Second>;
  using Output = Image_output<ConcurrencyTag, OffsetArray, Target, First, Second>;
  if constexpr(Target::takes_elements)
    return Output(first, second, callback.callback());
  else
    return Output(first, second, callback);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_IMAGE_OUTPUT_H
