// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_LISTS_SEARCH_H

// The search behind periodic_fixed_radius_neighbor_lists(): the pairs of images, sorted by points.

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Periodic_neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/doors/periodic_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A neighbor of a point, and how it is moved.
template <int Dimension>
struct Image_neighbor
{
  Neighbor_lists::Position point;
  Neighbor_lists::Position neighbor;
  Offset<Dimension> offset;

  friend bool operator<(const Image_neighbor& a, const Image_neighbor& b)
  {
    return std::tie(a.neighbor, a.offset) < std::tie(b.neighbor, b.offset);
  }
};

// Returns the lists of so many points. Distributes the neighbors over the lists, then sorts each.
template <int Dimension, class Neighbors>
Periodic_neighbor_lists<Dimension> sorted_lists(std::size_t size, Neighbors& parts,
                                                bool are_of_one_set)
{
  std::vector<std::size_t> begins(size + 2, 0); // of the list after the next one, at first
  parts.for_each([&](const auto& neighbors) {
    for(const auto& neighbor : neighbors)
      ++begins[neighbor.point + 2];
  });
  for(std::size_t i = 2; i < begins.size(); ++i)
    begins[i] += begins[i - 1];
  std::vector<Image_neighbor<Dimension>> sorted(begins.back());
  parts.for_each([&](const auto& neighbors) {
    for(const auto& neighbor : neighbors)
      sorted[begins[neighbor.point + 1]++] = neighbor;
  });
  begins.pop_back();
  std::vector<Neighbor_lists::Position> positions(sorted.size());
  std::vector<Offset<Dimension>> offsets(sorted.size());
  for(std::size_t i = 0; i < size; ++i)
    std::sort(sorted.data() + begins[i], sorted.data() + begins[i + 1]);
  for(std::size_t k = 0; k < sorted.size(); ++k) {
    positions[k] = sorted[k].neighbor;
    offsets[k] = sorted[k].offset;
  }
  return {Neighbor_lists(std::move(begins), std::move(positions), are_of_one_set),
          std::move(offsets)};
}

template <class ConcurrencyTag, class Domain, class NT, class NamedParameters, class... Ranges>
auto collect_periodic_neighbors(const Domain& domain, const Distance_bound<NT>& bound,
                                const NamedParameters& np, Ranges&... ranges)
{
  const auto collect = [&](const auto& elements, const auto& sets) {
    constexpr int dimension = decltype(lattice_of(domain))::dimension;
    using Neighbor = Image_neighbor<dimension>;
    using Position = Neighbor_lists::Position;
    using Sets = std::decay_t<decltype(sets)>;
    Per_thread<ConcurrencyTag, std::vector<Neighbor>> parts{std::vector<Neighbor>()};
    const auto add = [&](std::size_t i, std::size_t j, const Offset<dimension>& offset) {
      std::vector<Neighbor>& own = parts.local();
      own.push_back({static_cast<Position>(i), static_cast<Position>(j), offset});
      if constexpr(!Sets::are_two)
        own.push_back({static_cast<Position>(j), static_cast<Position>(i),
                       offset_between(offset, Offset<dimension>{})});
    };
    Periodic_search<ConcurrencyTag, std::decay_t<decltype(elements)>, Sets, Domain, NT>
      search(elements, sets, domain, bound, false);
    search.report(add, np, nullptr);
    return sorted_lists<dimension>(elements.first().size(), parts, !Sets::are_two);
  };
  return with_periodic_sets<ConcurrencyTag, Domain>(np, collect, ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PERIODIC_LISTS_SEARCH_H
