// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair on the kernels of doubles: every scene, larger ones with ties,
// crowds and extremes, the bounds on the work, bad input, and real data.

#define BOOST_TEST_MODULE closest_pair
#include "support/check_closest_pair.h"
#include "support/counting_minimum.h"
#include "support/data_facts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <list>
#include <random>
#include <set>

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;
using Point = Epick::Point_2;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// The text of the exception that f throws; "" if it throws none.
template <class Function>
std::string refusal(const Function& f)
{
  try {
    f();
  }
  catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class Maker>
void check_float_scenes(int dimension)
{
  for(Point_scene scene : closest_pair_scenes(dimension)) {
    bool is_finite = true;
    for(Coordinates& c : scene.points)
      for(double& x : c) {
        x = static_cast<float>(x);
        is_finite = is_finite && std::isfinite(x);
      }
    if(is_finite)
      check_closest_scene<Maker>(scene);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(epick_2) { check_closest_scenes<Maker<2>>(2); }
BOOST_AUTO_TEST_CASE(epick_3) { check_closest_scenes<Maker<3>>(3); }
BOOST_AUTO_TEST_CASE(double_2) { check_closest_scenes<Cartesian_points<Double_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(double_3) { check_closest_scenes<Cartesian_points<Double_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(float_2) { check_float_scenes<Cartesian_points<Float_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(float_3) { check_float_scenes<Cartesian_points<Float_kernel, 3>>(3); }

// ---- scenes that are large enough for a join ----------------------------------------------------

namespace {

template <int Dimension>
void check_large(const std::string& name, const Points& scene)
{
  BOOST_TEST_CONTEXT(name << ' ' << Dimension << 'D')
  check_closest_and_close_pair<Maker<Dimension>>(scene);
}

template <int Dimension>
void check_large_scenes()
{
  const std::size_t n = 2500;
  const Points uniform = uniform_points(Dimension, n, -0.3, 1, 1);
  const Points lattice
    = shuffled(lattice_points(Dimension, Dimension == 2 ? 40 : 12, 1, -6), 2);
  check_large<Dimension>("uniform", uniform);
  check_large<Dimension>("clusters", clustered_points(Dimension, n, 9, 1. / 4096, 3));
  check_large<Dimension>("lattice", lattice);
  check_large<Dimension>("lattice of tenths", moved(lattice, 0.1, 0));
  check_large<Dimension>("lattice far away", moved(lattice, 1, 1e15));
  check_large<Dimension>("huge", moved(uniform, 1e200, 0));
  check_large<Dimension>("huge lattice", moved(lattice, 1e200, 0));
  check_large<Dimension>("tiny", moved(uniform, 1e-200, 0));
  check_large<Dimension>("denormal", moved(lattice, 5e-324, 0));
  check_large<Dimension>("as large as doubles are", moved(uniform, 1e308, 0));

  Points outlier = uniform;
  outlier[n / 2] = Coordinates(Dimension, 1e15);
  check_large<Dimension>("outlier", outlier);
  Points pair_far_out = outlier; // beyond 2^63 cells of their distance
  pair_far_out[1] = Coordinates(Dimension, 1e15);
  pair_far_out[1][0] = std::nextafter(1e15, 0);
  check_large<Dimension>("pair far out", moved(pair_far_out, 1, 0));

  Points steps; // ever smaller: half of the points are in a cell of any size
  for(int i = 0; i < 1200; ++i)
    steps.push_back(Coordinates(Dimension, std::ldexp(1., -i % 1000) * (1 + i / 1000)));
  check_large<Dimension>("steps to zero", shuffled(steps, 4));

  Points twins = uniform; // neighbours in the input, so that a sample has no twins
  for(std::size_t i = 0; i + 1 < n; i += 2) {
    twins[i + 1] = twins[i];
    twins[i + 1][0] += 1e-9 * (1 + static_cast<double>((i * 7919) % n));
  }
  check_large<Dimension>("twins", twins);
  for(int axis = 0; axis < Dimension; ++axis)
    check_large<Dimension>("line", shuffled(axis_points(Dimension, 1200, axis, -9.9, 0.1), 5));
}

} // namespace

BOOST_AUTO_TEST_CASE(large_scenes_2) { check_large_scenes<2>(); }
BOOST_AUTO_TEST_CASE(large_scenes_3) { check_large_scenes<3>(); }

BOOST_AUTO_TEST_CASE(the_first_two_of_equal_points)
{
  const Points uniform = uniform_points(2, 3000, 0, 1, 6);
  for(const std::size_t copies : {2, 3})
    check_large<2>("copies", shuffled(repeated(uniform, copies), 7));
  Points points = uniform; // two sets of equal points; the second set starts first
  points[2000] = points[2500] = points[1500];
  points[2999] = points[1000];
  check_large<2>("a few copies", points);
  BOOST_CHECK(CGAL::closest_pair(make_points<Maker<2>>(points)) == Pair(1000, 2999));
  points[5] = {0., 1.};
  points[6] = {-0., 1.};
  check_large<2>("plus and minus zero", points);

  const std::vector<Point> same(1000000, Point(1, 2)); // not quadratic
  BOOST_CHECK(CGAL::closest_pair(same) == Pair(0, 1));
  BOOST_CHECK(CGAL::has_close_pair(same, CGAL::within_distance(0)));
  BOOST_CHECK(!CGAL::has_close_pair(same, CGAL::within_distance(0).open()));
  BOOST_CHECK(closest_by_division(same) == Pair(0, 1));
}

// The leaves of the recursion, and what is just above them.
BOOST_AUTO_TEST_CASE(a_few_points_of_a_small_lattice)
{
  std::mt19937_64 random(21);
  for(std::size_t n = 2; n <= 7; ++n)
    for(int repetition = 0; repetition < 100; ++repetition) {
      Points points;
      for(std::size_t i = 0; i < n; ++i)
        points.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 12)});
      BOOST_TEST_CONTEXT(n << " points, repetition " << repetition)
      check_closest_and_close_pair<Maker<2>>(points);
    }
}

// Nearly all points are in the strip, so that it is cut into cells; the closest pair is often in
// two of them.
BOOST_AUTO_TEST_CASE(closest_pair_of_a_wall)
{
  for(std::uint64_t seed = 0; seed < 20; ++seed) {
    Points wall = uniform_points(3, 200, 0, 1, seed);
    for(Coordinates& c : wall)
      c[0] /= 1048576;
    BOOST_TEST_CONTEXT("seed " << seed)
    check_closest_pair<Maker<3>>(wall);
  }
}

// What a join promises: all close pairs are visited, in the order of the input or not.
BOOST_AUTO_TEST_CASE(joins_visit_all_close_pairs)
{
  struct Visitor
  {
    Pairs& visited;
    bool operator()(std::size_t i, std::size_t j)
    {
      visited.push_back(std::minmax(i, j));
      return true;
    }
    void finish() {}
  };
  using Elements = Elements_of<Point>;
  std::size_t joined = 0;
  for(const Point_scene& scene : closest_pair_scenes(2)) {
    const double reach = upper_bound(scene.radius);
    if(!internal::Hashed_cells<2>::fits(reach, 0))
      continue;
    ++joined;
    const auto points = make_points<Maker<2>>(scene.points);
    const Elements elements(points);
    for(const double factor : {2., 16.}) {
      Pairs visited;
      const internal::Cell_join<CGAL::Sequential_tag, 2, Elements> join(elements, reach,
                                                                        factor * reach);
      internal::Unwatched_progress progress;
      join(internal::All_positions(points.size()), [&] { return Visitor{visited}; }, progress);
      std::sort(visited.begin(), visited.end());
      const Pairs& pairs = truth_of(scene).pairs;
      BOOST_CHECK_MESSAGE(std::includes(visited.begin(), visited.end(), pairs.begin(),
                                        pairs.end()), scene << ", factor " << factor);
    }
  }
  BOOST_CHECK_GT(joined, 30u);
}

// ---- the constants of packing -------------------------------------------------------------------

// The corners of a cube with edges as long as the bound, and its centre: 2^d points that are not
// closer, and in dimension 4 one more. All of them are in one cell, as its side is a little longer.
BOOST_AUTO_TEST_CASE(as_many_points_as_a_cell_holds)
{
  const auto corners = make_points<Maker<2>>(lattice_points(2, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners, CGAL::within_distance(3).open()));
  const auto corners_3 = make_points<Maker<3>>(lattice_points(3, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners_3, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners_3, CGAL::within_distance(3).open()));
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(1), 2u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(2), 4u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(3), 8u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(4), 81u); // 17 are possible
}

// Cells of side r: rounded numbers of cells near the end of a cell.
BOOST_AUTO_TEST_CASE(cells_lose_no_pair_at_the_bound)
{
  for(int i = -50; i < 50; ++i) {
    const double x = 2 + std::ldexp(i, -18);
    const std::vector<Point> points = {{0, 0}, {x, 0}, {x + 1, 0}};
    for(const auto access : {internal::Bucket_access::HASHING,
                             internal::Bucket_access::SORTED_ORDER})
      BOOST_CHECK(close_by_buckets(points, CGAL::within_distance(1), access) == Pair(1, 2));
  }
}

// ---- bounds of any size -------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(bounds_of_any_size)
{
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  Points scene = uniform_points(2, 3000, 0, 1, 8);
  scene[10] = {greatest, greatest};
  scene[20] = {-greatest, -greatest};
  scene[30] = {-least, least};
  const auto points = make_points<Maker<2>>(scene);
  for(const double r : {0., least, 1e-300, 1e-20})
    BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(r)));
  for(const double r : {1e-2, 1., 1e100, greatest, infinity})
    BOOST_CHECK(CGAL::has_close_pair(points, CGAL::within_distance(r)));

  scene[40] = {0, least}; // one step to the right
  const auto pair = CGAL::find_close_pair(make_points<Maker<2>>(scene),
                                          CGAL::within_distance(least));
  BOOST_CHECK(pair == Pair(30, 40));
  BOOST_CHECK(!CGAL::has_close_pair(make_points<Maker<2>>(scene),
                                    CGAL::within_distance(least).open()));
}

