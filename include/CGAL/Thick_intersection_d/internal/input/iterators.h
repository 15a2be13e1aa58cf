// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_ITERATORS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_ITERATORS_H

// How the iterators of the user's ranges reach their elements.

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Range` is const here if the range is.
template <class Range>
using Iterator_of = decltype(std::begin(std::declval<Range&>()));

template <class Iterator>
using Reference_of = decltype(*std::declval<const Iterator&>());

template <class Range, class = void>
struct Is_range : std::false_type {};
template <class Range>
struct Is_range<Range, std::void_t<Reference_of<Iterator_of<Range>>,
                                   decltype(++std::declval<Iterator_of<Range>&>()
                                            != std::end(std::declval<Range&>()))>>
  : std::is_copy_constructible<Iterator_of<Range>> {};

// The range as the package reads it: as const, unless only a range that is not const can be read,
// as with some views of C++20.
template <class Range>
using Read_range = std::conditional_t<Is_range<const Range>::value, const Range, Range>;

// Iterators of C++20 that make their elements have a concept above their category.
template <class Iterator, class = void>
struct Traversal
{
  using type = typename std::iterator_traits<Iterator>::iterator_category;
};
template <class Iterator>
struct Traversal<Iterator, std::void_t<typename Iterator::iterator_concept>>
{
  using type = typename Iterator::iterator_concept;
};

template <class Iterator>
inline constexpr bool has_random_access
  = std::is_base_of_v<std::random_access_iterator_tag, typename Traversal<Iterator>::type>;

template <class Iterator, class Sentinel, class = void>
struct Has_difference : std::false_type {};
template <class Iterator, class Sentinel>
struct Has_difference<Iterator, Sentinel,
                      std::void_t<decltype(std::declval<const Sentinel&>()
                                           - std::declval<const Iterator&>())>>
  : std::bool_constant<has_random_access<Iterator>> {};

// Returns the number of elements. The end of a range may have another type than its iterators, and
// be known only when it is reached.
template <class Iterator, class Sentinel>
std::size_t count_elements(Iterator first, const Sentinel& last)
{
  std::size_t size = 0;
  if constexpr(Has_difference<Iterator, Sentinel>::value)
    size = static_cast<std::size_t>(last - first);
  else
    for(; first != last; ++first)
      ++size;
  return size;
}

// Whether an iterator may refer to an element that it holds itself. Those of vectors do not.
template <class Iterator>
constexpr bool may_hold_element()
{
  if constexpr(!std::is_class_v<Iterator> || !std::is_lvalue_reference_v<Reference_of<Iterator>>)
    return false;
  else {
    using Vector = std::vector<std::decay_t<Reference_of<Iterator>>>;
    return !std::is_same_v<Iterator, typename Vector::iterator>
           && !std::is_same_v<Iterator, typename Vector::const_iterator>;
  }
}

// Whether an iterator refers to an element that it holds itself. The element is gone with the
// iterator. The iterators over a `Surface_mesh` are such, and after removals they advance step by
// step, though they have the category of random access.
template <class Iterator>
bool holds_element(const Iterator& iterator)
{
  if constexpr(may_hold_element<Iterator>()) {
    const void* const element = std::addressof(*iterator);
    const Iterator* const self = std::addressof(iterator);
    return !std::less<const void*>()(element, self) && std::less<const void*>()(element, self + 1);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_ITERATORS_H
