// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/mesh_methods.h"
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
Rows measure_mesh(const std::string& name, const Mesh_goals& goals, const Make_mesh& make,
                  std::size_t n)
{
  const double for_boxes = 1.5, for_pair = 40e-9;
  const Mesh_scene scene = make(n);
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

class Touching_experiments
{
public:
  explicit Touching_experiments(const Settings& settings) : settings_(settings) {}

  // With few exact ties.
  void add_general()
  {
    const Goal goal = at_most(1.2, 1);
    add("2D segments", goal, [](auto n) { return uniform_segments(2, n, n / 2); });
    add("3D triangles", goal, [](auto n) { return uniform_triangles(n, n / 2); });
    add("2D roads", goal, roads);
    add("2D streets", goal, streets);
  }

  // What shares vertices.
  void add_joined()
  {
    const Goal goal = at_most(1.2, 0.8);
    add("3D paths", goal, [](auto n) { return paths(n, n / 2); });
    add("3D beams", goal, frame_of_beams);
    add("2D triangulation", goal, triangulation);
    add("3D terrain", goal, terrain);
  }

  // In one plane, or nearly so.
  void add_flat()
  {
    const Goal goal = at_most(1.5, 1.1);
    add("2D rows of triangles", goal, rows_of_triangles);
    add("3D floor", goal, floor_of_triangles);
    add("3D tilted bricks", goal, bricks_of_decimals);
    add("3D tilted bricks in one plane", goal, bricks_of_floats);
    add("3D walls on floors", goal, walls_on_floors);
  }

  void add_tetrahedra()
  {
    const Goal goal = at_most(0.8, 0.5);
    add_row("3D tetrahedra of a mesh", measure_objects, goal, tetrahedra_of_mesh, 40000);
    add_row("3D tetrahedra, shifted", measure_objects, goal, shifted_tetrahedra, 40000);
  }

  void add_meshes()
  {
    add_mesh("mesh of a sphere", Goal(), sphere_mesh);
    add_mesh("mesh of a terrain", at_most(0.2), terrain_mesh);
    add_mesh("mesh of a floor", at_most(0.2), floor_mesh);
  }

  const Experiments& all() const { return all_; }

private:
  void add(const std::string& name, const Goal& goal, const Make_objects& make)
  {
    add_row(name, measure_objects, goal, make, 100000);
  }

  // And with its faces in random order, without goals: then memory takes most of the time.
  void add_mesh(const std::string& name, const Goal& pmp, const Make_mesh& make)
  {
    const Make_mesh make_shuffled = [=](std::size_t n) { return with_shuffled_faces(make(n)); };
    add_row(name, measure_mesh, Mesh_goals{at_most(1), pmp}, make, 200000);
    add_row(name + ", shuffled", measure_mesh, Mesh_goals{}, make_shuffled, 200000);
  }

  template <class Measurement, class Goals, class Make>
  void add_row(const std::string& name, const Measurement& measurement, const Goals& goals,
               const Make& make, std::size_t n)
  {
    const std::size_t fitted = settings_.is_quick ? n / 30 : n;
    all_.push_back({name, [=] { return measurement(name, goals, make, fitted); }});
  }

  const Settings settings_;
  Experiments all_;
};

} // namespace

void print_table(const Settings& settings)
{
  Touching_experiments all(settings);
  all.add_general();
  all.add_joined();
  all.add_flat();
  all.add_tetrahedra();
  all.add_meshes();
  print_rows(all.all(), settings);
}

} // namespace thick_benchmark
