// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every periodic search on random scenes, against rationals and all offsets. Each scene is drawn
// from a seed, and so is the search.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_PERIODIC_FUZZ_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_PERIODIC_FUZZ_H

#include "fuzz_makers.h"
#include "periodic_fuzz_scenes.h"
#include "rounding_mode.h"
#include "seeds.h"

#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>

namespace test_support {

// How many units of the points a unit of the domain is.
template <class Maker, class Domain_maker>
Rational domain_unit()
{
  return Maker::is_exact == Domain_maker::is_exact ? Rational(1)
         : Maker::is_exact                         ? Rational(3)
                                                   : Rational(1, 3);
}

// One scene and one search. The points and the domain may be of different kernels.
template <class Maker, class Domain_maker, class ConcurrencyTag>
class Periodic_fuzz_case
{
  static constexpr int dimension = Maker::dimension;
  static constexpr bool is_plane = dimension == 2;
  static constexpr bool are_doubles = !Maker::is_exact && !Domain_maker::is_exact;
  using Kernel = typename Domain_maker::Kernel;
  using Vector
    = std::conditional_t<is_plane, typename Kernel::Vector_2, typename Kernel::Vector_3>;
  using Iso_box
    = std::conditional_t<is_plane, typename Kernel::Iso_rectangle_2, typename Kernel::Iso_cuboid_3>;
  using Lattice = CGAL::Periodic_lattice_d<Vector>;
  using Point = typename Maker::Point;
  using Offset = Offset_of<dimension>;
  using Pair = Image_pair<dimension>;
  using Pairs = std::vector<Pair>;

public:
  explicit Periodic_fuzz_case(std::uint64_t seed)
    : seed_(seed),
      draw_(seed, Maker::range, Maker::is_exact || Domain_maker::is_exact,
            domain_unit<Maker, Domain_maker>()),
      scene_(draw_.scene())
  {
    for(const Lattice_place& place : scene_.places)
      points_.push_back(Maker::point(place, scene_.exponent));
    for(const Pair& pair : Periodic_oracle<dimension>(scene_.exact).pairs())
      expected_.push_back(scene_.given(pair));
    std::sort(expected_.begin(), expected_.end());
    first_size_ = draw_.random().below(scene_.places.size() + 1);
  }

  // Doubles are decided in any rounding mode. Returns the number of pairs.
  std::size_t check()
  {
    try {
      check_search();
    }
    catch(const std::exception& error) {
      BOOST_FAIL("seed " << seed_ << ": " << error.what());
    }
    return expected_.size();
  }

private:
  void check_search()
  {
    const std::size_t search = draw_.random().below(6);
    const int mode = are_doubles && draw_.is_chance(4)
                       ? rounding_modes[draw_.random().below(4)] : FE_TONEAREST;
    Pairs found;
    with_domain([&](const auto& domain) {
      const Rounding_mode rounding(mode);
      found = search == 0   ? found_closest_pairs(domain)
              : search == 1 ? pairs_in_lists(domain)
              : search == 2 ? found_between(domain)
                            : found_pairs(domain);
    });
    const Pairs expected = search == 0   ? closest_pairs()
                           : search == 1 ? all_in_lists()
                           : search == 2 ? pairs_between()
                                         : expected_;
    const char* const names[] = {"closest pair", "lists", "two sets", "pairs"};
    compare(names[(std::min)(search, std::size_t(3))], expected, found);
  }

  template <class Domain>
  Pairs found_pairs(const Domain& domain) const
  {
    Pairs found;
    CGAL::Scene_profile profile;
    with_bound([&](const auto& bound) {
      CGAL::periodic_fixed_radius_near_neighbors<ConcurrencyTag>(points_, domain, bound,
                                                                 collector(found), profile);
    });
    BOOST_REQUIRE_EQUAL(profile.size(), points_.size());
    return found;
  }

  template <class Domain>
  Pairs found_between(const Domain& domain) const
  {
    Pairs found;
    const auto [first, second] = split(points_, first_size_);
    with_bound([&, &first = first, &second = second](const auto& bound) {
      CGAL::periodic_fixed_radius_near_neighbors<ConcurrencyTag>(first, second, domain, bound,
                                                                 collector(found));
    });
    return found;
  }

  Pairs pairs_between() const
  {
    Pairs pairs;
    for(const auto& [i, j, offset] : expected_)
      if(i < first_size_ && j >= first_size_)
        pairs.emplace_back(i, j - first_size_, offset);
    return pairs;
  }

  template <class Domain>
  Pairs pairs_in_lists(const Domain& domain) const
  {
    Pairs found;
    with_bound([&](const auto& bound) {
      const auto lists
        = CGAL::periodic_fixed_radius_neighbor_lists<ConcurrencyTag>(points_, domain, bound);
      for(std::size_t i = 0; i < lists.size(); ++i) {
        auto offset = lists.offsets_of(i).begin();
        for(const std::size_t j : lists[i])
          found.emplace_back(i, j, *offset++);
      }
      BOOST_REQUIRE_EQUAL(lists.number_of_pairs(), expected_.size());
    });
    BOOST_REQUIRE(std::is_sorted(found.begin(), found.end()));
    return found;
  }

