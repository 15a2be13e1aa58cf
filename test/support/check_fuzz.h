// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every public search on random scenes, against brute force in integers. Each scene is drawn from a
// seed, and so is the search.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_FUZZ_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_FUZZ_H

#include "fuzz_makers.h"
#include "hull_oracle.h"
#include "instruction_sets.h"
#include "object_routes.h"
#include "rounding_mode.h"
#include "seeds.h"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

namespace test_support {

// The searches to check: each of them takes long to compile.
enum Fuzz_parts : unsigned {
  NEAR_PAIRS = 1,
  RECURSION = 2,
  CLOSEST_PAIRS = 4,
  BALLS = 8,
  OBJECTS = 16,
  ALL_PARTS = 31,
  PARTNERS = 32, // near pairs of scenes at the limits of narrow coordinates
  ROUTES = 64    // of balls and objects, also by routes that other scenes take
};

// One scene and one search.
template <class Maker, unsigned parts, class ConcurrencyTag>
class Fuzz_case
{
  using Point = typename Maker::Point;
  using Ball = std::pair<Point, typename Maker::FT>;
  static constexpr int dimension = Maker::dimension;

public:
  explicit Fuzz_case(std::uint64_t seed)
    : seed_(seed), draw_(seed, Maker::range),
      scene_(parts == PARTNERS ? draw_.scene_of_partners(dimension) : draw_.scene(dimension)),
      bound_(parts == PARTNERS ? draw_.bound_of_partners(scene_) : draw_.bound(scene_))
  {
    for(const Lattice_place& place : scene_.places)
      points_.push_back(Maker::point(place, scene_.exponent));
    if(draw_.is_chance(3))
      first_set_size_ = draw_.random().below(scene_.size() + 1);
  }

  void check()
  {
    if constexpr(parts == PARTNERS)
      return check_partners();
    const std::int64_t choice = draw_.below(8);
    if constexpr((parts & NEAR_PAIRS) != 0)
      if(choice < 3)
        return choice == 0 ? check_lists() : check_near_pairs();
    if constexpr((parts & CLOSEST_PAIRS) != 0)
      if(choice < 5)
        return choice == 4 ? check_close_pair() : check_closest_pair();
    if constexpr((parts & RECURSION) != 0)
      if(choice == 5)
        return check_recursion();
    if constexpr((parts & BALLS) != 0)
      if(choice == 6)
        return check_balls();
    if constexpr((parts & OBJECTS) != 0)
      check_objects();
    else
      check_near_pairs();
  }

private:
  // By any instruction set; in doubles, rounded in any direction as well.
  void check_partners()
  {
    const auto sets = instruction_sets();
    const Forced_instruction_set forced(sets[draw_.random().below(sets.size())]);
    const Rounding_mode rounding(Maker::is_exact ? FE_TONEAREST
                                                 : rounding_modes[draw_.random().below(4)]);
    check_near_pairs();
  }

  void check_near_pairs()
  {
    Pairs found;
    Locked_collector collect(found);
    with_bound([&](const auto& bound) {
      if(first_set_size_) {
        const auto [a, b] = split(points_, *first_set_size_);
        CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(a, b, bound, collect);
      }
      else if(CGAL::Scene_profile profile; draw_.is_chance(2)) // by slabs, however few they are
        CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(points_, bound, collect, profile);
      else
        CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(points_, bound, collect);
    });
    compare_pairs("near pairs", near_places(scene_, bound_, first_set_size_), found);
  }

  void check_lists()
  {
    Pairs found;
    with_bound([&](const auto& bound) {
      found = pairs_in_lists(CGAL::fixed_radius_neighbor_lists<ConcurrencyTag>(points_, bound));
    });
    BOOST_CHECK(std::is_sorted(found.begin(), found.end()));
    compare_pairs("lists", in_both_orders(near_places(scene_, bound_)), found);
  }

  void check_recursion()
  {
    with_bound([&](const auto& bound) {
      const CGAL::Thick_point_traits_d<Point> traits(bound, dimension);
      compare_pairs("recursion", near_places(scene_, bound_, first_set_size_),
                    object_pairs(points_, CGAL::parameters::geom_traits(traits)));
    });
  }

  void check_closest_pair()
  {
    if(scene_.size() < 2)
      return;
    const unsigned int seed = static_cast<unsigned int>(seed_);
    const Pair found
      = CGAL::closest_pair<ConcurrencyTag>(points_, CGAL::parameters::random_seed(seed));
    compare_pairs("closest pair", {closest_places(scene_)}, {found});
  }

  void check_close_pair()
  {
    const Pairs all = near_places(scene_, bound_);
    with_bound([&](const auto& bound) {
      const auto found = CGAL::find_close_pair<ConcurrencyTag>(points_, bound);
      const bool is_right = found ? std::binary_search(all.begin(), all.end(), *found)
                                  : all.empty();
      BOOST_REQUIRE_MESSAGE(is_right, "close pair, seed " << seed_);
    });
  }

