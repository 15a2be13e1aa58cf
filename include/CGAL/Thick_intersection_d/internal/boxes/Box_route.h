// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H

// The divide and conquer of [V03] for boxes of any sizes: boxes are cut into pieces, with copies of
// those that meet several pieces, and each piece is swept. doc/design.md describes it.

#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_classes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_order.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_planner.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_tree.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Cut_boxes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Pair_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Box_run.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` is like Boxed_objects.
template <class ConcurrencyTag, class Test, class Report, class Progress>
class Box_route
{
  using Box = typename Test::Box;
  using Cut = Cut_boxes<ConcurrencyTag, Box>;
  static constexpr int axes = Box::axes;

  // What a thread needs for its pieces.
  struct Worker
  {
    explicit Worker(const Box_tuning& tuning) : planner(tuning) {}

    Box_planner<axes> planner;
    std::tuple<Box_order<axes, 1>, Box_order<axes, 2>> orders;

    template <std::size_t Sets>
    Box_order<axes, Sets>& order() { return std::get<Sets - 1>(orders); }
  };

public:
  Box_route(const Test& test, Report& report, Progress& progress,
            const Box_tuning& tuning = Box_tuning())
    : test_(test), report_(report), progress_(progress), tuning_(tuning)
  {}

  // Reports the pairs of one set, or of two sets. Returns false iff the search was stopped.
  template <std::size_t Sets>
  bool search(const Piece<Box, Sets>& boxes)
  {
    Worker worker(tuning_);
    search_piece(worker, boxes, {first_box_sample, max_box_cuts, boxes.size()});
    return !report_.is_stopped();
  }

private:
  // What is known about a piece, and allowed in it.
  struct Piece_task
  {
    std::size_t sample_limit;
    int cuts_left;
    std::uint64_t copies_left;
    int sweep_axis = 0;
    bool is_planned = false;    // whether it is worth a try to sweep at once
    bool is_one_class = false;  // whether all boxes of a set are long along the same axes
    bool has_progress = true;   // whether the boxes are finished when the piece is
  };

  template <std::size_t Sets>
  void search_piece(Worker& worker, const Piece<Box, Sets>& piece, const Piece_task& task)
  {
    if(report_.is_stopped())
      return;
    if(!piece.has_pairs()) {
      finish(piece, task);
      return;
    }
    auto& order = worker.template order<Sets>();
    if(task.is_planned || piece.size() <= tuning_.few_boxes) {
      order.set(piece, task.sweep_axis, tuning_);
      if(order.candidate_count() <= tuning_.usual_candidates * piece.size()
         || piece.size() <= tuning_.few_boxes) {
        sweep_boxes(order);
        finish(piece, task);
        return;
      }
    }
    const Box_plan plan = worker.planner.plan(piece, task.sample_limit);
    if(plan.cut_axis >= 0 && task.cuts_left > 0 && cut(worker, piece, task, plan))
      return;
    order.set(piece, plan.sweep_axis, tuning_);
    if(!is_crowded(order, piece))
      sweep_boxes(order);
    else if(!task.is_one_class)
      search_classes(worker, piece, task);
    else
      search_tree(piece);
    finish(piece, task);
  }

  // Searches the pieces of a cut. Returns false if there would be too many copies.
  template <std::size_t Sets>
  bool cut(Worker& worker, const Piece<Box, Sets>& piece, const Piece_task& task,
           const Box_plan& plan)
  {
    const Equal_cut equal_cut(plan.range, plan.piece_count);
    std::vector<Cut> cuts;
    std::uint64_t size = 0;
    for(const auto& span : piece) {
      cuts.emplace_back(span, plan.cut_axis, equal_cut);
      size += cuts.back().size();
    }
    if(size - piece.size() > task.copies_left)
      return false;
    for(Cut& cut_of_set : cuts)
      cut_of_set.distribute();
    Piece_task task_of_pieces = task;
    task_of_pieces.sample_limit = box_sample;
    task_of_pieces.cuts_left = task.cuts_left - 1;
    task_of_pieces.copies_left = task.copies_left - (size - piece.size());
    task_of_pieces.sweep_axis = plan.sweep_axis;
    task_of_pieces.is_planned = plan.candidates <= tuning_.usual_candidates;
    for_each_piece(worker, equal_cut.count(), [&](Worker& own_worker, Place p) {
      Piece<Box, Sets> part;
      for(std::size_t set = 0; set < Sets; ++set)
        part[set] = cuts[set].piece(p);
      search_piece(own_worker, part, task_of_pieces);
    });
    return true;
  }

  // In parallel, a thread that waits for pieces may take another task, so tasks share no worker.
  template <class Task>
  void for_each_piece(Worker& worker, Place count, const Task& task) const
  {
    for_each_block<ConcurrencyTag>(count, [&](std::size_t piece, std::size_t last) {
      if constexpr(is_parallel_v<ConcurrencyTag>) {
        Worker own_worker(tuning_);
        for(; piece != last; ++piece)
          task(own_worker, static_cast<Place>(piece));
      }
      else
        for(; piece != last; ++piece)
          task(worker, static_cast<Place>(piece));
    });
  }

