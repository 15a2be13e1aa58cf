// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H

// What the user gives as callback: a functor of two positions, a functor of two elements, or an
// output iterator of pairs of either. Searches call functors of two positions.

#include <CGAL/Element_callback.h>

#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <cstddef>
#include <mutex>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Output, class A, class B, class = void>
struct Takes_pairs : std::false_type {};
template <class Output, class A, class B>
struct Takes_pairs<Output, A, B,
                   std::void_t<decltype(*std::declval<Output&>()++
                                        = std::declval<std::pair<std::decay_t<A>,
                                                                 std::decay_t<B>>>())>>
  : std::true_type {};

// What takes the pairs of elements of `First` and `Second`, and as what.
template <class Callback, class First, class Second>
struct Pair_target
{
  static constexpr bool takes_elements = false;
  using A = std::size_t;
  using B = std::size_t;
  using type = Callback;
};
template <class Callback, class First, class Second>
struct Pair_target<Element_callback<Callback>, First, Second>
{
  static constexpr bool takes_elements = true;
  using A = decltype(std::declval<const First&>().element(0));
  using B = decltype(std::declval<const Second&>().element(0));
  using type = std::remove_reference_t<Callback>;
};
template <class Callback, class First, class Second>
struct Pair_target<const Element_callback<Callback>, First, Second>
  : Pair_target<Element_callback<Callback>, First, Second>
{
  using type = std::remove_reference_t<std::add_const_t<Callback>>;
};

template <class Result>
inline constexpr bool is_void_or_bool
  = std::is_void_v<Result> || std::is_same_v<std::decay_t<Result>, bool>;

// Returns whether a callback takes the pairs of elements of `First` and `Second`. Explains to the
// compiler's user why not.
template <class Callback, class First, class Second>
constexpr bool check_callback()
{
  using Target = Pair_target<Callback, First, Second>;
  using A = typename Target::A;
  using B = typename Target::B;
  if constexpr(std::is_invocable_v<typename Target::type&, A, B>) {
    using Result = std::invoke_result_t<typename Target::type&, A, B>;
    static_assert(is_void_or_bool<Result>,
                  "The callback must return void, or bool to tell whether the search goes on.");
    return is_void_or_bool<Result>;
  }
  else {
    constexpr bool takes_pairs = Takes_pairs<typename Target::type, A, B>::value;
    static_assert(takes_pairs || Target::takes_elements,
                  "The callback must take two positions (std::size_t i, std::size_t j). For one "
                  "that takes two elements of the range, pass CGAL::with_elements(callback).");
    static_assert(takes_pairs || !Target::takes_elements,
                  "The callback in with_elements() must take two elements of the range.");
    return takes_pairs;
  }
}

// Hands the pairs of positions in two ranges to a functor of elements or to an output iterator.
template <class ConcurrencyTag, class Target, class First, class Second>
class Pair_output
{
  using A = typename Target::A;
  using B = typename Target::B;

public:
  Pair_output(const First& first, const Second& second, typename Target::type& target)
    : first_(first), second_(second), target_(target)
  {}

  auto operator()(std::size_t i, std::size_t j)
  {
    if constexpr(Target::takes_elements)
      return put(first_.element(i), second_.element(j));
    else
      return put(i, j);
  }

private:
  // Functors take pairs from several threads, output iterators from one thread at a time.
  auto put(A a, B b)
  {
    if constexpr(std::is_invocable_v<typename Target::type&, A, B>)
      return target_(std::forward<A>(a), std::forward<B>(b));
    else if constexpr(is_parallel_v<ConcurrencyTag>) {
      const std::lock_guard<std::mutex> lock(mutex_);
      write(a, b);
    }
    else
      write(a, b);
  }

  void write(const A& a, const B& b)
  {
    *target_++ = std::pair<std::decay_t<A>, std::decay_t<B>>(a, b);
  }

  const First& first_;
  const Second& second_;
  typename Target::type& target_;
  std::mutex mutex_;
};

// Returns a functor of two positions in two ranges: `callback` itself, if it is one. To be called
// if check_callback() has returned true.
template <class ConcurrencyTag, class First, class Second, class Callback>
decltype(auto) pair_output(const First& first, const Second& second, Callback& callback)
{
  using Target = Pair_target<Callback, First, Second>;
  using Output = Pair_output<ConcurrencyTag, Target, First, Second>;
  if constexpr(Target::takes_elements)
    return Output(first, second, callback.callback());
  else if constexpr(!std::is_invocable_v<Callback&, std::size_t, std::size_t>)
    return Output(first, second, callback);
  else
    return (callback);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H
