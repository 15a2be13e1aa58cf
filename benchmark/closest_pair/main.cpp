// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair, in multiples of std::sort of the x-coordinates in the same
// process.
//
//   closest_pair_table            Markdown: a row per promise, and the other methods
//   closest_pair_table --chart    CSV of all methods for 10^3 to 10^7 points
//   --quick                       10^4 points at most: does it work?
//
// Points are uniform in the unit square or cube, or all the same. Methods take turns, and the least
// time of the processor counts; what takes more than a second is measured once. It ends with status
// 1 if two methods disagree.

#include "methods.h"

#include "../support/run_facts.h"
#include "../support/timing.h"

#include <CGAL/closest_pair.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

namespace thick_benchmark {
namespace {

namespace internal = CGAL::Thick_intersection_d::internal;

// A way to an answer, and the answer that is expected of it.
struct Method
{
  std::string name;
  double target; // in times of the sort; 0: none
  double expected;
  std::function<double()> run;
  double seconds = std::numeric_limits<double>::infinity();
};

void measure(Method& method)
{
  double result = 0;
  const double seconds = processor_seconds_of([&] { result = method.run(); });
  if(result != method.expected)
    throw std::runtime_error(method.name + ": " + std::to_string(result) + " instead of "
                             + std::to_string(method.expected));
  method.seconds = std::min(method.seconds, seconds);
}

template <int Dimension>
Points<Dimension> uniform_points(std::size_t n)
{
  std::mt19937_64 random(n);
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  Points<Dimension> points;
  points.reserve(n);
  for(std::size_t i = 0; i < n; ++i) {
    const double x = coordinate(), y = coordinate();
    if constexpr(Dimension == 2)
      points.emplace_back(x, y);
    else
      points.emplace_back(x, y, coordinate());
  }
  return points;
}

template <int Dimension>
class Methods
{
  using Elements = internal::Elements<Points<Dimension>>;

public:
  explicit Methods(const Points<Dimension>& points)
    : points_(points), elements_(points),
      profile_(CGAL::profile_scene(points, CGAL::within_distance(0))),
      least_(square_of(CGAL::closest_pair(points))),
      below_(CGAL::within_squared_distance(0.99 * least_).open())
  {}

  // What is promised, after the sort.
  std::vector<Method> promised() const
  {
    // A cell of this side has 0.2 points on average, so some of them have five or more.
    const auto heavy = CGAL::within_distance(
      std::pow(0.2 / static_cast<double>(points_.size()), 1. / Dimension));
    return {{"std::sort of x", 0, 0, [&] { return sort(); }},
            {"closest_pair", Dimension == 2 ? 0.5 : 0.8, least_,
             [&] { return square_of(CGAL::closest_pair(points_)); }},
            {"has_close_pair, no", Dimension == 2 ? 0.35 : 0.6, 0,
             [&] { return CGAL::has_close_pair(points_, below_); }},
            {"has_close_pair, yes", 0.15, 1,
             [this, heavy] { return CGAL::has_close_pair(points_, heavy); }}};
  }

  // The algorithms of [L] and the randomised grid, and the rivals. For distinct points.
  std::vector<Method> others() const
  {
    std::vector<Method> methods
      = {{"divide and conquer", 0, least_, [&] { return by_division(); }},
         {"incremental grid", 0, least_, [&] { return by_incremental_grid(); }}};
    if(points_.size() > 1000000)
      return methods;
    methods.push_back({"grid of cells r, hashing, no", 0, 0,
                       [&] { return by_grid(internal::Bucket_access::HASHING); }});
    methods.push_back({"grid of cells r, order, no", 0, 0,
                       [&] { return by_grid(internal::Bucket_access::SORTED_ORDER); }});
    methods.push_back({"Delaunay", 0, least_, [&] { return closest_by_delaunay(points_); }});
    methods.push_back({"Kd_tree", 0, least_, [&] { return closest_by_kd_tree(points_); }});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
    methods.push_back({"nanoflann", 0, least_, [&] { return closest_by_nanoflann(points_); }});
#endif
    return methods;
  }

private:
  double square_of(const internal::Position_pair& pair) const
  {
    return CGAL::squared_distance(points_[pair.first], points_[pair.second]);
  }