// ---- the work -----------------------------------------------------------------------------------

namespace {

// Counts how often points are looked at.
template <class Point_>
struct Counted_points
{
  using value_type = Point_;
  const std::vector<Point_>& points;
  std::size_t& count;

  std::size_t size() const { return points.size(); }
  const Point_& operator[](std::size_t i) const
  {
    ++count;
    return points[i];
  }
};

// Points in cells of their own, before them the corners of a cell, which are not closer than 1, and
// behind them five points in a cell, two of which are, but not two of the first four.
std::vector<Point> points_before_a_heavy_cell()
{
  const double side = 1 + std::ldexp(1., -16);
  const double low = 64 * side + std::ldexp(1., -18);
  std::vector<Point> points;
  for(const double x : {0., low})
    for(const Coordinates& c : lattice_points(2, 2, 1))
      points.emplace_back(x + c[0], x + c[1]);
  points.emplace_back(low + 0.5, low + 0.5);
  for(const Coordinates& c : lattice_points(2, 20, 3, 3))
    points.emplace_back(c[0], c[1]);
  return points;
}

// Of the randomised cells, per point.
template <int Dimension>
double looks_of_cells(const Points& scene)
{
  using Counted = Counted_points<typename Maker<Dimension>::Point>;
  const auto points = make_points<Maker<Dimension>>(scene);
  std::vector<std::uint32_t> positions(points.size());
  std::iota(positions.begin(), positions.end(), 0);
  std::size_t looks = 0;
  const Counted counted = {points, looks};
  const internal::Scene scene_of_points =
      scene_of(Elements_of<typename Maker<Dimension>::Point>(points));
  internal::Pair_minimum<Counted> minimum(counted, scene_of_points);
  internal::Closest_pair_cells<Dimension, Counted> cells(counted, positions, scene_of_points, 1);
  internal::Unwatched_progress progress;
  BOOST_CHECK(cells.search(minimum, progress));
  BOOST_TEST_MESSAGE(Dimension << "D cells: " << looks / points.size() << " looks per point");
  return static_cast<double>(looks) / static_cast<double>(points.size());
}

template <int Dimension>
void check_work(const std::string& name, const Points& scene, double max_comparisons)
{
  const auto points = make_points<Maker<Dimension>>(scene);
  const Elements_of<typename Maker<Dimension>::Point> elements(points);
  Work_of_division work;
  Counting_minimum<std::decay_t<decltype(elements)>> minimum(elements, scene_of(elements), work);
  internal::Unwatched_progress progress;
  internal::divide_and_conquer<CGAL::Sequential_tag>(points.size(), Dimension, minimum, progress);
  const double n = static_cast<double>(points.size());
  const double comparisons = static_cast<double>(work.comparisons) / (n * std::log2(n));
  BOOST_TEST_MESSAGE(name << ' ' << Dimension << "D: " << comparisons
                          << " comparisons per n log n, " << work.max_candidates
                          << " candidates of a point at most");
  BOOST_CHECK_MESSAGE(comparisons <= max_comparisons, name << ": " << comparisons);
  BOOST_CHECK_MESSAGE(work.max_candidates <= internal::max_candidate_count(Dimension),
                      name << ": " << work.max_candidates << " candidates");
  BOOST_CHECK_GT(work.max_candidates, 0u);
}

// All points close to the dividing line at each division: distances along axis 0 vanish against
// those along the others.
Points flattened(Points points)
{
  for(Coordinates& c : points)
    c[0] *= 1. / 1048576;
  return points;
}

} // namespace

