// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H

// The divide and conquer of [V03] for boxes of any sizes: boxes are cut into pieces, with copies of
// those that meet several pieces, and each piece is swept. doc/searches.md describes it.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_order.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_planner.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_sweep.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_tree.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Cut_boxes.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Axes>
class Box_route
{
  using Box = Piece_box<Axes>;

  // What a thread needs for its pieces.
  struct Worker
  {
    explicit Worker(const Box_tuning& tuning) : planner(tuning) {}

    Box_planner<Axes> planner;
    Box_order<Axes> order;
  };

public:
  Box_route(Box_client<Axes>& client, const Threads& threads,
            const Box_tuning& tuning = Box_tuning())
    : client_(client), threads_(threads), tuning_(tuning)
  {}

  // Gives the pairs of one set, or of two, to the client. Returns false iff it was stopped.
  bool search(const Piece<Box>& boxes)
  {
    Worker worker(tuning_);
    search_piece(worker, boxes, {first_box_sample, max_box_cuts, boxes.size()});
    return !stop_.is_set();
  }

  // How many boxes were swept, as themselves or as copies, and how many candidates they had.
  std::uint64_t swept_count() const { return swept_count_; }
  std::uint64_t candidate_count() const { return candidate_count_; }

private:
  // What is known about a piece, and allowed in it.
  struct Piece_task
  {
    std::size_t sample_limit;
    int cuts_left;
    std::uint64_t copies_left;
    int sweep_axis = 0;
    bool may_be_swept = false;  // whether it is worth a try to sweep at once
    bool is_one_class = false;  // whether all boxes of a set are long along the same axes
    bool finishes_boxes = true; // whether the boxes are finished when the piece is
  };

  void search_piece(Worker& worker, const Piece<Box>& piece, const Piece_task& task)
  {
    if(stop_.is_set())
      return;
    Box_order<Axes>& order = worker.order;
    if(!piece.has_pairs())
      return finish(piece, task);
    if(piece.size() <= tuning_.few_boxes || task.may_be_swept) {
      order.set(piece, task.sweep_axis, tuning_);
      if(order.candidate_count() <= tuning_.usual_box_candidates * piece.size()
         || piece.size() <= tuning_.few_boxes)
        return sweep_boxes(order, piece, task);
    }
    plan_piece(worker, piece, task);
  }

  // Cuts the boxes, or sweeps them, or searches them in another way if they are crowded: if there
  // are many candidates, and few of them are pairs. The sample shows most crowds before they are
  // put in order.
  void plan_piece(Worker& worker, const Piece<Box>& piece, const Piece_task& task)
  {
    const Box_plan<Axes> plan = worker.planner.plan(piece, task.sample_limit);
    if(plan.cut_axis >= 0 && task.cuts_left > 0 && search_cut(worker, piece, task, plan))
      return;
    if(plan.candidates > tuning_.crowded_candidates && plan.pair_share < tuning_.crowded_share
       && search_crowd(worker, piece, task, plan, plan.candidates))
      return;
    Box_order<Axes>& order = worker.order;
    order.set(piece, plan.sweep_axis, tuning_);
    const double candidates = static_cast<double>(order.candidate_count()) / piece.size();
    const auto is_wanted = [&](Place i, Place j) {
      return !client_.have_groups || client_.is_wanted(i, j);
    };
    if(candidates > tuning_.crowded_candidates
       && order.share_of_pairs(is_wanted) < tuning_.crowded_share
       && search_crowd(worker, piece, task, plan, candidates))
      return;
    if(client_.have_groups && candidates > candidates_for_tree(piece.size()))
      sweep_while_wanted(worker, piece, task, plan, candidates);
    else
      sweep_boxes(order, piece, task);
  }

  // Searches crowded boxes by classes or by a tree. Returns false if a sweep is faster.
  bool search_crowd(Worker& worker, const Piece<Box>& piece, const Piece_task& task,
                    const Box_plan<Axes>& plan, double candidates)
  {
    if(!task.is_one_class && search_classes(worker, piece, task, plan))
      return true;
    if(candidates <= candidates_for_tree(piece.size()))
      return false;
    if(!Box_tree<Box>(client_, stop_).search(piece))
      stop_.set();
    finish(piece, task);
    return true;
  }

  // From how many candidates per box on the tree is faster than a sweep.
  double candidates_for_tree(double size) const
  {
    return tuning_.tree_candidates * std::ldexp(std::log2(size), Axes - 1);
  }

  // Searches the pieces of a cut. Returns false if there would be too many copies.
  bool search_cut(Worker& worker, const Piece<Box>& piece, const Piece_task& task,
                  const Box_plan<Axes>& plan)
  {
    const Equal_cut equal_cut(plan.range, plan.piece_count);
    Cut_boxes<Box> cut(piece, plan.cut_axis, equal_cut, threads_);
    const std::uint64_t copies = cut.size() - piece.size();
    if(copies > task.copies_left)
      return false;
    cut.distribute();
    Piece_task task_of_pieces = task;
    task_of_pieces.sample_limit = box_sample;
    task_of_pieces.cuts_left = task.cuts_left - 1;
    task_of_pieces.copies_left = task.copies_left - copies;
    task_of_pieces.sweep_axis = plan.sweep_axis;
    task_of_pieces.may_be_swept = plan.candidates <= tuning_.usual_box_candidates;
    for_each_piece(worker, equal_cut.count(), [&](Worker& own_worker, Place p) {
      search_piece(own_worker, cut.piece(p), task_of_pieces);
    });
    return true;
  }

