// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The distributed search, run by any number of processes: the pairs and the lists of neighbors are
// those of brute force, however points are distributed, and if a process fails or stops, all
// processes do.

#define BOOST_TEST_MODULE distributed_near_neighbors
#include "support/brute_force.h"
#include "support/mpi_fixture.h"
#include "support/scenes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>

#include <csignal>
#include <iostream>

using namespace test_support;

namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using On_pair = std::function<bool(std::uint64_t, std::uint64_t)>;

constexpr CGAL::Point_distribution balanced = CGAL::Point_distribution::BALANCED;
constexpr CGAL::Point_distribution as_is = CGAL::Point_distribution::AS_IS;

int rank()
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int process_count()
{
  int size;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

// ---- points and pairs of all processes ----------------------------------------------------------

// Where the points of each process begin: shares of equal size, shares that halve, or all points on
// one process, so that there are empty ones.
enum class Shares { EVEN, SKEWED, FIRST, LAST };

template <class Point>
std::vector<Point> share_of(const std::vector<Point>& all, Shares shares, int process)
{
  const std::size_t n = all.size();
  const auto begin = [&](int r) -> std::size_t {
    if(r == 0 || r == process_count())
      return r == 0 ? 0 : n;
    if(shares == Shares::EVEN)
      return n * static_cast<std::size_t>(r) / static_cast<std::size_t>(process_count());
    return shares == Shares::SKEWED ? n - (n >> r) : shares == Shares::FIRST ? n : 0;
  };
  return std::vector<Point>(all.begin() + static_cast<std::ptrdiff_t>(begin(process)),
                            all.begin() + static_cast<std::ptrdiff_t>(begin(process + 1)));
}

template <class Point>
std::vector<Point> my_share_of(const std::vector<Point>& all, Shares shares)
{
  return share_of(all, shares, rank());
}

// The pairs of all processes, on each process.
Pairs gathered(const Pairs& mine)
{
  const int count = static_cast<int>(mine.size() * sizeof(Pair));
  std::vector<int> counts(static_cast<std::size_t>(process_count())), begins(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  int sum = 0;
  for(std::size_t i = 0; i < counts.size(); ++i) {
    begins[i] = sum;
    sum += counts[i];
  }
  Pairs all(static_cast<std::size_t>(sum) / sizeof(Pair));
  MPI_Allgatherv(mine.data(), count, MPI_BYTE, all.data(), counts.data(), begins.data(), MPI_BYTE,
                 MPI_COMM_WORLD);
  return all;
}

std::uint64_t sum_of_all(std::uint64_t number)
{
  MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return number;
}

double largest_over_average(std::uint64_t number)
{
  std::uint64_t largest = number;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return static_cast<double>(largest) * process_count() / static_cast<double>(sum_of_all(number));
}

void check_equal(const Pairs& expected, const Pairs& mine)
{
  const Pairs_difference difference = compare(expected, gathered(mine));
  BOOST_CHECK_MESSAGE(difference.empty(), difference);
}

const On_pair ignore = [](std::uint64_t, std::uint64_t) { return true; };

On_pair add_to(Pairs& pairs)
{
  return [&pairs](std::uint64_t i, std::uint64_t j) {
    pairs.emplace_back(i, j);
    return true;
  };
}

template <class Point, class NT>
Pairs pairs_of(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& bound,
               CGAL::Point_distribution distribution)
{
  Pairs pairs;
  CGAL::Distributed_profile profile(distribution);
  BOOST_CHECK(CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points, bound,
                                                            add_to(pairs), profile));
  return pairs;
}

template <class Point, class NT>
void check_pairs_of(const std::vector<Point>& mine, const CGAL::Distance_bound<NT>& bound,
                    const Truth& truth)
{
  for(const CGAL::Point_distribution distribution : {balanced, as_is}) {
    check_equal(truth.pairs, pairs_of(mine, bound, distribution));
    check_equal(truth.open_pairs, pairs_of(mine, bound.open(), distribution));
  }
}

std::vector<Point_3> points_3(const Points& all)
{
  std::vector<Point_3> points;
  for(const Coordinates& x : all)
    points.emplace_back(x[0], x[1], x[2]);
  return points;
}

// Thirds of coordinates: no doubles, except where they are.
std::vector<Exact_kernel::Point_2> thirds_of(const Points& all)
{
  std::vector<Exact_kernel::Point_2> points;
  for(const Coordinates& x : all)
    points.emplace_back(Exact_kernel::FT(x[0]) / 3, Exact_kernel::FT(x[1]) / 3);
  return points;
}

// Scenes where the radius is a double.
Scenes scenes(int dimension)
{
  Scenes all;
  for(const Point_scene& scene : small_scenes(dimension))
    if(scene.radius.length())
      all.push_back(scene);
  all.push_back(scene("ties at 10^15", dimension,
                      shuffled(lattice_points(dimension, 6, 1, 1e15), 1), Radius::of_length(2)));
  // In even shares, parts are layers, and the radius leads from one layer to the next but one.
  all.push_back(scene("layers", dimension, lattice_points(dimension, 8, 0.1, -0.3),
                      Radius::of_length(2 * 0.1)));
  Points crowd = uniform_points(dimension, 300, 0, 1, 2);
  for(const Coordinates& x : uniform_points(dimension, 200, 0.5, 1e-9, 3))
    crowd.push_back(x);
  all.push_back(scene("a tiny crowd", dimension, crowd, Radius::of_length(0.05)));
  all.push_back(scene("five points", dimension, uniform_points(dimension, 5, 0, 1, 4),
                      Radius::of_length(1)));
  return all;
}

// ---- the pairs ----------------------------------------------------------------------------------

// Calls task(truth, mine, bound) for the scenes in space, each shared out in two ways: evenly and
// all to the first process, or in the two other ways, in turn.
template <class Task>
void for_each_share(bool is_even, const Task& task)
{
  for(const Point_scene& scene : scenes(3)) {
    const Truth& truth = truth_of(scene);
    const std::vector<Point_3> points = points_3(scene.points);
    const auto bound = CGAL::within_distance(*scene.radius.length());
    for(const Shares shares : {is_even ? Shares::EVEN : Shares::SKEWED,
                               is_even ? Shares::FIRST : Shares::LAST})
      BOOST_TEST_CONTEXT(scene << ", shares " << static_cast<int>(shares))
      {
        task(truth, my_share_of(points, shares), bound);
      }
    is_even = !is_even;
  }
}

BOOST_AUTO_TEST_CASE(pairs_are_those_of_one_process_however_points_are_distributed)
{
  for_each_share(true, [](const Truth& truth, const auto& mine, const auto& bound) {
    check_pairs_of(mine, bound, truth);
  });
}

// Calls task(a, b, bound, expected) for the scenes in space, with the shares of this process of two
// sets: the first third of the points, and the rest.
template <class Task>
void for_each_two_sets(Shares shares_a, Shares shares_b, const Task& task)
{
  for(const Point_scene& scene : scenes(3))
    BOOST_TEST_CONTEXT(scene)
    {
      const std::vector<Point_3> points = points_3(scene.points);
      const std::size_t size_a = points.size() / 3;
      const auto middle = points.begin() + static_cast<std::ptrdiff_t>(size_a);
      const std::vector<Point_3> a(points.begin(), middle), b(middle, points.end());
      const Pairs expected = of_two_sets(truth_of(scene).pairs, size_a);
      task(my_share_of(a, shares_a), my_share_of(b, shares_b),
           CGAL::within_distance(*scene.radius.length()), expected);
    }
}

BOOST_AUTO_TEST_CASE(pairs_of_two_sets_are_those_of_one_process)
{
  for_each_two_sets(Shares::SKEWED, Shares::EVEN, [](const auto& a, const auto& b,
                                                     const auto& bound, const Pairs& expected) {
    Pairs mine;
    BOOST_CHECK(CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, a, b, bound,
                                                              add_to(mine)));
    check_equal(expected, mine);
  });
}

