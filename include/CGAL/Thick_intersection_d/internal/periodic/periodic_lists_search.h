// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_LISTS_SEARCH_H

// The search behind periodic_fixed_radius_neighbor_lists(): the pairs of images, sorted by points.

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Periodic_neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/lists/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_search.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_sets.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
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

// Lists of neighbors that are moved, of few of many points.
template <int Dimension>
class Image_neighbors
{
  using Neighbor = Image_neighbor<Dimension>;

public:
  // Takes the neighbors of so many points, which each thread has found some of. Distributes them
  // over the points, then sorts each list.
  template <class Parts>
  Image_neighbors(std::size_t size, Parts& parts)
    : begins_(size + 2, 0) // of the list after the next one, at first
  {
    parts.for_each([&](const std::vector<Neighbor>& neighbors) {
      for(const Neighbor& neighbor : neighbors)
        ++begins_[neighbor.point + 2];
    });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    neighbors_.resize(begins_.back());
    parts.for_each([&](const std::vector<Neighbor>& neighbors) {
      for(const Neighbor& neighbor : neighbors)
        neighbors_[begins_[neighbor.point + 1]++] = neighbor;
    });
    for(std::size_t i = 0; i < size; ++i)
      std::sort(neighbors_.data() + begins_[i], neighbors_.data() + begins_[i + 1]);
  }

  std::size_t begin(std::size_t i) const { return begins_[i]; }

  // The neighbors of point i, in the order of their positions and offsets.
  boost::iterator_range<const Neighbor*> operator[](std::size_t i) const
  {
    return {neighbors_.data() + begins_[i], neighbors_.data() + begins_[i + 1]};
  }

private:
  std::vector<std::size_t> begins_;
  std::vector<Neighbor> neighbors_;
};

// Returns the lists of both kinds of neighbors, those that no offset between homes moves and the
// others. offset_of(i, j) returns the offset of the former.
template <int Dimension, class Offset_of>
Periodic_neighbor_lists<Dimension>
merged_lists(const Neighbor_lists& of_homes, const Image_neighbors<Dimension>& moved,
             bool are_of_one_set, const Offset_of& offset_of, const Threads& threads)
{
  using Neighbor = Image_neighbor<Dimension>;
  std::vector<std::size_t> begins(of_homes.size() + 1, 0);
  for(std::size_t i = 0; i < begins.size(); ++i)
    begins[i] = of_homes.begins()[i] + moved.begin(i);
  std::vector<Neighbor_lists::Position> positions(begins.back());
  std::vector<Offset<Dimension>> offsets(begins.back());
  threads.run_blocks(of_homes.size(), [&](std::size_t i, std::size_t end) {
    for(std::size_t place = begins[i]; i != end; ++i) {
      auto next = moved[i].begin();
      const auto put_until = [&](const Neighbor& last) {
        for(; next != moved[i].end() && *next < last; ++next, ++place) {
          positions[place] = next->neighbor;
          offsets[place] = next->offset;
        }
      };
      for(const Neighbor_lists::Position j : of_homes[i]) {
        const Neighbor home = {static_cast<Neighbor_lists::Position>(i), j, offset_of(i, j)};
        put_until(home);
        positions[place] = j;
        offsets[place++] = home.offset;
      }
      for(; next != moved[i].end(); ++next, ++place) {
        positions[place] = next->neighbor;
        offsets[place] = next->offset;
      }
    }
  });
  return {Neighbor_lists(std::move(begins), std::move(positions), are_of_one_set),
          std::move(offsets)};
}

// Adds the second point of a pair as a neighbor, and in one set the first point as well.
template <class Sets, int Dimension>
void add_neighbors(std::size_t i, std::size_t j, const Offset<Dimension>& offset,
                   std::vector<Image_neighbor<Dimension>>& neighbors)
{
  using Position = Neighbor_lists::Position;
  neighbors.push_back({static_cast<Position>(i), static_cast<Position>(j), offset});
  if constexpr(!Sets::are_two)
    neighbors.push_back({static_cast<Position>(j), static_cast<Position>(i),
                         offset_between(offset, Offset<Dimension>{})});
}

// The pairs that no offset between homes moves are most of all, and make lists as without periods.
template <class Domain, class NT, class NamedParameters, class... Ranges>
auto collect_periodic_neighbors(const Domain& domain, const Distance_bound<NT>& bound,
                                const NamedParameters& np, const Threads& threads,
                                Ranges&... ranges)
{
  const auto collect = [&](const auto& elements, const auto& sets) {
    constexpr int dimension = domain_dimension_v<Domain>;
    using Neighbor = Image_neighbor<dimension>;
    using Sets = std::decay_t<decltype(sets)>;
    Periodic_search<std::decay_t<decltype(elements)>, Sets, Domain, NT>
      search(elements, sets, domain, bound, false, threads);

    auto& scene = search.scene();
    Neighbor_lists of_homes(std::vector<std::size_t>(scene.first_size() + 1, 0), {},
                            !Sets::are_two);
    const auto np_of_search = parameters_for_parts(np);
    bool is_complete = scene.find_images(np_of_search);
    if(is_complete)
      scene.with_homes([&](const auto& homes) {
        const auto np_of_homes = scene.parameters_of_homes(np_of_search);
        is_complete = collect_pairs(of_homes, homes, sets,
                                    near_search(bound, np_of_homes, threads), threads);
      });

    Per_thread<std::vector<Neighbor>> parts(std::vector<Neighbor>(), threads);
    const auto add = [&](std::size_t i, std::size_t j, const Offset<dimension>& offset) {
      add_neighbors<Sets, dimension>(i, j, offset, parts.local());
    };
    if(is_complete)
      search.report_near(add, np_of_search, nullptr);
    return merged_lists<dimension>(
      of_homes, Image_neighbors<dimension>(of_homes.size(), parts), !Sets::are_two,
      [&](std::size_t i, std::size_t j) {
        return scene.offset_of_homes(i, scene.first_of_second() + j);
      }, threads);
  };
  return with_periodic_sets<Domain>(np, collect, ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_LISTS_SEARCH_H
