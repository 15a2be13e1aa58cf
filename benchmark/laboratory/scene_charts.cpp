// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What real scenes need of the arithmetic, and how many predicates a search calls.
//
//   scene_charts <folder for certificates.csv and work.csv> <largest n of work.csv>
//
// The data folders are those of test/support/data_files.h: THICK_SHIPPED_DATA, THICK_EXTRA_DATA.

#include "measuring/Csv_file.h"
#include "measuring/Tally.h"
#include "methods/Cell_list.h"

#include "support/data_facts.h"
#include "support/kernels.h"
#include "support/lattice_traits.h"
#include "support/point_generators.h"
#include "support/recursion_variants.h"

#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <sstream>

namespace {

using namespace test_support;
using thick_benchmark::Csv_file;
using thick_benchmark::Tally;

// ---- the certificate map ------------------------------------------------------------------------

template <int Dimension>
CGAL::Scene_profile profile(const Points& points, double radius)
{
  using Maker = Cartesian_points<CGAL::Simple_cartesian<double>, Dimension>;
  return CGAL::profile_scene(make_points<Maker>(points), CGAL::within_distance(radius));
}

void write_certificate(const Fact& fact, const char* stored, const Points& points, double radius,
                       Csv_file& csv)
{
  const CGAL::Scene_profile scene
    = fact.dimension == 2 ? profile<2>(points, radius) : profile<3>(points, radius);
  double extent = 0;
  for(int i = 0; i < fact.dimension; ++i)
    extent = std::max(extent, scene.range(i).second - scene.range(i).first);
  std::ostringstream tier;
  tier << scene.tier();
  csv.row(fact.file, static_cast<int>(fact.view), fact.dimension, fact.radius, stored,
          std::log2(extent) - scene.grid_exponent(), std::log2(scene.units()), scene.bits(),
          tier.str());
}

// The double next to digits / 10^decimals, as a reader of decimal text returns it.
double double_of(const Decimal_integer& digits, int decimals)
{
  return std::strtod((digits.str() + "e-" + std::to_string(decimals)).c_str(), nullptr);
}

void write_certificates(Csv_file& csv)
{
  for(const Fact& fact : facts()) {
    const auto path = find_data_file(fact.file, data_folders());
    if(!path)
      continue;
    const Decimal_points decimal = read_view(*path, fact.view);
    Points doubles;
    for(const auto& p : decimal.coordinates) {
      doubles.emplace_back();
      for(const Decimal_integer& x : p)
        doubles.back().push_back(double_of(x, decimal.decimals));
    }
    write_certificate(fact, "decimals read as doubles", doubles, std::stod(fact.radius), csv);
    if(const auto integers = as_exact_doubles(decimal)) {
      const double scale = std::pow(10., decimal.decimals); // exact up to 10^22
      write_certificate(fact, "integers, the decimals scaled", *integers,
                        std::nearbyint(std::stod(fact.radius) * scale), csv);
    }
  }
}

// ---- work ---------------------------------------------------------------------------------------

constexpr double side = 16777216; // 2^24

std::vector<Site> uniform_sites(int dimension, std::size_t n)
{
  Random random(n);
  std::vector<Site> sites;
  for(std::size_t i = 0; i < n; ++i) {
    std::vector<long> c;
    for(int axis = 0; axis < dimension; ++axis)
      c.push_back(static_cast<long>(side * random.fixed_point(24)));
    sites.emplace_back(std::move(c));
  }
  return sites;
}

// The distance at which n uniform points have about n pairs.
long distance_for_n_pairs(int dimension, std::size_t n)
{
  const double pi = 3.14159265358979323846;
  const double volume = 2 / static_cast<double>(n); // of a ball, in that of the scene
  return std::lround(side * (dimension == 2 ? std::sqrt(volume / pi)
                                            : std::cbrt(3 * volume / (4 * pi))));
}

template <std::size_t Dimension>
std::size_t count_cell_candidates(const std::vector<Site>& sites, long distance)
{
  std::vector<std::array<double, Dimension>> points(sites.size());
  for(std::size_t i = 0; i < sites.size(); ++i)
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      points[i][axis] = static_cast<double>(sites[i].coordinate(static_cast<int>(axis)));
  const double r = static_cast<double>(distance);
  std::size_t count = 0;
  thick_benchmark::Cell_list(points, [r](double x) { return std::floor(x / r); })
    .for_each_candidate([&](std::size_t, std::size_t) { ++count; });
  return count;
}

// Pairs that a sweep along the first axis alone would test.
std::size_t count_within_along_x(const std::vector<Site>& sites, long distance)
{
  std::vector<long> x;
  for(const Site& site : sites)
    x.push_back(site.coordinate(0));
  std::sort(x.begin(), x.end());
  std::size_t count = 0;
  for(std::size_t first = 0, i = 0; i < x.size(); ++i) {
    while(x[i] - x[first] > distance)
      ++first;
    count += i - first;
  }
  return count;
}

void write_work(int dimension, std::size_t n, Csv_file& csv)
{
  const std::vector<Site> sites = uniform_sites(dimension, n);
  const long distance = distance_for_n_pairs(dimension, n);
  std::size_t k = 0;
  const auto write = [&](const char* method, std::size_t calls) {
    csv.row(dimension, n, k, method, calls,
            static_cast<double>(calls) / static_cast<double>(n + k));
  };
  const auto write_search = [&](const char* method, long reach) {
    Calls calls;
    const Lattice_traits traits(dimension, distance, reach, calls);
    Tally tally;
    search_by_variant(sites, traits, {}, tally);
    k = tally.pairs;
    write(method, calls.do_intersect);
  };
  write_search("sweep, reach r", distance);
  write_search("sweep, reach 2 r", 2 * distance);
  write("grid of cells r", dimension == 2 ? count_cell_candidates<2>(sites, distance)
                                          : count_cell_candidates<3>(sites, distance));
  write("sweep along x alone", count_within_along_x(sites, distance));
}

} // namespace

int main(int, char** arguments)
{
  const std::string folder = arguments[1];
  Csv_file certificates(
    folder, "certificates.csv",
    "Scene_profile itself; test/functions/test_data.cpp checks the pairs of these scenes in "
    "integers",
    "file,view,dimension,radius,stored,log2_extent,log2_reach,bits,tier");
  write_certificates(certificates);

  Csv_file work(folder, "work.csv", "integer coordinates below 2^24, squared in 64 bits "
                                           "(test/support/lattice_traits.h, squared_distance)",
                     "dimension,n,k,method,calls,calls_per_output");
  for(int dimension : {2, 3})
    for(std::size_t n = 1000; n <= std::stoul(arguments[2]); n *= 10)
      write_work(dimension, n, work);
}
