// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes in groups: each pair of groups is found once, and pairs of boxes that cannot tell another
// one are not looked at, but for a few per box.

#include "support/number_boxes.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Group_scan.h>

BOOST_AUTO_TEST_SUITE(groups)

using namespace test_support;
using internal::Boxes_by_group;
using internal::Place;

// The groups of a list, in its order, each with its boxes.
std::vector<std::vector<Place>> groups_of(const Boxes_by_group& list)
{
  std::vector<std::vector<Place>> groups;
  for(Place first = list.first(); first != Boxes_by_group::none; first = list.next_group(first)) {
    groups.emplace_back();
    for(Place box = first; box != Boxes_by_group::none; box = list.next_in_group(box))
      groups.back().push_back(box);
  }
  return groups;
}

BOOST_AUTO_TEST_CASE(groups_are_in_the_order_of_their_first_boxes)
{
  Boxes_by_group list;
  list.set_group_count(9);
  list.restart(1);
  list.push_front(0, 8);
  list.set_group_count(7);
  BOOST_CHECK(groups_of(list).empty());
  for(unsigned int seed = 0; seed < 200; ++seed) {
    Generator random(seed);
    const auto size = static_cast<Place>(random() % 30);
    list.restart(size);
    BOOST_REQUIRE(groups_of(list).empty());
    std::map<Place, std::vector<Place>> expected; // the boxes of a group
    for(Place box = size; box-- > 0;) {
      const auto group = static_cast<Place>(random() % 7);
      list.push_front(box, group);
      expected[group].insert(expected[group].begin(), box);
      std::vector<std::vector<Place>> groups;
      for(const auto& entry : expected)
        groups.push_back(entry.second);
      std::sort(groups.begin(), groups.end());
      BOOST_REQUIRE(groups_of(list) == groups);
    }
  }
}

// Of the boxes of two groups that meet, one of `rarity` pairs makes the groups a pair. If `rarity`
// is zero, none does. What is asked is counted. Unwanted pairs are not to be asked about.
class Grouped_objects : public Number_objects
{
public:
  static constexpr bool may_have_groups = true;

  Grouped_objects(const Number_boxes& boxes, int dimension, const std::vector<std::size_t>& groups,
                  std::size_t rarity)
    : Number_objects(boxes, dimension, false), groups_(groups), rarity_(rarity)
  {}

  std::size_t group_of(std::size_t i) const { return groups_[i]; }

  bool is_wanted(std::size_t i, std::size_t j) const
  {
    ++looks;
    return is_open(i, j);
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    ++tests;
    wrong += !is_open(i, j);
    if(!Number_objects::do_intersect(i, j) || !is_pair(i, j))
      return false;
    known_.insert(groups_of(i, j));
    return true;
  }

  Pair groups_of(std::size_t i, std::size_t j) const
  {
    return std::minmax({groups_[i], groups_[j]});
  }

  // The pairs of groups, in ascending order.
  Pairs all_pairs(const Pairs& meeting_boxes) const
  {
    std::set<Pair> pairs;
    for(const auto& [i, j] : meeting_boxes)
      if(groups_[i] != groups_[j] && is_pair(i, j))
        pairs.insert(groups_of(i, j));
    return Pairs(pairs.begin(), pairs.end());
  }

  mutable std::size_t looks = 0; // at pairs of boxes, to see whether they are wanted
  mutable std::size_t tests = 0;
  mutable std::size_t wrong = 0; // tests

private:
  bool is_open(std::size_t i, std::size_t j) const
  {
    return groups_[i] != groups_[j] && known_.count(groups_of(i, j)) == 0;
  }

  bool is_pair(std::size_t i, std::size_t j) const
  {
    return rarity_ != 0 && ((std::min)(i, j) * 7 + (std::max)(i, j) * 31) % rarity_ == 0;
  }

  const std::vector<std::size_t> groups_;
  const std::size_t rarity_;
  mutable std::set<Pair> known_;
};

// The pairs of groups by the box route.
template <int Axes>
Pairs pairs_of_groups(const Grouped_objects& objects, const Box_tuning& tuning = Box_tuning(),
                      std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  for(const auto& [i, j] : pairs_by_boxes<Axes>(objects, tuning, first_set_size))
    pairs.push_back(objects.groups_of(i, j));
  return sorted(pairs);
}

// Tuned so that small scenes are cut, called crowded, swept for a while, and given to the tree.
Box_tuning tuning_of_groups(Generator& random)
{
  Box_tuning tuning = small_tuning(random);
  tuning.unwanted_candidates = static_cast<Place>(1 + random() % 3);
  tuning.candidates_per_wanted_pair = static_cast<std::int64_t>(random() % 3);
  return tuning;
}

