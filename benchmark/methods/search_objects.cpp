// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "object_methods.h"
#include "on_objects.h"

#include <CGAL/thick_intersection_d.h>

#include <type_traits>

namespace thick_benchmark {

namespace {

// The named parameters of a search: balls need their traits.
template <class Object, class... Others>
auto parameters_of(const std::vector<Object>& objects, const Others&... others)
{
  if constexpr(std::is_same_v<Object, Ball_3>)
    return CGAL::parameters::geom_traits(
      CGAL::Thick_ball_traits_d<Epick::Point_3>(objects, others...));
  else
    return CGAL::parameters::default_values();
}

template <class ConcurrencyTag, class Object, class Callback>
void search(const Objects<Object>& objects, Callback& callback)
{
  if(objects.are_two_sets)
    CGAL::thick_intersection_d<ConcurrencyTag>(objects.a, objects.b, callback,
                                               parameters_of(objects.a, objects.b));
  else
    CGAL::thick_self_intersection_d<ConcurrencyTag>(objects.a, callback,
                                                    parameters_of(objects.a));
}

#ifdef CGAL_LINKED_WITH_TBB
template <class ConcurrencyTag>
Run<Tally> run_with_parallel_tally(const Object_scene& scene)
{
  return run_on_objects<Tally>(scene, [](const auto& objects, Tally& tally) {
    const Parallel_tally sum;
    search<ConcurrencyTag>(objects, sum);
    tally = sum.sum();
  });
}
#endif

} // namespace

Search search_objects(const Object_scene& scene)
{
  Search result;
  result.sequential = run_on_objects<Tally>(scene, [](const auto& objects, Tally& tally) {
    search<CGAL::Sequential_tag>(objects, tally);
  });
#ifdef CGAL_LINKED_WITH_TBB
  result.parallel = run_with_parallel_tally<CGAL::Parallel_tag>(scene);
  result.sequential_like_parallel = run_with_parallel_tally<CGAL::Sequential_tag>(scene);
#endif
  return result;
}

Run<Pair_list> list_pairs(const Object_scene& scene)
{
  return run_on_simplices<Pair_list, Epick>(scene, [](const auto& objects, Pair_list& pairs) {
    search<CGAL::Sequential_tag>(objects, pairs);
  });
}

} // namespace thick_benchmark
