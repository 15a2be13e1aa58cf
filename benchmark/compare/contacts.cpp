// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_tables.h"

#include "measuring/timing.h"
#include "methods/contact_methods.h"

namespace thick_benchmark {

namespace {

void print_times(const std::string& name, const std::vector<Contact_method>& methods, int rounds)
{
  std::vector<Job> jobs;
  std::vector<std::size_t> counts;
  for(const Contact_method& method : methods) {
    counts.push_back(method.count());
    jobs.push_back(timed(method.count));
  }
  const std::vector<Seconds> times = time_in_turns(jobs, rounds, 0);
  for(std::size_t k = 0; k < methods.size(); ++k)
    print_line(name, methods[k].name, counts[k],
               1000 * median(times, [=](const Seconds& s) { return s[k]; }),
               median(times, [=](const Seconds& s) { return s[k] / s[0]; }));
}

} // namespace

void print_contacts(std::size_t n, int rounds)
{
  std::cout << "\nTwo meshes of " << n << " faces each.\n\n";
  print_head("meshes", "found", "ms", "time / ours");
  for(const Two_meshes& meshes : two_meshes(n)) {
    const std::string name = meshes.name + (meshes.do_meet ? ", 1 is right" : ", 0 is right");
    print_times(name, ways_to_any_contact(meshes), rounds);
    print_times(meshes.name, ways_to_all_contacts(meshes), rounds);
  }
}

} // namespace thick_benchmark