BOOST_AUTO_TEST_CASE(exact_numbers_are_sent_without_rounding)
{
  for(const Point_scene& scene : scenes(2))
    BOOST_TEST_CONTEXT(scene)
    check_pairs_of(my_share_of(thirds_of(scene.points), Shares::SKEWED),
                   CGAL::within_distance(Exact_kernel::FT(*scene.radius.length()) / 3),
                   truth_of(scene));
}

BOOST_AUTO_TEST_CASE(the_same_pairs_are_found_on_the_same_process_again)
{
  const std::vector<Point_3> mine
    = my_share_of(points_3(clustered_points(3, 2000, 5, 0.02, 5)), Shares::EVEN);
  const auto bound = CGAL::within_distance(0.01);
  const Pairs first = pairs_of(mine, bound, balanced);
  BOOST_CHECK(first == pairs_of(mine, bound, balanced));
}

// The first search makes their numbers exact, so the second one finds narrower bounds.
BOOST_AUTO_TEST_CASE(pairs_of_lazy_points_are_found_on_the_same_process_again)
{
  const Exact_kernel::FT far = 1e20;
  std::vector<Exact_kernel::Point_2> points;
  for(const Coordinates& x : uniform_points(2, 600, 0, 1, 10))
    points.emplace_back((far + 100 * x[0]) - far, Exact_kernel::FT(x[1]));
  const std::vector<Exact_kernel::Point_2> mine = my_share_of(points, Shares::EVEN);
  const auto bound = CGAL::within_distance(Exact_kernel::FT(1));
  const Pairs first = pairs_of(mine, bound, balanced);
  BOOST_CHECK(first == pairs_of(mine, bound, balanced));
}

