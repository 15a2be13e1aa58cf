// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The tree against all pairs, in one to five dimensions, with many equal ends; and how much it
// looks at.

#include "support/number_boxes.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Box_tree.h>

BOOST_AUTO_TEST_SUITE(Box_tree)

using namespace test_support;
std::size_t looks = 0; // at ends of boxes

template <int Axes>
struct Counted_ends
{
  std::array<double, Axes> ends;

  double operator[](int axis) const
  {
    ++looks;
    return ends[static_cast<std::size_t>(axis)];
  }
};

template <int Axes>
struct Counted_box
{
  static constexpr int axes = Axes;
  Counted_ends<Axes> low, high;
  internal::Place position, sides;
};

template <int Axes>
std::vector<Counted_box<Axes>> counted_boxes(const Number_boxes& boxes)
{
  std::vector<Counted_box<Axes>> counted(boxes.size());
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    counted[i].position = static_cast<internal::Place>(i);
    for(std::size_t axis = 0; axis < Axes; ++axis) {
      counted[i].low.ends[axis] = boxes[i][axis].low;
      counted[i].high.ends[axis] = boxes[i][axis].high;
    }
  }
  return counted;
}

// Searches one set, or two sets, until there are `limit` pairs.
template <int Axes>
Pairs pairs_by_tree(const Number_boxes& numbers, std::optional<std::size_t> first_set_size,
                    std::size_t limit = std::size_t(-1))
{
  using Box = Counted_box<Axes>;
  const std::vector<Box> boxes = counted_boxes<Axes>(numbers);
  std::vector<const Box*> a, b;
  for(const Box& box : boxes)
    (box.position < first_set_size.value_or(boxes.size()) ? a : b).push_back(&box);
  Pairs pairs;
  const auto report = [&](std::size_t i, std::size_t j) {
    pairs.emplace_back(i, j);
    return pairs.size() < limit;
  };
  internal::Unwatched_progress progress;
  const Number_objects objects(numbers, Axes);
  with_piece<Axes>(objects, std::nullopt, report, progress, [&](auto& client, const auto&) {
    const internal::Stop_flag stop;
    internal::Box_tree<Box> tree(client, stop);
    const bool goes_on = first_set_size ? tree.between(a, b) : tree.within(a);
    BOOST_CHECK_EQUAL(goes_on, pairs.size() < limit);
  });
  return pairs;
}

// Calls task(std::integral_constant<int, D>()) for the dimensions 1 to 5.
template <class Task>
void for_each_dimension(const Task& task)
{
  task(std::integral_constant<int, 1>());
  task(std::integral_constant<int, 2>());
  task(std::integral_constant<int, 3>());
  task(std::integral_constant<int, 4>());
  task(std::integral_constant<int, 5>());
}

// Boxes that are mostly long, so that many of them hold the lower ends of a part.
Number_boxes long_boxes(Generator& random, int dimension, std::size_t size, std::uint64_t side)
{
  Number_boxes boxes(size);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < dimension; ++axis) {
      const double a = below(random, side), b = below(random, side);
      box[axis] = random() % 3 == 0 ? internal::Interval{a, a}
                                    : internal::Interval{(std::min)(a, b), (std::max)(a, b)};
    }
  return boxes;
}

// Checks the pairs of one set, and those of two if the first one has this size.
template <int Axes>
void check_tree(const Number_boxes& boxes, std::size_t size_of_first, const std::string& name)
{
  for(const std::optional<std::size_t> first_set_size :
      {std::optional<std::size_t>(), std::optional<std::size_t>(size_of_first)}) {
    const Pairs expected = all_meeting_pairs(boxes, Axes, first_set_size);
    const Pairs found = sorted(pairs_by_tree<Axes>(boxes, first_set_size));
    BOOST_REQUIRE_MESSAGE(found == expected, name << ": " << compare(expected, found));
  }
}

BOOST_AUTO_TEST_CASE(tree_finds_the_pairs_of_long_boxes)
{
  for_each_dimension([](auto dimension) {
    for(const std::uint64_t side : {3, 20, 1000000})
      for(unsigned int seed = 0; seed < 20; ++seed) {
        Generator random(seed);
        const std::size_t size = 100 + random() % 300;
        const Number_boxes boxes = long_boxes(random, dimension, size, side);
        check_tree<dimension>(boxes, random() % size,
                              std::to_string(dimension) + "D, side " + std::to_string(side)
                                + ", seed " + std::to_string(seed));
      }
  });
}

BOOST_AUTO_TEST_CASE(identical_boxes_are_all_pairs)
{
  Number_boxes boxes(300);
  for(Number_box& box : boxes)
    box.fill({1, 1});
  for_each_dimension([&](auto dimension) {
    check_tree<dimension>(boxes, 100, "identical");
  });
}

BOOST_AUTO_TEST_CASE(tree_stops_when_told)
{
  Generator random(1);
  const Number_boxes boxes = long_boxes(random, 3, 300, 1000);
  for(const std::optional<std::size_t> first_set_size :
      {std::optional<std::size_t>(), std::optional<std::size_t>(150)}) {
    const std::size_t all = pairs_by_tree<3>(boxes, first_set_size).size();
    for(std::size_t limit = 1; limit <= all; limit += all / 50)
      BOOST_CHECK_EQUAL(pairs_by_tree<3>(boxes, first_set_size, limit).size(), limit);
  }
}

// Looks per n log2^d n + k.
template <int Axes>
void check_work(const Number_boxes& boxes,
                std::optional<std::size_t> first_set_size = std::nullopt)
{
  looks = 0;
  const double k = static_cast<double>(pairs_by_tree<Axes>(boxes, first_set_size).size());
  const double n = static_cast<double>(boxes.size());
  const double work = static_cast<double>(looks) / (n * std::pow(std::log2(n), Axes) + k);
  BOOST_TEST_MESSAGE(Axes << "D, n = " << n << ", k = " << k << ": " << work);
  BOOST_CHECK_LT(work, 3);
}

// Half beams: long horizontal boxes, and long vertical ones that are out
// of their way, so that many pairs meet along each axis, but no pair along both.
BOOST_AUTO_TEST_CASE(tree_looks_at_few_boxes)
{
  for(const std::size_t n : {2000, 16000}) {
    Generator random(n);
    const Number_boxes beams = half_beams(n);
    check_work<2>(beams);
    check_work<3>(beams);
    check_work<2>(long_boxes(random, 2, n, 1 << 30));
    check_work<3>(long_boxes(random, 3, n, 1 << 30));
  }
}

// The boxes of the first set that the sample takes are short, and all others hold all lower ends of
// the second set. All meet along axis 0, and none along axis 1.
BOOST_AUTO_TEST_CASE(sweeps_do_not_rely_on_a_sample)
{
  const std::size_t n = 8000, step = 174;
  Number_boxes boxes(2 * n);
  for(std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i);
    boxes[i] = {{{x, 1e6}, {0, 0}, {0, i % step == 0 ? 0 : 1e6}}};
    boxes[n + i] = {{{n + x, 1e6}, {1, 1}, {1 + x, 1 + x}}};
  }
  check_work<3>(boxes, n);
}

BOOST_AUTO_TEST_SUITE_END()