// Each point for its cell along each axis, and the pairs of the five.
BOOST_AUTO_TEST_CASE(heavy_cell_ends_the_search)
{
  const std::vector<Point> points = points_before_a_heavy_cell();
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(Elements_of<Point>(points));
  const internal::Is_within_distance<Point> is_within(
    internal::Squared_bound<Exact_of<Point>>(CGAL::within_distance(1).open()), 2);
  const internal::Close_pair_buckets<CGAL::Sequential_tag, Counted_points<Point>> buckets(
    counted, scene, is_within);
  internal::Unwatched_progress progress;
  BOOST_CHECK(buckets.find(internal::All_positions(points.size()), progress));
  BOOST_CHECK_LE(looks, 2 * points.size() + 20);
}

BOOST_AUTO_TEST_CASE(randomised_cells_look_at_points_a_few_times)
{
  BOOST_CHECK_LT(looks_of_cells<2>(uniform_points(2, 20000, 0, 1, 22)), 30);
  BOOST_CHECK_LT(looks_of_cells<2>(lattice_points(2, 150, 1)), 30);
  BOOST_CHECK_LT(looks_of_cells<3>(uniform_points(3, 20000, 0, 1, 23)), 30);
  BOOST_CHECK_LT(looks_of_cells<3>(lattice_points(3, 28, 1)), 100);
}