// ---- the lists ----------------------------------------------------------------------------------

// The ids of the points of this process, each with the ids in its list.
Pairs pairs_in(const CGAL::Distributed_neighbor_lists& lists)
{
  std::uint64_t size = lists.size(), first_id = 0;
  MPI_Exscan(&size, &first_id, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  Pairs pairs;
  for(std::size_t i = 0; i < lists.size(); ++i) {
    BOOST_CHECK(std::is_sorted(lists[i].begin(), lists[i].end()));
    for(const std::uint64_t j : lists[i])
      pairs.emplace_back((rank() == 0 ? 0 : first_id) + i, j);
  }
  BOOST_CHECK_EQUAL(lists.number_of_pairs(), pairs.size());
  return pairs;
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class Point, class NT>
void check_lists(const Pairs& expected, const std::vector<Point>& mine,
                 const CGAL::Distance_bound<NT>& bound, CGAL::Point_distribution distribution)
{
  CGAL::Distributed_profile profile(distribution);
  const auto lists = CGAL::distributed_fixed_radius_neighbor_lists<ConcurrencyTag>(
    MPI_COMM_WORLD, mine, bound, profile);
  BOOST_CHECK_EQUAL(lists.size(), mine.size());
  check_equal(in_both_orders(expected), pairs_in(lists));
}

BOOST_AUTO_TEST_CASE(lists_are_those_of_one_process_however_points_are_distributed)
{
  for_each_share(false, [](const Truth& truth, const auto& mine, const auto& bound) {
    check_lists(truth.pairs, mine, bound, balanced);
    check_lists(truth.open_pairs, mine, bound.open(), as_is);
  });
}

BOOST_AUTO_TEST_CASE(lists_of_two_sets_have_the_ids_of_the_second)
{
  for_each_two_sets(Shares::EVEN, Shares::SKEWED, [](const auto& a, const auto& b,
                                                     const auto& bound, const Pairs& expected) {
    const auto lists
      = CGAL::distributed_fixed_radius_neighbor_lists(MPI_COMM_WORLD, a, b, bound);
    BOOST_CHECK_EQUAL(lists.size(), a.size());
    check_equal(expected, pairs_in(lists));
  });
}

// As many points as several threads share.
BOOST_AUTO_TEST_CASE(lists_of_exact_numbers_are_made_by_several_threads)
{
  const Point_scene lattice = scene("thirds", 2, shuffled(lattice_points(2, 40, 1), 9),
                                    Radius::of_length(2));
  const auto bound = CGAL::within_distance(Exact_kernel::FT(2) / 3);
  const auto mine = my_share_of(thirds_of(lattice.points), Shares::SKEWED);
  check_lists<CGAL::Parallel_if_available_tag>(truth_of(lattice).pairs, mine, bound, balanced);
}

// ---- the work -----------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(uniform_points_and_clustered_pairs_are_shared_evenly)
{
  const Points uniform = uniform_points(3, 20000, 0, 1, 6);
  Points clustered = clustered_points(3, 20000, 20, 0.02, 7);
  clustered.insert(clustered.end(), uniform.begin(), uniform.end()); // with few pairs
  CGAL::Distributed_profile profile;
  std::uint64_t count = 0;
  const On_pair add = [&](std::uint64_t, std::uint64_t) { return ++count > 0; };
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, my_share_of(points_3(uniform), Shares::FIRST), CGAL::within_distance(0.04), add,
    profile);
  BOOST_CHECK_LE(largest_over_average(profile.size_of_points()), 1.1);
  BOOST_CHECK_LE(sum_of_all(profile.bytes_sent(CGAL::Distributed_phase::MIGRATION)), 34 * 20000);
  count = 0;
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, my_share_of(points_3(clustered), Shares::EVEN), CGAL::within_distance(0.01),
    add, profile);
  BOOST_CHECK_LE(largest_over_average(profile.size_of_points()), 1.1);
  BOOST_CHECK_LE(largest_over_average(count), 1.3);
}

