// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_TREE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_TREE_H

// The pairs of crowded boxes, by a segment tree that is never stored: Zomorodian and Edelsbrunner,
// "Fast software for box intersections", 2002. O(n log^(d-1) n + k) time, whatever the boxes are.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Group_scan.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// If boxes have groups, hardly any pairs are looked at that are not wanted.
template <class Box>
class Box_tree
{
  using Boxes = std::vector<const Box*>;
  using Client = Box_client<Box::axes>;
  using Iterator = typename Boxes::const_iterator;
  using Range = std::pair<Iterator, Iterator>;

public:
  Box_tree(Client& client, const Stop_flag& stop) : client_(client), stop_(stop), groups_(client)
  {}

  // Gives the pairs of a piece to the client. Returns false to stop. Boxes that are copies along a
  // common axis are not searched for pairs, so no pair is found in two pieces.
  bool search(const Piece<Box>& piece)
  {
    std::array<std::array<Boxes, std::size_t(1) << Box::axes>, 2> boxes; // by their sides
    for(std::size_t set = 0; set < 2; ++set)
      for(const Box* box = piece[set].first; box != piece[set].last; ++box)
        boxes[set][box->sides].push_back(box);
    const bool is_one_set = piece.set_count() == 1;
    const auto& others = boxes[is_one_set ? 0 : 1];
    bool goes_on = true;
    for(std::size_t a = 0; a < boxes[0].size(); ++a)
      for(std::size_t b = is_one_set ? a : 0; b < others.size(); ++b)
        if((a & b) == 0 && goes_on)
          goes_on = is_one_set && a == b ? within(boxes[0][a]) : between(boxes[0][a], others[b]);
    return goes_on;
  }

  // The same of a set.
  bool within(const Boxes& boxes)
  {
    std::vector<Box> sorted = sorted_copies(boxes);
    if(client_.have_groups)
      groups_.set_boxes(sorted, sorted);
    const Boxes all = pointers(sorted);
    return search(all, all, last_axis);
  }

  // The same of a box of `a` and a box of `b`.
  bool between(const Boxes& a, const Boxes& b)
  {
    std::vector<Box> sorted_a = sorted_copies(a);
    std::vector<Box> sorted_b = sorted_copies(b);
    if(client_.have_groups)
      groups_.set_boxes(sorted_a, sorted_b);
    return search_both(pointers(sorted_a), pointers(sorted_b), last_axis);
  }

private:
  static constexpr std::size_t few = 24;
  static constexpr std::size_t max_held = 24; // lower ends, per box in a sweep
  static constexpr std::size_t min_sample = 8;

  static constexpr int last_axis = Box::axes - 1;

  static double low(const Box* box, int axis) { return box->low[axis]; }
  static double high(const Box* box, int axis) { return box->high[axis]; }

  // Whether two boxes meet along the axes below `axis`.
  static bool do_meet_below(const Box* a, const Box* b, int axis)
  {
    for(int i = 0; i < axis; ++i)
      if(!(low(a, i) <= high(b, i) && low(b, i) <= high(a, i)))
        return false;
    return true;
  }

  static void sort(Boxes& boxes, int axis)
  {
    std::vector<Keyed_value> ends(boxes.size());
    for(std::size_t i = 0; i < boxes.size(); ++i)
      ends[i] = {radix_key(low(boxes[i], axis)), static_cast<Place>(i)};
    radix_sort(ends);
    const Boxes unsorted = boxes;
    std::transform(ends.begin(), ends.end(), boxes.begin(),
                   [&](const Keyed_value& end) { return unsorted[end.value]; });
    // Invariant: the boxes before `first` are in order.
    for(std::size_t first = 0, last; first != boxes.size(); first = last) {
      last = first + 1;
      while(last != boxes.size() && ends[last].key == ends[first].key)
        ++last;
      if(last - first > 1)
        std::sort(boxes.begin() + first, boxes.begin() + last,
                  [](const Box* a, const Box* b) { return a->position < b->position; });
    }
  }

  // Lists are mostly read along axis 0, so this is the order of the boxes in memory.
  BOOST_NOINLINE static std::vector<Box> sorted_copies(Boxes boxes)
  {
    sort(boxes, 0);
    std::vector<Box> copies(boxes.size());
    std::transform(boxes.begin(), boxes.end(), copies.begin(), [](const Box* box) { return *box; });
    return copies;
  }

  static Boxes pointers(const std::vector<Box>& boxes)
  {
    Boxes pointers(boxes.size());
    std::iota(pointers.begin(), pointers.end(), boxes.data());
    return pointers;
  }

  BOOST_NOINLINE bool search_both(const Boxes& a, const Boxes& b, int axis)
  {
    return search(a, b, axis) && search(b, a, axis);
  }

  // Reports the pairs of a box that holds the lower end, along `axis`, of one of `starting`. All
  // of these boxes meet along the axes above. Lists are sorted along axis 0.
  bool search(const Boxes& holding, const Boxes& starting, int axis)
  {
    if(holding.empty() || starting.empty())
      return true;
    if(stop_.is_set())
      return false;
    if(axis == 0)
      return client_.have_groups ? groups_.search(holding, starting) : scan(holding, starting);
    Boxes by_start = starting;
    sort(by_start, axis);
    Half all = {holding, starting, by_start.begin(), by_start.end()};
    return begin(all, axis) && halve(std::move(all), axis);
  }

