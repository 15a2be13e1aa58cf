// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/overlap_methods.h"
#include "scenes/object_generators.h"
#include "scenes/touching_generators.h"

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

// Objects overlap if they intersect, in a scene without ties, or no two of them do.
struct Object_row
{
  std::string name;
  Object_scene (*make)(std::size_t);
  bool do_only_touch;
  std::size_t n;
};

Rows measure_objects(const Object_row& row, std::size_t n)
{
  const Object_scene scene = row.make(n);
  const Overlap_search interiors = overlaps_by_interiors(scene);
  const Overlap_search closed = intersections_of_objects(scene);
  const Tally found = closed();
  check_equal(row.name, row.do_only_touch ? Tally() : found, interiors());
  const std::vector<Seconds> times = time_in_turns({timed(interiors), timed(closed)}, 7, 0);
  return {{row.name, "time / closed objects", at_most(1.1),
           median(times, [](const Seconds& s) { return s[0] / s[1]; }), scene.size(),
           row.do_only_touch ? 0 : found.pairs, median(times, milliseconds_of_first)}};
}

std::vector<Object_row> object_rows()
{
  return {{"2D boxes", [](auto n) { return uniform_boxes(2, n, n); }, false, 300000},
          {"3D boxes", [](auto n) { return uniform_boxes(3, n, n); }, false, 300000},
          {"balls", [](auto n) { return uniform_balls(n, n); }, false, 300000},
          {"2D triangulation", triangulation, true, 300000},
          {"3D tetrahedra of a mesh", tetrahedra_of_mesh, true, 40000}};
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
  for(const Object_row& row : object_rows())
    all.push_back({row.name, [=] {
                     return measure_objects(row, settings.is_quick ? row.n / 30 : row.n);
                   }});
  print_rows(all, settings);
}

} // namespace thick_benchmark