BOOST_AUTO_TEST_CASE(crowds_of_equal_points_are_shared)
{
  CGAL::Distributed_profile profile;
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, my_share_of(points_3(identical_points(3, 1000, 0.1)), Shares::EVEN),
    CGAL::within_distance(0.), ignore, profile);
  BOOST_CHECK_LE(largest_over_average(profile.size_of_points()), 1.1);
}

// Points that stay where they are cost nothing but their halo.
BOOST_AUTO_TEST_CASE(points_as_they_are_stay_where_they_are)
{
  const std::vector<Point_3> points = points_3(lattice_points(3, 10, 1));
  CGAL::Distributed_profile profile(as_is);
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, my_share_of(points, Shares::EVEN),
                                                CGAL::within_distance(1.), ignore, profile);
  BOOST_CHECK_EQUAL(profile.bytes_sent(CGAL::Distributed_phase::MIGRATION), 0);
  BOOST_CHECK_EQUAL(profile.size_of_points(), my_share_of(points, Shares::EVEN).size());
  BOOST_CHECK_EQUAL(sum_of_all(profile.size_of_halo()) > 0, process_count() > 1);
}

BOOST_AUTO_TEST_CASE(a_profile_is_that_of_the_last_search)
{
  const std::vector<Point_3> mine = my_share_of(points_3(lattice_points(3, 5, 1)), Shares::EVEN);
  const auto bound = CGAL::within_distance(1.);
  CGAL::Distributed_profile profile(as_is);
  CGAL::distributed_fixed_radius_neighbor_lists(MPI_COMM_WORLD, mine, bound, profile);
  BOOST_CHECK_GT(profile.seconds(CGAL::Distributed_phase::LISTS), 0);
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, mine, bound, ignore, profile);
  BOOST_CHECK_EQUAL(profile.seconds(CGAL::Distributed_phase::LISTS), 0);
  BOOST_CHECK_EQUAL(profile.bytes_sent(CGAL::Distributed_phase::LISTS), 0);
  BOOST_CHECK(profile.distribution() == as_is);
}