  // In parallel, a thread that waits for pieces may take another task, so tasks share no worker.
  template <class Task>
  void for_each_piece(Worker& worker, Place count, const Task& task)
  {
    stop_.run_blocks(threads_, count, [&](std::size_t piece, std::size_t last) {
      if(threads_.are_many()) {
        Worker own_worker(tuning_);
        for(; piece != last; ++piece)
          task(own_worker, static_cast<Place>(piece));
      }
      else
        for(; piece != last; ++piece)
          task(worker, static_cast<Place>(piece));
    });
  }

  // Sweeps the boxes in their order. If there are very many candidates, it sweeps in blocks.
  void sweep_boxes(const Box_order<Axes>& order, const Piece<Box>& piece, const Piece_task& task)
  {
    const std::uint64_t full_blocks = order.candidate_count() / tuning_.candidates_per_block;
    const Place count = static_cast<Place>((std::min)(full_blocks, max_sweep_blocks)) + 1;
    Sweep_allowance allowance;
    swept_count_.fetch_add(piece.size(), std::memory_order_relaxed);
    candidate_count_.fetch_add(order.candidate_count(), std::memory_order_relaxed);
    sweep_blocks(order, task.finishes_boxes ? original_count(piece) : 0, count, allowance);
  }

  // Sweeps crowded boxes that have groups, as long as enough candidates are wanted pairs. When few
  // are left, because pairs of groups have become known, searches the boxes as a crowd.
  void sweep_while_wanted(Worker& worker, const Piece<Box>& piece, const Piece_task& task,
                          const Box_plan<Axes>& plan, double candidates)
  {
    const std::size_t size = task.finishes_boxes ? original_count(piece) : 0;
    Sweep_allowance allowance(std::int64_t(tuning_.unwanted_candidates) * piece.size(),
                              tuning_.candidates_per_wanted_pair);
    const Place count = piece.size() / tuning_.unwanted_candidates + 1;
    sweep_blocks(worker.order, size, count, allowance);
    if(allowance.is_left() || stop_.is_set())
      return;
    Piece_task rest = task;
    rest.finishes_boxes = false;
    search_crowd(worker, piece, rest, plan, candidates);
    advance(size - allowance.finished());
  }

  // Sweeps boxes in `count` blocks, which threads share, and finishes `size` boxes by them. The
  // search can stop after each block, and the sweep ends with its allowance.
  void sweep_blocks(const Box_order<Axes>& order, std::size_t size, Place count,
                    Sweep_allowance& allowance)
  {
    stop_.run_blocks(threads_, count, [&](std::size_t block, std::size_t last) {
      Box_sweep<Axes> box_sweep(client_, stop_);
      for(; block != last && !stop_.is_set() && allowance.is_left(); ++block) {
        const std::uint64_t wanted_before = box_sweep.wanted_count();
        box_sweep.take_block(static_cast<Place>(block), count);
        for(std::size_t set = 0; set < order.set_count() && !stop_.is_set(); ++set)
          box_sweep.between(order.run(set), order.candidates(set));
        const std::size_t finished = size * (block + 1) / count - size * block / count;
        if(client_.have_groups)
          allowance.use(order.candidate_count_of_block(static_cast<Place>(block), count),
                        box_sweep.wanted_count() - wanted_before, finished);
        advance(finished);
      }
    });
  }

  // Searches boxes apart that are long along different axes. Beams along two axes of space are
  // short along the third axis, and beams along one axis are short along the others. So these
  // searches may have few candidates where that of all boxes has many. Returns false if all boxes
  // are of one class.
  bool search_classes(Worker& worker, const Piece<Box>& piece, const Piece_task& task,
                      const Box_plan<Axes>& plan)
  {
    std::array<std::vector<Span<Box>>, 2> classes;
    for(std::size_t set = 0; set < piece.set_count(); ++set)
      classes[set] = divide_into_classes(piece[set], plan.long_lengths);
    if(classes[0].size() + classes[1].size() == piece.set_count())
      return false;
    Piece_task part = task;
    part.may_be_swept = false;
    part.is_one_class = true;
    part.finishes_boxes = false;
    const bool is_one_set = piece.set_count() == 1;
    for(std::size_t a = 0; a < classes[0].size(); ++a) {
      const Span<Box>& boxes = classes[0][a];
      if(is_one_set)
        search_piece(worker, Piece<Box>(boxes), part);
      const auto& others = classes[piece.set_count() - 1];
      for(std::size_t b = 0; b < (is_one_set ? a : others.size()); ++b)
        search_piece(worker, Piece<Box>(boxes, others[b]), part);
      finish(Piece<Box>(boxes), task);
    }
    if(!is_one_set)
      finish(Piece<Box>(piece[1]), task);
    return true;
  }

  // Advances the progress by the boxes of a piece.
  void finish(const Piece<Box>& piece, const Piece_task& task)
  {
    if(task.finishes_boxes)
      advance(original_count(piece));
  }

  // The number of boxes that are no copies. Each box is one in one piece.
  static std::size_t original_count(const Piece<Box>& piece)
  {
    std::size_t count = 0;
    for(const auto& span : piece)
      for(const Box* box = span.first; box != span.last; ++box)
        count += box->sides == 0;
    return count;
  }

  void advance(std::size_t finished)
  {
    if(!stop_.is_set() && !client_.advance(finished))
      stop_.set();
  }

  Box_client<Axes>& client_;
  const Threads threads_;
  const Box_tuning tuning_;
  Stop_flag stop_;
  std::atomic<std::uint64_t> swept_count_ = 0;
  std::atomic<std::uint64_t> candidate_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ROUTE_H
