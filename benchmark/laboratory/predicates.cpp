// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The time of a single predicate, "are two points of space within r", and its wrong answers: on
// random pairs, exact ties and near misses, and for mixtures of random pairs with more and more
// ties.
//
//   predicates <folder for predicates.csv and tie_density.csv> <milliseconds per measurement>

#include "measuring/Csv_file.h"
#include "measuring/timing.h"
#include "methods/distance_forms.h"
#include "scenes/from_tests.h"

#include "support/exact_points.h"
#include "support/point_generators.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_point_traits_d.h>

#include <iostream>

namespace {

using namespace thick_benchmark;
using Array = Array_point<3>;
using test_support::Random;

// ---- the pairs ----------------------------------------------------------------------------------

// Pairs of points for one radius: points 2i and 2i + 1 of a scene are pair i.
using Pair_set = Scene;

Pair_set no_pairs(double r) { return {"", 3, {}, r}; }

void add(Pair_set& set, const Array& p, const Array& q)
{
  set.coordinates.insert(set.coordinates.end(), p.begin(), p.end());
  set.coordinates.insert(set.coordinates.end(), q.begin(), q.end());
}

// Whether r * r is rounded up or down matters to all pairs at once: hence many radii.
constexpr std::size_t radii = 16;
constexpr std::size_t size = 512; // pairs for each

Pair_set random_pairs(std::uint64_t seed)
{
  Random random(seed);
  // About the median distance in the unit cube.
  Pair_set set = no_pairs(0.6 + 0.1 * random.uniform());
  for(std::size_t i = 0; i < size; ++i) {
    Array p, q;
    for(int axis = 0; axis < 3; ++axis) {
      p[axis] = random.uniform();
      q[axis] = random.uniform();
    }
    add(set, p, q);
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
  Pair_set set = no_pairs(1155 * unit);
  for(std::size_t i = 0; i < size; ++i) {
    const Array& difference = quadruples[random.below(quadruples.size())];
    Array p, q;
    for(int axis = 0; axis < 3; ++axis) {
      p[axis] = unit * static_cast<double>(random.below(128));
      q[axis] = p[axis] + unit * difference[axis]; // exact, below 2^53
    }
    add(set, p, q);
  }
  return set;
}

// Pairs at a distance of r up to rounding.
Pair_set near_misses(std::uint64_t seed)
{
  Random random(seed);
  Pair_set set = no_pairs(0.6 + 0.1 * random.uniform());
  for(std::size_t i = 0; i < size; ++i) {
    Array direction;
    double length = 0;
    for(double& x : direction) {
      x = random.uniform() - 0.5;
      length += x * x;
    }
    Array p, q;
    for(int axis = 0; axis < 3; ++axis) {
      p[axis] = random.uniform();
      q[axis] = p[axis] + set.r * (direction[axis] / std::sqrt(length));
    }
    add(set, p, q);
  }
  return set;
}

// Ties, and for the others the same pairs with twice the difference, which no filter has doubts
// about.
Pair_set mixture(std::uint64_t seed, double share_of_ties)
{
  Random random(seed + 1000);
  Pair_set set = ties(seed);
  for(std::size_t i = 0; i < size; ++i)
    if(random.uniform() >= share_of_ties)
      for(double* p = &set.coordinates[6 * i]; p != &set.coordinates[6 * i] + 3; ++p)
        p[3] = 2 * p[3] - p[0];
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
  const test_support::Exact_points exact(points_of(set), radius_of(set));
  std::vector<char> answers;
  for(std::size_t i = 0; i < set.size(); i += 2)
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
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < answers.size(); ++i)
    wrong += static_cast<char>(is_near(points[2 * i], points[2 * i + 1])) != answers[i];

  double least = std::numeric_limits<double>::infinity();
  volatile std::size_t sink = 0;
  for(int repetition = 0; repetition < 5; ++repetition) {
    const Stopwatch watch;
    std::size_t calls = 0, near = 0;
    do {
      for(std::size_t i = 0; i < answers.size(); ++i)
        near += is_near(points[2 * i], points[2 * i + 1]);
      calls += answers.size();
    } while(1000 * watch.seconds() < milliseconds / 5);
    least = std::min(least, 1e9 * watch.seconds() / static_cast<double>(calls));
    sink = sink + near;
  }
  return {least, wrong};
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
    put<Arrays>(name, "form", [](double r) {
      return [r](const Array& p, const Array& q) { return Form::is_near(p, q, r); };
    });
  }

  // The kernel's predicate with r * r as its number type has it.
  template <class Kernel>
  void compare_squared_distance(const char* name) const
  {
    using Point = typename Kernel::Point_3;
    put<Kernel>(name, "kernel", [](double r) {
      return [square = square_in<Kernel>(r)](const Point& p, const Point& q) {
        return CGAL::compare_squared_distance(p, q, square) != CGAL::LARGER;
      };
    });
  }

  // Ours: the filter, then exact numbers.
  template <class Kernel>
  void ours(const char* name) const
  {
    using Traits = CGAL::Thick_point_traits_d<typename Kernel::Point_3>;
    put<Kernel>(name, "ours", [](double r) {
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

  template <class Kernel, class Make_predicate>
  void put(const char* name, const char* group, const Make_predicate& make_predicate) const
  {
    Measured sum{0, 0};
    for(std::size_t i = 0; i < sets_.size(); ++i) {
      const Measured one = measure(make_points<Kernel, 3>(sets_[i]), make_predicate(sets_[i].r),
                                   answers_[i], milliseconds_);
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
  on.template form<Squared_in<double>>("double");
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
  on.template form<Squared_in<float>>("float");
  on.template form<Squared_in<long double>>("long double");
  on.template form<With_square_root>("double, sqrt");
  on.template form<With_hypot>("double, hypot");
  on.template form<Expanded>("double, expanded");
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

  Csv_file csv(folder, "predicates.csv", truth, "set,pairs,true_pairs,method,group,ns,wrong");
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

  Csv_file tie_csv(folder, "tie_density.csv", truth, "share_of_ties,method,group,ns,wrong");
  for(double share : {0., 0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 1.})
    measure_main_predicates(
      sets([share](std::uint64_t seed) { return mixture(seed, share); }), milliseconds,
      [&](const char* name, const char* group, const Measured& measured) {
        tie_csv.row(share, name, group, measured.nanoseconds, measured.wrong);
      });
}
