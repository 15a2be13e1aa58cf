// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of all kinds in one range and in two, on the kernels, in sequence and by threads, against
// all pairs tested by the oracle of distances: which ones intersect, and which ones are near.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_KINDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_KINDS_H

#include "kernel_kinds.h"
#include "kind_scenes.h"
#include "pairs.h"
#include "rounding_mode.h"
#include "seeds.h"
#include "unit_test.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

namespace test_support {

// ---- the truth ----------------------------------------------------------------------------------

// How many pairs of two kinds there were.
struct Kind_counts
{
  std::size_t pairs = 0;
  std::size_t yes = 0;
  std::size_t ties = 0; // at the distance of the bound, or touching
};
using Kind_table = std::array<std::array<Kind_counts, 7>, 7>;

// With a bound of zero, near pairs are those that intersect.
class Kind_truth
{
public:
  explicit Kind_truth(const Kind_scene& scene) : scene_(scene)
  {
    for(std::size_t i = 0; i < size(); ++i) {
      squares_.emplace_back();
      for(std::size_t j = 0; j < i; ++j)
        squares_.back().push_back(squared_distance(scene.objects[i], scene.objects[j]));
    }
  }

  std::size_t size() const { return scene_.objects.size(); }

  // The pairs that are near, of one set.
  Pairs pairs(const Rational_bound& bound) const
  {
    return pairs_where(size(), [&](std::size_t i, std::size_t j) {
      return are_near(squares_[j][i], radii(i, j), bound);
    });
  }

  void count(const Rational_bound& bound, Kind_table& table) const
  {
    for(std::size_t i = 0; i < size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const auto [a, b] = std::minmax({kind(i), kind(j)});
        Kind_counts& counts = table[a][b];
        ++counts.pairs;
        counts.yes += are_near(squares_[i][j], radii(i, j), bound);
        counts.ties += compare_distance(squares_[i][j], bound, radii(i, j)) == 0;
      }
  }

private:
  std::size_t kind(std::size_t i) const { return static_cast<std::size_t>(scene_.objects[i].kind); }

  Rational radii(std::size_t i, std::size_t j) const
  {
    return Rational(scene_.objects[i].radius) + scene_.objects[j].radius;
  }

  const Kind_scene& scene_;
  std::vector<std::vector<Rational>> squares_; // of objects i and j < i
};

// ---- the searches -------------------------------------------------------------------------------

inline CGAL::Exact_rational exact_rational(const Rational& x)
{
  CGAL::Exact_rational result;
  std::istringstream(x.str()) >> result;
  return result;
}

inline Rational power_of_two(int exponent)
{
  const boost::multiprecision::mpz_int power
    = boost::multiprecision::mpz_int(1) << std::abs(exponent);
  return exponent >= 0 ? Rational(power) : Rational(1) / Rational(power);
}

// A scene in objects of a kernel, in one range and in two.
template <class Kinds>
struct Kind_ranges
{
  using Objects = std::vector<typename Kinds::Object>;

  Kind_ranges(const Kind_scene& scene, const Kinds& kinds, std::size_t middle)
  {
    for(const Kind_object& object : scene.objects)
      all.push_back(kinds.make(object));
    std::tie(a, b) = split(all, middle);
  }

  Objects all, a, b;
};

// One scene and its searches. Doubles are rounded in any direction.
template <class Kinds>
class Kind_case
{
public:
  explicit Kind_case(std::uint64_t seed)
    : seed_(seed), drawer_(seed, Kinds::dimension, Kinds::have_radii), scene_(drawer_.scene()),
      truth_(scene_),
      kinds_{{scene_.exponent, Kinds::is_exact && drawer_.is_chance(3)}},
      middle_(1 + drawer_.random().below(truth_.size() - 1)), ranges_(scene_, kinds_, middle_)
  {}

  void check_intersections(Kind_table& table)
  {
    const Rational_bound touching = {0, false, false};
    in_sequence_and_by_threads([&](auto tag) {
      using Tag = decltype(tag);
      check_pairs("intersections", touching, [](auto& collect, const auto&... ranges) {
        if constexpr(sizeof...(ranges) == 1)
          CGAL::thick_self_intersection_d<Tag>(ranges..., collect);
        else
          CGAL::thick_intersection_d<Tag>(ranges..., collect);
      });
    });
    truth_.count(touching, table);
  }

  void check_near_pairs(Kind_table& table)
  {
    with_bound([&](const auto& bound) {
      in_sequence_and_by_threads([&](auto tag) {
        using Tag = decltype(tag);
        check_pairs("near pairs", scene_.bound, [&](auto& collect, const auto&... ranges) {
          CGAL::fixed_radius_near_neighbors<Tag>(ranges..., bound, collect);
        });
        check_lists<Tag>(bound);
      });
    });
    truth_.count(scene_.bound, table);
  }

private:
  template <class Check>
  static void in_sequence_and_by_threads(const Check& check)
  {
    check(CGAL::Sequential_tag());
    check(CGAL::Parallel_if_available_tag());
  }