// One process has all points. The functor may change itself.
template <class Point>
void check_progress(const std::vector<Point>& points)
{
  for(const CGAL::Point_distribution distribution : {balanced, as_is}) {
    CGAL::Distributed_profile profile(distribution);
    double last = -1;
    const auto grow = [&last, before = 0.](double done) mutable {
      BOOST_CHECK_GE(done, before);
      last = before = done;
      return true;
    };
    BOOST_CHECK(CGAL::distributed_fixed_radius_near_neighbors(
      MPI_COMM_WORLD, my_share_of(points, Shares::LAST), CGAL::within_distance(0.05), ignore,
      profile, CGAL::parameters::callback(grow)));
    BOOST_CHECK_EQUAL(last, 1);
  }
}

// Of a process without points as well, beside others without points or one with points.
BOOST_AUTO_TEST_CASE(progress_ends_at_1_on_each_process)
{
  for(const std::size_t size : {0, 1000}) {
    check_progress(points_3(uniform_points(3, size, 0, 1, 9)));
    check_progress(thirds_of(uniform_points(2, size, 0, 1, 9)));
  }
}

// ---- failures -----------------------------------------------------------------------------------

// The process that fails: not the first one, if there are others.
int failing_rank() { return process_count() > 1 ? 1 : 0; }

struct Fault : std::runtime_error
{
  Fault() : std::runtime_error("a fault of the test") {}
};

const std::vector<Point_3>& many_points()
{
  static const std::vector<Point_3> points = points_3(uniform_points(3, 30000, 0, 1, 8));
  return points;
}

template <class NT>
bool search(const std::vector<Point_3>& points, const CGAL::Distance_bound<NT>& bound,
            const On_pair& on_pair)
{
  return CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points, bound, on_pair);
}

// Checks that a search throws `Error` on the process that fails and `Remote_error` on all others,
// in time, and that the next search is right.
template <class Error>
void check_failure(const std::function<void()>& search_that_fails)
{
  const auto start = std::chrono::steady_clock::now();
  if(rank() == failing_rank())
    BOOST_CHECK_THROW(search_that_fails(), Error);
  else
    BOOST_CHECK_EXCEPTION(search_that_fails(), CGAL::Remote_error, [](const auto& error) {
      return error.rank() == failing_rank() && std::string(error.what()).size() > 10;
    });
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  BOOST_CHECK_LT(time.count(), 10);
  const Point_scene next = scene("next", 3, lattice_points(3, 5, 1), Radius::of_length(1));
  check_equal(truth_of(next).pairs,
              pairs_of(my_share_of(points_3(next.points), Shares::EVEN), CGAL::within_distance(1.),
                       balanced));
}

// Returns a callback that calls `fail` at a pair of the process that fails.
On_pair at_pair(std::size_t number, const std::function<bool()>& fail)
{
  return [number, fail, count = std::size_t(0)](std::uint64_t, std::uint64_t) mutable {
    return ++count == number && rank() == failing_rank() ? fail() : true;
  };
}

const auto near_bound = CGAL::within_distance(0.05);

BOOST_AUTO_TEST_CASE(a_bad_argument_fails_on_all_processes)
{
  std::vector<Point_3> mine = my_share_of(many_points(), Shares::EVEN);
  if(rank() == failing_rank())
    mine[10] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  check_failure<std::invalid_argument>([&] { search(mine, near_bound, ignore); });
  const auto bound = CGAL::within_distance(rank() == failing_rank() ? -1. : 1.);
  check_failure<std::invalid_argument>([&] { search({}, bound, ignore); });
  check_failure<std::invalid_argument>([&] {
    CGAL::distributed_fixed_radius_neighbor_lists(MPI_COMM_WORLD, std::vector<Point_3>(), bound);
  });
}

