// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The time of a single predicate, "are two points of space within r", and its wrong answers: on
// random pairs, exact ties and near misses, and for mixtures of random pairs with more and more
// ties.
//
//   predicates <folder for predicates.csv and tie_density.csv> <milliseconds per measurement>

#include "measuring/Csv_file.h"
#include "methods/distance_forms.h"

#include "support/exact_points.h"
#include "support/mpfr_kernel_number.h"
#include "support/point_generators.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_point_traits_d.h>

#include <chrono>
#include <iostream>

namespace {

using lab::Csv_file;
using Array = lab::Array_point<3>;
using test_support::Random;

// ---- the pairs ----------------------------------------------------------------------------------

// Pairs of points for one radius.
struct Pair_set
{
  double r;
  std::vector<std::pair<Array, Array>> pairs;
};

// Whether r * r is rounded up or down matters to all pairs at once: hence many radii.
constexpr std::size_t radii = 16;
constexpr std::size_t size = 512; // pairs for each

Pair_set random_pairs(std::uint64_t seed)
{
  Random random(seed);
  Pair_set set{0.6 + 0.1 * random.uniform(), {}}; // about the median distance in the unit cube
  for(std::size_t i = 0; i < size; ++i) {
    std::pair<Array, Array> pair;
    for(int axis = 0; axis < 3; ++axis) {
      pair.first[axis] = random.uniform();
      pair.second[axis] = random.uniform();
    }
    set.pairs.push_back(pair);
  }
  return set;
}

// All integer (x, y, z) with x, y, z > 0 on the sphere of radius 1155.
std::vector<Array> pythagorean_quadruples()
{
  std::vector<Array> result;
  for(int x = 1; x < 1155; ++x)
    for(int y = 1; x * x + y * y < 1155 * 1155; ++y) {
      const int square = 1155 * 1155 - x * x - y * y;
      const int z = static_cast<int>(std::sqrt(static_cast<double>(square)));
      if(z * z == square)
        result.push_back({double(x), double(y), double(z)});
    }
  return result;
}

// Pairs at a distance of exactly r: 34-bit multiples of integer ones.
Pair_set ties(std::uint64_t seed)
{
  static const std::vector<Array> quadruples = pythagorean_quadruples();
  Random random(seed);
  const double unit = std::ldexp(1., 33) + 2 * std::ldexp(random.fixed_point(32), 32) + 1; // odd
  Pair_set set{1155 * unit, {}};
  for(std::size_t i = 0; i < size; ++i) {
    const Array& difference = quadruples[random.below(quadruples.size())];
    std::pair<Array, Array> pair;
    for(int axis = 0; axis < 3; ++axis) {
      pair.first[axis] = unit * static_cast<double>(random.below(128));
      pair.second[axis] = pair.first[axis] + unit * difference[axis]; // exact, below 2^53
    }
    set.pairs.push_back(pair);
  }
  return set;
}

// Pairs at a distance of r up to rounding.
Pair_set near_misses(std::uint64_t seed)
{
  Random random(seed);
  Pair_set set{0.6 + 0.1 * random.uniform(), {}};
  for(std::size_t i = 0; i < size; ++i) {
    Array direction;
    double length = 0;
    for(double& x : direction) {
      x = random.uniform() - 0.5;
      length += x * x;
    }
    std::pair<Array, Array> pair;
    for(int axis = 0; axis < 3; ++axis) {
      pair.first[axis] = random.uniform();
      pair.second[axis] = pair.first[axis] + set.r * (direction[axis] / std::sqrt(length));
    }
    set.pairs.push_back(pair);
  }
  return set;
}

// Ties, and for the others the same pairs with twice the difference, which no filter has doubts
// about.
Pair_set mixture(std::uint64_t seed, double share_of_ties)
{
  Random random(seed + 1000);
  Pair_set set = ties(seed);
  for(auto& pair : set.pairs)
    if(random.uniform() >= share_of_ties)
      for(int axis = 0; axis < 3; ++axis)
        pair.second[axis] = 2 * pair.second[axis] - pair.first[axis];
  return set;
}

// make(seed) for each of the radii.
template <class Make>
std::vector<Pair_set> sets(const Make& make)
{
  std::vector<Pair_set> result;
  for(std::uint64_t seed = 1; seed <= radii; ++seed)
    result.push_back(make(seed));
  return result;
}

std::vector<char> exact_answers(const Pair_set& set)
{
  test_support::Points points;
  for(const auto& pair : set.pairs)
    for(const Array& p : {pair.first, pair.second})
      points.emplace_back(p.begin(), p.end());
  const test_support::Exact_points exact(points, test_support::Radius::of_length(set.r));
  std::vector<char> answers;
  for(std::size_t i = 0; i < points.size(); i += 2)
    answers.push_back(exact.are_within_radius(i, i + 1));
  return answers;
}

// ---- the measurement ----------------------------------------------------------------------------

struct Measured
{
  double nanoseconds; // per call, the least of five: others may use the machine, too
  std::size_t wrong;
};

template <class Points, class Predicate>
Measured measure(const Points& points, const Predicate& is_near, const std::vector<char>& answers,
                 double milliseconds)
{
  using Clock = std::chrono::steady_clock;
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < answers.size(); ++i)
    wrong += static_cast<char>(is_near(points[2 * i], points[2 * i + 1])) != answers[i];