  Pairs all_in_lists() const
  {
    Pairs pairs;
    for(const auto& [i, j, offset] : expected_) {
      Offset opposite = offset;
      for(int& x : opposite)
        x = -x;
      pairs.emplace_back(i, j, offset);
      pairs.emplace_back(j, i, opposite);
    }
    return pairs;
  }

  template <class Domain>
  Pairs found_closest_pairs(const Domain& domain) const
  {
    if(!has_any_pair())
      return {};
    return {CGAL::periodic_closest_pair<ConcurrencyTag>(points_, domain)};
  }

  bool has_any_pair() const
  {
    const auto& repeats = scene_.exact.repeats;
    return points_.size() > 1
           || (points_.size() == 1
               && std::find(repeats.begin(), repeats.end(), true) != repeats.end());
  }

  // The least of those within the distance of some pair.
  Pairs closest_pairs() const
  {
    if(!has_any_pair())
      return {};
    Lattice_scene<dimension> scene = scene_.exact;
    const Periodic_oracle<dimension> oracle(scene);
    scene.is_open = false;
    scene.square = points_.size() > 1 ? oracle.square({0, 1, {}}) : -1;
    for(std::size_t k = 0; k < dimension; ++k) {
      Offset offset = {};
      offset[k] = 1;
      const Rational square = oracle.square({0, 0, offset});
      if(scene.repeats[k] && (scene.square < 0 || square < scene.square))
        scene.square = square;
    }
    Pairs closest;
    Rational least = scene.square;
    for(const Pair& pair : oracle.pairs()) {
      const Rational square = oracle.square(pair);
      if(square < least)
        closest.clear();
      least = (std::min)(least, square);
      if(square == least)
        closest.push_back(scene_.given(pair));
    }
    return {*std::min_element(closest.begin(), closest.end())};
  }

  auto collector(Pairs& pairs) const
  {
    return [&pairs, &mutex = mutex_](std::size_t i, std::size_t j, const Offset& offset) {
      const std::lock_guard<std::mutex> lock(mutex);
      pairs.emplace_back(i, j, offset);
    };
  }

  // Calls f with the box, or with its lattice now and then, or with the lattice.
  template <class Function>
  void with_domain(const Function& f)
  {
    const int exponent = scene_.exponent;
    if(scene_.is_box) {
      const Iso_box box(Domain_maker::point(scene_.low, exponent),
                        Domain_maker::point(scene_.high, exponent));
      return draw_.is_chance(4) ? f(Lattice(box)) : f(box);
    }
    std::array<Vector, dimension> vectors;
    for(std::size_t k = 0; k < dimension; ++k)
      vectors[k] = Domain_maker::point(scene_.vectors[k], exponent) - CGAL::ORIGIN;
    f(Lattice(vectors, scene_.repeats));
  }

  // Calls f with the bound as a double if it is one.
  template <class Function>
  void with_bound(const Function& f) const
  {
    const auto& bound = scene_.bound;
    if constexpr(!Maker::is_exact)
      if(bound.distance) {
        const double distance = std::ldexp(*bound.distance, scene_.exponent);
        if(std::ldexp(distance, -scene_.exponent) == *bound.distance)
          return f(CGAL::Distance_bound<double>(distance, false, bound.is_open));
      }
    const CGAL::Exact_rational unit
      = CGAL::Exact_rational(std::ldexp(1., scene_.exponent)) / (Maker::is_exact ? 3 : 1);
    CGAL::Exact_rational square;
    std::istringstream(bound.square.str()) >> square;
    f(CGAL::Distance_bound<CGAL::Exact_rational>(square * unit * unit, true, bound.is_open));
  }

  void compare(const char* name, Pairs expected, Pairs found) const
  {
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    BOOST_REQUIRE_MESSAGE(found == expected, name << ", seed " << seed_ << ": "
                                                  << found.size() << " found, "
                                                  << expected.size() << " expected");
  }

  const std::uint64_t seed_;
  Periodic_fuzz_drawer<dimension> draw_;
  const Periodic_fuzz_scene<dimension> scene_;
  std::vector<Point> points_;
  Pairs expected_;
  std::size_t first_size_ = 0;
  mutable std::mutex mutex_;
};

// Checks `count` scenes, or as many as the arguments of the program ask for.
template <class Maker, class Domain_maker = Maker, class ConcurrencyTag = CGAL::Sequential_tag>
void fuzz_periodic(std::uint64_t count)
{
  std::size_t pairs = 0;
  check_seeds(count, [&](std::uint64_t seed) {
    pairs += Periodic_fuzz_case<Maker, Domain_maker, ConcurrencyTag>(seed).check();
  });
  BOOST_TEST_MESSAGE(pairs << " pairs of images");
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_PERIODIC_FUZZ_H
