// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route against the recursive route, on many small structured scenes and on large skewed
// ones; and what it does to pairs that lie at the limits of slabs.

#include "support/kernels.h"
#include "support/point_source.h"
#include "support/seeds.h"
#include "support/slab_variants.h"

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Plane = Cartesian_points<Kernel, 2>;
using Space = Cartesian_points<Kernel, 3>;

namespace {

double below(Random& random, std::uint64_t n) { return static_cast<double>(random.below(n)); }

// Few points on a coarse lattice whose unit is no binary fraction, moved to either side, and some
// of them by a single bit: ties at the reach, at the limits of slabs, and next to both.
Points structured_scene(Random& random, int dimension, double unit)
{
  const double offset = (below(random, 3) - 1) * 0.368;
  const std::uint64_t side = 1 + random.below(30);
  Points points;
  for(double n = below(random, 40); n > 0; --n) {
    Coordinates c;
    for(int axis = 0; axis < dimension; ++axis) {
      double x = offset + unit * below(random, axis == 0 ? side : 1 + random.below(side));
      if(random.below(8) == 0)
        x = std::nextafter(x, random.below(2) != 0 ? infinity : -infinity);
      c.push_back(x);
    }
    points.push_back(c);
  }
  return points;
}

template <int Dimension>
void check_structured_scene(std::uint64_t seed)
{
  const double units[] = {1, 0.1, 1 / 3., 0.7, 49, 1e-3};
  Random random(seed);
  const double unit = units[seed % 6];
  const auto points = make_points<Cartesian_points<Kernel, Dimension>>(
    structured_scene(random, Dimension, unit));
  const auto bound = CGAL::within_distance(unit * below(random, 12));
  const Slab_tuning tuning = small_tuning(random);
  const Pairs expected = sorted(near_pairs_by_recursion(points, bound, Dimension));
  const Pairs found = sorted(slab_pairs<Dimension>(points, bound, tuning));
  BOOST_REQUIRE_MESSAGE(found == expected, "seed " << seed << ": " << compare(expected, found));
  if(seed % 4 != 0)
    return;
  const std::size_t first_set_size = points.size() / 3;
  BOOST_REQUIRE_MESSAGE(sorted(slab_pairs<Dimension>(points, bound, tuning, first_set_size))
                          == between_sets(expected, first_set_size),
                        "two sets, seed " << seed);
}

template <class Maker>
void check_large_scene(const std::string& name, const Points& points, double r)
{
  const auto made = make_points<Maker>(points);
  const int dimension = static_cast<int>(points.front().size());
  const Pairs expected = near_pairs_by_recursion(made, CGAL::within_distance(r), dimension);
  const Pairs_difference difference
    = compare(expected, near_pairs(made, CGAL::within_distance(r)));
  BOOST_CHECK_MESSAGE(difference.empty(), name << ": " << difference);
  BOOST_CHECK_GT(expected.size(), points.size() / 100);
}

// Coordinates 2^-k: each slab of equal height leaves nearly all points in the lowest one.
Points geometric(int dimension)
{
  Points points;
  for(int k = 0; k < 900; ++k)
    for(int copies = 0; copies < 3; ++copies) {
      Coordinates c(dimension, 1);
      c[k % dimension] = std::ldexp(1., -k);
      points.push_back(c);
    }
  return points;
}

BOOST_AUTO_TEST_CASE(first_structured_scenes) // enough for most errors
{
  for(std::uint64_t seed = 0; seed < 2000; ++seed)
    check_structured_scene<2>(seed);
  for(std::uint64_t seed = 0; seed < 6000; ++seed)
    check_structured_scene<3>(seed);
}

// scripts/fuzz_searches checks more of them.
BOOST_AUTO_TEST_CASE(many_structured_scenes)
{
  check_seeds(120000, check_structured_scene<2>);
  check_seeds(80000, check_structured_scene<3>);
}

// Reaches for which points in the unit cube, or of such clusters, have few pairs or many.
struct Skewed_scenes
{
  double reach, short_reach, flat_reach;
  double cluster_size, cluster_reach;
};

template <class Maker>
void check_skewed_scenes(int dimension, const Skewed_scenes& scenes)
{
  const Points uniform = uniform_points(dimension, 20000, 0, 1, 1);
  check_large_scene<Maker>("uniform", uniform, scenes.reach);
  check_large_scene<Maker>("sparse", uniform, scenes.short_reach);
  for(int axis = 0; axis < dimension; ++axis) {
    Points outlier = uniform;
    outlier[77][axis] = 1e15;
    check_large_scene<Maker>("outlier", outlier, scenes.reach);
    Points flat = uniform;
    for(Coordinates& c : flat)
      c[axis] *= 1e-6;
    check_large_scene<Maker>("flat", flat, scenes.flat_reach);
  }
  check_large_scene<Maker>("clusters",
                           clustered_points(dimension, 20000, 40, scenes.cluster_size, 3),
                           scenes.cluster_reach);
  check_large_scene<Maker>("flight", flight_points(dimension, 20000), 1);
  check_large_scene<Maker>("geometric", geometric(dimension), 1e-9);
}

BOOST_AUTO_TEST_CASE(skewed_scenes_2)
{
  check_skewed_scenes<Plane>(2, {0.01, 0.001, 1e-5, 1. / 256, 1. / 2048});
}
BOOST_AUTO_TEST_CASE(skewed_scenes_3)
{
  check_skewed_scenes<Space>(3, {0.05, 0.01, 0.01, 1. / 64, 1. / 256});
}

// Integers are counted from the lowest coordinate along each axis.
BOOST_AUTO_TEST_CASE(points_that_are_far_out_along_one_axis)
{
  Points points = uniform_points(2, 500, 0, 1, 5);
  for(Coordinates& c : points)
    c[1] += 1e6;
  const auto made = make_points<Plane>(points);
  const auto bound = CGAL::within_distance(0.1);
  BOOST_CHECK(sorted(slab_pairs<2>(made, bound, Slab_tuning()))
              == sorted(near_pairs_by_recursion(made, bound, 2)));
}

BOOST_AUTO_TEST_CASE(half_of_the_points_at_one_place)
{
  Points crowd = uniform_points(2, 2000, 0, 1, 4);
  for(std::size_t i = 0; i < crowd.size(); i += 2)
    crowd[i] = {0.25, 0.75};
  check_large_scene<Plane>("half of them at one place", crowd, 0.001);
}

// The limit of the points looked at for borders, per n + k.
const double max_border_points = 16;

// Points whose pairs in reach are left undecided and counted.
template <int Dimension>
struct Undecided_points : Point_source<Dimension>
{
  using Point_source<Dimension>::Point_source;

