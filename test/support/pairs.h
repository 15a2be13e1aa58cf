// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of positions, and what to print when two lists of them differ. Lists are compared as
// multisets: a pair reported twice is as wrong as a pair not reported.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PAIRS_H
#define THICK_INTERSECTION_TEST_SUPPORT_PAIRS_H

#include "standard_library.h"

namespace test_support {

using Pair = std::pair<std::size_t, std::size_t>;
using Pairs = std::vector<Pair>;

// Collects what a search reports. One type of callback for many calls, because compilers make a
// search for each type.
struct Pair_collector
{
  Pairs& pairs;

  void operator()(std::size_t i, std::size_t j) const { pairs.emplace_back(i, j); }
};

// The same for pairs from several threads.
class Locked_collector
{
public:
  explicit Locked_collector(Pairs& pairs) : pairs_(pairs) {}

  void operator()(std::size_t i, std::size_t j)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    pairs_.emplace_back(i, j);
  }

private:
  Pairs& pairs_;
  std::mutex mutex_;
};

// The pairs that search(callback) reports, in their order.
template <class Search>
Pairs reported(const Search& search)
{
  Pairs pairs;
  search(Pair_collector{pairs});
  return pairs;
}

inline Pairs sorted(Pairs pairs)
{
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Returns the pairs i < j of a set, or the pairs (i, j - first_set_size) of two sets, for which
// is_pair(i, j) holds.
template <class Is_pair>
Pairs pairs_where(std::size_t size, std::optional<std::size_t> first_set_size,
                  const Is_pair& is_pair)
{
  Pairs pairs;
  for(std::size_t i = 0; i < first_set_size.value_or(size); ++i)
    for(std::size_t j = first_set_size.value_or(i + 1); j < size; ++j)
      if(is_pair(i, j))
        pairs.emplace_back(i, j - first_set_size.value_or(0));
  return pairs;
}

template <class Is_pair>
Pairs pairs_where(std::size_t size, const Is_pair& is_pair)
{
  return pairs_where(size, std::nullopt, is_pair);
}

// The first elements, and the others.
template <class T>
std::pair<std::vector<T>, std::vector<T>> split(const std::vector<T>& all, std::size_t first_size)
{
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(first_size);
  return {{all.begin(), middle}, {middle, all.end()}};
}

// Of the pairs of one set, those of one of the first elements and one of the others.
inline Pairs between_sets(const Pairs& pairs, std::size_t first_size)
{
  Pairs between;
  for(const Pair& p : pairs)
    if(p.first < first_size && p.second >= first_size)
      between.push_back(p);
  return between;
}

// The same in the numbers of two sets.
inline Pairs of_two_sets(const Pairs& pairs, std::size_t first_size)
{
  Pairs between = between_sets(pairs, first_size);
  for(Pair& p : between)
    p.second -= first_size;
  return between;
}

// Lists of neighbors have each pair in both orders.
inline Pairs in_both_orders(const Pairs& pairs)
{
  Pairs both = pairs;
  for(const Pair& p : pairs)
    both.emplace_back(p.second, p.first);
  return sorted(both);
}

// The pairs of all lists, in their order.
template <class Lists>
Pairs pairs_in_lists(const Lists& lists)
{
  Pairs pairs;
  for(std::size_t i = 0; i < lists.size(); ++i)
    for(const std::size_t j : lists[i])
      pairs.emplace_back(i, j);
  return pairs;
}

// What `found` lacks and what it has too much of; a pair found three times instead of once is
// listed twice as extra. Both lists are sorted.
struct Pairs_difference
{
  Pairs missing;
  Pairs extra;

  bool empty() const { return missing.empty() && extra.empty(); }
};

inline Pairs_difference compare(Pairs expected, Pairs found)
{
  expected = sorted(std::move(expected));
  found = sorted(std::move(found));
  Pairs_difference difference;
  std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                      std::back_inserter(difference.missing));
  std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(),
                      std::back_inserter(difference.extra));
  return difference;
}

inline void print_first(std::ostream& out, const char* label, const Pairs& pairs)
{
  const std::size_t shown = std::min<std::size_t>(pairs.size(), 10);
  out << pairs.size() << ' ' << label;
  for(std::size_t i = 0; i < shown; ++i)
    out << " (" << pairs[i].first << ", " << pairs[i].second << ')';
  if(shown < pairs.size())
    out << " ...";
}

inline std::ostream& operator<<(std::ostream& out, const Pairs_difference& difference)
{
  print_first(out, "missing", difference.missing);
  out << "; ";
  print_first(out, "extra", difference.extra);
  return out;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PAIRS_H
