// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// compare: the time of many methods on the same scenes, as a program of Google Benchmark. Before a
// method is timed its pairs are compared with ours. A measurement is called
//
//   <dimension>/<scene>/<k/n aimed at>/<n>/<method>

#include "Contestant.h"

#include "measuring/run_facts.h"
#include "measuring/speed_up.h"
#include "measuring/timing.h"
#include "methods/ours.h"
#include "scenes/generators.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <iostream>
#include <sstream>

namespace thick_benchmark {
namespace {

struct Scene_kind
{
  std::string name;
  bool has_variants; // whether the variants of methods are measured as well
  std::function<Scene()> make;
};

// The scene and the method that were prepared last: the library runs a measurement several times.
class Stage
{
public:
  const Scene& scene(const Scene_kind& kind)
  {
    if(scene_name_ != kind.name) {
      run_ = nullptr;
      method_name_.clear();
      scene_ = kind.make();
      scene_name_ = kind.name;
      pairs_ = search_epick(scene_).sequential();
    }
    return scene_;
  }

  const Tally& pairs() const { return pairs_; }

  // After this, found() is what the method finds.
  void prepare(const Method<Tally>& method)
  {
    if(method_name_ == method.name)
      return;
    run_ = nullptr;
    run_ = method.prepare(scene_);
    method_name_ = method.name;
    seconds_ = seconds_of([this] { found_ = run_(); });
  }

  const Tally& found() const { return found_; }

  // The time of a run. One that takes long is not repeated.
  double seconds() const
  {
    constexpr double long_time = 1;
    if(seconds_ > long_time)
      return seconds_;
    return seconds_of([this] { benchmark::DoNotOptimize(run_()); });
  }

private:
  std::string scene_name_;
  Scene scene_;
  Tally pairs_;
  std::string method_name_;
  Run<Tally> run_;
  Tally found_;
  double seconds_ = 0; // that it took to find them
};

std::string difference_in_words(const Tally& expected, const Tally& found)
{
  std::ostringstream words;
  words << found << " instead of " << expected;
  return words.str();
}

void measure(benchmark::State& state, Stage& stage, const Scene_kind& kind,
             const Contestant& contestant)
{
  const Scene& scene = stage.scene(kind);
  stage.prepare(contestant);
  if(contestant.precision == Precision::EXACT && stage.found() != stage.pairs()) {
    state.SkipWithError(difference_in_words(stage.pairs(), stage.found()).c_str());
    return;
  }
  for(auto _ : state)
    state.SetIterationTime(stage.seconds());
  state.counters["n"] = static_cast<double>(scene.size());
  state.counters["k"] = static_cast<double>(stage.pairs().pairs);
  state.counters["r"] = scene.r;
  if(contestant.precision == Precision::ROUNDED)
    state.counters["pairs_too_many"] = static_cast<double>(stage.found().pairs)
                                       - static_cast<double>(stage.pairs().pairs);
}

std::string name(int dimension, const char* kind, double neighbours, std::size_t n)
{
  std::ostringstream name;
  name << dimension << "D/" << kind << '/' << neighbours << '/' << n;
  return name.str();
}

// Time against n, against k/n, and on other scenes.
std::vector<Scene_kind> scene_kinds(std::size_t max_n)
{
  std::vector<Scene_kind> kinds;
  const std::size_t n = std::min<std::size_t>(max_n, 1000000);
  const auto add_uniform = [&](int d, double neighbours, std::size_t size, bool has_variants) {
    kinds.push_back({name(d, "uniform", neighbours, size), has_variants, [=] {
                       return uniform(d, size, neighbours * static_cast<double>(size));
                     }});
  };
  for(int d : {2, 3}) {
    for(std::size_t size = 1000; size <= max_n; size *= 10)
      for(double neighbours : {0.5, 10.})
        add_uniform(d, neighbours, size, true);
    for(double neighbours : {0.01, 0.1, 2., 40., 100.})
      add_uniform(d, neighbours, n, false);
    kinds.push_back({name(d, "clusters", 2, n), false, [=] {
                       return with_fitting_distance(clusters(d, n), count_pairs);
                     }});
  }
  return kinds;
}

Contestants all_contestants()
{
  Contestants all;
  add_ours(all);
  add_recursive_routes(all);
  add_boxes(all);
  add_delaunay_epick(all);
  add_delaunay_epeck(all);
  add_trees(all);
  return all;
}

void register_all(Stage& stage, std::size_t max_n)
{
  const Contestants all = all_contestants();
  for(const Scene_kind& kind : scene_kinds(max_n)) {
    const std::size_t n = std::stoul(kind.name.substr(kind.name.rfind('/') + 1));
    for(const Contestant& one : all)
      if(n <= one.max_n && (kind.has_variants || !one.is_variant))
        benchmark::RegisterBenchmark(
          (kind.name + "/" + one.name).c_str(),
          [&stage, kind, one](benchmark::State& state) { measure(state, stage, kind, one); })
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
  }
}

// Takes "--largest=<n>", the only option of our own, out of the arguments.
std::size_t max_n(int& argc, char** argv)
{
  const std::string option = "--largest=";
  std::size_t n = 1000000;
  int kept = 1;
  for(int a = 1; a < argc; ++a)
    if(std::strncmp(argv[a], option.c_str(), option.size()) == 0)
      n = std::stoul(argv[a] + option.size());
    else
      argv[kept++] = argv[a];
  argc = kept;
  return n;
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
{
  using namespace thick_benchmark;
#ifdef CGAL_LINKED_WITH_TBB
  const Two_threads two_threads;
#endif
  const std::size_t n = max_n(argc, argv);
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv)) {
    std::cerr << "compare: besides those of Google Benchmark there is --largest=<n>\n";
    return 1;
  }
  for(const Run_fact& fact : run_facts())
    benchmark::AddCustomContext(fact.name, fact.value);
  Stage stage;
  register_all(stage, n);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