  // Calls find(collect, ranges...) with one range and with two.
  template <class Find>
  void check_pairs(const char* what, const Rational_bound& bound, const Find& find)
  {
    Pairs one_set, two_sets;
    {
      const Rounding_mode rounding(any_mode());
      Locked_collector collect_one(one_set), collect_two(two_sets);
      find(collect_one, ranges_.all);
      find(collect_two, ranges_.a, ranges_.b);
    }
    const Pairs expected = truth_.pairs(bound);
    compare_pairs(what, expected, one_set);
    for(Pair& pair : two_sets)
      pair.second += middle_;
    compare_pairs(what, between_sets(expected, middle_), two_sets);
  }

  template <class ConcurrencyTag, class Bound>
  void check_lists(const Bound& bound)
  {
    const Pairs found
      = pairs_in_lists(CGAL::fixed_radius_neighbor_lists<ConcurrencyTag>(ranges_.all, bound));
    BOOST_CHECK(std::is_sorted(found.begin(), found.end()));
    compare_pairs("lists", in_both_orders(truth_.pairs(scene_.bound)), found);
  }

  // Calls f with the bound in the unit of the scene, as a double if it is one.
  template <class Function>
  void with_bound(const Function& f) const
  {
    Rational value = scene_.bound.value;
    for(int k = scene_.bound.is_squared ? 2 : 1; k > 0; --k)
      value *= power_of_two(scene_.exponent) / (kinds_.is_third ? 3 : 1);
    if constexpr(!Kinds::is_exact) {
      const double rounded = static_cast<double>(value);
      if(std::isfinite(rounded) && Rational(rounded) == value)
        return f(bound_of(rounded));
    }
    f(bound_of(exact_rational(value)));
  }

  template <class NT>
  CGAL::Distance_bound<NT> bound_of(const NT& value) const
  {
    return CGAL::Distance_bound<NT>(value, scene_.bound.is_squared, scene_.bound.is_open);
  }

  int any_mode()
  {
    return Kinds::is_exact ? FE_TONEAREST : rounding_modes[drawer_.random().below(4)];
  }

  void compare_pairs(const char* what, const Pairs& expected, const Pairs& found) const
  {
    const Pairs_difference difference = compare(expected, found);
    BOOST_REQUIRE_MESSAGE(difference.empty(),
                          what << ", seed " << seed_ << ": " << difference << "\n"
                               << description(difference));
  }

  // The objects of the first pair that is wrong.
  std::string description(const Pairs_difference& difference) const
  {
    if(difference.empty())
      return "";
    const bool is_missing = !difference.missing.empty();
    const Pair pair = is_missing ? difference.missing.front() : difference.extra.front();
    std::ostringstream out;
    out << (is_missing ? "missing" : "extra") << ", unit 2^" << scene_.exponent
        << (kinds_.is_third ? " / 3" : "") << ", bound " << scene_.bound << '\n'
        << scene_.objects[pair.first] << '\n' << scene_.objects[pair.second];
    return out.str();
  }

  const std::uint64_t seed_;
  Kind_drawer drawer_;
  const Kind_scene scene_;
  const Kind_truth truth_;
  const Kinds kinds_;
  const std::size_t middle_; // of one range, where the second of two begins
  const Kind_ranges<Kinds> ranges_;
};

// Each cell of the table of kinds with kinds has pairs of all sorts.
inline void check_table(const Kind_table& table, int dimension)
{
  for(std::size_t a = 0; a < number_of_kinds(dimension); ++a)
    for(std::size_t b = a; b < number_of_kinds(dimension); ++b)
      BOOST_TEST_CONTEXT("kinds " << a << " and " << b << " in dimension " << dimension)
      {
        BOOST_CHECK_GT(table[a][b].yes, 20u);
        BOOST_CHECK_GT(table[a][b].pairs - table[a][b].yes, 20u);
        BOOST_CHECK_GT(table[a][b].ties, 10u);
      }
}

// Both questions about 1000 random scenes. In the seconds that scripts/fuzz_searches gives, there
// may be fewer, which do not fill the tables.
template <class Kinds>
void check_all_kinds()
{
  constexpr std::uint64_t count = 1000;
  Kind_table intersections = {};
  Kind_table near_pairs = {};
  const std::uint64_t checked = check_seeds(count, [&](std::uint64_t seed) {
    Kind_case<Kinds> scene(seed);
    scene.check_intersections(intersections);
    scene.check_near_pairs(near_pairs);
  });
  if(checked < count)
    return;
  check_table(intersections, Kinds::dimension);
  check_table(near_pairs, Kinds::dimension);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_KINDS_H