  bool is_pair(std::size_t, std::size_t, internal::Decision_counts&) const override
  {
    ++count;
    return false;
  }

  mutable std::size_t count = 0;
};

// What a sweep looks at: pairs of places, and points of strips, to find the borders. Each of the
// blocks that a slab is swept in looks at all of its points.
struct Work
{
  double candidates = 0;
  double border_points = 0;
};

template <int Dimension>
using Strips_of = internal::Strips<internal::Slab_point<Dimension, double>>;

// The points of two slabs, and those of their strips within reach, once for each two of them.
template <int Dimension>
double border_points(const Strips_of<Dimension>& a, const Strips_of<Dimension>& b, double reach)
{
  double count = &a == &b ? 0 : a.size() + b.size();
  if(Dimension == 3)
    for(const auto& p : a.strips())
      for(const auto& q : b.strips())
        if(&p != &q && (&a != &b || &p < &q) && q.box[1].low - p.box[1].high <= reach
           && p.box[1].low - q.box[1].high <= reach)
          count += p.size() + q.size();
  return count;
}

template <int Dimension>
Work work_of(const Points& points, double reach, const internal::Point_sets& sets)
{
  using Point = internal::Slab_point<Dimension, double>;
  const Undecided_points<Dimension> undecided(points);
  const internal::Near_task<Dimension> task = undecided.task(reach);
  const internal::Slab_tuning tuning;
  const internal::Slabs<Point> slabs(undecided.reader(), reach, sets, internal::Threads(), tuning);
  const internal::Slab_column<Point> column(slabs, 0, reach, false);
  const auto ignore = [](std::size_t, std::size_t) {};
  internal::Callback_taker<internal::One_set, decltype(ignore)> taker({}, ignore);
  internal::Stop_flag stop;
  internal::Near_sweep<Point> near_sweep(internal::question_of<double>(task), undecided, task,
                                         taker, stop);
  internal::Slab_sweep<Point> sweep(reach, near_sweep);
  internal::Slab_window<Point> window(column, reach, 0, tuning);
  typename internal::Slab_window<Point>::Slabs_nearby nearby;
  Work work;
  for(; window.front(); window.pop()) {
    const Strips_of<Dimension>& slab = *window.front();
    window.find_within_reach(slab.interval(Dimension - 1).high, nearby);
    sweep.between(slab, nearby);
    const double blocks = 1 + slab.candidates() / tuning.candidates_per_block;
    for(const Strips_of<Dimension>* other : nearby)
      work.border_points += blocks * border_points<Dimension>(slab, *other, reach);
  }
  work.candidates = static_cast<double>(undecided.count);
  return work;
}

template <int Dimension>
void check_candidates(const std::string& name, const Points& points, double r, double limit,
                      const internal::Point_sets& sets = {})
{
  using Maker = Cartesian_points<Kernel, Dimension>;
  std::size_t k = 0; // in the union of the sets
  CGAL::fixed_radius_near_neighbors(make_points<Maker>(points), CGAL::within_distance(r),
                                    [&](std::size_t, std::size_t) { ++k; });
  const double size = static_cast<double>(points.size() + k);
  const Work work = work_of<Dimension>(points, r, sets);
  BOOST_TEST_MESSAGE(Dimension << "D " << name << ", r = " << r << ", per n + k: candidates "
                               << work.candidates / size << ", border points "
                               << work.border_points / size);
  BOOST_CHECK_MESSAGE(work.candidates <= limit * size,
                      Dimension << "D " << name << ", r = " << r << ": " << work.candidates / size);
  BOOST_CHECK_MESSAGE(work.border_points <= max_border_points * size,
                      Dimension << "D " << name << ", r = " << r << ", border points: "
                                << work.border_points / size);
}

// Lines along and across the slabs, sparse or not; clusters; points that fill no slab.
template <int Dimension>
void check_candidates_of_scenes(double limit)
{
  const Points uniform = uniform_points(Dimension, 20000, 0, 1, 1);
  for(const double r : {1e-6, 1e-3, 1e-2, 3e-2})
    check_candidates<Dimension>("uniform", uniform, r, limit);
  for(int axis = 0; axis < Dimension; ++axis)
    for(const double r : {1e-6, 1e-5, 1e-3}) {
      Points line = uniform;
      Points plate = uniform;
      for(std::size_t i = 0; i < line.size(); ++i)
        for(int other = 0; other < Dimension; ++other) {
          line[i][other] = other == axis ? uniform[i][axis] : 0.5;
          plate[i][other] = other == axis ? 0.5 : uniform[i][other];
        }
      check_candidates<Dimension>("line along " + std::to_string(axis), line, r, limit);
      check_candidates<Dimension>("plate across " + std::to_string(axis), plate, r, limit);
    }
  check_candidates<Dimension>("clusters", clustered_points(Dimension, 20000, 40, 1. / 256, 3),
                              1. / 2048, limit);
  check_candidates<Dimension>("flight", flight_points(Dimension, 20000), 1, limit);
}

// Thin scenes in space, each with an outlier along one axis and without: wires along an axis, which
// end a reach or many from each other across it; bars and plates; a cross of wires; and two plates.
void check_thin_scenes()
{
  const std::size_t n = 30000;
  const Points uniform = uniform_points(3, n, 0, 1, 2);
  const double r = 1. / static_cast<double>(n);
  for(const double height : {1e-4, 4.5, 9., 40.})
    for(int axis = 0; axis < 3; ++axis)
      for(int out = -1; out < 3; ++out) {
        Points bar = uniform, plate = uniform;
        const double reach = std::sqrt(r * height); // of the plate
        for(std::size_t i = 0; i < n; ++i)
          for(int other = 0; other < 3; ++other)
            (other == axis ? plate : bar)[i][other] *= height * (other == axis ? reach : r);
        if(out >= 0)
          bar[77][out] = plate[77][out] = 1e12;
        const std::string name = std::to_string(height) + " reaches, axis " + std::to_string(axis)
                                 + ", outlier " + std::to_string(out);
        check_candidates<3>("bar, " + name, bar, r, 10);
        check_candidates<3>("plate, " + name, plate, reach, 10);
      }
  Points cross = uniform;
  for(std::size_t i = 0; i < n; ++i)
    cross[i] = i % 2 ? Coordinates{uniform[i][0], 0.3, 0.1} : Coordinates{0.3, uniform[i][0], 0.7};
  check_candidates<3>("cross", cross, r, 10);

  // One of the strips of the lower plate meets all strips of the upper plate.
  Points plates = uniform;
  for(std::size_t i = 0; i < n; ++i) {
    plates[i][2] = (i % 2 + uniform[i][2]) * 3e-8;
    if(i % 2 || i % 100 == 0)
      plates[i][1] = 0.5 + uniform[i][1] / 2000;
  }
  check_candidates<3>("two plates", plates, 1e-8, 10);
}

// Points of one set on a line, points of the other one in a plane, in bands along an axis; and
// scenes whose sample shows next to nothing of them.
template <int Dimension>
void check_two_sets(double limit)
{
  const std::size_t n = 30000;
  const Points uniform = uniform_points(Dimension, n, 0, 1, 3);
  for(int axis = 0; axis < Dimension; ++axis)
    for(const double width : {0.01, 0.9}) {
      Points points = uniform;
      for(std::size_t i = 0; i < n; ++i) {
        double& x = points[i][axis];
        x = (std::floor(62 * x) + width * uniform[i][(axis + 1) % Dimension]) / 62;
        if(i < n / 2)
          for(int other = 0; other < Dimension; ++other)
            points[i][other] = other == axis ? x : 0.5;
      }
      for(const double r : {1e-12, 1e-6, 1e-4})
        for(const std::size_t first_size : {n / 2, n / 10})
          check_candidates<Dimension>("line and plane, axis " + std::to_string(axis), points, r,
                                      limit, {static_cast<internal::Place>(first_size)});
    }
  Points misleading = uniform;
  for(std::size_t s = 0; s < internal::sample_size; ++s)
    for(double& x : misleading[s * n / internal::sample_size])
      x = 0.5 + 1e-9 * x;
  check_candidates<Dimension>("misleading sample", misleading, 1e-3, limit);
}

BOOST_AUTO_TEST_CASE(thin_scenes_cost_no_more_than_others) { check_thin_scenes(); }
BOOST_AUTO_TEST_CASE(two_sets_cost_no_more_than_their_union_2) { check_two_sets<2>(4); }
BOOST_AUTO_TEST_CASE(two_sets_cost_no_more_than_their_union_3) { check_two_sets<3>(8); }
BOOST_AUTO_TEST_CASE(candidates_are_few_2) { check_candidates_of_scenes<2>(4); }
BOOST_AUTO_TEST_CASE(candidates_are_few_3) { check_candidates_of_scenes<3>(8); }

// Extents that overflow, and reaches below the smallest normal number.
BOOST_AUTO_TEST_CASE(extents_without_end)
{
  const auto points = make_points<Plane>({{-1e308, 0}, {1e308, 0}, {1e308, 5e-324}, {0, 1e308}});
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(1)) == (Pairs{{1, 2}}));
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(5e-324)) == (Pairs{{1, 2}}));
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(0)).empty());
  BOOST_CHECK_EQUAL(near_pairs(points, CGAL::within_distance(1e308)).size(), 1u);
}

} // namespace
