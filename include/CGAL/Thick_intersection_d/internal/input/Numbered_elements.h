// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H

// The elements of the user's range or ranges by their positions. The input is neither copied nor
// reordered. A range gets a table of its iterators if these have no random access, or if they hold
// their elements.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <CGAL/Thick_intersection_d/internal/input/iterators.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The identity, for ranges whose elements are the objects themselves.
struct No_map {};

// Iterates over elements in a range-based for loop.
template <class Elements>
class Element_iterator
{
public:
  Element_iterator(const Elements& elements, std::size_t position)
    : elements_(elements), position_(position)
  {}
  decltype(auto) operator*() const { return elements_[position_]; }
  Element_iterator& operator++()
  {
    ++position_;
    return *this;
  }
  bool operator!=(const Element_iterator& other) const { return position_ != other.position_; }

private:
  const Elements& elements_;
  std::size_t position_;
};

template <class Range, class Map = No_map>
class Numbered_elements
{
  using Readable = Read_range<Range>;
  using Iterator = Iterator_of<Readable>;
  using Reference = Reference_of<Iterator>;

  static decltype(auto) mapped(Reference element, const Map& map)
  {
    if constexpr(std::is_same_v<Map, No_map>)
      return static_cast<Reference>(element);
    else if constexpr(std::is_reference_v<Reference>)
      return get(map, element);
    else // a reference into a temporary would dangle
      return std::decay_t<decltype(get(map, element))>(get(map, element));
  }

public:
  using value_type = std::decay_t<decltype(mapped(std::declval<Reference>(),
                                                  std::declval<const Map&>()))>;

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

  std::size_t size() const { return size_; }
  Element_iterator<Numbered_elements> begin() const { return {*this, 0}; }
  Element_iterator<Numbered_elements> end() const { return {*this, size_}; }

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

// The elements of two ranges in one numbering. The first range comes first.
template <class First, class Second>
class Joined_elements
{
public:
  using value_type = typename First::value_type;
  static_assert(std::is_same_v<value_type, typename Second::value_type>,
                "The two ranges hold objects of different types.");

  Joined_elements(const First& first, const Second& second) : first_(first), second_(second) {}

  const First& first() const { return first_; }
  const Second& second() const { return second_; }

  std::size_t size() const { return first_.size() + second_.size(); }
  Element_iterator<Joined_elements> begin() const { return {*this, 0}; }
  Element_iterator<Joined_elements> end() const { return {*this, size()}; }

  decltype(auto) operator[](std::size_t position) const
  {
    return position < first_.size() ? first_[position] : second_[position - first_.size()];
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

// Returns task(elements, first_size) for the elements of two ranges in one numbering, and the
// number of elements of the first range.
template <class RangeA, class RangeB, class NamedParameters, class Task>
auto with_two_ranges(RangeA& range_a, RangeB& range_b, const NamedParameters& np, const Task& task)
{
  const auto elements_a = make_elements(range_a, np);
  const auto elements_b = make_elements(range_b, np);
  return task(Joined_elements(elements_a, elements_b), elements_a.size());
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
