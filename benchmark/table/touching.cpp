// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/object_methods.h"
#include "scenes/object_generators.h"
#include "scenes/touching_generators.h"

namespace thick_benchmark {

namespace {

// Slow rounds are fewer.
int rounds_for(const Run<Tally>& run) { return processor_seconds_of(run) < 1 ? 7 : 3; }

// ---- objects ------------------------------------------------------------------------------------

using Make_objects = std::function<Object_scene(std::size_t)>;

// The time with exact tests in that with plain doubles, and what these get wrong.
Rows measure_objects(const std::string& name, const Goal& goal, const Make_objects& make,
                     std::size_t n)
{
  const Object_scene scene = make(n);
  const Tally expected = boxes_of_objects(100).prepare(scene)();
  const Subject subject = make_subject(name, scene.size(), search_objects(scene), expected);
  const Run<Tally>& exact = subject.search.sequential;
  const std::vector<Seconds> times
    = time_in_turns({timed(exact), timed(search_in_doubles(scene))}, rounds_for(exact));
  const Pair_list right = list_pairs(scene)(), found = list_pairs_in_doubles(scene)();
  const std::size_t wrong_pairs = count_missing(right, found) + count_missing(found, right);
  return {{name, "time / doubles", goal,
           median(times, [](const Seconds& s) { return s[0] / s[1]; }), subject.n, subject.k,
           median(times, milliseconds_of_first)},
          {name, "wrong pairs of doubles", Goal(), static_cast<double>(wrong_pairs), subject.n,
           subject.k, std::nullopt}};
}

// ---- meshes -------------------------------------------------------------------------------------

using Make_mesh = std::function<Mesh_scene(std::size_t)>;

struct Mesh_goals
{
  Goal boxes, pmp;
};

// The time in that of the boxes alone and of a predicate for each of the K pairs of boxes, and in
// that of CGAL.
Rows measure_mesh(const std::string& name, const Mesh_goals& goals, const Mesh_scene& scene)
{
  const double for_boxes = 1.5, for_pair = 40e-9;
  const Mesh_searches searches = mesh_searches(scene);
  const Tally found = searches.ours();
  check_equal(name, searches.as_in_pmp(), found);
  const double for_pairs = for_pair * static_cast<double>(searches.boxes_that_meet().pairs);
  const std::vector<Seconds> times = time_in_turns(
    {timed(searches.ours), timed(searches.boxes_that_meet), timed(searches.as_in_pmp)},
    rounds_for(searches.as_in_pmp));
  const auto row = [&](const std::string& quantity, const Goal& goal, const auto& value) {
    return Row{name, quantity, goal, median(times, value), scene.faces.size(), found.pairs,
               median(times, milliseconds_of_first)};
  };
  return {row("time / (1.5 boxes + 40 ns K)", goals.boxes,
              [=](const Seconds& s) { return s[0] / (for_boxes * s[1] + for_pairs); }),
          row("time / PMP", goals.pmp, [](const Seconds& s) { return s[0] / s[2]; })};
}

// ---- the table ----------------------------------------------------------------------------------

struct Object_row
{
  std::string name;
  Goal goal;
  Make_objects make;
  std::size_t n = 100000;
};

// With few exact ties; what shares vertices; what is in one plane, or nearly so; tetrahedra.
std::vector<Object_row> object_rows()
{
  const Goal general = at_most(1.2, 1), joined = at_most(1.2, 0.8), flat = at_most(1.5, 1.1);
  const Goal solid = at_most(0.8, 0.5);
  return {{"2D segments", general, [](auto n) { return uniform_segments(2, n, n / 2); }},
          {"3D triangles", general, [](auto n) { return uniform_triangles(n, n / 2); }},
          {"2D roads", general, roads},
          {"2D streets", general, streets},
          {"3D paths", joined, [](auto n) { return paths(n, n / 2); }},
          {"3D beams", joined, frame_of_beams},
          {"2D triangulation", joined, triangulation},
          {"3D terrain", joined, terrain},
          {"2D rows of triangles", flat, rows_of_triangles},
          {"3D floor", flat, floor_of_triangles},
          {"3D tilted bricks", flat, bricks_of_decimals},
          {"3D tilted bricks in one plane", flat, bricks_of_floats},
          {"3D walls on floors", flat, walls_on_floors},
          {"3D tetrahedra of a mesh", solid, tetrahedra_of_mesh, 40000},
          {"3D tetrahedra, shifted", solid, shifted_tetrahedra, 40000}};
}

struct Mesh_row
{
  std::string name;
  Goal pmp;
  Make_mesh make;
};

std::vector<Mesh_row> mesh_rows()
{
  return {{"mesh of a sphere", Goal(), sphere_mesh},
          {"mesh of a terrain", at_most(0.2), terrain_mesh},
          {"mesh of a floor", at_most(0.2), floor_mesh}};
}

} // namespace

// Meshes are measured with their faces in random order as well, without goals: then memory takes
// most of the time.
void print_table(const Settings& settings)
{
  Experiments all;
  for(const Object_row& row : object_rows())
    all.push_back({row.name, [=, n = settings.is_quick ? row.n / 30 : row.n] {
                     return measure_objects(row.name, row.goal, row.make, n);
                   }});
  const std::size_t n = settings.is_quick ? 6666 : 200000;
  for(const Mesh_row& row : mesh_rows()) {
    all.push_back({row.name, [=] {
                     return measure_mesh(row.name, {at_most(1), row.pmp}, row.make(n));
                   }});
    all.push_back({row.name + ", shuffled", [=] {
                     return measure_mesh(row.name + ", shuffled", {},
                                         with_shuffled_faces(row.make(n)));
                   }});
  }
  print_rows(all, settings);
}

} // namespace thick_benchmark