// Squared distances overflow for the first pair only.
BOOST_AUTO_TEST_CASE(first_point_may_be_far_out)
{
  auto points = make_points<Maker<2>>(uniform_points(2, 20000, 0, 1, 26));
  points[0] = Point(1e200, 0);
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(counted);
  internal::Unwatched_progress progress;
  const Pair pair = internal::Closest_pair_search<CGAL::Sequential_tag, Counted_points<Point>,
                                                  internal::Unwatched_progress>(counted, scene, 1,
                                                                         progress).find();
  BOOST_CHECK(pair == closest_by_division(points));
  BOOST_CHECK_LE(looks, 20 * points.size());
}

BOOST_AUTO_TEST_CASE(division_makes_n_log_n_comparisons_in_the_plane)
{
  BOOST_CHECK_EQUAL(internal::max_candidate_count(2), 7u);
  const Points lattice = lattice_points(2, 150, 1);
  check_work<2>("uniform", uniform_points(2, 20000, 0, 1, 9), 8);
  check_work<2>("lattice", lattice, 12);
  check_work<2>("shuffled lattice", shuffled(lattice, 10), 12);
  check_work<2>("flat uniform", flattened(uniform_points(2, 20000, 0, 1, 11)), 12);
  check_work<2>("line across the cuts", axis_points(2, 20000, 0, 0, 1), 12);
  check_work<2>("line along the cuts", axis_points(2, 20000, 1, 0, 1), 12);
  check_work<2>("clusters", clustered_points(2, 20000, 10, 1. / 4096, 12), 12);
}

