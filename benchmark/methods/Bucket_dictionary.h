// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The dictionary of [L]: hashing with lists of the buckets in the same slot. The hash is random, so
// finding a bucket takes expected O(1) time for any cells.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_BUCKET_DICTIONARY_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_BUCKET_DICTIONARY_H

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace thick_benchmark {

namespace internal = CGAL::Thick_intersection_d::internal;

class Bucket_dictionary
{
public:
  // Holds all buckets, whatever the first one is that is asked for.
  Bucket_dictionary(const internal::Cell_table& table, const internal::Forward_offsets& offsets,
                    std::size_t)
    : table_(table), offsets_(offsets), axis_count_(static_cast<int>(offsets[0].size())),
      hash_(axis_count_, internal::seed_of_process()),
      slot_bits_(internal::hash_table_bits(table.bucket_count())),
      heads_(std::size_t(1) << slot_bits_), next_(table.bucket_count())
  {
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket) {
      std::uint32_t& head = heads_[slot([&](int axis) { return table_.number(bucket, axis); })];
      next_[bucket] = head;
      head = static_cast<std::uint32_t>(bucket) + 1;
    }
  }

  // Returns the bucket at offset `i` from `bucket`, or bucket_count() if it is empty.
  std::size_t operator()(std::size_t bucket, std::size_t i) const
  {
    const std::vector<int>& offset = offsets_[i];
    std::uint32_t other
      = heads_[slot([&](int axis) { return table_.number(bucket, axis) + offset[axis]; })];
    while(other != 0 && table_.compare(other - 1, bucket, offset) != 0)
      other = next_[other - 1];
    return other == 0 ? table_.bucket_count() : other - 1;
  }

private:
  template <class Number_along>
  std::size_t slot(const Number_along& number_along) const
  {
    std::uint64_t sum = 0;
    for(int axis = 0; axis < axis_count_; ++axis)
      sum = hash_.add(sum, axis, number_along(axis));
    return hash_.finish(sum) >> (64 - slot_bits_);
  }

  const internal::Cell_table& table_;
  const internal::Forward_offsets& offsets_;
  int axis_count_;
  internal::Sequence_hash<> hash_;
  int slot_bits_;
  std::vector<std::uint32_t> heads_; // by slot: 1 + the last bucket in the slot, or 0
  std::vector<std::uint32_t> next_;  // by bucket: 1 + the bucket before it in the slot, or 0
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_BUCKET_DICTIONARY_H
