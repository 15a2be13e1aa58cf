// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes, with the header of CGAL in the same program: the same pairs as CGAL::box_intersection_d(),
// with the same box first. Lattices of few coordinates have boxes that touch, equal boxes, flat
// boxes and copies of boxes.

#include "support/check_pairs.h"
#include "support/counting_allocator.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_box_intersection_d.h>

#include <boost/mpl/list.hpp>

using namespace test_support;

using CGAL::Box_intersection_d::BIPARTITE;
using CGAL::Box_intersection_d::CLOSED;
using CGAL::Box_intersection_d::COMPLETE;
using CGAL::Box_intersection_d::HALF_OPEN;

namespace {

constexpr int max_dimension = 5;
int dimension_now = 0; // the dimension of the boxes of all types

// A box whose ends are given by their places in a list of coordinates.
struct Lattice_box
{
  std::size_t id;
  int low[max_dimension];
  int high[max_dimension];
};

template <class NT_>
struct Box
{
  using NT = NT_;
  using ID = std::size_t;
  ID number;
  NT low[max_dimension];
  NT high[max_dimension];

  static int dimension() { return dimension_now; }
  ID id() const { return number; }
  NT min_coord(int i) const { return low[i]; }
  NT max_coord(int i) const { return high[i]; }
};

template <class AnyBox>
std::size_t id_of(const AnyBox& box) { return box.id(); }
template <class AnyBox>
std::size_t id_of(const AnyBox* box) { return box->id(); }

// `size` boxes with ends among the first `count` coordinates. Their extents are up to `extent`, and
// positive if they are not to be flat. They are in any order, or ids ascend if the seed is odd.
std::vector<Lattice_box> lattice_boxes(std::size_t size, int count, int extent, bool are_flat,
                                       std::size_t first_id, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Lattice_box> boxes(size);
  for(std::size_t i = 0; i < size; ++i) {
    boxes[i].id = first_id + i;
    for(int axis = 0; axis < max_dimension; ++axis) {
      const int length = are_flat ? below(extent + 1) : 1 + below(extent);
      boxes[i].low[axis] = below(count - length);
      boxes[i].high[axis] = boxes[i].low[axis] + length;
    }
  }
  if(seed % 2 == 0)
    std::shuffle(boxes.begin(), boxes.end(), random);
  return boxes;
}

// Two sets of boxes. Some boxes are in both.
struct Scene
{
  std::vector<Lattice_box> a;
  std::vector<Lattice_box> b;
};

Scene lattice_scene(std::size_t size, int count, bool are_flat, unsigned int seed)
{
  Scene scene = {lattice_boxes(size, count, 2, are_flat, 0, seed),
                 lattice_boxes(size / 2, count, 3, are_flat, size, seed + 2)};
  scene.b.insert(scene.b.begin(), scene.a.begin(), scene.a.begin() + std::ptrdiff_t(size / 4));
  return scene;
}

template <class NT>
std::vector<Box<NT>> boxes_at(const std::vector<Lattice_box>& lattice,
                              const std::vector<NT>& coordinates)
{
  std::vector<Box<NT>> boxes(lattice.size());
  for(std::size_t i = 0; i < lattice.size(); ++i) {
    boxes[i].number = lattice[i].id;
    for(int axis = 0; axis < max_dimension; ++axis) {
      boxes[i].low[axis] = coordinates[static_cast<std::size_t>(lattice[i].low[axis])];
      boxes[i].high[axis] = coordinates[static_cast<std::size_t>(lattice[i].high[axis])];
    }
  }
  return boxes;
}

template <class NT>
std::vector<const Box<NT>*> pointers_to(const std::vector<Box<NT>>& boxes)
{
  std::vector<const Box<NT>*> pointers;
  for(const Box<NT>& box : boxes)
    pointers.push_back(&box);
  return pointers;
}

// Collects the ids of pairs, in the order of the arguments.
template <class Handle>
struct Id_collector
{
  Pairs& pairs;

