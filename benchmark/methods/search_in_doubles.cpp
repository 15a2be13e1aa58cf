// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "object_methods.h"
#include "on_objects.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/intersections.h>
#include <CGAL/thick_intersection_d.h>

#include <vector>

namespace thick_benchmark {

namespace {

// The test is that of the kernel, whatever it is worth. All else is that of Thick_object_traits_d,
// so that two searches differ in nothing but the test.
template <class Object>
struct Kernel_test_traits : CGAL::Thick_object_traits_d<Object>
{
  struct Do_intersect_d
  {
    bool operator()(const Object& a, const Object& b) const { return CGAL::do_intersect(a, b); }

    // What the library calls for its own traits.
    bool decide(const Object& a, const Object& b) const { return (*this)(a, b); }
  };

  Do_intersect_d do_intersect_d_object() const { return {}; }
};

template <class Object, class Callback>
void search(const std::vector<Object>& objects, Callback& callback)
{
  CGAL::thick_self_intersection_d(objects, callback,
                                  CGAL::parameters::geom_traits(Kernel_test_traits<Object>()));
}

template <class Answer>
Run<Answer> run(const Object_scene& scene)
{
  return run_on_simplices<Answer, CGAL::Simple_cartesian<double>>(
    scene, [](const auto& objects, Answer& answer) { search(objects.a, answer); });
}

} // namespace

Run<Tally> search_in_doubles(const Object_scene& scene) { return run<Tally>(scene); }

Run<Pair_list> list_pairs_in_doubles(const Object_scene& scene) { return run<Pair_list>(scene); }

} // namespace thick_benchmark
