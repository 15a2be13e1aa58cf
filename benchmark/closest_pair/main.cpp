// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair, in multiples of std::sort of the x-coordinates in the same
// process.
//
//   closest_pair_table            a row per promise: measured, target; and the other methods
//   closest_pair_table --chart    CSV of all methods for 10^3 to 10^7 points
//
// Points are uniform in the unit square or cube. All methods take turns, and the least time of the
// processor counts. It ends with status 1 if two methods disagree or a target is missed.

#include "methods.h"

#include "../support/timing.h"

#include <CGAL/closest_pair.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <random>
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

double seconds_of(const Method& method, bool& agrees)
{
  double result = 0;
  const double seconds = processor_seconds_of([&] { result = method.run(); });
  if(result != method.expected) {
    std::cerr << method.name << ": " << result << " instead of " << method.expected << '\n';
    agrees = false;
  }
  return seconds;
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
  static constexpr std::size_t any_size = ~std::size_t(0);

public:
  explicit Methods(const Points<Dimension>& points)
    : points_(points), elements_(points), profile_(CGAL::profile_scene(points, zero()))
  {}

  std::vector<Method> operator()() const
  {
    const double least = square_of(CGAL::closest_pair(points_));
    const double below = std::sqrt(least) * 0.99;
    // A cell of this side has 0.2 points on average, so some of them have five or more.
    const double heavy = std::pow(0.2 / static_cast<double>(points_.size()), 1. / Dimension);
    std::vector<Method> methods;
    const auto add = [&](const std::string& name, double target, std::size_t greatest_size,
                         double expected, const std::function<double()>& run) {
      if(points_.size() <= greatest_size)
        methods.push_back({name, target, expected, run});
    };
    add("sort", 0, any_size, 0, [&] { return sort(); });
    add("closest_pair", Dimension == 2 ? 0.5 : 0.8, any_size, least,
        [&] { return square_of(CGAL::closest_pair(points_)); });
    add("has_close_pair, no", Dimension == 2 ? 0.35 : 0.6, any_size, 0,
        [this, below] { return CGAL::has_close_pair(points_, CGAL::within_distance(below)); });
    add("has_close_pair, yes", 0.15, any_size, 1,
        [this, heavy] { return CGAL::has_close_pair(points_, CGAL::within_distance(heavy)); });
    add("divide and conquer", 0, any_size, least, [&] {
      return square_by([&](auto& minimum, auto& progress) {
        internal::divide_and_conquer<CGAL::Sequential_tag>(points_.size(), Dimension, minimum,
                                                           progress);
      });
    });
    add("incremental grid", 0, any_size, least, [&] {
      return square_by([&](auto& minimum, auto& progress) {
        std::vector<std::uint32_t> positions(points_.size());
        std::iota(positions.begin(), positions.end(), 0);
        internal::Closest_pair_grid<Dimension, Elements>(elements_, std::move(positions), Dimension,
                                                         0, 1).search(minimum, progress);
      });
    });
    add("grid of cells r, hashing, no", 0, any_size, 0,
        [this, below] { return by_grid(below, internal::Bucket_access::HASHING); });
    add("grid of cells r, order, no", 0, any_size, 0,
        [this, below] { return by_grid(below, internal::Bucket_access::SORTED_ORDER); });
    add("Delaunay", 0, 1000000, least, [&] { return closest_by_delaunay(points_); });
    add("Kd_tree", 0, 1000000, least, [&] { return closest_by_kd_tree(points_); });
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
    add("nanoflann", 0, 1000000, least, [&] { return closest_by_nanoflann(points_); });
#endif
    return methods;
  }

private:
  static CGAL::Distance_bound<int> zero() { return CGAL::within_distance(0); }

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

  // The squared distance of the pair that search(minimum, progress) leaves.
  template <class Search>
  double square_by(const Search& search) const
  {
    internal::Pair_minimum<Elements> minimum(elements_, profile_);
    internal::No_progress progress;
    search(minimum, progress);
    return square_of(minimum.pair());
  }

  double by_grid(double r, internal::Bucket_access access) const
  {
    using Exact = internal::Exact_number_t<double>;
    const internal::Squared_bound<Exact> bound(CGAL::within_distance(r));
    const internal::Close_pair_grid<CGAL::Sequential_tag, Elements> grid(elements_, bound, profile_,
                                                                         0, access);
    internal::No_progress progress;
    return grid.find(internal::All_positions(points_.size()), progress).has_value();
  }

  const Points<Dimension>& points_;
  const Elements elements_;
  const CGAL::Scene_profile profile_;
};

