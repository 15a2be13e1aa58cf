// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The textbook method for near pairs: cells as wide as the radius, and pairs of points in equal and
// in neighbouring cells as candidates. How the cell of a coordinate is computed is up to the user,
// and so are the pairs that it loses.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_CELL_LIST_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_CELL_LIST_H

#include "all_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace thick_benchmark {

template <int Dimension>
class Cell_list
{
  using Cell = std::array<double, Dimension>;

public:
  // cell_of(x) is the index of the cell of a coordinate, an integer as a double. A point for which
  // it is NaN is in no cell.
  template <class Point, class Cell_of>
  Cell_list(const std::vector<Point>& points, const Cell_of& cell_of)
  {
    for(std::size_t i = 0; i < points.size(); ++i) {
      Entry entry{{}, i};
      for(int axis = 0; axis < Dimension; ++axis)
        entry.cell[axis] = cell_of(points[i][axis]);
      if(std::none_of(entry.cell.begin(), entry.cell.end(), [](double c) { return c != c; }))
        entries_.push_back(entry);
    }
    std::sort(entries_.begin(), entries_.end(), Less());
  }

  // Calls f(i, j) for each two points in one cell or in neighbouring ones, once.
  template <class Function>
  void for_each_candidate(const Function& f) const
  {
    for(Iterator first = entries_.begin(); first != entries_.end();) {
      const Iterator last = std::upper_bound(first, entries_.end(), *first, Less());
      for(Iterator a = first; a != last; ++a)
        for(Iterator b = a + 1; b != last; ++b)
          f(a->position, b->position);
      visit_later_neighbours(first, last, first->cell, 0, false, f);
      first = last;
    }
  }

private:
  struct Entry
  {
    Cell cell;
    std::size_t position;
  };
  struct Less
  {
    bool operator()(const Entry& a, const Entry& b) const { return a.cell < b.cell; }
  };
  using Iterator = typename std::vector<Entry>::const_iterator;

  // Fixes the cell of a neighbour axis by axis, and visits it if it comes later: if the first axis
  // along which it differs goes up.
  template <class Function>
  void visit_later_neighbours(Iterator first, Iterator last, Cell cell, int axis,
                              bool is_later, const Function& f) const
  {
    if(axis == Dimension) {
      if(!is_later)
        return;
      const auto range = std::equal_range(entries_.begin(), entries_.end(), Entry{cell, 0}, Less());
      for(Iterator a = first; a != last; ++a)
        for(Iterator b = range.first; b != range.second; ++b)
          f(a->position, b->position);
      return;
    }
    const double own = cell[axis];
    for(int step = is_later ? -1 : 0; step <= 1; ++step) {
      cell[axis] = own + step;
      if(step == 0 || cell[axis] != own) // beyond 2^53 a step is lost
        visit_later_neighbours(first, last, cell, axis + 1, is_later || step > 0, f);
    }
  }

  std::vector<Entry> entries_;
};

template <class Point, class Cell_of>
Cell_list(const std::vector<Point>&, const Cell_of&) -> Cell_list<dimension_of<Point>>;

// Small scenes are searched pair by pair, so that only the predicate is to blame for what is
// wrong; large ones by cells, whose division loses no pair.
template <class Point, class Function>
void for_each_candidate(const std::vector<Point>& points, double r, const Function& f)
{
  if(points.size() > 2000 && r > 0)
    Cell_list(points, [r](double x) { return std::floor(x / r); }).for_each_candidate(f);
  else
    all_pairs(points.size(), [](std::size_t, std::size_t) { return true; }, f);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_CELL_LIST_H