template <int Axes>
void check_groups(const Number_boxes& boxes, int dimension, std::uint64_t seed)
{
  Generator random(seed);
  const Box_tuning tuning = tuning_of_groups(random);
  const std::size_t group_count = 1 + random() % 6;
  std::vector<std::size_t> groups(boxes.size());
  for(std::size_t i = 0; i < groups.size(); ++i) // some groups of positions that follow each other
    groups[i] = random() % 2 ? 10 * (random() % group_count)
                             : 10 * (i * group_count / groups.size());
  std::optional<std::size_t> first_set_size;
  if(seed % 3 == 0)
    first_set_size = random() % (boxes.size() + 1);
  const Grouped_objects objects(boxes, dimension, groups, random() % 4);
  const Pairs expected
    = objects.all_pairs(all_meeting_pairs(boxes, dimension, first_set_size));
  const Pairs found = pairs_of_groups<Axes>(objects, tuning, first_set_size);
  BOOST_REQUIRE_MESSAGE(found == expected, "seed " << seed << ": " << compare(expected, found));
  BOOST_REQUIRE_EQUAL(objects.wrong, 0u);
}

BOOST_AUTO_TEST_CASE(each_pair_of_groups_is_found_once)
{
  for(std::uint64_t seed = 0; seed < 4000; ++seed) {
    Generator random(seed);
    const std::size_t size = seed % 16 == 0 ? 60 + random() % 200 : 1 + random() % 30;
    check_groups<2>(structured_boxes(random, 2, size), 2, seed);
    check_groups<3>(structured_boxes(random, 3, size), 3, seed);
    check_groups<4>(structured_boxes(random, 5, size), 5, seed);
  }
}

// Boxes of no length, diagonal ones that all meet, and rows and columns that cross, each in random
// order.
Number_boxes boxes_of_kind(int kind, std::size_t size)
{
  Generator random(size);
  Number_boxes boxes(size);
  for(std::size_t i = 0; i < size; ++i) {
    const double x = static_cast<double>(i), far = static_cast<double>(size);
    if(kind == 0)
      boxes[i].fill({1, 1});
    else if(kind == 1)
      boxes[i].fill({x, x + far});
    else if(i % 2 == 0)
      boxes[i] = {{{0, far}, {x, x}, {x, x + far}}};
    else
      boxes[i] = {{{x, x}, {0, far}, {x, x + far}}};
  }
  std::shuffle(boxes.begin(), boxes.end(), random);
  return boxes;
}

// Groups of which each of `size` boxes is in the next one.
std::vector<std::size_t> groups_in_turn(std::size_t size, std::size_t count)
{
  std::vector<std::size_t> groups(size);
  for(std::size_t i = 0; i < size; ++i)
    groups[i] = i % count;
  return groups;
}

// Few of the boxes that meet tell a pair of groups, so the tree is to find each of them.
BOOST_AUTO_TEST_CASE(rare_pairs_of_crowded_boxes_are_found)
{
  Box_tuning tuning;
  tuning.crowded_candidates = 0;
  tuning.tree_candidates = 0;
  tuning.crowded_share = 2;
  for(int kind = 0; kind < 3; ++kind)
    for(const std::size_t rarity : {97, 997, 4001}) {
      const Number_boxes boxes = boxes_of_kind(kind, 400);
      const Grouped_objects objects(boxes, 2, groups_in_turn(boxes.size(), 40), rarity);
      const Pairs expected = objects.all_pairs(all_meeting_pairs(boxes, 2));
      BOOST_CHECK(!expected.empty());
      BOOST_CHECK(pairs_of_groups<2>(objects, tuning) == expected);
    }
}

// Looks at pairs, per n log2^(d-1) n, apart from those that are tested.
template <int Axes>
void check_looks(const Grouped_objects& objects, const Pairs& expected, const std::string& name,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  BOOST_CHECK_MESSAGE(pairs_of_groups<Axes>(objects, Box_tuning(), first_set_size) == expected,
                      name);
  const double n = static_cast<double>(objects.size());
  const double work = static_cast<double>(objects.looks - objects.tests)
                      / (n * std::pow(std::log2(n), Axes - 1));
  BOOST_TEST_MESSAGE(Axes << "D, " << name << ", n = " << n << ": looks "
                          << static_cast<double>(objects.looks) / n << " n, tests "
                          << static_cast<double>(objects.tests) / n << " n, work " << work);
  BOOST_CHECK_MESSAGE(work <= (Axes == 2 ? 40 : 8), name << ": " << work);
}