  void operator()(const Handle& a, const Handle& b) const
  {
    pairs.emplace_back(id_of(a), id_of(b));
  }
};

template <class Handle, class Search>
Pairs ids_of(const Search& search)
{
  Pairs pairs;
  search(Id_collector<Handle>{pairs});
  return pairs;
}

// CGAL reorders its ranges, so it gets copies of them. Ours are constant.
template <class Handle, class Topology>
void compare_self(const std::vector<Handle>& a, std::ptrdiff_t cutoff, Topology topology)
{
  std::vector<Handle> copy = a;
  const Pairs expected = ids_of<Handle>([&](const auto& callback) {
    CGAL::box_self_intersection_d(copy.begin(), copy.end(), callback, cutoff, topology);
  });
  const Pairs found = ids_of<Handle>([&](const auto& callback) {
    CGAL::thick_box_self_intersection_d(a.begin(), a.end(), callback, cutoff, topology);
  });
  check_pairs(std::to_string(dimension_now) + "D, one set", expected, found);
  BOOST_CHECK(found == ids_of<Handle>([&](const auto& callback) { // in the same order
    CGAL::thick_box_self_intersection_d(a.begin(), a.end(), callback, cutoff, topology);
  }));
}

template <class Handle, class Topology, class Setting>
void compare_two(const std::vector<Handle>& a, const std::vector<Handle>& b, std::ptrdiff_t cutoff,
                 Topology topology, Setting setting)
{
  std::vector<Handle> copy_a = a, copy_b = b;
  const Pairs expected = ids_of<Handle>([&](const auto& callback) {
    CGAL::box_intersection_d(copy_a.begin(), copy_a.end(), copy_b.begin(), copy_b.end(), callback,
                             cutoff, topology, setting);
  });
  const Pairs found = ids_of<Handle>([&](const auto& callback) {
    CGAL::thick_box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), callback, cutoff,
                                   topology, setting);
  });
  check_pairs(std::to_string(dimension_now) + "D, two sets", expected, found);
}

template <class Handle>
void compare_all_choices(const std::vector<Handle>& a, const std::vector<Handle>& b)
{
  for(const std::ptrdiff_t cutoff : {2, 1000})
    for(const auto topology : {CLOSED, HALF_OPEN}) {
      compare_self(a, cutoff, topology);
      compare_two(a, b, cutoff, topology, BIPARTITE);
      compare_two(a, b, cutoff, topology, COMPLETE);
      compare_two(a, a, cutoff, topology, COMPLETE);
    }
}

template <class NT>
void compare_at(const std::vector<NT>& coordinates)
{
  for(dimension_now = 1; dimension_now <= max_dimension; ++dimension_now)
    for(const std::size_t size : {6, 60})
      for(const bool are_flat : {false, true})
        for(unsigned int seed = 0; seed < 4; ++seed) {
          const int count = static_cast<int>(coordinates.size());
          const Scene scene = lattice_scene(size, count, are_flat, seed);
          const auto a = boxes_at(scene.a, coordinates), b = boxes_at(scene.b, coordinates);
          compare_all_choices(a, b);
          if constexpr(std::is_same_v<NT, double>)
            compare_all_choices(pointers_to(a), pointers_to(b));
        }
}

template <class NT>
std::vector<NT> special_coordinates()
{
  using Limits = std::numeric_limits<NT>;
  const NT large = (Limits::max)() / 8, denormal = Limits::denorm_min();
  return {-large, -1, -denormal, -NT(0), NT(0), denormal, 2 * denormal, (Limits::min)(), 1,
          std::nextafter(NT(1), NT(2)), large};
}

template <int Dimension>
auto boxes_of_CGAL(const std::vector<Lattice_box>& lattice)
{
  std::vector<CGAL::Box_intersection_d::Box_d<double, Dimension>> boxes;
  for(const Lattice_box& box : lattice) {
    double low[Dimension], high[Dimension];
    std::copy_n(box.low, Dimension, low);
    std::copy_n(box.high, Dimension, high);
    boxes.emplace_back(low, high);
  }
  return boxes;
}

std::vector<Box<double>> some_boxes()
{
  dimension_now = 3;
  std::vector<double> coordinates(8);
  std::iota(coordinates.begin(), coordinates.end(), 0.);
  return boxes_at(lattice_boxes(100, 8, 2, true, 0, 3), coordinates);
}

} // namespace

BOOST_AUTO_TEST_CASE(ints_give_the_pairs_of_CGAL)
{
  compare_at(std::vector<int>{-1000000000, -1, 0, 1, 2, 3, 2000000000});
  compare_at(std::vector<unsigned int>{0, 1, 2, 3, 4000000000u});
}

BOOST_AUTO_TEST_CASE(doubles_give_the_pairs_of_CGAL)
{
  compare_at(std::vector<double>{0, 1, 2, 3, 4});
  compare_at(special_coordinates<double>());
}

BOOST_AUTO_TEST_CASE(floats_give_the_pairs_of_CGAL)
{
  compare_at(special_coordinates<float>());
}

// The pairs depend on the order of the coordinates alone, so CGAL tells them from ints.
using Rational = CGAL::Exact_rational;
using Exact_types
  = boost::mpl::list<Rational, CGAL::Lazy_exact_nt<Rational>, long long, long double>;
