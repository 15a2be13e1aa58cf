// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_CHUNKED_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_CHUNKED_LISTS_H

// Many lists of small items, whose lengths are not known beforehand.
//
// A list grows by chunks that stay in place. A vector would copy all items to grow. Large blocks of
// memory hold many chunks, because each block costs an allocation.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Item, std::size_t chunk_size>
class Chunked_lists
{
public:
  explicit Chunked_lists(std::size_t list_count) : lists_(list_count) {}

  // A copy has as many lists, which are empty.
  Chunked_lists(const Chunked_lists& other) : Chunked_lists(other.lists_.size()) {}
  Chunked_lists& operator=(const Chunked_lists&) = delete;

  // Throws if memory runs out, and leaves all lists as they were.
  void append(std::size_t list, const Item& item)
  {
    List& l = lists_[list];
    if(l.next == l.end)
      extend(l);
    *l.next++ = item;
  }

  std::size_t size(std::size_t list) const
  {
    const List& l = lists_[list];
    return l.chunks.size() * chunk_size - static_cast<std::size_t>(l.end - l.next);
  }

  // Calls task(item, end) for the chunks of a list in order, until the task returns false. Returns
  // whether the task never returned false.
  template <class Task>
  bool for_each_chunk(std::size_t list, const Task& task) const
  {
    const List& l = lists_[list];
    for(const Item* item : l.chunks)
      if(!task(item, item + chunk_size == l.end ? l.next : item + chunk_size))
        return false;
    return true;
  }

  // Calls task(item) for the items of a list in order, until the task returns false. Returns
  // whether the task never returned false.
  template <class Task>
  bool for_each(std::size_t list, const Task& task) const
  {
    return for_each_chunk(list, [&](const Item* item, const Item* end) {
      for(; item != end; ++item)
        if(!task(*item))
          return false;
      return true;
    });
  }

  // Frees the memory of all lists, after which there is none.
  void clear()
  {
    lists_.clear();
    blocks_.clear();
  }

private:
  static constexpr std::size_t max_block_size = 2048; // chunks

  struct List
  {
    std::vector<Item*> chunks;
    Item* next = nullptr; // in the last chunk
    Item* end = nullptr;  // of the last chunk
  };

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void extend(List& list)
  {
    if(chunks_left_ == 0) {
      const std::size_t size = (std::min)(2 * block_size_, max_block_size);
      blocks_.emplace_back(make_uninitialized<Item>(size * chunk_size));
      block_size_ = size;
      chunks_left_ = size;
    }
    Item* const chunk = blocks_.back().get() + (chunks_left_ - 1) * chunk_size;
    list.chunks.push_back(chunk);
    --chunks_left_;
    list.next = chunk;
    list.end = chunk + chunk_size;
  }

  std::vector<List> lists_;
  std::vector<std::unique_ptr<Item[]>> blocks_;
  std::size_t block_size_ = 1;  // of the last block, in chunks
  std::size_t chunks_left_ = 0; // in the last block
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_CHUNKED_LISTS_H
