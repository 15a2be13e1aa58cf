// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_CLOSEST_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_CLOSEST_PAIR_SEARCH_H

// The search behind periodic_closest_pair(). The closest pair of homes and the shortest vector of
// the basis bound the distance. Neither homes nor images of one point are much closer to each other
// than the bound, so few pairs of images are within it.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/closest_pair/find_closest_pair.h>
#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_search.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_sets.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements, class Domain>
class Periodic_closest_pair_search
{
  template <class NT>
  using Search = Periodic_search<Elements, One_set, Domain, NT>;
  using Exact = typename Search<double>::Exact;
  using Offsets = typename Search<double>::Offsets;

public:
  using Pair = std::tuple<std::size_t, std::size_t, Offsets>;

  // Checks the domain and the points.
  Periodic_closest_pair_search(const Elements& points, const Domain& domain,
                               const Threads& threads)
    : points_(points), domain_(domain), threads_(threads),
      homes_(points, One_set(), domain, at_zero_, false, threads)
  {}

  // Returns the closest pair. If the search is cancelled, returns the closest of those that it has
  // seen so far.
  template <class NamedParameters>
  Pair find(const NamedParameters& np)
  {
    bool is_cancelled = false;
    Minimum minimum = homes_minimum(parameters_of_part(np, 0, 0.5, &is_cancelled));
    if(!minimum.pair)
      throw std::invalid_argument("There is no closest pair of fewer than two points.");

    // Closer pairs are few, and if there are any, they make all others no matter. Otherwise nothing
    // is left but pairs that are as close. They are few as well, unless they are of equal points:
    // then the pair is of the first two of equal homes, or an image of the first one is in another
    // pair.
    const Pair bound_pair = *minimum.pair;
    const auto bound = within_squared_distance(minimum.square);
    if(!is_cancelled)
      offer_reported(bound.open(), minimum, parameters_of_part(np, 0.5, 0.75, &is_cancelled),
                     [this](Minimum& own, const Pair& pair) { own.offer(pair, square_of(pair)); });
    if(is_cancelled)
      return *minimum.pair;
    if(*minimum.pair == bound_pair)
      offer_reported(bound, minimum, parameters_of_part(np, 0.75, 1),
                     [](Minimum& own, const Pair& pair) { own.offer_tie(pair); });
    else
      make_progress(np, points_.size()).finish();
    return *minimum.pair;
  }

private:
  struct Minimum
  {
    std::optional<Pair> pair;
    Exact square = Exact(0); // of the distance of the pair

    void offer(const Pair& other, const Exact& other_square)
    {
      if(!pair || other_square < square || (other_square == square && other < *pair)) {
        pair = other;
        square = other_square;
      }
    }

    void offer_tie(const Pair& other) { pair = (std::min)(*pair, other); }
  };

  Exact square_of(const Pair& pair) const
  {
    return homes_.scene().squared_distance(std::get<0>(pair), std::get<1>(pair), std::get<2>(pair));
  }

  // Returns the closest of the pairs of homes and of the pairs of a point and an image of it by one
  // vector of the basis. If the progress is cancelled, the pair is one of those.
  template <class NamedParameters>
  Minimum homes_minimum(const NamedParameters& np)
  {
    Minimum minimum;
    if(points_.size() == 0)
      return minimum;
    auto& scene = homes_.scene();
    for(int k = 0; k < scene.rank(); ++k) {
      const Pair pair(0, 0, scene.basis_offset(k));
      minimum.offer(pair, square_of(pair));
    }
    if(points_.size() < 2)
      return minimum;
    if(!scene.find_images(np)) {
      const Pair pair(0, 1, Offsets{});
      minimum.offer(pair, square_of(pair));
    }
    else
      scene.with_homes([&](const auto& homes) {
        const auto [i, j]
          = find_closest_pair(homes, scene.parameters_of_homes(np), threads_);
        const Pair pair(i, j, scene.offset_of_homes(i, j));
        minimum.offer(pair, square_of(pair));
      });
    return minimum;
  }

  // Calls offer(own, pair) for the pairs within the bound, with a minimum of each thread.
  template <class NT, class NamedParameters, class Offer>
  void offer_reported(const Distance_bound<NT>& bound, Minimum& minimum, const NamedParameters& np,
                      const Offer& offer) const
  {
    Per_thread<Minimum> minima(minimum, threads_);
    const auto report = [&](std::size_t i, std::size_t j, const Offsets& offset) {
      offer(minima.local(), Pair(i, j, offset));
    };
    Search<NT> search(points_, One_set(), domain_, bound, false, threads_);
    if(bound.value() == NT(0)) // then homes that are equal are known
      search.report_equal(report, np);
    else
      search.report(report, np, nullptr);
    minima.for_each([&](const Minimum& own) { minimum.offer(*own.pair, own.square); });
  }

  const Elements& points_;
  const Domain& domain_;
  const Threads threads_;
  const Distance_bound<double> at_zero_ = within_distance(0.);
  Search<double> homes_;
};

template <class Domain, class NamedParameters, class Range>
auto find_periodic_closest_pair(const Domain& domain, const NamedParameters& np,
                                const Threads& threads, Range& range)
{
  return with_periodic_sets<Domain>(np, [&](const auto& points, const One_set&) {
    using Elements = std::decay_t<decltype(points)>;
    return Periodic_closest_pair_search<Elements, Domain>(points, domain, threads)
      .find(parameters_for_parts(np));
  }, range);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_CLOSEST_PAIR_SEARCH_H
