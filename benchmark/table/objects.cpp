// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/object_methods.h"
#include "scenes/generators.h"
#include "scenes/object_generators.h"

namespace thick_benchmark {

namespace {

// ---- against box intersection -------------------------------------------------------------------

// A way to the pairs of a scene, which has been run once.
struct Entrant
{
  std::string name;
  Run<Tally> run;
  Tally tally;
  double seconds;
};

template <class Method, class Scene>
Entrant make_entrant(const Method& method, const Scene& scene)
{
  Entrant entrant{method.name, method.prepare(scene), {}, 0};
  entrant.seconds = processor_seconds_of([&] { entrant.tally = entrant.run(); });
  return entrant;
}

// Box intersection with the cutoff that is the best of four; all of them have found the same pairs.
// Once a cutoff takes twice as long as the best, larger ones are left out.
template <class Scene, class Boxes>
Entrant best_boxes(const std::string& name, const Scene& scene, const Boxes& boxes)
{
  Entrant best = make_entrant(boxes(10), scene);
  for(const std::ptrdiff_t cutoff : {100, 1000, 10000}) {
    const Entrant entrant = make_entrant(boxes(cutoff), scene);
    check_equal(name + ": " + entrant.name, best.tally, entrant.tally);
    if(entrant.seconds > 2 * best.seconds)
      break;
    if(entrant.seconds < best.seconds)
      best = entrant;
  }
  return best;
}

// Slow rounds are fewer.
int rounds_for(const std::vector<Entrant>& entrants)
{
  double seconds = 0;
  for(const Entrant& entrant : entrants)
    seconds += entrant.seconds;
  return seconds < 0.3 ? 7 : seconds < 1 ? 5 : 3;
}

// A row for each entrant: the time of the subject in that of the entrant. The goal is that of the
// first one. All have been run once, and so has the subject.
Rows measure_against(const Subject& subject, const Goal& goal,
                     const std::vector<Entrant>& entrants)
{
  std::vector<Job> jobs = {timed(subject.search.sequential)};
  for(const Entrant& entrant : entrants)
    jobs.push_back(timed(entrant.run));
  const std::vector<Seconds> times = time_in_turns(jobs, rounds_for(entrants), 0);
  Rows rows;
  for(std::size_t i = 0; i < entrants.size(); ++i)
    rows.push_back({subject.name, "time / " + entrants[i].name, i == 0 ? goal : Goal(),
                    median(times, [=](const Seconds& s) { return s[0] / s[i + 1]; }), subject.n,
                    subject.k, median(times, milliseconds_of_first)});
  return rows;
}

// ---- objects ------------------------------------------------------------------------------------

// What else is measured: nothing, the speed-up by two threads, and the other methods besides.
enum class Extras { NONE, THREADS, RIVALS };

std::vector<Object_method> rivals([[maybe_unused]] const Object_scene& scene)
{
  std::vector<Object_method> methods = {boxes_of_objects(10), boxes_by_address()};
#ifdef THICK_BENCHMARK_HAS_ARBORX
  if(scene.shape == Shape::BOX)
    methods.push_back(bvh_of_boxes());
#endif
  return methods;
}

using Make_objects = std::function<Object_scene(std::size_t)>;

Rows measure_objects(const std::string& name, const Goal& goal, const Make_objects& make,
                     std::size_t n, Extras extras)
{
  const Object_scene scene = make(n);
  std::vector<Entrant> entrants = {best_boxes(name, scene, boxes_of_objects)};
  const Tally expected = entrants.front().tally;
  if(extras == Extras::RIVALS)
    for(const Object_method& method : rivals(scene)) {
      entrants.push_back(make_entrant(method, scene));
      check_equal(name + ": " + method.name, expected, entrants.back().tally);
    }
  const Subject subject = make_subject(name, scene.size(), search_objects(scene), expected);
  Rows rows = measure_against(subject, goal, entrants);
#ifdef CGAL_LINKED_WITH_TBB
  if(extras != Extras::NONE)
    rows.push_back(measure_two_threads(subject));
#endif
  return rows;
}

Rows measure_points(const std::string& name, const Goal& goal, int dimension, std::size_t n,
                    Dimension_kind kind)
{
  const Scene scene = uniform(dimension, n, static_cast<double>(n) / 2);
  const Entrant boxes = best_boxes(
    name, scene, [=](std::ptrdiff_t cutoff) { return boxes_of_points_d(cutoff, kind); });
  return measure_against(make_subject(name, n, search_points_d(scene, kind), boxes.tally), goal,
                         {boxes});
}

Rows measure_boxes_d(const std::string& name, const Goal& goal, int dimension, std::size_t n,
                     Dimension_kind kind)
{
  const Object_scene scene = uniform_boxes_d(dimension, n, static_cast<double>(n) / 2);
  const Entrant boxes = best_boxes(name, scene, boxes_d);
  return measure_against(make_subject(name, n, search_boxes_d(scene, kind), boxes.tally), goal,
                         {boxes});
}

// ---- the table ----------------------------------------------------------------------------------

std::string in_space(int dimension, const std::string& name)
{
  return std::to_string(dimension) + "D " + name;
}

std::string suffix_of(Dimension_kind kind)
{
  return kind == Dimension_kind::STATIC ? "" : ", dynamic dimension";
}

const Goal in_four_dimensions = at_most(0.25, 0.12), in_six_dimensions = at_most(0.45, 0.3);

class Object_experiments
{
public:
  explicit Object_experiments(const Settings& settings) : settings_(settings) {}