  double sort() const
  {
    std::vector<double> x;
    for(const auto& point : points_)
      x.push_back(point.x());
    std::sort(x.begin(), x.end());
    return x.front() > x.back();
  }

  double by_division() const
  {
    internal::Pair_minimum<Elements> minimum(elements_, profile_);
    internal::No_progress progress;
    internal::divide_and_conquer<CGAL::Sequential_tag>(points_.size(), Dimension, minimum,
                                                       progress);
    return square_of(minimum.pair());
  }

  double by_incremental_grid() const
  {
    std::vector<std::uint32_t> positions(points_.size());
    std::iota(positions.begin(), positions.end(), 0);
    internal::Pair_minimum<Elements> minimum(elements_, profile_);
    internal::No_progress progress;
    internal::Closest_pair_grid<Dimension, Elements>(elements_, std::move(positions), Dimension, 0,
                                                     1).search(minimum, progress);
    return square_of(minimum.pair());
  }

  double by_grid(internal::Bucket_access access) const
  {
    using Exact = internal::Exact_number_t<double>;
    const internal::Squared_bound<Exact> bound(below_);
    internal::No_progress progress;
    return internal::Close_pair_grid<CGAL::Sequential_tag, Elements>(elements_, bound, profile_, 0,
                                                                     access)
      .find(internal::All_positions(points_.size()), progress).has_value();
  }

