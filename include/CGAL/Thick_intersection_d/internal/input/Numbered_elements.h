// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H

// The elements of the user's range or ranges by their positions. The input is neither copied nor
// reordered. A range gets a table of its iterators if these have no random access, or if they hold
// their elements.

#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/input/kinds.h>

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

// Whether the objects of a range are meant without their boundaries: `CGAL/interiors.h`.
template <class Range>
inline constexpr bool are_interiors_v = false;

// Iterators of C++20 that make their elements have a concept. Others that make them have no random
// access, whatever their category says: those over a `Surface_mesh` of CGAL 6 advance step by step
// after removals.
template <class Iterator, class = void>
struct Traversal
{
  using type = std::conditional_t<std::is_reference_v<Reference_of<Iterator>>,
                                  typename std::iterator_traits<Iterator>::iterator_category,
                                  std::input_iterator_tag>;
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

// Whether an iterator refers to an element that it holds itself, and that is gone with it. Those
// over a `Surface_mesh` of CGAL 5 are such, and they advance step by step after removals as well.
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

// The identity, for ranges whose elements are the objects themselves.
struct No_map {};

// Returns an element as a map sees it. Without a map, get() is not looked for: that of meshes would
// be found, which does not compile.
template <class Map, class Element>
decltype(auto) look_up([[maybe_unused]] const Map& map, Element&& element)
{
  if constexpr(std::is_same_v<Map, No_map>)
    return std::forward<Element>(element);
  else
    return get(map, std::forward<Element>(element));
}

template <class Range, class Map = No_map>
class Numbered_elements
{
  using Readable = Read_range<Range>;
  using Iterator = Iterator_of<Readable>;
  using Reference = Reference_of<Iterator>;

  static decltype(auto) mapped(Reference element, const Map& map)
  {
    if constexpr(std::is_reference_v<Reference>)
      return look_up(map, static_cast<Reference>(element));
    else // a reference into a temporary would dangle
      return std::decay_t<decltype(look_up(map, element))>(look_up(map, element));
  }

public:
  using value_type = std::decay_t<decltype(mapped(std::declval<Reference>(),
                                                  std::declval<const Map&>()))>;
  static constexpr bool are_open = are_interiors_v<Range>;

  explicit Numbered_elements(Readable& range, const Map& map = Map())
    : first_(std::begin(range)), map_(map)
  {
    const auto last = std::end(range);
    if(has_random_access<Iterator> && !(first_ != last && holds_element(first_)))
      size_ = count_elements(first_, last);
    else {
      for(Iterator it = first_; it != last; ++it)
        table_.push_back(it);
      size_ = table_.size();
    }
  }

  // The elements of both sets, where a search of two sets has those of two ranges.
  const Numbered_elements& first() const { return *this; }
  const Numbered_elements& second() const { return *this; }

  std::size_t size() const { return size_; }

  // Returns an element of the range as the map sees it.
  decltype(auto) operator[](std::size_t position) const
  {
    return mapped(element(position), map_);
  }

  // Returns an element of the range itself.
  decltype(auto) element(std::size_t position) const
  {
    if constexpr(!has_random_access<Iterator>)
      return *table_[position];
    else {
      if constexpr(may_hold_element<Iterator>())
        if(!table_.empty())
          return *table_[position];
      return *(first_ + static_cast<std::ptrdiff_t>(position));
    }
  }

private:
  Iterator first_;
  std::vector<Iterator> table_; // empty if `first_` reaches all elements
  std::size_t size_;
  Map map_;
};

// The elements of two ranges in one numbering. The first range comes first. If the ranges hold
// objects of different types, or if those of one range are open, each is one of two.
template <class First, class Second>
class Joined_elements
{
  using A = decltype(std::declval<const First&>()[0]);
  using B = decltype(std::declval<const Second&>()[0]);
  static constexpr bool are_alike
    = std::is_same_v<typename First::value_type, typename Second::value_type>
      && First::are_open == Second::are_open;

public:
  using value_type
    = std::conditional_t<are_alike, typename First::value_type, One_of_two<A, B>>;

  Joined_elements(const First& first, const Second& second) : first_(first), second_(second) {}

  const First& first() const { return first_; }
  const Second& second() const { return second_; }

  std::size_t size() const { return first_.size() + second_.size(); }

  decltype(auto) operator[](std::size_t position) const
  {
    if constexpr(are_alike)
      return position < first_.size() ? first_[position] : second_[position - first_.size()];
    else if(position < first_.size())
      return value_type(std::in_place_index<0>, first_[position]);
    else
      return value_type(std::in_place_index<1>, second_[position - first_.size()]);
  }

private:
  const First& first_;
  const Second& second_;
};

// Whether a range comes with a map from its elements to points, as a `Point_set_3` does.
template <class Range, class = void>
struct Has_point_map : std::false_type {};
template <class Range>
struct Has_point_map<Range, std::void_t<decltype(get(std::declval<Range&>().point_map(),
                                                     *std::begin(std::declval<const Range&>())))>>
  : std::true_type {};

// Returns the map from the elements of `range` to points or objects: the point map of the named
// parameters, if there is one, or else the point map of the range.
template <class Range, class NamedParameters>
auto element_map(Range& range, const NamedParameters& np)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value)
    return parameters::get_parameter(np, internal_np::point_map);
  else if constexpr(Has_point_map<Range>::value)
    return range.point_map();
  else
    return No_map();
}

// Returns the elements of `range`, seen through its map.
template <class Range, class NamedParameters>
auto make_elements(Range& range, const NamedParameters& np)
{
  using Map = std::decay_t<decltype(element_map(range, np))>;
  return Numbered_elements<std::remove_const_t<Range>, Map>(range, element_map(range, np));
}

template <class Range, class NamedParameters>
using Elements_of
  = decltype(make_elements(std::declval<Range&>(), std::declval<const NamedParameters&>()));

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
