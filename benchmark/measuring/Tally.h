// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The callbacks of all measurements. One counts the pairs and combines their positions, so that the
// pairs cannot be left uncomputed, and two methods can be compared. Another one keeps the pairs.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_TALLY_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_TALLY_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <mutex>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace thick_benchmark {

struct Tally
{
  std::uint64_t pairs = 0;
  std::uint64_t positions = 0; // of the points of all pairs, combined by exclusive or

  void operator()(std::size_t i, std::size_t j)
  {
    ++pairs;
    positions ^= i ^ j;
  }
  // Of the neighbours of each point, those behind it make the pairs.
  void neighbour(std::size_t i, std::size_t j)
  {
    if(i < j)
      (*this)(i, j);
  }

  friend bool operator==(const Tally& a, const Tally& b)
  {
    return a.pairs == b.pairs && a.positions == b.positions;
  }
  friend bool operator!=(const Tally& a, const Tally& b) { return !(a == b); }
  friend std::ostream& operator<<(std::ostream& out, const Tally& tally)
  {
    return out << tally.pairs << " pairs (positions " << tally.positions << ")";
  }
};

// Throws unless they are equal.
inline void check_equal(const std::string& name, const Tally& expected, const Tally& found)
{
  std::ostringstream message;
  message << name << ": " << found << " instead of " << expected;
  if(expected != found)
    throw std::runtime_error(message.str());
}

// One tally per thread, so that threads never write to the same cache line. There is one for the
// whole program: a thread looks its tally up once and then keeps a reference to it.
class Parallel_tally
{
public:
  Parallel_tally() { take(); }

  void operator()(std::size_t i, std::size_t j) const
  {
    thread_local Tally& own = add_tally();
    own(i, j);
  }

  Tally sum() const
  {
    Tally sum;
    for(const Own_tally& own : tallies()) {
      sum.pairs += own.tally.pairs;
      sum.positions ^= own.tally.positions;
    }
    return sum;
  }

  // Returns the sum, and begins anew.
  Tally take() const
  {
    const Tally all = sum();
    for(Own_tally& own : tallies())
      own.tally = Tally();
    return all;
  }

private:
  struct alignas(64) Own_tally
  {
    Tally tally;
  };

  static std::deque<Own_tally>& tallies()
  {
    static std::deque<Own_tally> tallies;
    return tallies;
  }

  static Tally& add_tally()
  {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    return tallies().emplace_back().tally;
  }
};

// To tell how many pairs differ between two searches.
struct Pair_list
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;

  // Searches of one set give i < j.
  void operator()(std::size_t i, std::size_t j) { pairs.emplace_back(i, j); }
};

// How many pairs of `a` are not in `b`.
inline std::size_t count_missing(Pair_list a, Pair_list b)
{
  std::sort(a.pairs.begin(), a.pairs.end());
  std::sort(b.pairs.begin(), b.pairs.end());
  Pair_list missing;
  std::set_difference(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), b.pairs.end(),
                      std::back_inserter(missing.pairs));
  return missing.pairs.size();
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_TALLY_H