template <int Axes>
void check_work_of_groups()
{
  for(const std::size_t n : {2000, 8000})
    for(int kind = 0; kind < 3; ++kind) {
      const Number_boxes boxes = boxes_of_kind(kind, n);
      const std::string name = "kind " + std::to_string(kind);
      const auto groups = [&](std::size_t count) { return groups_in_turn(n, count); };
      check_looks<Axes>({boxes, Axes, groups(1), 0}, {}, name + ", one group");
      check_looks<Axes>({boxes, Axes, groups(1), 0}, {}, name + ", one group in two sets", n / 3);
      check_looks<Axes>({boxes, Axes, groups(2), 1}, {{0, 1}}, name + ", two groups");
      check_looks<Axes>({boxes, Axes, groups(3), 5}, {{0, 1}, {0, 2}, {1, 2}},
                        name + ", three groups");
      check_looks<Axes>({boxes, Axes, groups(3), 5}, {{0, 1}, {0, 2}, {1, 2}},
                        name + ", three groups in two sets", n / 2);
    }
}

BOOST_AUTO_TEST_CASE(pairs_within_a_group_and_of_known_groups_are_not_looked_at)
{
  check_work_of_groups<2>();
  check_work_of_groups<3>();
}

// Groups that meet in all of their boxes and are no pairs are tested, in a sweep or in the tree.
BOOST_AUTO_TEST_CASE(each_wanted_pair_is_tested_at_most_three_times)
{
  const std::size_t n = 3000;
  std::vector<std::size_t> groups(n);
  for(std::size_t i = 0; i < n; ++i)
    groups[i] = i < n / 2 ? i % 3 : 3; // group 3 is in half of the boxes
  const Number_boxes boxes = boxes_of_kind(1, n);
  const Grouped_objects objects(boxes, 2, groups, 0);
  BOOST_CHECK(pairs_of_groups<2>(objects).empty());
  std::size_t wanted = 0;
  for(std::size_t i = 0; i < n; ++i)
    wanted += static_cast<std::size_t>(
      std::count_if(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](std::size_t group) { return group != groups[i]; }));
  BOOST_CHECK_GE(objects.tests, wanted);
  BOOST_CHECK_LE(objects.tests, 3 * wanted);
}

// Who tests all candidates because they are wanted has no reason to begin again with a tree.
BOOST_AUTO_TEST_CASE(a_sweep_of_wanted_pairs_is_not_given_up)
{
  const std::size_t n = 2000;
  const Number_boxes boxes = boxes_of_kind(1, n);
  const Grouped_objects objects(boxes, 2, groups_in_turn(n, n), 0);
  BOOST_CHECK(pairs_of_groups<2>(objects).empty());
  BOOST_CHECK_EQUAL(objects.tests, n * (n - 1) / 2);
}

// A sweep begins, all groups become known, and the tree takes over: progress ends at one, and goes
// on until then.
BOOST_AUTO_TEST_CASE(progress_counts_boxes_once_when_a_sweep_is_given_up)
{
  const std::size_t n = 4000;
  const Number_boxes boxes = boxes_of_kind(0, n);
  const Grouped_objects objects(boxes, 2, groups_in_turn(n, 2), 1);
  Box_progress progress;
  std::size_t pairs = 0;
  const auto callback = [&](std::size_t, std::size_t) { ++pairs; };
  BOOST_CHECK(search_boxes<2>(objects, Box_tuning(), std::nullopt, callback, progress));
  BOOST_CHECK_EQUAL(pairs, 1u);
  BOOST_CHECK_EQUAL(progress.finished, n);
  BOOST_CHECK_GT(progress.steps, 1u);
}

// One group is in most boxes, so the tree searches them, and finds a pair with each of the others.
BOOST_AUTO_TEST_CASE(callback_stops_the_search_of_groups)
{
  const std::size_t n = 3000;
  const Number_boxes boxes = boxes_of_kind(1, n);
  std::vector<std::size_t> groups(n, 0);
  for(std::size_t i = 0; i < 40; ++i)
    groups[i] = i;
  for(const std::size_t limit : {1, 5, 39}) {
    const Grouped_objects objects(boxes, 2, groups, 1);
    std::size_t pairs = 0;
    const auto callback = [&](std::size_t, std::size_t) { return ++pairs < limit; };
    internal::Unwatched_progress progress;
    BOOST_CHECK(!search_boxes<2>(objects, Box_tuning(), std::nullopt, callback, progress));
    BOOST_CHECK_EQUAL(pairs, limit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
