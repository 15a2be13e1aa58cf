// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A search of a scene, in sequence and in parallel.

#ifndef THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_MAKE_SEARCH_H
#define THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_MAKE_SEARCH_H

#include "searches.h"

#include "methods/on_objects.h"
#include "scenes/Scene.h"

#include <CGAL/Neighbor_lists.h>
#include <CGAL/thick_intersection_d.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace thick_benchmark {

// search(tag, callback) for both tags. The pairs are counted, in the same way in sequence and in
// parallel.
template <class Search>
Many_search search_of_pairs(const Search& search)
{
  const Parallel_tally tally;
  return {[=] { search(CGAL::Sequential_tag(), tally); },
          [=] { search(CGAL::Parallel_tag(), tally); }, [=] { return tally.take(); }};
}

inline Tally tally_of(const CGAL::Neighbor_lists& lists)
{
  Tally tally;
  for(std::size_t i = 0; i < lists.size(); ++i)
    for(const std::size_t j : lists[i])
      tally.neighbour(i, j);
  return tally;
}

// search(tag, lists) for both tags.
template <class Search>
Many_search search_of_lists(const Search& search)
{
  const auto lists = std::make_shared<CGAL::Neighbor_lists>();
  return {[=] { search(CGAL::Sequential_tag(), *lists); },
          [=] { search(CGAL::Parallel_tag(), *lists); },
          [=] { return tally_of(std::exchange(*lists, CGAL::Neighbor_lists())); }};
}

template <int Dimension>
auto shared_points(const Scene& scene)
{
  using Points = std::vector<Point_t<Epick, Dimension>>;
  return std::make_shared<const Points>(make_points<Epick, Dimension>(scene));
}

template <class Maker>
auto shared_objects(const Object_scene& scene)
{
  using Objects = std::vector<decltype(Maker::make(nullptr))>;
  return std::make_shared<const Objects>(make_objects<Maker>(scene).a);
}

template <class Maker>
Many_search objects(const Object_scene& scene)
{
  return search_of_pairs([all = shared_objects<Maker>(scene)](auto tag, const auto& callback) {
    CGAL::thick_self_intersection_d<decltype(tag)>(*all, callback);
  });
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_MAKE_SEARCH_H
