// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_LISTS_H

// The neighbors of the points of the slabs in the window, as the sweep finds them. The two points
// of a pair are in the window, where their lists are in the cache. When a slab leaves the window,
// its lists are complete.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/run_sorter.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/slabs/List_bins.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>

#include <boost/config.hpp> // BOOST_LIKELY, BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The room for positions fills two cache lines. Most points of scenes with 20 neighbors per point
// have no more.
struct alignas(64) Short_list
{
  static constexpr Place capacity = 32;

  std::array<Place, capacity> positions;
};
static_assert(Short_list::capacity == max_run_size);

// Takes pairs from Near_sweep. Points have numbers here: those of a slab in the window are
// consecutive, and free for other slabs afterwards.
//
// The first neighbors of a point go to a short list of its own. There are few further ones in most
// scenes; they are stored with the number of their point, and sorted by it in the end.
class Slab_lists final : public Pair_taker, public Place_numbers
{
public:
  // There are `slab_count` slabs in all. The window has up to three of them in most scenes.
  explicit Slab_lists(std::size_t slab_count)
    : slabs_at_once_((std::min)(slab_count, std::size_t(3)))
  {}

  // Adds a slab behind those in the window.
  Place add(Place size, Place*& positions) override
  {
    const Place first = find_room(size);
    first_position_ = positions_.data();
    positions = positions_.data() + first;
    std::fill_n(sizes_.data() + first, size, Place(0));
    window_.push_back({first, first + size});
    return first;
  }

  // Returns where the positions of points begin, by their numbers. They move when a slab is added.
  const Place* const* positions() const { return &first_position_; }

  // Makes the points of each pair of numbers neighbors of each other. Never stops.
  bool take(const Found_pair* pairs, std::size_t count) override
  {
    const Place* const positions = positions_.data(); // copies stay in registers
    Place* const sizes = sizes_.data();
    Short_list* const lists = lists_.data();
    const auto append = [&](Place of, Place position) {
      const Place size = sizes[of]++;
      if(BOOST_LIKELY(size < Short_list::capacity))
        lists[of].positions[size] = position;
      else
        append_further({of, position});
    };
    for(const Found_pair* const end = pairs + count; pairs != end; ++pairs) {
      append(pairs->i, positions[pairs->j]);
      append(pairs->j, positions[pairs->i]);
    }
    return true;
  }

  // Removes the first slab from the window, and hands its lists to `bins`, in ascending order,
  // without those of points in the border of a column. `strips` are the strips of the slab.
  template <class Point>
  void finish(const Strips<Point>& strips, List_bins& bins)
  {
    take_further_neighbors(window_.front());
    for(const auto& strip : strips.strips())
      if(Point::may_be_shared && strip.sides == Point_sets::side_of_border)
        std::fill_n(sizes_.data() + window_.front().first + strip.begin, strip.size(), Place(0));
    hand_over(bins);
  }

  // Removes the first slab from the window, and its lists with it.
  void drop()
  {
    take_further_neighbors(window_.front());
    window_.pop_front();
  }

private:
  static constexpr std::size_t lines_ahead = 8 * sizeof(Short_list) / cache_line_size;

  struct Numbers
  {
    Place first;
    Place end;
  };

  struct Neighbor
  {
    Place of; // a number
    Place position;
  };

  // Not inline, so that the loop over pairs stays short.
  BOOST_NOINLINE void append_further(const Neighbor& neighbor) { further_.push_back(neighbor); }

  // Returns the first of `size` numbers that no slab in the window has: zero, or the first one
  // behind a slab.
  Place find_room(Place size)
  {
    std::size_t first = 0;
    for(bool is_free = false; !is_free;) {
      is_free = true;
      for(const Numbers& slab : window_)
        if(first < slab.end && slab.first < first + size) {
          first = slab.end;
          is_free = false;
        }
    }
    const std::size_t end = first + size;
    check_size(end);
    if(end > lists_.size()) {
      if(window_.empty()) // room for all slabs takes less memory than room that grows
        lists_.reserve(slabs_at_once_ * (size + std::size_t(size) / 8));
      positions_.resize(end);
      sizes_.resize(end);
      lists_.resize(end);
    }
    return static_cast<Place>(first);
  }

  // Removes the first slab from the window, and hands its lists to `bins`.
  BOOST_NOINLINE void hand_over(List_bins& bins)
  {
    const Numbers slab = window_.front();
    for(Place number = slab.first; number != slab.end; ++number) {
      prefetch_to_read(lists_.data() + number, lines_ahead);
      prefetch_to_read(lists_.data() + number, lines_ahead + 1);
      const Place size = sizes_[number];
      if(size == 1)
        *bins.append_short(positions_[number], 1) = lists_[number].positions[0];
      else if(size > Short_list::capacity)
        finish_long_list(number, ends_[number - slab.first], bins);
      else if(size > 0)
        sorter_.sort(lists_[number].positions.data(), size,
                     bins.append_short(positions_[number], size));
    }
    window_.pop_front();
  }

  // Moves the further neighbors of the points of a slab to `sorted_`, in the order of the points.
  // Sets `ends_` to where those of each point end.
  void take_further_neighbors(const Numbers& slab)
  {
    if(further_.empty())
      return;
    ends_.clear();
    std::size_t sum = 0;
    for(Place number = slab.first; number != slab.end; ++number) {
      ends_.push_back(sum);
      sum += (std::max)(sizes_[number], Short_list::capacity) - Short_list::capacity;
    }
    Place* const sorted = sorted_.require(sum);
    std::size_t kept = 0;
    for(const Neighbor& neighbor : further_)
      if(slab.first <= neighbor.of && neighbor.of < slab.end)
        sorted[ends_[neighbor.of - slab.first]++] = neighbor.position;
      else
        further_[kept++] = neighbor;
    further_.resize(kept);
  }

  // `end` is where the further neighbors of the point end.
  void finish_long_list(Place number, std::size_t end, List_bins& bins)
  {
    const std::size_t size = sizes_[number];
    const Place* const last = sorted_.data() + end;
    Place* const list = long_list_.require(size);
    std::copy_n(lists_[number].positions.data(), Short_list::capacity, list);
    std::copy(last - (size - Short_list::capacity), last, list + Short_list::capacity);
    sort_distinct(list, list + size, memory_of_sort_, sorter_);
    bins.append(positions_[number], list, list + size);
  }

  const std::size_t slabs_at_once_;
  const Run_sorter& sorter_ = run_sorter();
  std::deque<Numbers> window_;

  // By numbers.
  std::vector<Place> positions_;
  const Place* first_position_ = nullptr;
  std::vector<Place> sizes_; // of the lists, with further neighbors
  std::vector<Short_list> lists_;

  std::vector<Neighbor> further_;
  std::vector<std::size_t> ends_; // by numbers, from the first one of a slab on
  Buffer<Place> sorted_;
  Buffer<Place> long_list_;
  Buffer<Place> memory_of_sort_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_LISTS_H