  void add_boxes_of_the_plane()
  {
    const Goal goal = at_most(0.25, 0.14);
    add_main("2D rectangles, k ~ n/2", goal, [](auto n) { return uniform_boxes(2, n, n / 2); });
    add("2D rectangles, k ~ 10 n", goal, [](auto n) { return uniform_boxes(2, n, 10 * n); });
    add_main("2D squares by a power law", goal, [](auto n) { return power_law_boxes(2, n, n); });
    add("2D squares of six decades", goal, [](auto n) { return log_uniform_boxes(2, n, n); });
    add("2D thin rectangles", goal, [](auto n) { return thin_boxes(n, n); });
    add("2D rectangles and a giant", goal, [](auto n) { return boxes_with_giant(2, n, n / 2); });
    add("2D squares in clusters", goal, [](auto n) { return clustered_boxes(2, n); });
    add("2D long along one axis", goal, [](auto n) { return long_boxes(2, n, n); });
  }

  void add_boxes_of_space()
  {
    const Goal even = at_most(0.2, 0.1), skewed = at_most(0.25, 0.12);
    add_main("3D cuboids, k ~ n/2", even, [](auto n) { return uniform_boxes(3, n, n / 2); });
    add_main("3D cuboids, k ~ 10 n", even, [](auto n) { return uniform_boxes(3, n, 10 * n); });
    add("3D cubes by a power law", skewed, [](auto n) { return power_law_boxes(3, n, n); });
    add_main("3D cubes of six decades", skewed, [](auto n) { return log_uniform_boxes(3, n, n); });
    add("3D cuboids and a giant", skewed, [](auto n) { return boxes_with_giant(3, n, n / 2); });
    add("3D beams", skewed, [](auto n) { return beams(n, n); });
    add("3D cubes in clusters", skewed, [](auto n) { return clustered_boxes(3, n); });
    add("3D long along one axis", skewed, [](auto n) { return long_boxes(3, n, n); });
  }

  // With the exact test, which takes most of the time of both sides where segments in space meet at
  // their ends, so paths have no target.
  void add_other_shapes()
  {
    const Goal goal = at_most(0.3, 0.2);
    add_main("3D balls of radii .3 to .5", at_most(0.2, 0.1),
             [](auto n) { return uniform_balls(n, n); });
    add("3D balls by a power law", at_most(0.25, 0.12),
        [](auto n) { return power_law_balls(n, n); });
    add_main("2D segments", goal, [](auto n) { return uniform_segments(2, n, n / 2); });
    add("3D segments", goal, [](auto n) { return uniform_segments(3, n, n / 2); });
    add("2D roads", goal, roads);
    add("3D paths", Goal(), [](auto n) { return paths(n, n / 2); });
    add_main("3D triangles", goal, [](auto n) { return uniform_triangles(n, n / 2); });
    for(int d : {2, 3})
      add_main(in_space(d, "boxes of a mesh"), at_most(0.3, 0.18),
               [=](auto n) { return mesh_boxes(d, n); });
  }

