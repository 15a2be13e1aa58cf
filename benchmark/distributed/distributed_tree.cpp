// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// ArborX's distributed tree, asked for the points in a ball around each point. Where a point is
// found, it is counted: results are not sent back.

#include "Processes.h"
#include "tables.h"

#include <ArborX_DistributedTree.hpp>

#include <Kokkos_Core.hpp>

namespace thick_benchmark {
namespace {

using Space = Kokkos::Serial;
using Point = ArborX::Point<3, double>;
using Numbered_point = ArborX::PairValueIndex<Point, std::uint64_t>;
using Points = Kokkos::View<Numbered_point*, Space>;

struct Balls
{
  Points points;
  double r;
};

struct Report
{
  Tally* tally;

  template <class Ball>
  void operator()(const Ball& ball, const Numbered_point& other) const
  {
    tally->neighbour(ArborX::getData(ball), other.index);
  }
};

} // namespace
} // namespace thick_benchmark

template <>
struct ArborX::AccessTraits<thick_benchmark::Balls>
{
  using memory_space = thick_benchmark::Space::memory_space;

  static std::size_t size(const thick_benchmark::Balls& balls) { return balls.points.size(); }
  static auto get(const thick_benchmark::Balls& balls, std::size_t i)
  {
    const thick_benchmark::Numbered_point& point = balls.points(i);
    return attach(intersects(Sphere<3, double>{point.value, balls.r}), point.index);
  }
};

namespace thick_benchmark {

Tally search_distributed_tree(const Scene& share, std::size_t first)
{
  static const Kokkos::ScopeGuard guard;
  const Points points(Kokkos::view_alloc("points", Kokkos::WithoutInitializing), share.size());
  for(std::size_t i = 0; i < share.size(); ++i) {
    const double* const x = share.point(i);
    points(i) = {{x[0], x[1], x[2]}, first + i};
  }
  const ArborX::DistributedTree tree(MPI_COMM_WORLD, Space(), points);
  Tally tally;
  tree.query(Space(), Balls{points, share.r}, Report{&tally});
  return tally;
}

} // namespace thick_benchmark
