// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The experiments of [V03], section 3, once more: disks of one radius whose centres are uniform in
// a rectangle and given in single precision, against sorting, against testing all pairs, and
// against the Delaunay triangulation, which is the Voronoi diagram, with exact predicates.
//
//   section_3 <folder for section_3.csv> <disks> <disks for rational numbers> <disks, all near>

#include "measuring/Csv_file.h"
#include "paper_traits.h"

#include "support/book_variants.h"
#include "support/kernels.h"
#include "support/point_generators.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <chrono>
#include <iostream>

namespace {

using namespace test_support;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

// The centres in the rectangle [0, 2) x [0, 1), in single precision.
Points float_points(std::size_t n)
{
  Points points = uniform_points(2, n, 0, 1, 1);
  for(Coordinates& p : points) {
    p[0] = static_cast<double>(static_cast<float>(2 * p[0]));
    p[1] = static_cast<double>(static_cast<float>(p[1]));
  }
  return points;
}

// The distance at which n of them have about n / 2 pairs.
double sparse_radius(std::size_t n)
{
  return static_cast<double>(
    static_cast<float>(std::sqrt(2 / (3.14159265358979 * static_cast<double>(n)))));
}

template <class Kernel>
std::vector<typename Kernel::Point_2> in_kernel(const Points& points)
{
  return make_points<Cartesian_points<Kernel, 2>>(points);
}

class Section_3
{
public:
  explicit Section_3(const std::string& folder)
    : csv_(folder + "/section_3.csv",
           "none needed for times; the pair counts of all methods are compared (section_3.cpp)",
           "experiment,method,degree,n,k,seconds")
  {}

  void run_sparse(std::size_t n)
  {
    start("sparse, k < n", n);
    const Points points = float_points(n);
    const double r = sparse_radius(n);
    write_sort(points);
    write_package(points, r);
    write_paper_version(points, r);
    write_delaunay<Epick>("Delaunay triangulation, EPICK", points);
    write_delaunay<Epeck>("Delaunay triangulation, EPECK", points);
  }

  void run_sparse_with_rationals(std::size_t n)
  {
    start("sparse, rational numbers", n);
    const Points points = float_points(n);
    const double r = sparse_radius(n);
    write_package(points, r);
    write_in_kernel<Rational_kernel>("this package, rational numbers", points, r);
    write_delaunay<Epick>("Delaunay triangulation, EPICK", points);
    write_delaunay<Rational_kernel>("Delaunay triangulation, rational numbers", points);
  }

  void run_dense(std::size_t n)
  {
    start("dense, k = n(n-1)/2", n);
    const Points points = float_points(n);
    const double r = 3; // beyond the diagonal
    write_all_pairs(points, r);
    write_package(points, r);
    write_paper_version(points, r);
  }

private:
  void start(const std::string& experiment, std::size_t n)
  {
    experiment_ = experiment;
    n_ = n;
    k_.reset();
  }

  // Writes the median time of three runs of count(), which returns the number of pairs if the
  // method finds pairs.
  template <class Count>
  void write(const char* method, int degree, const Count& count)
  {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    std::optional<std::size_t> k;
    for(int repetition = 0; repetition < 3; ++repetition) {
      const Clock::time_point begin = Clock::now();
      k = count();
      times.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    std::sort(times.begin(), times.end());
    if(k && k_ && k != k_)
      throw std::logic_error(std::string(method) + " finds another number of pairs");
    if(k)
      k_ = k;
    csv_.row(experiment_, method, degree, n_, k_.value_or(0), times[1]);
    std::cout << experiment_ << ", n = " << n_ << ", " << method << ": " << times[1] << " s\n";
  }

  void write_sort(const Points& points)
  {
    std::vector<double> x;
    for(const Coordinates& p : points)
      x.push_back(p[0]);
    write("std::sort of the x-coordinates", 1, [&]() -> std::optional<std::size_t> {
      std::vector<double> copy = x;
      std::sort(copy.begin(), copy.end());
      return std::nullopt;
    });
  }

  template <class Kernel>
  void write_in_kernel(const char* method, const Points& points, double r)
  {
    const auto kernel_points = in_kernel<Kernel>(points);
    write(method, 2, [&]() -> std::optional<std::size_t> {
      std::size_t k = 0;
      CGAL::fixed_radius_near_neighbors(kernel_points, CGAL::within_distance(r),
                                        [&](std::size_t, std::size_t) { ++k; });
      return k;
    });
  }

  void write_package(const Points& points, double r)
  {
    write_in_kernel<Epick>("this package", points, r);
  }

  // The program of the paper: a random pivot, the walk, and the predicates in double.
  void write_paper_version(const Points& points, double r)
  {
    using Traits = lab::Paper_point_traits<Double_kernel::Point_2, 2>;
    const auto kernel_points = in_kernel<Double_kernel>(points);
    const internal::Elements<std::vector<Double_kernel::Point_2>> elements(kernel_points);
    const Traits traits(r);
    const internal::Book_scene<decltype(elements), Traits> scene(elements, std::nullopt, traits);
    write("[V03] as in its section 3, in double", 2, [&]() -> std::optional<std::size_t> {
      std::size_t k = 0;
      const auto callback = [&](std::size_t, std::size_t) { ++k; };
      internal::No_progress progress;
      internal::search_by_the_book<CGAL::Sequential_tag>(
        scene, {Pivot::RANDOM, Base_case::WALK, 1}, callback, progress);
      return k;
    });
  }

  void write_all_pairs(const Points& points, double r)
  {
    const auto kernel_points = in_kernel<Double_kernel>(points);
    write("all pairs, in double", 2, [&]() -> std::optional<std::size_t> {
      std::size_t k = 0;
      for(std::size_t i = 0; i < kernel_points.size(); ++i)
        for(std::size_t j = i + 1; j < kernel_points.size(); ++j)
          k += CGAL::squared_distance(kernel_points[i], kernel_points[j]) <= r * r;
      return k;
    });
  }

  template <class Kernel>
  void write_delaunay(const char* method, const Points& points)
  {
    const auto kernel_points = in_kernel<Kernel>(points);
    write(method, 4, [&]() -> std::optional<std::size_t> {
      const CGAL::Delaunay_triangulation_2<Kernel> triangulation(kernel_points.begin(),
                                                                 kernel_points.end());
      return std::nullopt;
    });
  }

  lab::Csv_file csv_;
  std::string experiment_;
  std::size_t n_ = 0;
  std::optional<std::size_t> k_;
};

} // namespace

int main(int, char** arguments)
{
  Section_3 section(arguments[1]);
  section.run_sparse(std::stoul(arguments[2]));
  section.run_sparse_with_rationals(std::stoul(arguments[3]));
  section.run_dense(std::stoul(arguments[4]));
}