BOOST_AUTO_TEST_CASE(different_bounds_are_refused_on_all_processes)
{
  const double r = 0.05;
  const bool differs = rank() == failing_rank();
  const auto open = CGAL::Distance_bound<double>(r, false, differs);
  const auto longer = CGAL::within_distance(differs ? std::nextafter(r, 1.) : r);
  const auto squared = CGAL::Distance_bound<double>(r, differs);
  for(const auto& bound : {open, longer, squared})
    if(process_count() > 1)
      BOOST_CHECK_THROW(search({}, bound, ignore), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_exception_of_a_callback_reaches_all_processes)
{
  const std::vector<Point_3> mine = my_share_of(many_points(), Shares::EVEN);
  for(const std::size_t number : {1, 5000}) {
    check_failure<Fault>(
      [&] { search(mine, near_bound, at_pair(number, []() -> bool { throw Fault(); })); });
    check_failure<std::bad_alloc>(
      [&] { search(mine, near_bound, at_pair(number, []() -> bool { throw std::bad_alloc(); })); });
  }
}

BOOST_AUTO_TEST_CASE(a_callback_stops_all_processes_and_so_do_all_callbacks_at_once)
{
  const std::vector<Point_3> mine = my_share_of(many_points(), Shares::EVEN);
  for(int round = 0; round < 3; ++round)
    for(const std::size_t number : {1, 5000})
      BOOST_CHECK(!search(mine, near_bound, at_pair(number, [] { return false; })));
  BOOST_CHECK(search(mine, near_bound, ignore));
  const auto stop = [](std::uint64_t, std::uint64_t) { return false; };
  BOOST_CHECK(!search(mine, near_bound, stop));
  const auto fail = [](std::uint64_t, std::uint64_t) -> bool { throw Fault(); };
  BOOST_CHECK_THROW(search(mine, near_bound, fail), Fault);
  BOOST_CHECK(search(mine, near_bound, ignore));
}

// Only check_killed_process.sh runs it, which expects that it ends in the search.
BOOST_AUTO_TEST_CASE(a_killed_process_ends_the_job, *boost::unit_test::disabled())
{
  search(my_share_of(many_points(), Shares::EVEN), near_bound, at_pair(1, [] {
    std::cout << "rank " << rank() << " is killed now" << std::endl;
    return std::raise(SIGKILL) == 0;
  }));
  MPI_Barrier(MPI_COMM_WORLD);
}

// ---- failures of lists --------------------------------------------------------------------------

// The lists of all points, from a search that one process ends in the middle by `fail`.
CGAL::Distributed_neighbor_lists lists_until(const std::function<bool()>& fail)
{
  const auto progress
    = [&](double done) { return done < 0.5 || rank() != failing_rank() || fail(); };
  return CGAL::distributed_fixed_radius_neighbor_lists(
    MPI_COMM_WORLD, my_share_of(many_points(), Shares::EVEN), near_bound,
    CGAL::parameters::callback(progress));
}

BOOST_AUTO_TEST_CASE(pairs_of_a_cancelled_search_are_in_both_of_their_lists)
{
  const auto all = lists_until([] { return true; });
  const auto some = lists_until([] { return false; });
  BOOST_CHECK_EQUAL(some.size(), all.size());
  const Pairs pairs = gathered(pairs_in(some));
  BOOST_CHECK_LT(pairs.size(), sum_of_all(all.number_of_pairs()));
  BOOST_CHECK_GT(pairs.size(), 0);
  Pairs swapped;
  for(const Pair& pair : pairs)
    swapped.emplace_back(pair.second, pair.first);
  BOOST_CHECK(sorted(swapped) == sorted(pairs));
}

BOOST_AUTO_TEST_CASE(no_process_gets_lists_if_one_throws)
{
  check_failure<Fault>([&] { lists_until([]() -> bool { throw Fault(); }); });
}

} // namespace