  std::vector<double> times;
  volatile std::size_t sink = 0;
  for(int repetition = 0; repetition < 5; ++repetition) {
    std::size_t calls = 0, near = 0;
    const Clock::time_point start = Clock::now();
    double elapsed = 0;
    do {
      for(std::size_t i = 0; i < answers.size(); ++i)
        near += is_near(points[2 * i], points[2 * i + 1]);
      calls += answers.size();
      elapsed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    } while(elapsed < milliseconds / 5);
    sink = sink + near;
    times.push_back(1e6 * elapsed / static_cast<double>(calls));
  }
  return {*std::min_element(times.begin(), times.end()), wrong};
}

template <class Kernel>
std::vector<typename Kernel::Point_3> kernel_points(const Pair_set& set)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_3> points;
  for(const auto& pair : set.pairs)
    for(const Array& p : {pair.first, pair.second})
      points.emplace_back(FT(p[0]), FT(p[1]), FT(p[2]));
  return points;
}

std::vector<Array> array_points(const Pair_set& set)
{
  std::vector<Array> points;
  for(const auto& pair : set.pairs)
    for(const Array& p : {pair.first, pair.second})
      points.push_back(p);
  return points;
}

// Measures predicates on the sets and hands each result to write(name, group, measured).
template <class Write>
class Predicates_on_sets
{
public:
  Predicates_on_sets(const std::vector<Pair_set>& sets, double milliseconds, const Write& write)
    : sets_(sets), milliseconds_(milliseconds / static_cast<double>(sets.size())), write_(write)
  {
    for(const Pair_set& set : sets)
      answers_.push_back(exact_answers(set));
  }

  template <class Form>
  void form(const char* name) const
  {
    put(name, "form", array_points, [](double r) {
      return [r](const Array& p, const Array& q) { return Form::is_near(p, q, r); };
    });
  }

  // The kernel's predicate with r * r as its number type has it.
  template <class Kernel>
  void compare_squared_distance(const char* name) const
  {
    using Point = typename Kernel::Point_3;
    put(name, "kernel", kernel_points<Kernel>, [](double r) {
      return [square = square_in<Kernel>(r)](const Point& p, const Point& q) {
        return CGAL::compare_squared_distance(p, q, square) != CGAL::LARGER;
      };
    });
  }

  template <class Kernel>
  void bounded_side(const char* name) const
  {
    using Point = typename Kernel::Point_3;
    put(name, "kernel", kernel_points<Kernel>, [](double r) {
      return [square = square_in<Kernel>(r)](const Point& p, const Point& q) {
        return !typename Kernel::Sphere_3(p, square).has_on_unbounded_side(q);
      };
    });
  }

  // Ours: the filter, then exact numbers.
  template <class Kernel>
  void ours(const char* name) const
  {
    using Traits = CGAL::Thick_point_traits_d<typename Kernel::Point_3>;
    put(name, "ours", kernel_points<Kernel>, [](double r) {
      return Traits(CGAL::within_distance(r)).do_intersect_d_object();
    });
  }

private:
  template <class Kernel>
  static typename Kernel::FT square_in(double r)
  {
    const typename Kernel::FT number(r);
    return number * number;
  }

