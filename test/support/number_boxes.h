// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes of doubles as the box route asks for them, small structured scenes of them, all pairs of
// them by brute force, and the pairs by the route.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_NUMBER_BOXES_H
#define THICK_INTERSECTION_TEST_SUPPORT_NUMBER_BOXES_H

#include "pairs.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Box_route.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Box_tuning;

// The interval of a box along each axis. Axes beyond the dimension are not looked at.
using Number_box = std::array<internal::Interval, 8>;
using Number_boxes = std::vector<Number_box>;
using Generator = std::mt19937_64;

inline double below(Generator& random, std::uint64_t n)
{
  return static_cast<double>(random() % n);
}

inline bool intervals_meet(const internal::Interval& a, const internal::Interval& b)
{
  return a.low <= b.high && b.low <= a.high;
}

inline bool do_meet(const Number_box& a, const Number_box& b, int dimension)
{
  for(int axis = 0; axis < dimension; ++axis)
    if(!intervals_meet(a[axis], b[axis]))
      return false;
  return true;
}

// All pairs of meeting boxes, of one set or of two, in ascending order.
inline Pairs all_meeting_pairs(const Number_boxes& boxes, int dimension,
                               std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  for(std::size_t i = 0; i < first_set_size.value_or(boxes.size()); ++i)
    for(std::size_t j = first_set_size.value_or(i + 1); j < boxes.size(); ++j)
      if(do_meet(boxes[i], boxes[j], dimension))
        pairs.emplace_back(i, j);
  return pairs;
}

// What Boxed_objects asks. Objects are their boxes; if they are said to be more than that, the
// pairs that are asked about are written down.
class Number_objects : public internal::Objects_in_boxes<0>
{
public:
  Number_objects(const Number_boxes& boxes, int dimension, bool are_exact = true)
    : boxes_(boxes), dimension_(dimension), are_exact_(are_exact)
  {}

  std::size_t size() const { return boxes_.size(); }
  int dimension() const { return dimension_; }
  auto intervals(std::size_t position) const
  {
    return [this, position](int axis) { return boxes_[position][axis]; };
  }
  bool are_exact() const { return are_exact_; }
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    asked_.emplace_back((std::min)(i, j), (std::max)(i, j));
    return do_meet(boxes_[i], boxes_[j], dimension_);
  }

  const Pairs& asked() const { return asked_; }

private:
  const Number_boxes& boxes_;
  int dimension_;
  bool are_exact_;
  mutable Pairs asked_;
};

// Returns which of `size` boxes the first plan looks at, if it takes one of three.
inline std::vector<bool> sampled_of_three(std::size_t size)
{
  std::vector<bool> sampled(size);
  internal::Random_numbers random;
  for(std::size_t i = 0; i + 3 <= size; i += 3)
    sampled[i + random.below(3)] = true;
  return sampled;
}

// Adds up the boxes that are finished, and cancels when there are `limit`.
struct Box_progress
{
  bool advance(std::size_t count)
  {
    finished += count;
    steps += count != 0;
    return finished < limit;
  }

  std::size_t limit = std::size_t(-1);
  std::size_t finished = 0, steps = 0;
};

// Calls search(client, piece) with the boxes of objects, of one set or of two. In either case, the
// callback gets positions in one numbering.
template <int Axes, class Objects, class Callback, class Progress, class Search>
auto with_piece(const Objects& objects, std::optional<std::size_t> first_set_size,
                Callback& callback, Progress& progress, const Search& search)
{
  using Box = internal::Piece_box<Axes>;
  std::vector<int> all_axes(static_cast<std::size_t>(objects.dimension()));
  std::iota(all_axes.begin(), all_axes.end(), 0);
  internal::Boxed_objects<Axes, Objects, Callback, Progress> client(objects, all_axes, callback,
                                                                    progress);
  std::vector<Box> boxes(objects.size());
  client.read(0, boxes.size(), boxes.data());
  Box* const first = boxes.data();
  Box* const last = first + boxes.size();
  if(!first_set_size)
    return search(client, internal::Piece<Box>({first, last}));
  Box* const middle = first + *first_set_size;
  return search(client, internal::Piece<Box>({first, middle}, {middle, last}));
}