BOOST_AUTO_TEST_CASE(division_makes_n_log_n_comparisons_in_space)
{
  BOOST_CHECK_EQUAL(internal::max_candidate_count(3), 47u);
  const Points lattice = lattice_points(3, 28, 1);
  check_work<3>("uniform", uniform_points(3, 20000, 0, 1, 13), 12);
  check_work<3>("lattice", lattice, 30);
  check_work<3>("shuffled lattice", shuffled(lattice, 14), 30);
  check_work<3>("flat lattice", flattened(lattice_points(3, 28, 1)), 60);
  check_work<3>("plane", embedded(lattice_points(2, 150, 1), 3), 20);
  Points wall; // the plane x = 0: every point is in every strip
  for(const Coordinates& c : lattice_points(2, 150, 1))
    wall.push_back({0, c[0], c[1]});
  check_work<3>("wall", wall, 30);
  for(int axis = 0; axis < 3; ++axis)
    check_work<3>("line", axis_points(3, 20000, axis, 0, 1), 20);
}

// ---- contracts ----------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(fewer_than_two_points_have_no_closest_pair)
{
  std::vector<Point> points;
  BOOST_CHECK_THROW(CGAL::closest_pair(points), std::invalid_argument);
  BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(1)));
  points.emplace_back(1, 2);
  BOOST_CHECK_THROW(CGAL::closest_pair(points), std::invalid_argument);
  BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(infinity)));
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_by_position)
{
  for(const double bad : {nan_value, infinity, -infinity})
    for(const std::size_t n : {std::size_t(3), std::size_t(5000)}) {
      std::vector<Point> points(n, Point(0, 0)); // with a close pair long before the bad one
      points[n - 1] = Point(0, bad);
      const std::string expected
        = "Coordinate 1 of point " + std::to_string(n - 1) + " is NaN or infinite.";
      BOOST_CHECK_EQUAL(refusal([&] { CGAL::closest_pair(points); }), expected);
      BOOST_CHECK_EQUAL(refusal([&] { CGAL::has_close_pair(points, CGAL::within_distance(1)); }),
                        expected);
    }
  const std::vector<Point> none;
  for(const double bad : {-1., -5e-324, -infinity, nan_value})
    BOOST_CHECK_NE(refusal([&] { CGAL::has_close_pair(none, CGAL::within_distance(bad)); }), "");
}

BOOST_AUTO_TEST_CASE(any_range_of_points_will_do)
{
  const Points scene = uniform_points(2, 2000, 0, 1, 15);
  const auto points = make_points<Maker<2>>(scene);
  const Pair expected = known_closest(scene).pair;
  const auto bound = CGAL::within_distance(0.01);
  const auto close = CGAL::find_close_pair(points, bound);

  const std::list<Point> list(points.begin(), points.end());
  check_pair("list", expected, CGAL::closest_pair(list));
  BOOST_CHECK(CGAL::find_close_pair(list, bound) == close);

  std::vector<std::pair<Point, int>> named;
  for(const Point& p : points)
    named.emplace_back(p, 1);
  const auto np = CGAL::parameters::point_map(
    CGAL::First_of_pair_property_map<std::pair<Point, int>>()).geom_traits(Epick());
  check_pair("map", expected, CGAL::closest_pair(named, np));
  BOOST_CHECK(CGAL::find_close_pair(named, bound, np) == close);
}

BOOST_AUTO_TEST_CASE(close_pair_is_a_function_of_the_input)
{
  const auto points = make_points<Maker<2>>(uniform_points(2, 5000, 0, 1, 16));
  for(const double r : {0.5, 0.01, 0.001})
    BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(r))
                == CGAL::find_close_pair(points, CGAL::within_distance(r)));
}

// ---- progress -----------------------------------------------------------------------------------

namespace {

template <class Scene>
void check_progress_on(const std::string& name, const Scene& scene, std::size_t least_calls)
{
  BOOST_TEST_CONTEXT(name)
  check_progress_of_both<CGAL::Sequential_tag>(make_points<Maker<2>>(scene), least_calls);
}

} // namespace

// By the join, by the grid of few points or of crowded cells, and by divide and conquer.
BOOST_AUTO_TEST_CASE(progress_grows_to_one_and_cancels)
{
  const Points uniform = uniform_points(2, 20000, 0, 1, 17);
  check_progress_on("uniform", uniform, 50);
  check_progress_on("few", uniform_points(2, 300, 0, 1, 18), 2);
  check_progress_on("crowded", clustered_points(2, 20000, 3, 1. / 1048576, 19), 50);
  check_progress_on("huge", moved(uniform, 1e200, 0), 50);
}