template <int Dimension>
std::vector<Method> timed_methods(std::size_t n, int repetitions, bool& agrees)
{
  const Points<Dimension> points = uniform_points<Dimension>(n);
  const Methods<Dimension> make_methods(points);
  std::vector<Method> methods = make_methods();
  for(int repetition = 0; repetition < repetitions; ++repetition)
    for(Method& method : methods)
      method.seconds = std::min(method.seconds, seconds_of(method, agrees));
  for(Method& method : methods)
    method.run = nullptr; // it refers to the points
  return methods;
}

template <int Dimension>
bool print_table(std::size_t n)
{
  bool is_good = true;
  const std::vector<Method> methods = timed_methods<Dimension>(n, 3, is_good);
  const double sort = methods.front().seconds;
  std::cout << Dimension << "D, n = " << n << ": sort " << std::fixed << std::setprecision(1)
            << 1000 * sort << " ms\n";
  for(const Method& method : methods) {
    std::cout << "  " << std::left << std::setw(32) << method.name << std::right << std::setw(10)
              << std::setprecision(1) << 1000 * method.seconds << " ms" << std::setw(9)
              << std::setprecision(2) << method.seconds / sort << " sorts";
    if(method.target != 0) {
      const bool is_met = method.seconds <= method.target * sort;
      std::cout << "   target " << method.target << (is_met ? "   met" : "   MISSED");
      is_good = is_good && is_met;
    }
    std::cout << '\n';
  }
  return is_good;
}

// n equal points, for which no time may depend on the number of pairs.
template <int Dimension>
void print_identical(std::size_t n)
{
  const Points<Dimension> points(n, uniform_points<Dimension>(1).front());
  internal::Position_pair pair;
  const double seconds = processor_seconds_of([&] { pair = CGAL::closest_pair(points); });
  std::cout << Dimension << "D, " << n << " equal points: pair " << pair.first << ' '
            << pair.second << std::setprecision(1) << " in "
            << 1000 * seconds << " ms\n";
}

template <int Dimension>
bool print_chart(std::size_t n)
{
  bool agrees = true;
  const std::vector<Method> methods
    = timed_methods<Dimension>(n, n <= 100000 ? 7 : n <= 1000000 ? 3 : 1, agrees);
  for(const Method& method : methods)
    std::cout << Dimension << ',' << n << ",\"" << method.name << "\"," << method.seconds << ','
              << method.seconds / methods.front().seconds << '\n';
  return agrees;
}

bool run(bool is_chart)
{
  bool is_good = true;
  if(is_chart) {
    std::cout << "dimension,n,method,seconds,sorts\n";
    for(std::size_t n = 1000; n <= 10000000; n *= 10) {
      is_good = print_chart<2>(n) && is_good;
      is_good = print_chart<3>(n) && is_good;
    }
    return is_good;
  }
  is_good = print_table<2>(1000000) && is_good;
  is_good = print_table<3>(1000000) && is_good;
  print_identical<2>(10000000);
  print_identical<3>(10000000);
  return is_good;
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
{
  if(argc > 2 || (argc == 2 && std::string(argv[1]) != "--chart")) {
    std::cerr << "usage: " << argv[0] << " [--chart]\n";
    return 2;
  }
  return thick_benchmark::run(argc == 2) ? 0 : 1;
}