// The same, if nobody calls the callback.
template <int Axes, class Objects, class Search>
auto with_piece(const Objects& objects, std::optional<std::size_t> first_set_size,
                const Search& search)
{
  const auto ignore = [](std::size_t, std::size_t) {};
  internal::Unwatched_progress progress;
  return with_piece<Axes>(objects, first_set_size, ignore, progress, search);
}

// Reports the pairs by the box route. Returns false iff it was stopped.
template <int Axes, class Objects, class Callback, class Progress>
bool search_boxes(const Objects& objects, const Box_tuning& tuning,
                  std::optional<std::size_t> first_set_size, Callback& callback, Progress& progress)
{
  return with_piece<Axes>(
    objects, first_set_size, callback, progress, [&](auto& client, const auto& piece) {
      return internal::Box_route<Axes>(client, internal::Threads(), tuning).search(piece);
    });
}

template <int Axes, class Objects>
Pairs pairs_by_boxes(const Objects& objects, const Box_tuning& tuning = Box_tuning(),
                     std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  internal::Unwatched_progress progress;
  const auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  search_boxes<Axes>(objects, tuning, first_set_size, callback, progress);
  return pairs;
}

// Cuts few boxes again and again, sorts or not, and calls them crowded or not.
inline Box_tuning small_tuning(Generator& random)
{
  Box_tuning tuning;
  tuning.move_cost = 0;
  tuning.box_cost = below(random, 2);
  tuning.candidate_cost = 1 + below(random, 8);
  tuning.piece_cost = 0;
  tuning.min_boxes_per_piece = 1 + below(random, 2);
  tuning.few_boxes = static_cast<internal::Place>(1 + random() % 3);
  tuning.usual_box_candidates = below(random, 3);
  tuning.max_bucket_pairs = below(random, 4);
  tuning.candidates_per_block = 1 + below(random, 64);
  if(random() % 2) {
    tuning.crowded_candidates = 0;
    tuning.tree_candidates = 0;
    tuning.crowded_share = random() % 2 ? 2 : 0.5;
  }
  return tuning;
}

// Boxes with corners on a lattice whose unit may be no binary fraction, denormal or huge. Many of
// them touch or are equal, some have no extent, few are long, and zeros have either sign.
inline Number_boxes structured_boxes(Generator& random, int dimension, std::size_t size)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double units[] = {1, 1, 0.1, 1 / 3., 5e-324, 1e300};
  const double unit = units[random() % 6];
  const std::uint64_t side = 1 + random() % 24, usual = 1 + random() % 4, few = 2 + random() % 30;
  const bool has_infinite = random() % 16 == 0;
  Number_boxes boxes(size);
  for(std::size_t i = 0; i < size; ++i) {
    if(i > 0 && random() % 8 == 0) {
      boxes[i] = boxes[random() % i];
      continue;
    }
    for(int axis = 0; axis < dimension; ++axis) {
      const double length = random() % few == 0 ? below(random, 2 * side) : below(random, usual);
      const double low = below(random, side) - static_cast<double>(side / 2);
      internal::Interval& interval = boxes[i][axis];
      interval = {unit * low, unit * (low + length)};
      for(double* end : {&interval.low, &interval.high})
        if(*end == 0 && random() % 2)
          *end = -*end;
      if(has_infinite && random() % 4 == 0)
        (random() % 2 ? interval.low = -infinity : interval.high = infinity);
    }
  }
  return boxes;
}

// Horizontals that begin at 0 or later, and long verticals before 0: many pairs meet along each
// axis, none along both.
inline Number_boxes half_beams(std::size_t n)
{
  Generator random(n);
  Number_boxes boxes(n);
  for(std::size_t i = 0; i < n; ++i) {
    const double x = below(random, 1 << 30) / (1 << 30), y = below(random, 1 << 30) / (1 << 30);
    if(i % 2)
      boxes[i] = {{{x / 8, 1 + x}, {y, y}}};
    else
      boxes[i] = {{{-1 - x, -1 - x}, {y / 8, 1 + y}}};
  }
  return boxes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_NUMBER_BOXES_H
