// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How many times as fast as in sequence the searches are by 1, 2, 4, ... threads up to as many as
// there are processors, and what the machine gives as many searches that share nothing.

#include "many_processors/searches.h"
#include "measuring/timing.h"
#include "table/print.h"
#include "table/table.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace thick_benchmark {
namespace {

// One thread does the work of an arena of so many slots at least: searches divide their work by
// the number of slots, and the more there are the more it costs.
constexpr int min_slots = 16;

// The numbers of threads beyond one.
std::vector<int> thread_counts()
{
  const int all = tbb::info::default_concurrency();
  std::vector<int> counts;
  for(int count = 2; count < all; count *= 2)
    counts.push_back(count);
  if(all > 1)
    counts.push_back(all);
  return counts;
}

// By one thread, in an arena whose other slots are kept for threads that never come.
template <class Function>
void run_by_one(const Function& function)
{
  const int slots = (std::max)(min_slots, tbb::info::default_concurrency());
  tbb::task_arena(slots, static_cast<unsigned>(slots)).execute(function);
}

template <class Function>
void run_by(int threads, const Function& function)
{
  tbb::task_arena(threads).execute(function);
}

// Runs searches that have nothing to do with each other, each in sequence.
void run_alone(const std::vector<Many_search>& searches, int count)
{
  std::vector<std::thread> threads;
  for(int i = 0; i < count; ++i)
    threads.emplace_back(searches[static_cast<std::size_t>(i)].sequential);
  for(std::thread& thread : threads)
    thread.join();
}

// What is found by one thread and by all has to be what is found in sequence.
Tally checked_tally(const std::string& name, const Many_search& search)
{
  search.sequential();
  const Tally expected = search.found();
  run_by_one(search.parallel);
  check_equal(name + " by one thread", expected, search.found());
  run_by(tbb::info::default_concurrency(), search.parallel);
  check_equal(name + " by all threads", expected, search.found());
  return expected;
}

// In sequence and by one thread, in the time of the processor; then by the clock in sequence, and
// for each number of threads the search and the independent ones.
std::vector<Seconds> times_of(const std::vector<Many_search>& searches, int rounds)
{
  const Many_search& search = searches[0];
  std::vector<Job> jobs
    = {timed(search.sequential), timed([=] { run_by_one(search.parallel); }),
       timed_by_the_clock(search.sequential)};
  for(const int count : thread_counts()) {
    jobs.push_back(timed_by_the_clock([=] { run_by(count, search.parallel); }));
    jobs.push_back(timed_by_the_clock([&searches, count] { run_alone(searches, count); }));
  }
  return time_in_turns(jobs, rounds);
}

void print_row(const Many_row& row, std::size_t n, int rounds)
{
  std::vector<Many_search> searches(1, row.make(n));
  const Tally expected = checked_tally(row.name, searches[0]);
  while(static_cast<int>(searches.size()) < tbb::info::default_concurrency())
    searches.push_back(row.make(n));
  const std::vector<Seconds> times = times_of(searches, rounds);
  const auto cell = [&](auto value, int decimals) { return fixed(median(times, value), decimals); };
  std::string line = cell([](const Seconds& s) { return 1000 * s[0]; }, 1);
  const double of_one = median(times, [](const Seconds& s) { return s[1] / s[0]; });
  line += " | " + fixed(of_one, 2) + " | <= 1.08 | " + (of_one <= 1.08 ? "met" : "missed");
  std::size_t job = 3;
  for(const int count : thread_counts()) {
    line += " | " + cell([=](const Seconds& s) { return s[2] / s[job]; }, 2) + " | "
            + cell([=](const Seconds& s) { return count * s[2] / s[job + 1]; }, 2);
    job += 2;
  }
  print_line(row.name, n, expected.pairs, line);
}

} // namespace

void print_table(const Settings& settings)
{
  std::vector<std::string> names = {"search", ">n", ">pairs", ">ms in sequence", ">1 thread",
                                    ">target", "verdict"};
  for(const int count : thread_counts()) {
    names.push_back(">" + std::to_string(count) + " threads");
    names.push_back(">machine");
  }
  print_head(names);
  std::vector<std::size_t> sizes = {settings.is_quick ? std::size_t(10000) : 1000000};
  if(settings.is_large)
    sizes.push_back(10000000);
  for(const std::size_t n : sizes)
    for(const auto& rows : {many_rows(), other_rows()})
      for(const Many_row& row : rows)
        if(row.name.find(settings.only) != std::string::npos)
          print_row(row, n, settings.is_quick ? 3 : 9);
}

} // namespace thick_benchmark