BOOST_AUTO_TEST_CASE_TEMPLATE(exact_numbers_give_the_pairs_of_their_order, NT, Exact_types)
{
  std::vector<int> places(6);
  std::iota(places.begin(), places.end(), 0);
  std::vector<NT> thirds, neighbors;
  for(const int place : places) {
    thirds.push_back(NT(place) / NT(3));
    neighbors.push_back(NT(std::ldexp(1., 60)) + NT(place)); // doubles do not tell them apart
  }
  if(std::is_integral_v<NT>)
    thirds = std::vector<NT>(places.begin(), places.end());

  for(dimension_now = 1; dimension_now <= 3; ++dimension_now)
    for(unsigned int seed = 0; seed < 8; ++seed) {
      const Scene scene = lattice_scene(40, 6, seed % 2 == 0, seed);
      for(const auto topology : {CLOSED, HALF_OPEN})
        for(const auto setting : {BIPARTITE, COMPLETE}) {
          std::vector<Box<int>> a = boxes_at(scene.a, places), b = boxes_at(scene.b, places);
          const Pairs expected = ids_of<Box<int>>([&](const auto& callback) {
            CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), callback, 10, topology,
                                     setting);
          });
          for(const std::vector<NT>& coordinates : {thirds, neighbors}) {
            const auto c = boxes_at(scene.a, coordinates), d = boxes_at(scene.b, coordinates);
            const Pairs found = ids_of<Box<NT>>([&](const auto& callback) {
              CGAL::thick_box_intersection_d(c.begin(), c.end(), d.begin(), d.end(), callback, 10,
                                             topology, setting);
            });
            check_pairs(std::to_string(dimension_now) + "D", expected, found);
          }
        }
    }
}

// Up to 64 boxes are compared each with each, on the stack.
BOOST_AUTO_TEST_CASE(few_boxes_give_the_pairs_of_CGAL)
{
  for(std::size_t size = 0; size <= 68; ++size)
    for(const bool are_flat : {false, true}) {
      const Scene scene = lattice_scene(size, 14, are_flat, static_cast<unsigned int>(size));
      compare_all_choices(boxes_of_CGAL<2>(scene.a), boxes_of_CGAL<2>(scene.b));
      compare_all_choices(boxes_of_CGAL<3>(scene.a), boxes_of_CGAL<3>(scene.b));
    }
}

BOOST_AUTO_TEST_CASE(few_boxes_need_no_memory)
{
  for(std::size_t size = 0; size <= 64; ++size) {
    const auto boxes = boxes_of_CGAL<3>(lattice_boxes(size, 14, 2, true, 0, 3));
    std::size_t count = 0;
    BOOST_CHECK_NO_THROW({
      const Memory_that_runs_out none(0);
      const auto add = [&](const auto&, const auto&) { ++count; };
      CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(), add);
    });
  }
}

// The bytes that a search takes for each of n boxes of two sets. No two of them meet, but nearly
// all of one set end in the same half of each half of the other set.
double bytes_per_box(int n)
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 2>;
  Random random(1);
  const double last = std::floor(2 * n / 3.);
  const auto left = [&](double low, double high) {
    return CGAL::Bbox_2(-1000 + 990 * random.uniform(), low, 1, high);
  };
  std::vector<Box> a, b;
  for(double y = 0; y < n; ++y) {
    a.emplace_back(left(-n * random.uniform() - 1, last + .5));
    b.emplace_back(y > last ? left(y, y + .1)
                            : CGAL::Bbox_2(2 + 980 * random.uniform(), y, 1000, y + .1));
  }
  std::size_t pairs = 0;
  const std::size_t bytes = bytes_taken_by([&] {
    CGAL::thick_box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                                   [&](const Box&, const Box&) { ++pairs; });
  });
  BOOST_CHECK_EQUAL(pairs, 0u);
  return static_cast<double>(bytes) / (2 * n);
}

BOOST_AUTO_TEST_CASE(crowded_boxes_take_linear_memory)
{
  BOOST_CHECK_LE(bytes_per_box(80000), 1.02 * bytes_per_box(10000));
}

BOOST_AUTO_TEST_CASE(boxes_of_CGAL_are_taken_as_they_are)
{
  using Iterator = std::vector<CGAL::Bbox_3>::const_iterator;
  using Handle_box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, Iterator>;
  const std::vector<CGAL::Bbox_3> things = {{0, 0, 0, 1, 1, 1}, {1, 1, 1, 2, 2, 2},
                                            {3, 0, 0, 4, 1, 1}, {0, 0, 0, 3, 1, 1}};
  std::vector<Handle_box> boxes;
  for(Iterator it = things.begin(); it != things.end(); ++it)
    boxes.emplace_back(*it, it);
  Pairs found;
  CGAL::thick_box_self_intersection_d(
    boxes.begin(), boxes.end(), [&](const Handle_box& a, const Handle_box& b) {
      found.emplace_back(a.handle() - things.begin(), b.handle() - things.begin());
    });
  BOOST_CHECK(compare({{1, 0}, {1, 3}, {3, 0}, {3, 2}}, found).empty());
}

