// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route against the book route, on many small structured scenes and on large skewed ones;
// and what it does to pairs that lie at the limits of slabs.

#define BOOST_TEST_MODULE slab_route
#include "support/kernels.h"
#include "support/point_generators.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>

#include <random>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Plane = Cartesian_points<Kernel, 2>;
using Space = Cartesian_points<Kernel, 3>;

namespace {

using Generator = std::mt19937_64;

double below(Generator& random, std::uint64_t n) { return static_cast<double>(random() % n); }

// Few points on a coarse lattice whose unit is no binary fraction, moved to either side, and some
// of them by a single bit: ties at the reach, at the limits of slabs, and next to both.
Points structured_scene(Generator& random, int dimension, double unit)
{
  const double offset = (below(random, 3) - 1) * 0.368;
  const std::uint64_t side = 1 + random() % 30;
  Points points;
  for(double n = below(random, 60); n > 0; --n) {
    Coordinates c;
    for(int axis = 0; axis < dimension; ++axis) {
      const double x = offset + unit * below(random, axis == 0 ? side : 1 + random() % side);
      const double infinity = std::numeric_limits<double>::infinity();
      c.push_back(random() % 8 == 0 ? std::nextafter(x, random() % 2 ? infinity : -infinity) : x);
    }
    points.push_back(c);
  }
  return points;
}

template <class Maker>
void check_structured_scenes(int dimension, unsigned int scenes)
{
  const double units[] = {1, 0.1, 1 / 3., 0.7, 49, 1e-3};
  for(unsigned int seed = 0; seed < scenes; ++seed) {
    Generator random(seed);
    const double unit = units[seed % 6];
    const Points points = structured_scene(random, dimension, unit);
    const auto bound = CGAL::within_distance(unit * below(random, 12));
    const auto made = make_points<Maker>(points);
    const Pairs expected = sorted(near_pairs_by_the_book(made, bound, dimension));
    const Pairs found = sorted(near_pairs(made, bound));
    BOOST_REQUIRE_MESSAGE(found == expected,
                          "seed " << seed << ": " << compare(expected, found));

    const auto middle = made.begin() + static_cast<std::ptrdiff_t>(made.size() / 3);
    const std::vector<typename Maker::Point> a(made.begin(), middle), b(middle, made.end());
    Pairs between;
    for(const Pair& p : expected)
      if(p.first < a.size() && p.second >= a.size())
        between.emplace_back(p.first, p.second - a.size());
    BOOST_REQUIRE_MESSAGE(sorted(near_pairs(a, b, bound)) == between, "two sets, seed " << seed);
  }
}

template <class Maker>
void check_large_scene(const std::string& name, const Points& points, double r)
{
  const auto made = make_points<Maker>(points);
  const int dimension = static_cast<int>(points.front().size());
  const Pairs expected = near_pairs_by_the_book(made, CGAL::within_distance(r), dimension);
  const Pairs_difference difference
    = compare(expected, near_pairs(made, CGAL::within_distance(r)));
  BOOST_CHECK_MESSAGE(difference.empty(), name << ": " << difference);
  BOOST_CHECK_GT(expected.size(), points.size() / 100);
}

Points flights(int dimension, std::size_t n)
{
  Generator random(5);
  Points points = {Coordinates(dimension, 0)};
  while(points.size() < n) { // Levy flight: steps of every length
    Coordinates c = points.back();
    const double step = 1 / (1e-9 + std::ldexp(static_cast<double>(random() >> 11), -53));
    for(double& x : c)
      x += step * (std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5);
    points.push_back(c);
  }
  return points;
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

} // namespace

BOOST_AUTO_TEST_CASE(structured_scenes_2) { check_structured_scenes<Plane>(2, 60000); }
BOOST_AUTO_TEST_CASE(structured_scenes_3) { check_structured_scenes<Space>(3, 30000); }

BOOST_AUTO_TEST_CASE(skewed_scenes_2)
{
  const Points uniform = uniform_points(2, 20000, 0, 1, 1);
  check_large_scene<Plane>("uniform", uniform, 0.01);
  check_large_scene<Plane>("sparse", uniform, 0.001);
  for(int axis = 0; axis < 2; ++axis) {
    Points outlier = uniform;
    outlier[77][axis] = 1e15;
    check_large_scene<Plane>("outlier", outlier, 0.01);
    Points flat = uniform;
    for(Coordinates& c : flat)
      c[axis] *= 1e-6;
    check_large_scene<Plane>("flat", flat, 1e-5);
  }
  check_large_scene<Plane>("clusters", clustered_points(2, 20000, 40, 1. / 256, 3), 1. / 2048);
  check_large_scene<Plane>("flight", flights(2, 20000), 1);
  check_large_scene<Plane>("geometric", geometric(2), 1e-9);
  Points crowd = uniform_points(2, 2000, 0, 1, 4);
  for(std::size_t i = 0; i < crowd.size(); i += 2)
    crowd[i] = {0.25, 0.75};
  check_large_scene<Plane>("half of them at one place", crowd, 0.001);
}

BOOST_AUTO_TEST_CASE(skewed_scenes_3)
{
  const Points uniform = uniform_points(3, 20000, 0, 1, 1);
  check_large_scene<Space>("uniform", uniform, 0.05);
  check_large_scene<Space>("sparse", uniform, 0.01);
  for(int axis = 0; axis < 3; ++axis) {
    Points outlier = uniform;
    outlier[77][axis] = 1e15;
    check_large_scene<Space>("outlier", outlier, 0.05);
    Points flat = uniform;
    for(Coordinates& c : flat)
      c[axis] *= 1e-6;
    check_large_scene<Space>("flat", flat, 0.01);
  }
  check_large_scene<Space>("clusters", clustered_points(3, 20000, 40, 1. / 64, 3), 1. / 256);
  check_large_scene<Space>("flight", flights(3, 20000), 1);
  check_large_scene<Space>("geometric", geometric(3), 1e-9);
}

namespace {

namespace internal = CGAL::Thick_intersection_d::internal;

// How many pairs of places a sweep looks at: in sorted parts within a reach of each other, those
// within a reach along axis 0. Counted on the parts, without the sweep.
template <int Dimension>
class Candidate_counter
{
public:
  Candidate_counter(const Points& points, double reach)
    : elements_(points), columns_(elements_, 0, points.size()), reach_(reach),
      slabs_(internal::Slab_order<CGAL::Sequential_tag, Dimension>(columns_, reach)())
  {}