// The last step of a search that finds a pair early, and of one that has nothing to do.
BOOST_AUTO_TEST_CASE(progress_ends_at_one)
{
  const auto points = make_points<Maker<2>>(uniform_points(2, 20000, 0, 1, 20));
  const std::vector<Point> same(5000, Point(1, 2)), none;
  const auto find = [](const auto& points) {
    return [&](const auto& np) {
      CGAL::find_close_pair(points, CGAL::within_distance(0.1), np);
    };
  };
  BOOST_CHECK_EQUAL(progress_of(find(points), 2).back(), 1);
  BOOST_CHECK_EQUAL(progress_of(find(same), 2).back(), 1);
  BOOST_CHECK_EQUAL(progress_of(find(none), 2).back(), 1);
  BOOST_CHECK_EQUAL(progress_of([&](const auto& np) { CGAL::closest_pair(same, np); }, 2).back(),
                    1);
}

BOOST_AUTO_TEST_CASE(parts_of_a_search_share_what_is_left_of_the_progress)
{
  std::vector<double> told;
  const Watch watch = {told, 2};
  internal::Watched_progress<Watch> progress(watch, 4);
  for(const std::size_t total : {4, 2}) {
    progress.restart(total);
    progress.advance(1);
    progress.advance(1);
  }
  BOOST_CHECK((told == std::vector<double>{0.25, 0.5, 0.75, 1}));
}

// Once it is cancelled, a search ends with the block of points that it is in.
BOOST_AUTO_TEST_CASE(cancelled_search_looks_at_few_points_more)
{
  const auto points = make_points<Maker<2>>(uniform_points(2, 20000, 0, 1, 25));
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Squared_bound<Exact_of<Point>> zero(CGAL::within_distance(0));
  const internal::Scene scene = scene_of(counted);
  for(const double share : {0., 0.1, 0.3, 0.6, 0.9}) {
    std::size_t before = 0;
    const auto cancel = [&](double done) {
      before = looks;
      return done < share;
    };
    using Progress = internal::Watched_progress<decltype(cancel)>;
    using Counted = Counted_points<Point>;
    Progress progress(cancel, points.size());
    internal::Closest_pair_search<CGAL::Sequential_tag, Counted, Progress>(counted, scene, 1,
                                                                           progress).find();
    BOOST_CHECK_LE(looks - before, 4000u);
    Progress other(cancel, points.size());
    internal::Close_pair_search<CGAL::Sequential_tag, Counted, Progress>(counted, zero, scene,
                                                                         other).find();
    BOOST_CHECK_LE(looks - before, 4000u);
  }
}

// Searches that nobody watches have nothing to keep or to count.
static_assert(std::is_empty_v<internal::Unwatched_progress>);
static_assert(std::is_same_v<decltype(internal::make_progress(CGAL::parameters::default_values(),
                                                              1)),
                             internal::Unwatched_progress>);

// ---- real data ----------------------------------------------------------------------------------

namespace {

template <int Dimension>
void check_data(const Decimal_points& decimals)
{
  const auto doubles = as_exact_doubles(decimals);
  if(!doubles) // a kernel of rationals is for these
    return;
  const auto points = make_points<Maker<Dimension>>(*doubles);
  check_pair("default", closest_of_integers(decimals.coordinates).pair,
             CGAL::closest_pair(points));
  check_pair("division", closest_of_integers(decimals.coordinates).pair,
             closest_by_division(points));
}

} // namespace

BOOST_AUTO_TEST_CASE(files_have_the_closest_pair_of_their_integers)
{
  std::set<std::string> checked;
  for(const Fact& fact : facts())
    if(const auto path = find_data_file(fact.file, data_folders()))
      if(checked.insert(fact.file + std::to_string(fact.dimension)).second)
        BOOST_TEST_CONTEXT(fact)
        {
          const Decimal_points points = read_view(*path, fact.view);
          if(fact.dimension == 2)
            check_data<2>(points);
          else
            check_data<3>(points);
        }
  BOOST_CHECK_GE(checked.size(), 9u); // the shipped files
}