  template <class Make_points, class Make_predicate>
  void put(const char* name, const char* group, const Make_points& make_points,
           const Make_predicate& make_predicate) const
  {
    Measured sum{0, 0};
    for(std::size_t i = 0; i < sets_.size(); ++i) {
      const Measured one = measure(make_points(sets_[i]), make_predicate(sets_[i].r), answers_[i],
                                   milliseconds_);
      sum.nanoseconds += one.nanoseconds / static_cast<double>(sets_.size());
      sum.wrong += one.wrong;
    }
    write_(name, group, sum);
  }

  const std::vector<Pair_set>& sets_;
  std::vector<std::vector<char>> answers_;
  const double milliseconds_;
  const Write& write_;
};

using Double_kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Write>
void measure_main_predicates(const std::vector<Pair_set>& sets, double milliseconds,
                             const Write& write)
{
  const Predicates_on_sets<Write> on(sets, milliseconds, write);
  on.template form<lab::Squared_in<double>>("double");
  on.template compare_squared_distance<Epick>("EPICK");
  on.template compare_squared_distance<Epeck>("EPECK");
  on.template compare_squared_distance<CGAL::Simple_cartesian<CGAL::Mpzf>>("Mpzf");
  on.template compare_squared_distance<CGAL::Simple_cartesian<CGAL::Exact_rational>>("rational");
  on.template ours<Double_kernel>("ours, double");
  on.template ours<Epeck>("ours, EPECK");
  on.template ours<CGAL::Simple_cartesian<CGAL::Exact_rational>>("ours, rational");
}

template <class Write>
void measure_all_predicates(const std::vector<Pair_set>& sets, double milliseconds,
                            const Write& write)
{
  measure_main_predicates(sets, milliseconds, write);
  const Predicates_on_sets<Write> on(sets, milliseconds, write);
  on.template form<lab::Squared_in<float>>("float");
  on.template form<lab::Squared_in<long double>>("long double");
  on.template form<lab::With_square_root>("double, sqrt");
  on.template form<lab::With_hypot>("double, hypot");
  on.template form<lab::Expanded>("double, expanded");
  on.template bounded_side<Epick>("EPICK Sphere_3");
  on.template compare_squared_distance<CGAL::Simple_cartesian<CGAL::Gmpzf>>("Gmpzf");
  on.template compare_squared_distance<CGAL::Simple_cartesian<test_support::Mpfr_number<16>>>(
    "MPFR 55 bits");
  on.template compare_squared_distance<CGAL::Simple_cartesian<test_support::Mpfr_number<76>>>(
    "MPFR 255 bits");
}

const char* const truth = "GMP integers (test/support/exact_points.h, are_within_radius)";

std::size_t count_near(const std::vector<Pair_set>& sets)
{
  std::size_t count = 0;
  for(const Pair_set& set : sets)
    for(char is_near : exact_answers(set))
      count += static_cast<std::size_t>(is_near);
  return count;
}

} // namespace

int main(int, char** arguments)
{
  const std::string folder = arguments[1];
  const double milliseconds = std::stod(arguments[2]);

  Csv_file csv(folder + "/predicates.csv", truth, "set,pairs,true_pairs,method,group,ns,wrong");
  const auto measure_set = [&](const char* name, const std::vector<Pair_set>& sets) {
    const std::size_t near = count_near(sets);
    measure_all_predicates(
      sets, milliseconds, [&](const char* method, const char* group, const Measured& measured) {
        csv.row(name, radii * size, near, method, group, measured.nanoseconds, measured.wrong);
      });
  };
  measure_set("random", sets(random_pairs));
  measure_set("exact ties", sets(ties));
  measure_set("near misses", sets(near_misses));

  Csv_file tie_csv(folder + "/tie_density.csv", truth, "share_of_ties,method,group,ns,wrong");
  for(double share : {0., 0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 1.})
    measure_main_predicates(
      sets([share](std::uint64_t seed) { return mixture(seed, share); }), milliseconds,
      [&](const char* name, const char* group, const Measured& measured) {
        tie_csv.row(share, name, group, measured.nanoseconds, measured.wrong);
      });
}
