// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Few boxes are compared each with each, on the stack. They get the pairs that CGAL reports, in an
// order that the input tells, and no memory.

#include "support/check_pairs.h"
#include "support/counting_allocator.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_box_intersection_d.h>

using namespace test_support;

namespace {

template <int Dimension>
using Box = CGAL::Box_intersection_d::Box_d<double, Dimension>;

constexpr std::size_t max_size = 68; // a few more than are compared each with each

// Boxes with corners on a grid, so that many touch. Some are flat.
template <int Dimension>
std::vector<Box<Dimension>> boxes_on_grid(std::size_t size, unsigned int seed, int min_side)
{
  std::mt19937 random(seed);
  std::vector<Box<Dimension>> boxes;
  while(boxes.size() < size) {
    double low[Dimension], high[Dimension];
    for(int axis = 0; axis < Dimension; ++axis) {
      low[axis] = static_cast<double>(random() % 12);
      high[axis] = low[axis] + min_side + static_cast<double>(random() % 3);
    }
    boxes.emplace_back(low, high);
  }
  return boxes;
}

// The pairs of ids that a search reports, and in their order.
template <class Search>
Pairs pairs_of(const Search& search)
{
  Pairs pairs;
  search([&](const auto& a, const auto& b) { pairs.emplace_back(a.id(), b.id()); });
  return pairs;
}

template <int Dimension>
void check_all_sizes(int min_side)
{
  using CGAL::Box_intersection_d::BIPARTITE;
  for(const auto topology : {CGAL::Box_intersection_d::CLOSED, CGAL::Box_intersection_d::HALF_OPEN})
    for(std::size_t size = 0; size <= max_size; ++size) {
      const unsigned int seed = 7 + static_cast<unsigned int>(size);
      const auto boxes = boxes_on_grid<Dimension>(size, seed, min_side);
      const auto others = boxes_on_grid<Dimension>(size / 3, 1, min_side);
      BOOST_TEST_CONTEXT(size << " boxes, topology " << topology) {
        auto a = boxes, b = others; // the other search moves the boxes
        const auto self = [&](const auto& callback) {
          CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(), callback, 10, topology);
        };
        const Pairs pairs = pairs_of(self);
        check_pairs("one set", pairs_of([&](const auto& callback) {
          CGAL::box_self_intersection_d(a.begin(), a.end(), callback, std::ptrdiff_t(10), topology);
        }), pairs);
        BOOST_CHECK(pairs == pairs_of(self));
        check_pairs("two sets", pairs_of([&](const auto& callback) {
          CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), callback,
                                   std::ptrdiff_t(10), topology, BIPARTITE);
        }), pairs_of([&](const auto& callback) {
          CGAL::thick_box_intersection_d(boxes.begin(), boxes.end(), others.begin(), others.end(),
                                         callback, 10, topology);
        }));
      }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(pairs_of_few_boxes_are_those_of_cgal)
{
  for(const int min_side : {0, 1}) { // with flat boxes, and without
    check_all_sizes<2>(min_side);
    check_all_sizes<3>(min_side);
  }
}

BOOST_AUTO_TEST_CASE(few_boxes_meet_none_of_an_empty_range)
{
  const auto boxes = boxes_on_grid<2>(20, 5, 3);
  const auto report = [](const auto&, const auto&) { BOOST_ERROR("a pair of one range"); };
  CGAL::thick_box_intersection_d(boxes.begin(), boxes.end(), boxes.end(), boxes.end(), report);
  CGAL::thick_box_intersection_d(boxes.end(), boxes.end(), boxes.begin(), boxes.end(), report);
}

BOOST_AUTO_TEST_CASE(few_boxes_need_no_memory)
{
  for(std::size_t size = 0; size <= 64; ++size) {
    const auto boxes = boxes_on_grid<3>(size, 4, 1);
    std::size_t count = 0;
    const auto search = [&] {
      const Memory_that_runs_out none(0);
      const auto add = [&](const auto&, const auto&) { ++count; };
      CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(), add);
    };
    BOOST_CHECK_NO_THROW(search());
  }
}
