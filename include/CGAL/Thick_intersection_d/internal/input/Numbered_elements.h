// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H

// The elements of the user's range or ranges by their positions. The input is neither copied nor
// reordered. A range without random access gets a table of iterators.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

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
  using Iterator = decltype(std::begin(std::declval<const Range&>()));
  using Reference = decltype(*std::declval<Iterator&>());
  static constexpr bool has_random_access
    = std::is_base_of_v<std::random_access_iterator_tag,
                        typename std::iterator_traits<Iterator>::iterator_category>;

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

  explicit Numbered_elements(const Range& range, const Map& map = Map()) : map_(map)
  {
    if constexpr(has_random_access) {
      table_ = std::begin(range);
      size_ = static_cast<std::size_t>(std::end(range) - std::begin(range));
    }
    else {
      for(Iterator it = std::begin(range); it != std::end(range); ++it)
        table_.push_back(it);
      size_ = table_.size();
    }
  }

  std::size_t size() const { return size_; }
  Element_iterator<Numbered_elements> begin() const { return {*this, 0}; }
  Element_iterator<Numbered_elements> end() const { return {*this, size_}; }

  decltype(auto) operator[](std::size_t position) const
  {
    if constexpr(has_random_access)
      return mapped(*(table_ + static_cast<std::ptrdiff_t>(position)), map_);
    else
      return mapped(*table_[position], map_);
  }

private:
  std::conditional_t<has_random_access, Iterator, std::vector<Iterator>> table_;
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

// Returns the elements of `range`. Applies the point map of the named parameters, if there is one.
template <class Range, class NamedParameters>
auto make_elements(const Range& range, const NamedParameters& np)
{
  using Map = typename internal_np::Lookup_named_param_def<internal_np::point_t, NamedParameters,
                                                           No_map>::type;
  return Numbered_elements<Range, Map>(
    range, parameters::choose_parameter<Map>(
             parameters::get_parameter(np, internal_np::point_map)));
}

// Returns task(elements, first_size) for the elements of two ranges in one numbering, and the
// number of elements of the first range.
template <class RangeA, class RangeB, class NamedParameters, class Task>
auto with_two_ranges(const RangeA& range_a, const RangeB& range_b, const NamedParameters& np,
                     const Task& task)
{
  const auto elements_a = make_elements(range_a, np);
  const auto elements_b = make_elements(range_b, np);
  return task(Joined_elements(elements_a, elements_b), elements_a.size());
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_NUMBERED_ELEMENTS_H
