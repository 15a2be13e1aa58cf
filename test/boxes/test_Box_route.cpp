// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The box route against all pairs, on many small structured scenes that are cut again and again,
// and on large ones; what it asks the objects, and how it stops.

#include "support/instruction_sets.h"
#include "support/number_boxes.h"
#include "support/seeds.h"

BOOST_AUTO_TEST_SUITE(Box_route)

using namespace test_support;

// One set, or two sets if the size of the first one is given. Objects that are more than their
// boxes are asked once about each pair of boxes that meet.
template <int Axes>
void check_pairs(const Number_boxes& boxes, int dimension, const Box_tuning& tuning,
                 bool are_exact, std::optional<std::size_t> first_set_size,
                 const std::string& name)
{
  const Number_objects objects(boxes, dimension, are_exact);
  const Pairs expected = all_meeting_pairs(boxes, dimension, first_set_size);
  const Pairs found = sorted(pairs_by_boxes<Axes>(objects, tuning, first_set_size));
  BOOST_REQUIRE_MESSAGE(found == expected, name << ": " << compare(expected, found));
  if(!are_exact && dimension <= Axes)
    BOOST_REQUIRE_MESSAGE(sorted(objects.asked()) == expected, name << " asks for other pairs");
}

template <int Axes>
void check_structured_scene(int dimension, std::uint64_t seed)
{
  Generator random(seed);
  const std::size_t size = seed % 16 == 0 ? 13 + random() % 50 : 1 + random() % 12;
  const Number_boxes boxes = structured_boxes(random, dimension, size);
  const Box_tuning tuning = small_tuning(random);
  std::optional<std::size_t> first_set_size;
  if(seed % 3 == 0)
    first_set_size = random() % (size + 1);
  check_pairs<Axes>(boxes, dimension, tuning, seed % 2 == 0, first_set_size,
                    std::to_string(dimension) + "D, seed " + std::to_string(seed));
}

BOOST_AUTO_TEST_CASE(first_structured_scenes) // enough for most errors
{
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    for(std::uint64_t seed = 0; seed < 1000; ++seed) {
      check_structured_scene<2>(2, seed);
      check_structured_scene<3>(3, seed);
      check_structured_scene<4>(5, seed);
    }
  }
}

// scripts/fuzz_searches checks more of them.
BOOST_AUTO_TEST_CASE(many_structured_scenes)
{
  check_seeds(20000, [](std::uint64_t seed) { check_structured_scene<2>(1, seed); });
  check_seeds(70000, [](std::uint64_t seed) { check_structured_scene<2>(2, seed); });
  check_seeds(70000, [](std::uint64_t seed) { check_structured_scene<3>(3, seed); });
  check_seeds(20000, [](std::uint64_t seed) { check_structured_scene<4>(4, seed); });
  check_seeds(20000, [](std::uint64_t seed) { check_structured_scene<4>(5, seed); });
}

// Faces of boxes lie on the borders of pieces, and boxes begin and end on both sides of them.
BOOST_AUTO_TEST_CASE(boxes_at_the_borders_of_pieces_meet_once)
{
  Number_boxes boxes;
  for(int x = 0; x <= 16; ++x)
    for(int y = 0; y <= 16; ++y)
      for(const double low : {-1., std::nextafter(0., -1.), 0., 5e-324})
        boxes.push_back({{{x + low, static_cast<double>(x)}, {y + low, static_cast<double>(y)}}});
  for(Number_box& box : boxes)
    for(internal::Interval& interval : box)
      interval.high = (std::max)(interval.low, interval.high);
  for(unsigned int seed = 0; seed < 20; ++seed) {
    Generator random(seed);
    const Box_tuning tuning = small_tuning(random);
    check_pairs<2>(boxes, 2, tuning, true, std::nullopt, "borders");
    check_pairs<2>(boxes, 2, tuning, false, 700, "borders, two sets");
  }
}

// Boxes whose sizes follow a power law, up to the whole scene, among small ones.
Number_boxes power_law(Generator& random, int dimension, std::size_t size)
{
  Number_boxes boxes(size);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < dimension; ++axis) {
      const double low = below(random, 1 << 16);
      box[axis] = {low, low + std::floor(0.5 * std::pow(1 + below(random, 1 << 17), 0.8))
                              / (random() % 8 == 0 ? 1 : 256)};
    }
  return boxes;
}

