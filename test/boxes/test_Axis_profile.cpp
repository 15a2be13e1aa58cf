// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Profiles of samples: the sizes of pieces against counting, outliers, and what cannot be cut.

#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(Axis_profile)

using namespace test_support;
using Box = internal::Piece_box<1>;

std::vector<Box> boxes_of(const std::vector<internal::Interval>& intervals)
{
  std::vector<Box> boxes;
  for(const internal::Interval& interval : intervals)
    boxes.push_back({{interval.low}, {interval.high}, 0, 0});
  return boxes;
}

internal::Axis_profile profile_of(const std::vector<Box>& boxes)
{
  std::vector<const Box*> sample;
  for(const Box& box : boxes)
    sample.push_back(&box);
  internal::Axis_profile profile;
  profile.set(sample, 0);
  return profile;
}

// 256 boxes that begin at random integers from 0 to 256, so that each bucket has length one.
std::vector<Box> integer_boxes(std::uint64_t longest, std::uint64_t seed)
{
  Generator random(seed);
  std::vector<internal::Interval> intervals = {{0, 1}, {256, 256}};
  while(intervals.size() < 256) {
    const double low = below(random, 257);
    intervals.push_back({low, low + below(random, longest)});
  }
  return boxes_of(intervals);
}

BOOST_AUTO_TEST_CASE(pieces_hold_the_boxes_that_meet_them)
{
  for(const std::uint64_t longest : {1, 3, 40, 1000}) {
    const std::vector<Box> boxes = integer_boxes(longest, longest);
    const internal::Axis_profile profile = profile_of(boxes);
    BOOST_REQUIRE(profile.is_cuttable());
    BOOST_CHECK_EQUAL(profile.max_piece_count(), 256u);
    for(internal::Place count = 1; count <= 256; count *= 2) {
      std::vector<double> sizes(count, 0);
      const auto piece_of = [&](double x) {
        return static_cast<std::size_t>((std::min)(x * count / 256, count - 1.));
      };
      for(const Box& box : boxes)
        for(std::size_t piece = piece_of(box.low[0]); piece <= piece_of(box.high[0]); ++piece)
          ++sizes[piece];
      double sum = 0, pairs = 0;
      for(const double size : sizes) {
        sum += size / 256;
        pairs += size * (size - 1) / (256 * 255);
      }
      BOOST_CHECK_CLOSE(profile.piece_sizes(count).sum, sum, 1e-9);
      BOOST_CHECK_CLOSE(profile.piece_sizes(count).pairs, pairs, 1e-9);
    }
  }
}

// Ends are taken to be evenly spread within buckets.
BOOST_AUTO_TEST_CASE(share_of_meeting_pairs_is_estimated)
{
  for(const double length : {0., 0.01, 0.1, 0.5}) {
    Generator random(3);
    std::vector<internal::Interval> intervals;
    for(int i = 0; i < 1000; ++i) {
      const double low = below(random, 1 << 20) / (1 << 20);
      intervals.push_back({low, low + length * below(random, 1 << 20) / (1 << 20)});
    }
    double pairs = 0;
    for(std::size_t i = 0; i < intervals.size(); ++i)
      for(std::size_t j = i + 1; j < intervals.size(); ++j)
        pairs += intervals_meet(intervals[i], intervals[j]);
    const double share = pairs / (1000 * 999 / 2);
    BOOST_CHECK_SMALL(profile_of(boxes_of(intervals)).meeting_share() - share, 0.003);
  }
}

BOOST_AUTO_TEST_CASE(short_boxes_that_begin_at_a_few_places_meet)
{
  for(const std::uint64_t places : {10, 40}) {
    Generator random(places);
    std::vector<internal::Interval> intervals;
    for(std::size_t i = 0; i < 4 * internal::box_sample; ++i) {
      const double low = below(random, places);
      intervals.push_back({low, low + 1e-9});
    }
    const double share = 1 / static_cast<double>(places);
    BOOST_CHECK_CLOSE(profile_of(boxes_of(intervals)).meeting_share(), share, 30);
  }
}

// Most boxes begin at one place, but not those that a part of the sample at equal steps would see.
BOOST_AUTO_TEST_CASE(common_places_are_seen_between_equal_steps)
{
  Generator random(7);
  std::vector<internal::Interval> intervals;
  for(std::size_t i = 0; i < 4 * internal::box_sample; ++i) {
    const double low = i % 16 == 0 ? below(random, 1 << 20) / (1 << 20) : 0.3;
    intervals.push_back({low, low + 1e-9});
  }
  BOOST_CHECK_GT(profile_of(boxes_of(intervals)).meeting_share(), 0.5);
}

// Copies begin before the piece that they are in.
BOOST_AUTO_TEST_CASE(copies_do_not_widen_the_range)
{
  std::vector<Box> boxes = integer_boxes(3, 1);
  for(int i = 0; i < 8; ++i)
    boxes.push_back({{-1e6}, {300}, 0, 1});
  const internal::Axis_profile profile = profile_of(boxes);
  BOOST_CHECK_EQUAL(profile.range().low, 0);
  BOOST_CHECK_EQUAL(profile.range().high, 256);
  BOOST_CHECK_GE(profile.piece_sizes(2).sum, 1 + 8. / 264);
}

BOOST_AUTO_TEST_CASE(few_outliers_do_not_widen_the_range)
{
  for(const double far : {1e4, 1e9, 1e15}) {
    std::vector<Box> boxes = integer_boxes(3, 1);
    boxes.push_back({{far}, {far}, 0, 0});
    boxes.push_back({{-far}, {far}, 0, 0});
    const internal::Axis_profile profile = profile_of(boxes);
    BOOST_CHECK(profile.is_cuttable());
    BOOST_CHECK_GT(profile.range().low, -1000);
    BOOST_CHECK_LT(profile.range().high, 1300);
    BOOST_CHECK_LT(profile.piece_sizes(8).pairs, 0.6);
  }
}

BOOST_AUTO_TEST_CASE(two_halves_far_apart_are_no_outliers)
{
  std::vector<Box> boxes = integer_boxes(3, 1);
  for(std::size_t i = 0; i < boxes.size(); i += 2)
    boxes[i].low[0] = boxes[i].high[0] = boxes[i].high[0] + 1e6;
  const internal::Axis_profile profile = profile_of(boxes);
  BOOST_CHECK_LT(profile.range().low, 256);
  BOOST_CHECK_GE(profile.range().high, 1e6);
}

BOOST_AUTO_TEST_CASE(what_begins_at_one_place_or_nowhere_cannot_be_cut)
{
  for(const internal::Interval& interval :
      {internal::Interval{1, 2}, internal::Interval{-infinity, infinity},
       internal::Interval{-infinity, 0}, internal::Interval{-0., 0}}) {
    const internal::Axis_profile profile
      = profile_of(boxes_of(std::vector<internal::Interval>(100, interval)));
    BOOST_CHECK(!profile.is_cuttable());
    BOOST_CHECK_EQUAL(profile.meeting_share(), 1);
  }
  const internal::Axis_profile huge = profile_of(boxes_of({{-1e308, 0}, {1e308, 1e308}}));
  BOOST_CHECK(!huge.is_cuttable());
}

BOOST_AUTO_TEST_SUITE_END()
