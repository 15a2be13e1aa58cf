// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "measuring/timing.h"
#include "methods/ours.h"
#include "scenes/generators.h"

#include "support/counting_allocator.h"

#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>

#include <malloc.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>

namespace thick_benchmark {

namespace {

using CGAL::Thick_intersection_d::internal::Instruction_set;
using CGAL::Thick_intersection_d::internal::best_instruction_set;
using CGAL::Thick_intersection_d::internal::instruction_set;

using Quotient = std::function<double(const Seconds&)>;

const int rounds = 7;

Subject make_subject(const std::string& name, const Scene& scene,
                     Search (*search)(const Scene&) = search_epick)
{
  return make_subject(name, scene.size(), search(scene), tally_by_recursive_route(scene));
}

// Times the subject in turns with other jobs: `quotient` is told the seconds of the subject and of
// the others, in this order. A second row tells the speed-up in parallel.
Rows measure(const Subject& subject, const std::string& quantity, const Goal& goal,
             const std::vector<Job>& others, const Quotient& quotient)
{
  std::vector<Job> jobs = {timed(subject.search.sequential)};
  jobs.insert(jobs.end(), others.begin(), others.end());
  const std::vector<Seconds> times = time_in_turns(jobs, rounds);
  Rows rows = {{subject.name, quantity, goal, median(times, quotient), subject.n, subject.k,
                median(times, milliseconds_of_first)}};
#ifdef CGAL_LINKED_WITH_TBB
  rows.push_back(measure_two_threads(subject));
#endif
  return rows;
}

double of_first_other(const Seconds& s) { return s[0] / s[1]; }

// ---- against std::sort --------------------------------------------------------------------------

// Sorts the x-coordinates of a scene, copied anew each time; the copy takes no part in the seconds.
Job sort_of_x(const Scene& scene)
{
  return [unsorted = x_coordinates(scene)] {
    std::vector<double> x = unsorted;
    return processor_seconds_of([&] { std::sort(x.begin(), x.end()); });
  };
}

// The instruction sets of lanes, from the best one on.
struct Named_set
{
  Instruction_set set;
  std::string name;
};
const Named_set named_sets[] = {{Instruction_set::AVX512, "AVX-512"},
                                {Instruction_set::AVX2, "AVX2"},
                                {Instruction_set::SSE2, "SSE2"}};

// A scene of uniform points, and what it is called.
struct Uniform_scene
{
  int dimension;
  double neighbours; // k / n
  std::array<Goal, 3> goals; // of the time in that of std::sort, by named_sets

