// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The recursive route in all its variants against brute force, on integer sites. Points whose
// coordinates and reach round are in slabs/test_Slab_route.cpp.

#include "support/lattice_traits.h"
#include "support/recursion_variants.h"
#include "support/unit_test.h"

using namespace test_support;

namespace {

using Generator = std::mt19937_64;

long below(Generator& random, long n)
{
  return static_cast<long>(random() % static_cast<std::uint64_t>(n));
}

std::vector<Site> random_sites(Generator& random, int dimension, long n)
{
  std::vector<Site> sites;
  const long side = 1 + below(random, 40);
  const bool is_flat = below(random, 3) == 0; // one axis has few values, or one
  const long flat_side = 1 + below(random, 3);
  const int flat_axis = static_cast<int>(below(random, dimension));
  for(long i = 0; i < n; ++i) {
    std::vector<long> c;
    for(int axis = 0; axis < dimension; ++axis)
      c.push_back(below(random, is_flat && axis == flat_axis ? flat_side : side) - side / 2);
    sites.emplace_back(std::move(c));
  }
  return sites;
}

// Checks the pairs of one set, or of two sets if the size of the first one is given.
template <class Range, class Traits>
void check_variants(const Pairs& expected, const Range& objects, const Traits& traits,
                    unsigned int seed, std::optional<std::size_t> first_set_size = std::nullopt)
{
  for(const Recursion_variant& variant : recursion_variants(seed)) {
    const Pairs_difference difference
      = compare(expected, pairs_by_variant(objects, traits, variant, first_set_size));
    BOOST_CHECK_MESSAGE(difference.empty(), name(variant) << ", seed " << seed << ": "
                                                          << difference);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(sites_at_random)
{
  for(unsigned int seed = 0; seed < 3000; ++seed) {
    Generator random(seed);
    const int dimension = 1 + static_cast<int>(below(random, 4));
    const std::vector<Site> sites = random_sites(random, dimension, below(random, 60));
    const long distance = below(random, 8);
    Calls calls;
    const Lattice_traits traits(dimension, distance, distance + below(random, 3), calls);
    check_variants(pairs_of_sites(sites, distance), sites, traits, seed);
  }
}

BOOST_AUTO_TEST_CASE(two_sets_of_sites_at_random)
{
  for(unsigned int seed = 0; seed < 2000; ++seed) {
    Generator random(seed);
    const int dimension = 1 + static_cast<int>(below(random, 3));
    const std::vector<Site> sites = random_sites(random, dimension, below(random, 60));
    const std::size_t first = sites.empty() ? 0 : random() % (sites.size() + 1);
    const long distance = below(random, 8);

    Calls calls;
    const Lattice_traits traits(dimension, distance, distance, calls);
    check_variants(of_two_sets(pairs_of_sites(sites, distance), first), sites, traits, seed,
                   first);
  }
}

BOOST_AUTO_TEST_CASE(objects_without_axes_are_compared_pair_by_pair)
{
  std::vector<Site> sites;
  for(const long x : {0, 10, 20, 30, 40})
    sites.emplace_back(std::vector<long>{x});
  Calls calls;
  const Lattice_traits traits(0, 20, 20, calls);
  const Pairs expected = pairs_of_sites(sites, 20);
  check_variants(expected, sites, traits, 0);
  check_variants(of_two_sets(expected, 2), sites, traits, 0, 2);
  BOOST_CHECK_EQUAL(calls.less + calls.is_close, 0u);
}

// Is_close_along_axis_d may be true too often, and in any pattern.
BOOST_AUTO_TEST_CASE(closeness_that_is_true_too_often)
{
  struct Careless_traits : Lattice_traits
  {
    using Lattice_traits::Lattice_traits;
    struct Is_close_along_axis_d
    {
      Lattice_traits::Is_close_along_axis_d is_close;
      bool operator()(const Site& a, const Site& b, int i) const
      {
        return is_close(a, b, i) || (a.coordinate(i) * b.coordinate(i)) % 3 == 1;
      }
    };
    Is_close_along_axis_d is_close_along_axis_d_object() const
    {
      return {Lattice_traits::is_close_along_axis_d_object()};
    }
  };
  for(unsigned int seed = 0; seed < 500; ++seed) {
    Generator random(seed);
    const std::vector<Site> sites = random_sites(random, 2, 60);
    const std::size_t first = random() % 60;
    Calls calls;
    const Careless_traits traits(2, 3, 3, calls);
    const Pairs expected = pairs_of_sites(sites, 3);
    check_variants(expected, sites, traits, seed);
    check_variants(of_two_sets(expected, first), sites, traits, seed, first);
  }
}

// Half of the sites are at one end, a quarter of them a reach farther, and so on: the median is
// close to this end. The best cut is at the last site that is close to it. It leaves the sites
// before it behind as well, which then enter fewer strips.
BOOST_AUTO_TEST_CASE(cuts_at_the_last_site_that_is_close_to_an_end_leave_most_sites_behind)
{
  const std::size_t size = 1024;
  for(const long direction : {1, -1}) {
    std::vector<Site> sites;
    long step = 0;
    for(std::size_t count = size / 2; count > 0; count /= 2, ++step)
      for(std::size_t i = 0; i < count; ++i)
        sites.emplace_back(std::vector<long>{100 * static_cast<long>(sites.size()),
                                             10 * direction * step});
    Calls calls;
    const Lattice_traits traits(2, 10, 10, calls);
    BOOST_CHECK(pairs_by_variant(sites, traits, {Pivot::MEDIAN, Base_case::SWEEP, 1}).empty());
    BOOST_CHECK_LT(calls.is_close, 2 * size); // 2.5 times the size if the cut is at the median
  }
}

// Sites within two reaches of each other are not cut. A cut would partition them twice, with five
// calls of Less_along_axis_d for three sites.
BOOST_AUTO_TEST_CASE(sites_that_are_close_to_the_pivot_are_not_cut)
{
  std::vector<Site> sites;
  for(const long i : {0, 1, 2})
    sites.emplace_back(std::vector<long>{100 * i, 9 * (i - 1)});
  Calls calls;
  const Lattice_traits traits(2, 10, 10, calls);
  BOOST_CHECK(pairs_by_variant(sites, traits, {Pivot::MEDIAN, Base_case::SWEEP, 1}).empty());
  BOOST_CHECK_LE(calls.less, 12u);
}

// Wherever in the recursion the callback stops the search, no predicate is asked after it.
BOOST_AUTO_TEST_CASE(searches_that_are_stopped_ask_nothing_more)
{
  Generator random(6);
  std::vector<Site> sites; // enough for a few cuts one below another
  for(int i = 0; i < 200; ++i)
    sites.emplace_back(std::vector<long>{below(random, 60), below(random, 60)});
  const std::size_t pair_count = pairs_of_sites(sites, 3).size();
  BOOST_REQUIRE_GT(pair_count, 50u);
  for(const Recursion_variant& variant : recursion_variants(6))
    for(std::size_t last = 1; last <= pair_count; ++last) {
      Calls calls;
      const Lattice_traits traits(2, 3, 3, calls);
      std::size_t reported = 0;
      std::size_t asked = 0; // before the last report
      const auto callback = [&](std::size_t, std::size_t) {
        asked = calls.less + calls.is_close + calls.do_intersect;
        return ++reported < last;
      };
      search_by_variant(sites, traits, variant, callback);
      BOOST_REQUIRE_MESSAGE(reported == last, name(variant) << ", stopped by pair " << last);
      BOOST_REQUIRE_MESSAGE(calls.less + calls.is_close + calls.do_intersect == asked,
                            name(variant) << ", stopped by pair " << last);
    }
}

// A random pivot is a function of the seed and of nothing else.
BOOST_AUTO_TEST_CASE(order_of_reports_is_a_function_of_the_input)
{
  Generator random(5);
  const std::vector<Site> sites = random_sites(random, 2, 400);
  Calls calls;
  const Lattice_traits traits(2, 3, 3, calls);
  for(const Recursion_variant& variant : recursion_variants(17))
    BOOST_CHECK_MESSAGE(pairs_by_variant(sites, traits, variant) ==
                            pairs_by_variant(sites, traits, variant),
                        name(variant));
}