  void check_balls()
  {
    const std::size_t radius_one_in = draw_.is_chance(3) ? 1000 : 1; // often all radii are equal
    std::vector<std::int64_t> radii;
    std::vector<Ball> balls;
    for(const Point& point : points_) {
      radii.push_back(radii.empty() || draw_.is_chance(radius_one_in)
                        ? draw_.length(draw_.is_chance(10) ? 40 : 5) : radii.front());
      balls.emplace_back(point, Maker::number(radii.back(), scene_.exponent));
    }
    const auto do_intersect = [&](std::size_t i, std::size_t j) {
      const Fuzz_bound bound = {Wide_integer(radii[i]) + radii[j], false, false};
      return bound.holds_for(squared_distance(scene_.places[i], scene_.places[j]));
    };
    const CGAL::Thick_ball_traits_d<Point> traits(balls);
    const Pairs expected = pairs_where(scene_.size(), first_set_size_, do_intersect);
    if constexpr((parts & ROUTES) != 0)
      if(draw_.is_chance(3))
        return compare_pairs("balls by recursion", expected, reported([&](auto collect) {
          report_by_recursion(balls, first_set_size_, traits, collect);
        }));
    compare_pairs("balls", expected, object_pairs(balls, CGAL::parameters::geom_traits(traits)));
  }

  void check_objects()
  {
    using Types = typename Maker::Types;
    if(draw_.is_chance(4))
      return check_hulls<typename Types::Triangle, 3>("triangles", 8);
    if constexpr(dimension == 3 && (parts & ROUTES) != 0)
      if(draw_.is_chance(4))
        return check_hulls<typename Maker::Kernel::Tetrahedron_3, 4>("tetrahedra", 6);
    if constexpr(dimension == 2 || (parts & ROUTES) != 0)
      if(draw_.is_chance(2))
        return check_hulls<typename Types::Segment, 2>("segments",
                                                       dimension == 2 ? 160 : 12);
    if constexpr(std::is_same_v<typename Maker::FT, double>)
      if(draw_.is_chance(2))
        return check_boxes();
    check_iso_boxes();
  }

  // Objects of some vertices each. Many are flat. Doubles are decided in any rounding mode. The
  // oracle takes its time for many vertices.
  template <class Object, std::size_t vertex_count>
  void check_hulls(const char* what, std::size_t max_size)
  {
    using Integer = boost::multiprecision::int512_t;
    std::vector<Hull_vectors<Integer>> hulls;
    std::vector<Object> objects;
    const std::size_t size = (std::min)(scene_.size(), max_size);
    for(std::size_t i = 0; i < size; ++i) {
      std::array<std::size_t, vertex_count> vertices = {i};
      for(std::size_t k = 1; k < vertex_count; ++k)
        vertices[k] = draw_.random().below(scene_.size());
      hulls.emplace_back();
      for(const std::size_t v : vertices) {
        const Lattice_place& p = scene_.places[v];
        hulls.back().push_back({Integer(p[0]), Integer(p[1]), Integer(p[2])});
      }
      std::apply([&](auto... v) { objects.emplace_back(points_[v]...); }, vertices);
    }
    if(first_set_size_)
      first_set_size_ = (std::min)(*first_set_size_, size);
    const auto find_pairs = [&] {
      const Rounding_mode rounding(Maker::is_exact ? FE_TONEAREST
                                                   : rounding_modes[draw_.random().below(4)]);
      return kernel_object_pairs(objects);
    };
    compare_pairs(what, pairs_where(size, first_set_size_, [&](std::size_t i, std::size_t j) {
      return do_hulls_intersect(hulls[i], hulls[j]);
    }), find_pairs());
  }

  void check_iso_boxes()
  {
    using Iso_box = typename Maker::Types::Iso_box;
    const std::vector<Lattice_box> ends = lattice_boxes(0);
    std::vector<Iso_box> boxes;
    for(const Lattice_box& box : ends)
      boxes.emplace_back(Maker::point(box.first, scene_.exponent),
                         Maker::point(box.second, scene_.exponent));
    const Pairs expected = meeting_boxes(ends, true);
    compare_pairs("iso-boxes", expected, kernel_object_pairs(boxes));
    if constexpr(std::is_same_v<typename Maker::FT, double> && (parts & ROUTES) != 0) {
      std::vector<decltype(boxes[0].bbox())> bounding_boxes;
      for(const Iso_box& box : boxes)
        bounding_boxes.push_back(box.bbox());
      compare_pairs("bounding boxes", expected, kernel_object_pairs(bounding_boxes));
    }
  }