  std::string name() const
  {
    return std::to_string(dimension) + "D uniform, k ~ " + (neighbours < 1 ? "n/2" : "10 n");
  }
  Scene make(std::size_t n) const
  {
    return uniform(dimension, n, neighbours * static_cast<double>(n));
  }
};

const Uniform_scene uniform_scenes[]
  = {{2, 0.5, {at_most(0.40, 0.32), at_most(0.42, 0.34), at_most(0.50, 0.40)}},
     {2, 10, {at_most(0.80, 0.68), at_most(0.85, 0.75), at_most(1.15, 1.0)}},
     {3, 0.5, {at_most(0.65, 0.50), at_most(0.70, 0.56), at_most(0.95, 0.80)}},
     {3, 10, {at_most(1.15, 0.95), at_most(1.30, 1.12), at_most(2.1, 1.85)}}};

// With each instruction set that the processor has. Threads are measured with the best one.
Rows measure_uniform(const std::string& name, const Uniform_scene& u, std::size_t n)
{
  const Scene scene = u.make(n);
  const Subject subject = make_subject(name, scene);
  Rows rows;
  for(std::size_t s = 0; s < std::size(named_sets); ++s) {
    if(named_sets[s].set > best_instruction_set())
      continue;
    instruction_set() = named_sets[s].set;
    const Subject by_set = make_subject(name + ", " + named_sets[s].name, subject.n,
                                        subject.search, subject.search.sequential());
    const std::vector<Seconds> times
      = time_in_turns({timed(subject.search.sequential), sort_of_x(scene)}, rounds);
    rows.push_back({by_set.name, "time / std::sort", u.goals[s], median(times, of_first_other),
                    subject.n, subject.k, median(times, milliseconds_of_first)});
  }
  instruction_set() = best_instruction_set();
#ifdef CGAL_LINKED_WITH_TBB
  rows.push_back(measure_two_threads(subject));
#endif
  return rows;
}

// While it lives, memory that was freed is at hand for the next search.
class Warm_memory
{
public:
  Warm_memory()
  {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
  }
  ~Warm_memory()
  {
    mallopt(M_MMAP_MAX, 65536);
    mallopt(M_TRIM_THRESHOLD, 128 << 10);
  }
};

// Lists of neighbours, against counting the pairs: with plain memory, and with memory at hand.
Rows measure_lists(const std::string& name, const Uniform_scene& u, std::size_t n)
{
  const Subject subject = make_subject(name, u.make(n));
  if(subject.search.lists() != subject.k)
    throw std::runtime_error(name + ": the lists have other pairs");
  const auto measure_row = [&](const std::string& suffix, const Goal& goal) {
    const std::vector<Seconds> times
      = time_in_turns({timed(subject.search.lists), timed(subject.search.sequential)}, rounds);
    return Row{name + suffix, "time / counting", goal, median(times, of_first_other), subject.n,
               subject.k, median(times, milliseconds_of_first)};
  };
  const Row plain = measure_row("", Goal());
  const Warm_memory warm;
  return {plain, measure_row(", memory at hand", at_most(3))};
}

// The quotient to std::sort of ten times as many points, divided by that of n points.
Rows measure_growth(const std::string& name, const Uniform_scene& u, std::size_t n)
{
  const Scene few = u.make(n);
  const Scene many = u.make(10 * n);
  return measure(make_subject(name, many), "time / std::sort, / that of n", at_most(1.05, 1.0),
                 {sort_of_x(many), timed(search_epick(few).sequential), sort_of_x(few)},
                 [](const Seconds& s) { return (s[0] / s[1]) / (s[2] / s[3]); });
}

// ---- other kernels ------------------------------------------------------------------------------

Rows measure_kernel(const std::string& name, Search (*search)(const Scene&), double target,
                    const Uniform_scene& u, std::size_t n)
{
  const Scene scene = u.make(n);
  return measure(make_subject(name, scene, search), "time / EPICK", at_most(target),
                 {timed(search_epick(scene).sequential)}, of_first_other);
}

// Against reading the coordinates once and searching their doubles.
Rows measure_exact_kernel(const std::string& name, const Uniform_scene& u, std::size_t n)
{
  const Scene scene = u.make(n);
  const Subject subject = make_subject(name, scene, search_exact);
  return measure(subject, "time / (to_interval + EPICK)", at_most(1.3),
                 {timed(subject.search.sum_of_intervals), timed(search_epick(scene).sequential)},
                 [](const Seconds& s) { return s[0] / (s[1] + s[2]); });
}

// ---- against uniform points ---------------------------------------------------------------------

// The time per n + k in that of uniform points with as many pairs.
Rows measure_against_uniform(const std::string& name, const Goal& goal,
                             const std::function<Scene()>& make_scene)
{
  const Scene scene = make_scene();
  const Subject subject = make_subject(name, scene);
  const Scene even = uniform(scene.dimension, scene.size(), static_cast<double>(subject.k));
  const Subject reference = make_subject(name + ": uniform points", even);
  const double work = static_cast<double>(subject.n + subject.k)
                      / static_cast<double>(reference.n + reference.k);
  return measure(subject, "time / (n + k), / uniform", goal, {timed(reference.search.sequential)},
                 [=](const Seconds& s) { return s[0] / s[1] / work; });
}

std::size_t side_of_lattice(int dimension, std::size_t n)
{
  return static_cast<std::size_t>(std::lround(std::pow(static_cast<double>(n), 1. / dimension)));
}

// ---- dense scenes, memory, and many points ------------------------------------------------------

Rows measure_dense(const std::string& name, int dimension, std::size_t n)
{
  const Scene scene = dense(dimension, n);
  const Run<Tally> naive = naive_double_loop(scene);
  return measure(make_subject(name, scene.size(), search_epick(scene), naive()),
                 "time / naive double loop", at_most(1.0, 0.6), {timed(naive)}, of_first_other);
}

// The most bytes allocated during `job` beyond those before it.
template <class Job>
std::size_t peak_bytes_of(const Job& job)
{
  const std::size_t before = test_support::current_bytes();
  test_support::reset_peak();
  job();
  return test_support::peak_bytes() - before;
}

Rows measure_memory(const std::string& name, int dimension, double neighbours, std::size_t n)
{
  const Scene scene = uniform(dimension, n, neighbours * static_cast<double>(n));
  const Search search = search_epick(scene);
  const Goal goal = at_most(neighbours > 10 ? 32 : dimension == 2 ? 20 : 28);
  Tally tally;
  const auto bytes_per_point = [&](const Run<Tally>& run) {
    return static_cast<double>(peak_bytes_of([&] { tally = run(); })) / static_cast<double>(n);
  };
  const double bytes = bytes_per_point(search.sequential);
  Rows rows = {{name, "bytes / point", goal, bytes, n, tally.pairs, std::nullopt}};
  if(search.parallel)
    rows.push_back({name + ", 2 threads", "bytes / point", goal, bytes_per_point(search.parallel),
                    n, tally.pairs, std::nullopt});
  return rows;
}

// The time per point of a hundred times as many points. The recursive route would take minutes and
// more memory than there may be: sequential and parallel search are compared with each other alone.
Rows measure_huge(const std::string& name, std::size_t n)
{
  const Search few = search_epick(uniform(2, n, 0.5 * static_cast<double>(n)));
  const Scene scene = uniform(2, 100 * n, 50 * static_cast<double>(n));
  const Search search = search_epick(scene);
  return measure(make_subject(name, scene.size(), search, search.sequential()),
                 "time / point, / that of n", at_most(2), {timed(few.sequential)},
                 [](const Seconds& s) { return s[0] / s[1] / 100; });
}

// ---- the table ----------------------------------------------------------------------------------

class Point_experiments
{
public:
  explicit Point_experiments(const Settings& settings) : n_(settings.is_quick ? 100000 : 1000000) {}

