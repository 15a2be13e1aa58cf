// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How many times as fast as in sequence the searches are with 16, 64 and 256 processors: the time
// in sequence over work / P + span, of tasks that run in turn (Task_record.h).

#include "many_processors/Task_record.h"
#include "many_processors/searches.h"
#include "table/print.h"
#include "table/table.h"

#include "support/counting_allocator.h"

#include <malloc.h>
#include <time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace thick_benchmark {
namespace {

// The time is that of the processor: on a machine that does other things too, a long segment is
// interrupted in each run.
Reading read()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  const Reading reading
    = {std::int64_t(1000000000) * time.tv_sec + time.tv_nsec,
       static_cast<std::int64_t>(test_support::current_bytes()),
       static_cast<std::int64_t>(test_support::peak_bytes())};
  test_support::reset_peak();
  return reading;
}

// Sets whether memory that was freed is at hand, with pages that were touched before. If not, the
// system clears each page that a search touches first.
void keep_memory(bool keeps)
{
  mallopt(M_MMAP_MAX, keeps ? 0 : 65536);
  mallopt(M_TRIM_THRESHOLD, keeps ? -1 : 128 << 10);
}

// The cost of a search by so many processors, with the least time that each of its segments took in
// several runs.
Cost cost_of(const std::function<void()>& run, const Many_search& search, std::size_t processors,
             int rounds, const Tally& expected)
{
  const auto run_once = [&] {
    const Task_record record = record_tasks(processors, read, run);
    check_equal("with tasks in turn", expected, search.found());
    return record;
  };
  run_once(); // so that memory is as in later runs
  Task_record least = run_once();
  for(int round = 1; round < rounds; ++round)
    least.take_least_times(run_once());
  return least.cost();
}

struct Costs
{
  Cost sequential;
  Cost parallel;

  double speed_up(std::size_t processors) const
  {
    return sequential.work / (parallel.work / static_cast<double>(processors) + parallel.span);
  }
};

Costs costs_of(const Many_search& search, std::size_t processors, bool keeps, const Tally& expected)
{
  keep_memory(keeps);
  const int rounds = keeps ? 7 : 3;
  return {cost_of(search.sequential, search, 1, rounds, expected),
          cost_of(search.parallel, search, processors, rounds, expected)};
}

void print_row(const Many_row& row, std::size_t n)
{
  const Many_search search = row.make(n);
  search.sequential();
  const Tally expected = search.found();
  const auto bytes_more = [&](const Costs& costs) {
    return static_cast<double>(costs.parallel.most_bytes - costs.sequential.most_bytes)
           / static_cast<double>(n);
  };
  const Costs of_16 = costs_of(search, 16, true, expected);
  const Costs of_64 = costs_of(search, 64, true, expected);
  const Costs of_256 = costs_of(search, 256, true, expected);
  const Costs touching = costs_of(search, 64, false, expected);
  const double speed_ups[] = {of_16.speed_up(16), of_64.speed_up(64), of_256.speed_up(256)};
  const double target = n >= 1000000 ? row.target : 12;
  const bool is_met = speed_ups[1] >= target && speed_ups[2] >= speed_ups[1];
  print_line(row.name, n, expected.pairs, fixed(1e-6 * of_64.sequential.work, 1),
             fixed(of_64.parallel.work / of_64.sequential.work, 2),
             fixed(1e-6 * of_64.parallel.span, 2), fixed(speed_ups[0], 1), fixed(speed_ups[1], 1),
             fixed(speed_ups[2], 1), ">= " + fixed(target, 0), is_met ? "met" : "missed",
             fixed(touching.speed_up(64), 1), fixed(bytes_more(of_64), 0),
             fixed(bytes_more(of_256), 0));
}

} // namespace

void print_table(const Settings& settings)
{
  print_head({"search", ">n", ">pairs", ">ms in sequence", ">work", ">span, ms", ">P = 16",
              ">P = 64", ">P = 256", ">target", "verdict", ">pages touched first", ">bytes more",
              ">with P = 256"});
  std::vector<std::size_t> sizes = {100000, 1000000};
  if(settings.is_quick)
    sizes = {10000};
  if(settings.is_large)
    sizes.push_back(10000000);
  for(const std::size_t n : sizes)
    for(const Many_row& row : many_rows())
      if(row.name.find(settings.only) != std::string::npos)
        print_row(row, n);
}

} // namespace thick_benchmark