  // The same along axis 0.
  bool scan(const Boxes& holding, const Boxes& starting)
  {
    auto first = starting.begin();
    for(const Box* a : holding) {
      while(first != starting.end() && !begins_before(a, *first, 0))
        ++first;
      for(auto b = first; b != starting.end() && (*b)->low[0] <= a->high[0]; ++b)
        if(!give(a, *b))
          return false;
    }
    return true;
  }

  bool give(const Box* a, const Box* b) { return client_.take_pair(a->position, b->position); }

  // Some boxes that start, [first, last) in their order along an axis, and boxes that hold lower
  // ends of these along it. Both lists are sorted along axis 0.
  struct Half
  {
    Boxes holding;
    Boxes starting;
    Iterator first;
    Iterator last;
  };

  // Sweeps along `axis` or along axis 0, if few boxes meet along it, and leaves none. Otherwise
  // takes out the boxes that hold all lower ends: they meet what starts along the axis, and need
  // not be searched along it.
  BOOST_NOINLINE bool begin(Half& half, int axis)
  {
    const Boxes &holding = half.holding, &starting = half.starting;
    const Iterator first = half.first, last = half.last;
    if(holding.empty() || starting.empty())
      return true;
    bool goes_on;
    if((starting.size() < few || held_count(holding, first, last, axis) <= max_held)
       && find_held(holding, first, last, axis, held_))
      goes_on = for_held(holding, held_, [&](const Box* a, const Box* b) {
        return !do_meet_below(a, b, axis) || give(a, b);
      });
    else if(held_count(holding, starting.begin(), starting.end(), 0)
                  + held_count(starting, holding.begin(), holding.end(), 0) <= max_held
            && find_held(holding, starting.begin(), starting.end(), 0, held_)
            && find_held(starting, holding.begin(), holding.end(), 0, held_by_starting_))
      goes_on = sweep_along_axis_0(holding, starting, axis);
    else {
      Boxes spanning;
      auto kept = half.holding.begin();
      for(const Box* box : holding)
        if(begins_before(box, *first, axis) && low(last[-1], axis) <= high(box, axis))
          spanning.push_back(box);
        else
          *kept++ = box;
      half.holding.erase(kept, holding.end());
      return search_both(spanning, starting, axis - 1);
    }
    half.holding = Boxes();
    return goes_on;
  }

  // Halves what begin() left. A box that is left in one of two halves holds some of its lower ends,
  // and not all. So it is in two of all halves that wait to be halved, and these have O(n) boxes.
  bool halve(Half half, int axis)
  {
    if(half.holding.empty() || half.starting.empty())
      return true;
    const Iterator middle = half.first + (half.last - half.first) / 2;
    std::array<Half, 2> halves = {{{{}, {}, half.first, middle}, {{}, {}, middle, half.last}}};
    for(Half& part : halves)
      for(const Box* box : half.holding)
        if(begins_before(box, part.last[-1], axis) && low(*part.first, axis) <= high(box, axis))
          part.holding.push_back(box);
    for(const Box* box : half.starting)
      halves[begins_before(box, *middle, axis) ? 0 : 1].starting.push_back(box);
    half = {};
    return begin(halves[0], axis) && begin(halves[1], axis)
           && halve(std::move(halves[0]), axis) && halve(std::move(halves[1]), axis);
  }

  // How many lower ends a box holds, on average over a sample, which takes a part of the time that
  // it takes to halve the boxes.
  static std::size_t held_count(const Boxes& holding, Iterator first, Iterator last, int axis)
  {
    std::size_t count = 0;
    const std::size_t search_cost = 16 * static_cast<std::size_t>(std::ilogb(last - first) + 1);
    const std::size_t step = holding.size() / (min_sample + holding.size() / search_cost) + 1;
    for(std::size_t i = 0; i < holding.size(); i += step) {
      const Range range = boxes_held_by(holding[i], first, last, axis);
      count += static_cast<std::size_t>(range.second - range.first);
    }
    return count * step / holding.size();
  }

  // Finds the boxes of [first, last) whose lower ends each box holds. Returns false if there are
  // many of them: then the sample was misleading, and no sweep follows.
  static bool find_held(const Boxes& holding, Iterator first, Iterator last, int axis,
                        std::vector<Range>& ranges)
  {
    std::size_t count = 0;
    ranges.clear();
    for(const Box* a : holding) {
      ranges.push_back(boxes_held_by(a, first, last, axis));
      count += static_cast<std::size_t>(ranges.back().second - ranges.back().first);
    }
    return count <= 4 * max_held * holding.size();
  }

  // Calls task(a, b) for each box b in the range of a box a.
  template <class Task>
  static bool for_held(const Boxes& holding, const std::vector<Range>& ranges, const Task& task)
  {
    for(std::size_t i = 0; i < holding.size(); ++i)
      for(Iterator b = ranges[i].first; b != ranges[i].second; ++b)
        if(!task(holding[i], *b))
          return false;
    return true;
  }

  bool sweep_along_axis_0(const Boxes& holding, const Boxes& starting, int axis)
  {
    const auto test = [&](const Box* a, const Box* b) {
      const bool is_held = begins_before(a, b, axis) && low(b, axis) <= high(a, axis);
      return !is_held || !do_meet_below(a, b, axis) || give(a, b);
    };
    return for_held(holding, held_, test)
           && for_held(starting, held_by_starting_,
                       [&](const Box* b, const Box* a) { return test(a, b); });
  }

  Client& client_;
  const Stop_flag& stop_;
  Group_scan<Box> groups_;
  std::vector<Range> held_; // by the boxes of a sweep
  std::vector<Range> held_by_starting_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_TREE_H