  void add_uniform()
  {
    for(const Uniform_scene& u : uniform_scenes)
      add(u.name(), measure_uniform, u, n_);
    for(const Uniform_scene& u : uniform_scenes)
      add(u.name() + ", 10 times the points", measure_growth, u, n_);
  }

  void add_lists()
  {
    for(const Uniform_scene& u : uniform_scenes)
      if(u.neighbours > 1)
        add(u.name() + ", lists of neighbours", measure_lists, u, n_);
  }

  void add_kernels()
  {
    for(const Uniform_scene& u : uniform_scenes) {
      add(u.name() + ", Cartesian<double>", measure_kernel, search_double, 1.0, u, n_);
      add(u.name() + ", EPECK", measure_kernel, search_epeck, 1.3, u, n_);
      add(u.name() + ", Cartesian<rational>", measure_exact_kernel, u, n_);
    }
  }

  void add_lattices(const std::string& extra_data)
  {
    const Goal goal = at_most(1.3, 1.0);
    for(int dimension : {2, 3})
      for(double unit : {1., 0.1}) {
        const std::string name
          = std::to_string(dimension) + "D lattice, r = unit = " + (unit == 1 ? "1" : "0.1");
        add(name, measure_against_uniform, goal, [=, n = n_] {
          return lattice(dimension, side_of_lattice(dimension, n), unit);
        });
      }
    const std::string file = extra_data + "/pba38478.tsp";
    if(!extra_data.empty() && std::filesystem::exists(file))
      add("2D pba38478, tiled", measure_against_uniform, goal, [=, n = n_] {
        return with_fitting_integer_distance(tiled(file, n), count_pairs);
      });
  }

  void add_skewed()
  {
    const std::size_t n = n_;
    for(int d : {2, 3}) {
      const std::string prefix = std::to_string(d) + "D ";
      add_fitted(prefix + "clusters", [=] { return clusters(d, n); });
      add_fitted(prefix + "Levy flight", [=] { return levy_flight(d, n); });
      add(prefix + "outlier at 10^15 r", measure_against_uniform, skew_,
          [=] { return with_outlier(uniform(d, n, 2 * static_cast<double>(n))); });
      add(prefix + "90 % identical", measure_against_uniform, skew_,
          [=] { return mostly_identical(d, n / 50); });
    }
    add_fitted("3D oblique plane", [=] { return oblique_plane(n); });
    add_fitted("3D oblique line", [=] { return oblique_line(n); });
  }

  void add_dense()
  {
    for(int dimension : {2, 3})
      add(std::to_string(dimension) + "D dense, all pairs", measure_dense, dimension, n_ / 50);
  }

  void add_memory()
  {
    for(int dimension : {2, 3})
      for(double neighbours : {0.5, 10., 100.})
        add(std::to_string(dimension) + "D uniform, memory, k ~ "
              + (neighbours < 1 ? "n/2" : neighbours < 100 ? "10 n" : "100 n"),
            measure_memory, dimension, neighbours, n_);
  }

  void add_huge() { add("2D uniform, k ~ n/2, 100 times the points", measure_huge, n_); }

  const Experiments& all() const { return all_; }

private:
  template <class Measurement, class... Arguments>
  void add(const std::string& name, const Measurement& measurement, const Arguments&... arguments)
  {
    all_.push_back({name, [=] { return measurement(name, arguments...); }});
  }

  // At a distance that gives between n and 4 n pairs.
  template <class Make_scene>
  void add_fitted(const std::string& name, const Make_scene& make_scene)
  {
    add(name, measure_against_uniform, skew_,
        [=] { return with_fitting_distance(make_scene(), count_pairs); });
  }

  const Goal skew_ = at_most(2, 1.2);
  const std::size_t n_;
  Experiments all_;
};

} // namespace

void print_table(const Settings& settings)
{
  Point_experiments all(settings);
  all.add_uniform();
  all.add_kernels();
  all.add_lattices(settings.data);
  all.add_skewed();
  all.add_dense();
  all.add_memory();
  if(settings.is_large)
    all.add_huge();
  all.add_lists(); // at the end, because the allocator does not forget all that it was told
  print_rows(all.all(), settings);
}

} // namespace thick_benchmark