// Boxes of CGAL whose dimension() is their own.
template <class Integer>
struct Flat_box : CGAL::Box_intersection_d::Box_d<double, 3>
{
  using Base = CGAL::Box_intersection_d::Box_d<double, 3>;
  using Base::Base;
  static Integer dimension() { return 2; }
};

template <class Box>
constexpr int known_dimension
  = CGAL::Thick_intersection_d::internal::Inherited_dimension<Box>::value;

BOOST_AUTO_TEST_CASE(the_dimension_of_boxes_of_CGAL_is_a_constant)
{
  using CGAL::Box_intersection_d::Box_d;
  static_assert(known_dimension<Box_d<double, 2>> == 2);
  static_assert(known_dimension<Box_d<float, 5>> == 5);
  static_assert(known_dimension<CGAL::Box_intersection_d::Box_with_info_d<int, 4, char>> == 4);
  static_assert(known_dimension<Box<double>> == 0);
  static_assert(known_dimension<Flat_box<int>> == 0);
  static_assert(known_dimension<Flat_box<std::size_t>> == 0);
  using Members = CGAL::Thick_intersection_d::internal::Box_members<const Box_d<double, 2>*>;
  static_assert(Members::dimension() == 2);
}

BOOST_AUTO_TEST_CASE(boxes_may_have_fewer_axes_than_their_base)
{
  const std::vector<Flat_box<int>> boxes = {CGAL::Bbox_3(0, 0, 0, 1, 1, 1),
                                            CGAL::Bbox_3(1, 1, 5, 2, 2, 6)};
  int count = 0;
  CGAL::thick_box_self_intersection_d(
    boxes.begin(), boxes.end(), [&](const Flat_box<int>&, const Flat_box<int>&) { ++count; });
  BOOST_CHECK_EQUAL(count, 1);
}

BOOST_AUTO_TEST_CASE(every_form_of_the_call_finds_the_same)
{
  std::vector<Box<double>> a = some_boxes(), b = a;
  const auto begin = a.begin(), end = a.end(), begin2 = b.begin(), end2 = b.end();
  const CGAL::Box_intersection_d::Box_traits_d<Box<double>> traits;
  const auto own_topology = CGAL::Thick_box_intersection_d::CLOSED;
  const auto own_setting = CGAL::Thick_box_intersection_d::BIPARTITE;
  std::size_t found = 0;
  const auto callback = [&](Box<double>&, Box<double>&) { ++found; };
  const auto find = [&](auto... arguments) {
    found = 0;
    CGAL::thick_box_self_intersection_d(begin, end, callback, arguments...);
    const std::size_t count = found;
    CGAL::thick_box_intersection_d(begin, end, begin2, end2, callback, arguments...);
    BOOST_CHECK_EQUAL(found, 3 * count); // a pair of one set is two pairs of two sets
    return count;
  };
  const std::size_t count = find();
  BOOST_CHECK_GT(count, 100u);
  BOOST_CHECK_EQUAL(find(5), count);
  BOOST_CHECK_EQUAL(find(std::ptrdiff_t(5)), count);
  BOOST_CHECK_EQUAL(find(5, CLOSED), count);
  BOOST_CHECK_EQUAL(find(5, own_topology), count);
  BOOST_CHECK_EQUAL(find(traits), count);
  BOOST_CHECK_EQUAL(find(traits, 5), count);
  BOOST_CHECK_EQUAL(find(traits, 5, CLOSED), count);
  BOOST_CHECK_EQUAL(find(traits, 5, own_topology), count);
  BOOST_CHECK_LT(find(5, HALF_OPEN), count);

  const auto find_two = [&](auto... arguments) {
    found = 0;
    CGAL::thick_box_intersection_d(begin, end, begin2, end2, callback, arguments...);
    return found;
  };
  BOOST_CHECK_EQUAL(find_two(5, own_topology, own_setting), 2 * count);
  BOOST_CHECK_EQUAL(find_two(traits, 5, CLOSED, own_setting), 2 * count);
  BOOST_CHECK_EQUAL(find_two(traits, 5, CLOSED, COMPLETE), count);
}

BOOST_AUTO_TEST_CASE(boxes_stay_in_place)
{
  std::vector<Box<double>> boxes = some_boxes();
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [](Box<double>&, Box<double>&) {});
  for(std::size_t i = 0; i < boxes.size(); ++i)
    BOOST_CHECK_EQUAL(boxes[i].id(), i);
}
