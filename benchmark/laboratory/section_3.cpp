// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The experiments of [V03], section 3, once more: disks of one radius whose centres are uniform in
// a rectangle and given in single precision, against sorting, against testing all pairs, and
// against the Delaunay triangulation, which is the Voronoi diagram, with exact predicates.
//
//   section_3 <folder for section_3.csv> <disks> <disks for rational numbers> <disks, all near>

#include "paper_traits.h"

#include "measuring/Csv_file.h"
#include "measuring/Tally.h"
#include "measuring/timing.h"
#include "methods/Method.h"
#include "methods/all_pairs.h"
#include "scenes/from_tests.h"

#include "support/point_generators.h"
#include "support/recursion_variants.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <iostream>
#include <optional>

namespace {

using namespace thick_benchmark;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

// The centres in the rectangle [0, 2) x [0, 1), in single precision.
Scene float_scene(std::size_t n, double r)
{
  test_support::Points points = test_support::uniform_points(2, n, 0, 1, 1);
  for(test_support::Coordinates& p : points) {
    p[0] = static_cast<double>(static_cast<float>(2 * p[0]));
    p[1] = static_cast<double>(static_cast<float>(p[1]));
  }
  return scene_of("", points, r, 2);
}

// The distance at which n of them have about n / 2 pairs.
double sparse_radius(std::size_t n)
{
  return static_cast<double>(
    static_cast<float>(std::sqrt(2 / (3.14159265358979 * static_cast<double>(n)))));
}

class Section_3
{
public:
  explicit Section_3(const std::string& folder)
    : csv_(folder, "section_3.csv",
           "none needed for times; the pair counts of all methods are compared (section_3.cpp)",
           "experiment,method,degree,n,k,seconds")
  {}

  void run_sparse(std::size_t n)
  {
    start("sparse, k < n", float_scene(n, sparse_radius(n)));
    write("std::sort of the x-coordinates", 1, sort_of_x<Tally>(scene_), false);
    write_search<Epick>("this package");
    write_paper_version();
    write_delaunay<Epick>("Delaunay triangulation, EPICK");
    write_delaunay<Epeck>("Delaunay triangulation, EPECK");
  }

  void run_sparse_with_rationals(std::size_t n)
  {
    start("sparse, rational numbers", float_scene(n, sparse_radius(n)));
    write_search<Epick>("this package");
    write_search<Rational_kernel>("this package, rational numbers");
    write_delaunay<Epick>("Delaunay triangulation, EPICK");
    write_delaunay<Rational_kernel>("Delaunay triangulation, rational numbers");
  }

  void run_dense(std::size_t n)
  {
    start("dense, k = n(n-1)/2", float_scene(n, 3)); // beyond the diagonal
    write_all_pairs();
    write_search<Epick>("this package");
    write_paper_version();
  }

private:
  void start(const std::string& experiment, const Scene& scene)
  {
    experiment_ = experiment;
    scene_ = scene;
    k_.reset();
  }

  // Writes the median time of three runs.
  void write(const char* method, int degree, const Run<Tally>& run, bool finds_pairs)
  {
    Tally found;
    const auto times = time_in_turns({timed_by_the_clock([&] { found = run(); })}, 3, 0);
    const double seconds = median(times, [](const Seconds& s) { return s[0]; });
    if(finds_pairs && found.pairs != k_.value_or(found.pairs))
      throw std::logic_error(std::string(method) + " finds another number of pairs");
    if(finds_pairs)
      k_ = found.pairs;
    csv_.row(experiment_, method, degree, scene_.size(), k_.value_or(0), seconds);
    std::cout << experiment_ << ", n = " << scene_.size() << ", " << method << ": " << seconds
              << " s\n";
  }

  // search(points, tally), on the points of a kernel.
  template <class Kernel, class Search>
  void write_on_points(const char* method, int degree, const Search& search,
                       bool finds_pairs = true)
  {
    write(method, degree, run_on_points_d<Tally, Kernel, 2>(scene_, search), finds_pairs);
  }

  template <class Kernel>
  void write_search(const char* method)
  {
    write_on_points<Kernel>(method, 2, [r = scene_.r](const auto& points, Tally& tally) {
      CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r), tally);
    });
  }

  // The program of the paper: a random pivot, the walk, and the predicates in double.
  void write_paper_version()
  {
    const lab::Paper_point_traits<Double_kernel::Point_2, 2> traits(scene_.r);
    write_on_points<Double_kernel>("[V03] as in its section 3, in double", 2,
                                   [traits](const auto& points, Tally& tally) {
                                     using test_support::Base_case, test_support::Pivot;
                                     test_support::search_by_variant(
                                       points, traits, {Pivot::RANDOM, Base_case::WALK, 1}, tally);
                                   });
  }

  void write_all_pairs()
  {
    write_on_points<Double_kernel>(
      "all pairs, in double", 2, [r = scene_.r](const auto& points, Tally& tally) {
        const auto is_near = [&](std::size_t i, std::size_t j) {
          return CGAL::squared_distance(points[i], points[j]) <= r * r;
        };
        all_pairs(points.size(), is_near, tally);
      });
  }

  template <class Kernel>
  void write_delaunay(const char* method)
  {
    const auto build = [](const auto& points, Tally&) {
      const CGAL::Delaunay_triangulation_2<Kernel> triangulation(points.begin(), points.end());
    };
    write_on_points<Kernel>(method, 4, build, false);
  }

  Csv_file csv_;
  std::string experiment_;
  Scene scene_;
  std::optional<std::uint64_t> k_;
};

} // namespace

int main(int, char** arguments)
{
  Section_3 section(arguments[1]);
  section.run_sparse(std::stoul(arguments[2]));
  section.run_sparse_with_rationals(std::stoul(arguments[3]));
  section.run_dense(std::stoul(arguments[4]));
}
