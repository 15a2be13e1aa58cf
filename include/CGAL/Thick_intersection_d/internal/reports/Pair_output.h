// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H

// What the user gives as callback: a functor of two positions, a functor of two elements, or an
// output iterator of pairs of either. Searches call functors of two positions. Pairs of a domain
// that repeats come with an offset.

#include <CGAL/Element_callback.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <cstddef>
#include <mutex>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Output, class Value, class = void>
struct Takes_values : std::false_type {};
template <class Output, class Value>
struct Takes_values<Output, Value,
                    std::void_t<decltype(*std::declval<Output&>()++ = std::declval<Value>())>>
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

// Hands the pairs of positions in two ranges to a functor of elements or to an output iterator.
// With each pair comes a value of each of the types `More`.
template <class Target, class First, class Second, class... More>
class Pair_output
{
  using A = typename Target::A;
  using B = typename Target::B;
  using Functor = typename Target::type;
  using Pair = std::pair<std::decay_t<A>, std::decay_t<B>>;
  using Value = std::conditional_t<sizeof...(More) == 0, Pair,
                                   std::tuple<std::decay_t<A>, std::decay_t<B>, More...>>;
  static constexpr bool is_functor = std::is_invocable_v<Functor&, A, B, const More&...>;

public:
  Pair_output(const First& first, const Second& second, Functor& target, const Threads& threads)
    : first_(first), second_(second), target_(target), are_threads_many_(threads.are_many())
  {}

  auto operator()(std::size_t i, std::size_t j, const More&... more)
  {
    if constexpr(Target::takes_elements)
      return put(first_.element(i), second_.element(j), more...);
    else
      return put(i, j, more...);
  }

  // Returns whether the target takes the pairs. Explains to the compiler's user why not.
  static constexpr bool check()
  {
    if constexpr(is_functor) {
      constexpr bool tells
        = is_void_or_bool<std::invoke_result_t<Functor&, A, B, const More&...>>;
      static_assert(tells, "The callback must return void, or bool to tell whether the search "
                           "goes on.");
      return tells;
    }
    else {
      constexpr bool takes = Takes_values<Functor, Value>::value;
      constexpr bool is_pair = sizeof...(More) == 0;
      static_assert(takes || !is_pair || Target::takes_elements,
                    "The callback must take two positions (std::size_t i, std::size_t j). For one "
                    "that takes two elements of the range, pass CGAL::with_elements(callback).");
      static_assert(takes || !is_pair || !Target::takes_elements,
                    "The callback in with_elements() must take two elements of the range.");
      static_assert(takes || is_pair,
                    "The callback must take two positions and an offset: (std::size_t i, "
                    "std::size_t j, std::array<int, d> offset); or, in CGAL::with_elements(), "
                    "two elements and an offset.");
      return takes;
    }
  }

private:
  // Functors take pairs from several threads, output iterators from one thread at a time.
  auto put(A a, B b, const More&... more)
  {
    if constexpr(is_functor)
      return target_(std::forward<A>(a), std::forward<B>(b), more...);
    else {
      std::unique_lock<std::mutex> lock(mutex_, std::defer_lock);
      if(are_threads_many_)
        lock.lock();
      *target_++ = Value(a, b, more...);
    }
  }

  const First& first_;
  const Second& second_;
  Functor& target_;
  const bool are_threads_many_;
  std::mutex mutex_;
};

// Returns whether a callback takes the pairs of elements of `First` and `Second`, and `More`.
template <class Callback, class First, class Second, class... More>
constexpr bool check_callback()
{
  using Target = Pair_target<Callback, First, Second>;
  return Pair_output<Target, First, Second, More...>::check();
}

// Returns a functor of two positions in two ranges, and of `More`: `callback` itself, if it is one.
// To be called if check_callback() has returned true.
template <class... More, class First, class Second, class Callback>
decltype(auto) pair_output(const First& first, const Second& second, Callback& callback,
                           const Threads& threads)
{
  using Target = Pair_target<Callback, First, Second>;
  using Output = Pair_output<Target, First, Second, More...>;
  if constexpr(Target::takes_elements)
    return Output(first, second, callback.callback(), threads);
  else if constexpr(!std::is_invocable_v<Callback&, std::size_t, std::size_t, const More&...>)
    return Output(first, second, callback, threads);
  else
    return (callback);
}

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

// Returns a functor that calls callback(i, j), and returns whether the search goes on.
template <class Callback>
auto reporter_of(Callback& callback)
{
  return [&callback](std::size_t i, std::size_t j) { return goes_on_after(callback, i, j); };
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_OUTPUT_H