  std::size_t operator()() const { return within(slabs_); }

private:
  // Lets the columns read coordinates.
  struct Point
  {
    const Coordinates& c;
    double cartesian(int i) const { return c[static_cast<std::size_t>(i)]; }
  };
  struct Elements
  {
    explicit Elements(const Points& points) : points_(points) {}
    Point operator[](std::size_t i) const { return {points_[i]}; }
    const Points& points_;
  };

  std::size_t within(const internal::Parts& parts) const
  {
    std::size_t count = 0;
    for(std::size_t p = 0; p < parts.size(); ++p) {
      count += parts[p].children.empty() ? between(parts[p], parts[p]) / 2
                                         : within(parts[p].children);
      for(std::size_t q = p + 1; q < parts.size(); ++q)
        if(parts[q].low - parts[p].high <= reach_)
          count += between(parts[p], parts[q]);
    }
    return count;
  }

  std::size_t between(const internal::Part& p, const internal::Part& q) const
  {
    std::size_t count = 0;
    if(p.children.empty()) {
      const double* x = columns_.columns[0].get();
      for(internal::Place i = p.begin; i != p.end; ++i)
        count += static_cast<std::size_t>(
          std::upper_bound(x + q.begin, x + q.end, x[i] + reach_)
          - std::lower_bound(x + q.begin, x + q.end, x[i] - reach_));
      return count;
    }
    for(const internal::Part& c : p.children)
      for(const internal::Part& d : q.children)
        if(c.low - d.high <= reach_ && d.low - c.high <= reach_)
          count += between(c, d);
    return count;
  }

  Elements elements_;
  internal::Slab_points<Dimension> columns_;
  double reach_;
  internal::Parts slabs_;
};

template <int Dimension>
void check_candidates(const std::string& name, const Points& points, double r, double limit)
{
  using Maker = Cartesian_points<Kernel, Dimension>;
  const std::size_t k
    = near_pairs(make_points<Maker>(points), CGAL::within_distance(r)).size();
  const double work = static_cast<double>(Candidate_counter<Dimension>(points, r)())
                      / static_cast<double>(points.size() + k);
  BOOST_TEST_MESSAGE(Dimension << "D " << name << ": candidates/(n + k) " << work);
  BOOST_CHECK_MESSAGE(work <= limit, Dimension << "D " << name << ": " << work);
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
      check_candidates<Dimension>("line", line, r, limit);
      check_candidates<Dimension>("plate", plate, r, limit);
    }
  check_candidates<Dimension>("clusters", clustered_points(Dimension, 20000, 40, 1. / 256, 3),
                              1. / 2048, limit);
  check_candidates<Dimension>("flight", flights(Dimension, 20000), 1, limit);
}

} // namespace

BOOST_AUTO_TEST_CASE(candidates_are_few_2) { check_candidates_of_scenes<2>(8); }
BOOST_AUTO_TEST_CASE(candidates_are_few_3) { check_candidates_of_scenes<3>(12); }

// Extents that overflow, and reaches below the smallest normal number.
BOOST_AUTO_TEST_CASE(extents_without_end)
{
  const auto points = make_points<Plane>({{-1e308, 0}, {1e308, 0}, {1e308, 5e-324}, {0, 1e308}});
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(1)) == (Pairs{{1, 2}}));
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(5e-324)) == (Pairs{{1, 2}}));
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(0)).empty());
  BOOST_CHECK_EQUAL(near_pairs(points, CGAL::within_distance(1e308)).size(), 1u);
}
