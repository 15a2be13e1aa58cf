// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/overlap_methods.h"

namespace thick_benchmark {

namespace {

struct Overlap_row
{
  std::string name;
  Rings (*make)(std::size_t);
  std::size_t n;
};

// The time in that of the others, all of which find the same pairs. GEOS rounds, so it may not.
Rows measure_overlaps(const std::string& name, const Rings& rings)
{
  const Overlap_search ours = overlaps_by_interiors(rings);
  const Overlap_search closed = intersections_of_polygons(rings);
  const Overlap_search boolean_sets = overlaps_by_boolean_sets(rings);
  const Tally found = ours();
  check_equal(name, boolean_sets(), found);
  std::vector<Job> jobs = {timed(ours), timed(closed), timed(boolean_sets)};
#ifdef THICK_BENCHMARK_HAS_GEOS
  jobs.push_back(timed(overlaps_by_geos(rings)));
#endif
  const std::vector<Seconds> times = time_in_turns(jobs, 3, 0);
  const auto row = [&](const std::string& quantity, const Goal& goal, std::size_t other) {
    const auto ratio = [=](const Seconds& s) { return s[0] / s[other]; };
    return Row{name, quantity, goal, median(times, ratio), rings.size(), found.pairs,
               median(times, milliseconds_of_first)};
  };
  Rows rows = {row("time / closed polygons", Goal(), 1),
               row("time / Boolean sets", at_most(.05, .01), 2)};
#ifdef THICK_BENCHMARK_HAS_GEOS
  rows.push_back(row("time / GEOS", at_most(1), 3));
  const Tally of_geos = overlaps_by_geos(rings)();
  rows.push_back({name, "pairs of GEOS", Goal(), static_cast<double>(of_geos.pairs), rings.size(),
                  found.pairs, std::nullopt});
#endif
  return rows;
}

std::vector<Overlap_row> overlap_rows()
{
  return {{"parcels", parcels, 100000},
          {"triangles", triangles_of_parcels, 60000},
          {"parcels of long borders", parcels_of_long_borders, 200000},
          {"stars", stars, 200000}};
}

} // namespace

void print_table(const Settings& settings)
{
  Experiments all;
  for(const Overlap_row& row : overlap_rows())
    all.push_back({row.name, [=] {
                     return measure_overlaps(row.name,
                                             row.make(settings.is_quick ? row.n / 30 : row.n));
                   }});
  print_rows(all, settings);
}

} // namespace thick_benchmark