  // Half-open boxes are not flat: the rules for these are those of CGAL, not of geometry.
  void check_boxes()
  {
    using Box = CGAL::Box_intersection_d::Box_d<double, dimension,
                                                CGAL::Box_intersection_d::ID_EXPLICIT>;
    using Topology = CGAL::Thick_box_intersection_d::Topology;
    const bool is_closed = draw_.is_chance(2);
    const std::vector<Lattice_box> ends = lattice_boxes(is_closed ? 0 : 1);
    std::vector<Box> boxes;
    for(const Lattice_box& box : ends) {
      double low[dimension], high[dimension];
      for(int axis = 0; axis < dimension; ++axis) {
        low[axis] = Maker::number(box.first[axis], scene_.exponent);
        high[axis] = Maker::number(box.second[axis], scene_.exponent);
      }
      boxes.emplace_back(low, high);
    }
    Pairs found;
    Locked_collector collect(found);
    const auto middle = boxes.begin() + static_cast<std::ptrdiff_t>(first_set_size_.value_or(0));
    const auto report = [&](const Box& a, const Box& b) {
      const std::size_t i = static_cast<std::size_t>(&a - boxes.data());
      const std::size_t j = static_cast<std::size_t>(&b - boxes.data());
      if(first_set_size_)
        collect(i, j - *first_set_size_);
      else
        collect((std::min)(i, j), (std::max)(i, j));
    };
    const Topology topology = is_closed ? Topology::CLOSED : Topology::HALF_OPEN;
    if(first_set_size_)
      CGAL::thick_box_intersection_d<ConcurrencyTag>(boxes.begin(), middle, middle, boxes.end(),
                                                     report, 10, topology);
    else
      CGAL::thick_box_self_intersection_d<ConcurrencyTag>(boxes.begin(), boxes.end(), report, 10,
                                                          topology);
    compare_pairs("boxes", meeting_boxes(ends, is_closed), found);
  }

  std::vector<Lattice_box> lattice_boxes(std::int64_t least_length)
  {
    std::vector<Lattice_box> boxes;
    for(const Lattice_place& place : scene_.places) {
      boxes.emplace_back(place, place);
      for(int axis = 0; axis < dimension; ++axis)
        boxes.back().second[axis] += least_length + draw_.length(draw_.is_chance(8) ? 8 : 3);
    }
    return boxes;
  }

  Pairs meeting_boxes(const std::vector<Lattice_box>& boxes, bool are_closed) const
  {
    return pairs_where(boxes.size(), first_set_size_, [&](std::size_t i, std::size_t j) {
      return do_boxes_meet(boxes[i], boxes[j], dimension, are_closed);
    });
  }

  template <class Object>
  Pairs kernel_object_pairs(const std::vector<Object>& objects)
  {
    if constexpr((parts & ROUTES) != 0)
      if(const std::int64_t route = draw_.below(4); route < 2) {
        const CGAL::Thick_object_traits_d<Object> traits(objects);
        return reported([&](auto collect) {
          if(route == 0)
            report_by_recursion(objects, first_set_size_, traits, collect);
          else
            report_by_cuts(objects, first_set_size_, traits, collect, seed_);
        });
      }
    return object_pairs(objects, CGAL::parameters::default_values());
  }

  template <class Object, class NamedParameters>
  Pairs object_pairs(const std::vector<Object>& objects, const NamedParameters& np) const
  {
    Pairs found;
    Locked_collector collect(found);
    if(first_set_size_) {
      const auto [a, b] = split(objects, *first_set_size_);
      CGAL::thick_intersection_d<ConcurrencyTag>(a, b, collect, np);
    }
    else
      CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, collect, np);
    return found;
  }

  // Calls f with the bound as a double if it is one.
  template <class Function>
  void with_bound(const Function& f) const
  {
    const double unit = std::ldexp(1., scene_.exponent);
    if(!bound_.is_squared && !Maker::is_exact)
      return f(CGAL::Distance_bound<double>(static_cast<double>(bound_.value) * unit, false,
                                            bound_.is_open));
    const CGAL::Exact_rational exact_unit
      = CGAL::Exact_rational(unit) / CGAL::Exact_rational(Maker::is_exact ? 3 : 1);
    CGAL::Exact_rational value = exact_rational(bound_.value) * exact_unit;
    if(bound_.is_squared)
      value *= exact_unit;
    f(CGAL::Distance_bound<CGAL::Exact_rational>(value, bound_.is_squared, bound_.is_open));
  }

  void compare_pairs(const char* search, Pairs expected, Pairs found) const
  {
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    BOOST_REQUIRE_MESSAGE(found == expected, search << ", seed " << seed_ << ": "
                                                    << compare(expected, found));
  }

  const std::uint64_t seed_;
  Fuzz_drawer draw_;
  const Fuzz_scene scene_;
  const Fuzz_bound bound_;
  std::vector<Point> points_;
  std::optional<std::size_t> first_set_size_;
};

// Checks `count` scenes, or as many as the arguments of the program ask for.
template <class Maker, unsigned parts = ALL_PARTS, class ConcurrencyTag = CGAL::Sequential_tag>
void fuzz(std::uint64_t count)
{
  check_seeds(count, [](std::uint64_t seed) {
    Fuzz_case<Maker, parts, ConcurrencyTag>(seed).check();
  });
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_FUZZ_H