  const Points<Dimension>& points_;
  const Elements elements_;
  const CGAL::Scene_profile profile_;
  const double least_; // the squared distance of the closest pair
  const CGAL::Distance_bound<double> below_; // no pair is within it
};

void take_turns(std::vector<Method>& methods, int rounds)
{
  for(int round = 0; round < rounds; ++round)
    for(Method& method : methods)
      if(round == 0 || method.seconds <= 1)
        measure(method);
}

// Returns the seconds of the sort, which are the unit unless another one is given: equal numbers
// are sorted in no time.
template <int Dimension>
double print_rows(const std::string& scene, const Points<Dimension>& points, bool with_others,
                  std::optional<double> unit = std::nullopt)
{
  const Methods<Dimension> all(points);
  std::vector<Method> methods = all.promised();
  if(with_others)
    for(const Method& method : all.others())
      methods.push_back(method);
  take_turns(methods, 5);
  const double sort = unit.value_or(methods.front().seconds);
  for(const Method& method : methods) {
    std::cout << "| " << Dimension << "D " << scene << " | " << points.size() << " | "
              << method.name << " | " << std::fixed << std::setprecision(1)
              << 1000 * method.seconds << " | " << std::setprecision(2) << method.seconds / sort
              << " | ";
    if(method.target != 0)
      std::cout << "<= " << method.target
                << (method.seconds <= method.target * sort ? " | met |\n" : " | missed |\n");
    else
      std::cout << "| |\n";
  }
  return sort;
}

#ifdef CGAL_LINKED_WITH_TBB

// The speed-up of a function by two threads, and that of two sorts, which have nothing to do with
// each other: how much of two processors the machine had to give at the time.
template <int Dimension, class Function>
void print_speed_up(const std::string& name, const Points<Dimension>& points,
                    const Function& function)
{
  const tbb::global_control two_threads(tbb::global_control::max_allowed_parallelism, 2);
  const auto sort = [&] {
    std::vector<double> x;
    for(std::size_t i = 0; i < points.size(); i += 4)
      x.push_back(points[i].x());
    std::sort(x.begin(), x.end());
  };
  const std::vector<Seconds> times = time_in_turns(
    {timed_by_the_clock([&] { function(CGAL::Sequential_tag()); }),
     timed_by_the_clock([&] { function(CGAL::Parallel_tag()); }),
     timed_by_the_clock([&] { sort(); sort(); }),
     timed_by_the_clock([&] { tbb::parallel_invoke(sort, sort); })}, 7);
  std::cout << "| " << Dimension << "D uniform | " << points.size() << " | " << name << " | "
            << std::setprecision(1) << median(times, [](const Seconds& s) { return 1000 * s[1]; })
            << " | " << std::setprecision(2)
            << median(times, [](const Seconds& s) { return s[0] / s[1]; }) << " | "
            << median(times, [](const Seconds& s) { return s[2] / s[3]; }) << " |\n";
}

template <int Dimension>
void print_speed_ups(std::size_t n)
{
  const Points<Dimension> points = uniform_points<Dimension>(n);
  const auto [i, j] = CGAL::closest_pair(points);
  const auto below
    = CGAL::within_squared_distance(CGAL::squared_distance(points[i], points[j])).open();
  print_speed_up<Dimension>("closest_pair", points, [&](auto tag) {
    CGAL::closest_pair<decltype(tag)>(points);
  });
  print_speed_up<Dimension>("has_close_pair, no", points, [&](auto tag) {
    CGAL::has_close_pair<decltype(tag)>(points, below);
  });
}

#endif // CGAL_LINKED_WITH_TBB

template <int Dimension>
void print_rows_of_dimension(bool is_quick)
{
  const std::size_t n = is_quick ? 1000 : 1000000;
  print_rows<Dimension>("uniform", uniform_points<Dimension>(n), true);
  const double sort = print_rows<Dimension>("uniform", uniform_points<Dimension>(10 * n), false);
  const Point<Dimension> point = uniform_points<Dimension>(1).front();
  print_rows<Dimension>("identical", Points<Dimension>(10 * n, point), false, sort);
}

void print_tables(bool is_quick)
{
  for(const Run_fact& fact : run_facts())
    std::cout << "- " << fact.name << ": " << fact.value << '\n';
  std::cout << "\n| scene | n | method | ms | time / std::sort | target | verdict |\n"
               "|---|--:|---|--:|--:|--:|---|\n";
  print_rows_of_dimension<2>(is_quick);
  print_rows_of_dimension<3>(is_quick);
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t n = is_quick ? 10000 : 1000000;
  std::cout << "\n| scene | n | method | ms of 2 threads | speed-up | machine |\n"
               "|---|--:|---|--:|--:|--:|\n";
  print_speed_ups<2>(n);
  print_speed_ups<3>(n);
#endif
}

template <int Dimension>
void print_chart(std::size_t n)
{
  const Points<Dimension> points = uniform_points<Dimension>(n);
  const Methods<Dimension> all(points);
  std::vector<Method> methods = all.promised();
  for(const Method& method : all.others())
    methods.push_back(method);
  take_turns(methods, n <= 100000 ? 7 : 3);
  for(const Method& method : methods)
    std::cout << Dimension << ',' << n << ",\"" << method.name << "\"," << method.seconds << '\n';
}

void print_charts(bool is_quick)
{
  std::cout << "dimension,n,method,seconds\n";
  for(std::size_t n = 1000; n <= (is_quick ? 10000 : 10000000); n *= 10) {
    print_chart<2>(n);
    print_chart<3>(n);
  }
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
{
  bool is_chart = false, is_quick = false;
  for(int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    is_chart = is_chart || argument == "--chart";
    is_quick = is_quick || argument == "--quick";
    if(argument != "--chart" && argument != "--quick") {
      std::cerr << "usage: " << argv[0] << " [--chart] [--quick]\n";
      return 2;
    }
  }
  try {
    is_chart ? thick_benchmark::print_charts(is_quick) : thick_benchmark::print_tables(is_quick);
  }
  catch(const std::runtime_error& error) { // methods disagree
    std::cerr << error.what() << '\n';
    return 1;
  }
}