  // Sweeps the boxes in their order. If there are very many candidates, it sweeps in blocks, which
  // threads share.
  template <std::size_t Sets>
  void sweep_boxes(const Box_order<axes, Sets>& order)
  {
    const double candidates = static_cast<double>(order.candidate_count());
    const Place count = static_cast<Place>(candidates / tuning_.candidates_per_block) + 1;
    for_each_block<ConcurrencyTag>(count, [&](std::size_t block, std::size_t last) {
      Pair_sweep<Test, Report> pair_sweep(test_, report_);
      for(; block != last && !report_.is_stopped(); ++block) {
        pair_sweep.take_block(static_cast<Place>(block), count);
        for(std::size_t set = 0; set < Sets && !pair_sweep.is_stopped(); ++set)
          pair_sweep.between(order.run(set), order.run(Sets - 1 - set));
      }
    });
  }

  // Whether a sweep would look at many more candidates than the tree does, and at many more than
  // there are pairs. The latter is estimated from a sample of the candidates.
  template <std::size_t Sets>
  bool is_crowded(const Box_order<axes, Sets>& order, const Piece<Box, Sets>& piece) const
  {
    const double size = piece.size();
    const double candidates = static_cast<double>(order.candidate_count());
    const double factor = std::pow(std::log2(size), test_.dimension() - 1);
    if(candidates <= tuning_.crowded_candidates * size * factor)
      return false;
    return share_of_pairs(order) < tuning_.crowded_share;
  }

  // The share of pairs of boxes among the candidates.
  template <std::size_t Sets>
  double share_of_pairs(const Box_order<axes, Sets>& order) const
  {
    const double step = static_cast<double>(order.candidate_count()) / crowd_sample;
    double next = step / 2;
    double passed = 0;
    Place pairs = 0;
    for(std::size_t set = 0; set < Sets; ++set) {
      const auto& a = order.run(set);
      const auto& b = order.run(Sets - 1 - set);
      for(Place i = a.first; i < a.last; passed += a.ends[i] - a.begins[i], ++i)
        for(; next < passed + (a.ends[i] - a.begins[i]); next += step)
          pairs += do_meet(a, i, b, a.begins[i] + static_cast<Place>(next - passed));
    }
    return static_cast<double>(pairs) / crowd_sample;
  }

  static bool do_meet(const Box_run<axes>& a, Place i, const Box_run<axes>& b, Place j)
  {
    bool meet = (a.sides[i] & b.sides[j]) == 0;
    for(int axis = 0; axis < axes; ++axis)
      meet = meet && a.low[axis][i] <= b.high[axis][j] && b.low[axis][j] <= a.high[axis][i];
    return meet;
  }

  // Searches boxes apart that are long along different axes. Beams along two axes of space are
  // short along the third axis, and beams along one axis are short along the others. So these
  // searches may have few candidates where that of all boxes has many.
  template <std::size_t Sets>
  void search_classes(Worker& worker, const Piece<Box, Sets>& piece, const Piece_task& task)
  {
    Piece_task task_of_classes = task;
    task_of_classes.is_planned = false;
    task_of_classes.is_one_class = true;
    task_of_classes.has_progress = false;
    const auto lengths = worker.planner.long_lengths();
    std::array<Box_classes<Box>, Sets> classes;
    for(std::size_t set = 0; set < Sets; ++set)
      classes[set] = Box_classes<Box>(piece[set], lengths);
    for(Place a = 0; a < classes[0].count; ++a)
      if constexpr(Sets == 1) {
        search_piece(worker, Piece<Box, 1>{{{classes[0][a]}}}, task_of_classes);
        for(Place b = 0; b < a; ++b)
          search_piece(worker, Piece<Box, 2>{{{classes[0][a], classes[0][b]}}}, task_of_classes);
      }
      else
        for(Place b = 0; b < classes[1].count; ++b)
          search_piece(worker, Piece<Box, 2>{{{classes[0][a], classes[1][b]}}}, task_of_classes);
  }

  // Searches the boxes by a tree. Boxes that are copies along a common axis are not searched for
  // pairs, so no pair is found in two pieces.
  template <std::size_t Sets>
  void search_tree(const Piece<Box, Sets>& piece)
  {
    const auto report = [&](const Box& a, const Box& b) {
      if(!test_.do_intersect(a.position, b.position))
        return true;
      return a.position < b.position ? report_(a.position, b.position)
                                     : report_(b.position, a.position);
    };
    Box_tree<Box, Test, decltype(report)> tree(test_, report);
    using Boxes_by_sides = std::array<std::vector<const Box*>, std::size_t(1) << axes>;
    std::array<Boxes_by_sides, Sets> boxes;
    for(std::size_t set = 0; set < Sets; ++set)
      for(const Box* box = piece[set].first; box != piece[set].last; ++box)
        boxes[set][box->sides].push_back(box);
    bool goes_on = true;
    for(std::size_t a = 0; a < boxes[0].size(); ++a)
      for(std::size_t b = Sets == 1 ? a : 0; b < boxes[0].size(); ++b)
        if((a & b) == 0 && goes_on)
          goes_on = Sets == 1 && a == b ? tree.within(boxes[0][a])
                                        : tree.between(boxes[0][a], boxes[Sets - 1][b]);
  }

  // Advances the progress by the boxes that are no copies: each is finished in one piece.
  template <std::size_t Sets>
  void finish(const Piece<Box, Sets>& piece, const Piece_task& task)
  {
    if(!task.has_progress)
      return;
    std::size_t finished = 0;
    for(const auto& span : piece)
      for(const Box* box = span.first; box != span.last; ++box)
        finished += box->sides == 0;
    if(!report_.is_stopped() && !progress_.advance(finished))
      report_.stop();
  }

  const Test& test_;
  Report& report_;
  Progress& progress_;
  const Box_tuning tuning_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H