BOOST_AUTO_TEST_CASE(large_scenes_with_the_usual_constants)
{
  Generator random(1);
  for(const std::size_t size : {100, 1000, 6000}) {
    const Number_boxes boxes = power_law(random, 5, size);
    const Box_tuning usual;
    check_pairs<2>(boxes, 1, usual, true, std::nullopt, "1D");
    check_pairs<2>(boxes, 2, usual, false, std::nullopt, "2D");
    check_pairs<3>(boxes, 3, usual, false, size / 3, "3D, two sets");
    check_pairs<4>(boxes, 4, usual, true, std::nullopt, "4D");
    check_pairs<4>(boxes, 5, usual, false, size / 3, "5D, two sets");
  }
}

// The tree searches boxes that were cut, so copies meet copies in it.
BOOST_AUTO_TEST_CASE(crowded_pieces_are_searched_by_the_tree)
{
  Generator random(2);
  Box_tuning tuning;
  tuning.crowded_candidates = 0;
  tuning.tree_candidates = 0;
  tuning.crowded_share = 2;
  for(const std::size_t size : {300, 3000}) {
    const Number_boxes boxes = power_law(random, 5, size);
    check_pairs<2>(boxes, 2, tuning, false, std::nullopt, "2D");
    check_pairs<3>(boxes, 3, tuning, true, size / 2, "3D, two sets");
    check_pairs<4>(boxes, 5, tuning, false, std::nullopt, "5D");
  }
}

// The boxes that the sample takes are small: it does not see that a cut would copy the others to
// many pieces.
BOOST_AUTO_TEST_CASE(cuts_that_would_make_too_many_copies_are_not_made)
{
  Generator random(3);
  Number_boxes boxes(3 * internal::first_box_sample);
  const std::vector<bool> sampled = sampled_of_three(boxes.size());
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(int axis = 0; axis < 2; ++axis) {
      const double low = below(random, 1 << 20);
      boxes[i][axis] = {low, low + (sampled[i] ? 1 : 1 << 14)};
    }
  check_pairs<2>(boxes, 2, Box_tuning(), true, std::nullopt, "boxes of the sample are small");
}

BOOST_AUTO_TEST_CASE(order_of_reports_is_a_function_of_the_input)
{
  Generator random(4);
  const Number_boxes boxes = power_law(random, 3, 3000);
  const Number_objects objects(boxes, 3);
  const Pairs pairs = pairs_by_boxes<3>(objects);
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    BOOST_CHECK(pairs_by_boxes<3>(objects) == pairs);
  }
}

BOOST_AUTO_TEST_CASE(callback_stops_each_part_of_the_search)
{
  for(unsigned int seed = 0; seed < 300; ++seed) {
    Generator random(seed);
    const Number_boxes boxes = structured_boxes(random, 2, 30 + random() % 100);
    const Box_tuning tuning = small_tuning(random);
    const Number_objects objects(boxes, 2);
    std::optional<std::size_t> first_set_size;
    if(seed % 2)
      first_set_size = boxes.size() / 2;
    const std::size_t all = pairs_by_boxes<2>(objects, tuning, first_set_size).size();
    for(std::size_t limit = 1; limit <= all; limit += 1 + all / 10) {
      std::size_t calls = 0;
      Box_progress progress;
      std::size_t finished = 0;
      const auto callback = [&](std::size_t, std::size_t) {
        finished = progress.finished;
        return ++calls < limit;
      };
      BOOST_CHECK(!search_boxes<2>(objects, tuning, first_set_size, callback, progress));
      BOOST_CHECK_EQUAL(calls, limit);
      BOOST_CHECK_EQUAL(progress.finished, finished); // no progress after the stop
    }
  }
}

BOOST_AUTO_TEST_CASE(progress_counts_each_box_once_and_cancels)
{
  const auto ignore = [](std::size_t, std::size_t) {};
  for(unsigned int seed = 0; seed < 3000; ++seed) {
    Generator random(seed);
    const Number_boxes boxes = structured_boxes(random, 3, random() % 60);
    const Box_tuning tuning = small_tuning(random);
    const Number_objects objects(boxes, 3);
    std::optional<std::size_t> first_set_size;
    if(seed % 2)
      first_set_size = random() % (boxes.size() + 1);
    Box_progress to_the_end;
    BOOST_CHECK(search_boxes<3>(objects, tuning, first_set_size, ignore, to_the_end));
    BOOST_CHECK_EQUAL(to_the_end.finished, boxes.size());
    Box_progress cancelled = {boxes.size() / 2 + 1};
    const bool is_complete = search_boxes<3>(objects, tuning, first_set_size, ignore, cancelled);
    BOOST_CHECK_EQUAL(is_complete, cancelled.finished < cancelled.limit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
