// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H

// Hashes of sequences of integers, such as the numbers of a cell along the axes.

#ifndef CGAL_THICK_INTERSECTION_D_COMPILED
#include <CGAL/Thick_intersection_d/internal/arrays/seed_of_process.inc>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns a seed that the process draws once. No input can be made to suit it.
template <class Word = std::uint64_t>
Word seed_of_process();

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template std::uint64_t seed_of_process<std::uint64_t>();
#endif

// Moves the seed on, and returns 64 bits of it, mixed: SplitMix64. [Steele, Lea, Flood: Fast
// splittable pseudorandom number generators, 2014]
inline std::uint64_t random_word(std::uint64_t& seed)
{
  std::uint64_t x = seed += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// A random function of sequences of integers. Which sequences collide depends on the keys, and the
// keys on the seed. So an input that does not know the seed has few collisions, whatever it is.
//
// The sum is NH, with a key of 64 bits for each place of the sequence. Two sequences of one length
// have the same sum for at most one in 2^32 choices of the keys. [Black, Halevi, Krawczyk, Krovetz,
// Rogaway: UMAC, 1999] Here a number and its key are added before they are cut into halves. The
// proof allows for that: the carry depends on the lower halves alone.
//
// The product with a random odd factor has the same upper k bits for two different sums for at most
// two in 2^k factors. [Dietzfelbinger, Hagerup, Katajainen, Penttonen: A reliable randomized
// algorithm for the closest-pair problem, 1997] So a slot that is given by the upper bits of a hash
// holds O(1) other entries of a table, in expectation, whatever the sequences. The upper half of a
// sum is folded into its lower half first: the sums of a lattice of cells are another lattice.
//
// `Length` is the length of the sequences, or 0 if it is known at run time only.
template <int Length = 0>
class Sequence_hash
{
public:
  Sequence_hash() = default;
  Sequence_hash(int length, std::uint64_t seed)
  {
    if constexpr(Length == 0)
      keys_ = std::vector<std::uint64_t>(static_cast<std::size_t>(length));
    factor_ = random_word(seed) | 1;
    for(std::uint64_t& key : keys_)
      key = random_word(seed);
  }

  // Returns the sum so far and the number at a place of the sequence. The first sum is 0.
  std::uint64_t add(std::uint64_t sum, int place, std::uint64_t number) const
  {
    const std::uint64_t x = number + keys_[static_cast<std::size_t>(place)];
    return sum + (x & 0xffffffff) * (x >> 32);
  }

  // Returns the hash of the whole sequence. The upper bits are the best.
  std::uint64_t finish(std::uint64_t sum) const { return (sum ^ (sum >> 32)) * factor_; }

private:
  std::uint64_t factor_ = 1;
  std::conditional_t<Length == 0, std::vector<std::uint64_t>, std::array<std::uint64_t, Length>>
    keys_{};
};

// Returns the logarithm of the number of slots of a hash table for `size` entries. The table is at
// most half full.
inline int hash_table_bits(std::size_t size)
{
  int bits = 4;
  while(std::size_t(1) << bits < 2 * size)
    ++bits;
  return bits;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H