  // Where no cut helps.
  void add_hard()
  {
    const Goal goal = at_most(0.6, 0.3);
    for(int d : {2, 3}) {
      add(in_space(d, "overlap on one axis"), goal,
          [=](auto n) { return boxes_on_one_axis(d, n, n / 2); });
      add(in_space(d, "trap for trees"), goal, [=](auto n) { return trap(d, n); });
      add_dense(in_space(d, "nested"), goal, [=](auto n) { return nested_boxes(d, n); });
      add_dense(in_space(d, "identical"), goal, [=](auto n) { return identical_boxes(d, n); });
    }
  }

  void add_two_sets()
  {
    for(int d : {2, 3})
      add(in_space(d, "boxes of two sets, k ~ n/2"), at_most(0.3, 0.15),
          [=](auto n) { return in_two_sets(uniform_boxes(d, n, n)); });
  }

  void add_points()
  {
    add_points(4, in_four_dimensions, 200000);
    add_points(5, at_most(0.35, 0.2), 200000);
    add_points(6, in_six_dimensions, 200000);
    add_points(8, at_most(0.7, 0.5), 30000);
  }

  // With the targets of points.
  void add_boxes_of_more_dimensions()
  {
    add_boxes(4, in_four_dimensions, Dimension_kind::STATIC);
    add_boxes(6, in_six_dimensions, Dimension_kind::STATIC);
  }

  // With the targets of what the compiler knows more about.
  void add_dynamic_dimension()
  {
    add_points(4, in_four_dimensions, 200000, Dimension_kind::DYNAMIC);
    add_points(6, in_six_dimensions, 200000, Dimension_kind::DYNAMIC);
    add_boxes(4, in_four_dimensions, Dimension_kind::DYNAMIC);
    add_boxes(6, in_six_dimensions, Dimension_kind::DYNAMIC);
  }

  const Experiments& all() const { return all_; }

private:
  void add(const std::string& name, const Goal& goal, const Make_objects& make)
  {
    add_objects(name, goal, make, 300000, Extras::NONE);
    if(settings_.is_large)
      add_objects(name + ", 10^6", goal, make, 1000000, Extras::NONE);
  }
  void add_main(const std::string& name, const Goal& goal, const Make_objects& make)
  {
    add_objects(name, goal, make, 300000, Extras::RIVALS);
    if(!settings_.is_quick)
      add_objects(name + ", 10^6", goal, make, 1000000, Extras::THREADS);
  }
  void add_dense(const std::string& name, const Goal& goal, const Make_objects& make)
  {
    add_objects(name, goal, make, 20000, Extras::NONE);
  }

  void add_objects(const std::string& name, const Goal& goal, const Make_objects& make,
                   std::size_t n, Extras extras)
  {
    add_row(name, measure_objects, goal, make, fitted(n), extras);
  }
  void add_points(int dimension, const Goal& goal, std::size_t n,
                  Dimension_kind kind = Dimension_kind::STATIC)
  {
    add_row(in_space(dimension, "points, k ~ n/2") + suffix_of(kind), measure_points, goal,
            dimension, fitted(n), kind);
  }
  void add_boxes(int dimension, const Goal& goal, Dimension_kind kind)
  {
    add_row(in_space(dimension, "boxes, k ~ n/2") + suffix_of(kind), measure_boxes_d, goal,
            dimension, fitted(200000), kind);
  }

  template <class Measurement, class... Arguments>
  void add_row(const std::string& name, const Measurement& measurement,
               const Arguments&... arguments)
  {
    all_.push_back({name, [=] { return measurement(name, arguments...); }});
  }

  std::size_t fitted(std::size_t n) const { return settings_.is_quick ? n / 30 : n; }

  const Settings settings_;
  Experiments all_;
};

} // namespace

void print_table(const Settings& settings)
{
  Object_experiments all(settings);
  all.add_boxes_of_the_plane();
  all.add_boxes_of_space();
  all.add_other_shapes();
  all.add_hard();
  all.add_two_sets();
  all.add_points();
  all.add_boxes_of_more_dimensions();
  all.add_dynamic_dimension();
  print_rows(all.all(), settings);
}

} // namespace thick_benchmark
