// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the box route: the boxes that it looks at are counted against n log2^(d-1) n + k, on
// scenes of all sizes of boxes, and on scenes where no cut helps.

#include "support/number_boxes.h"
#include "support/unit_test.h"

using namespace test_support;

namespace {

double uniform(Generator& random) { return below(random, std::uint64_t(1) << 32) / (1ull << 32); }

// Searches one set, or two sets of n/2 boxes. Returns how often a box is swept on average, as
// itself or as a copy.
template <int Axes, std::size_t Sets = 1>
double check_work(const std::string& name, const Number_boxes& boxes, double limit)
{
  const Number_objects objects(boxes, Axes);
  double k = 0, candidates = 0, swept = 0;
  const auto callback = [&](std::size_t, std::size_t) { ++k; };
  internal::Unwatched_progress progress;
  std::optional<std::size_t> first_set_size;
  if(Sets == 2)
    first_set_size = boxes.size() / 2;
  with_piece<Axes>(objects, first_set_size, callback, progress,
                   [&](auto& client, const auto& piece) {
                     internal::Box_route<Axes> route(client, internal::Threads());
                     route.search(piece);
                     candidates = static_cast<double>(route.candidate_count());
                     swept = static_cast<double>(route.swept_count());
                   });
  const double n = static_cast<double>(boxes.size());
  const double work = (candidates + swept) / (n * std::pow(std::log2(n), Axes - 1) + k);
  BOOST_TEST_MESSAGE(Axes << "D " << name << ", n = " << n << ", k/n = " << k / n
                          << ": candidates/n " << candidates / n << ", work " << work);
  BOOST_CHECK_MESSAGE(work <= limit, Axes << "D " << name << ": " << work);
  return swept / n;
}

// Boxes that begin anywhere in the unit cube, with extents(i, axis).
template <int Axes, class Extents>
Number_boxes boxes_with(std::size_t n, const Extents& extents)
{
  Generator random(n);
  Number_boxes boxes(n);
  for(std::size_t i = 0; i < n; ++i)
    for(int axis = 0; axis < Axes; ++axis) {
      const double low = uniform(random);
      boxes[i][axis] = {low, low + extents(random, i, axis)};
    }
  return boxes;
}

template <int Axes>
void check_scenes(std::size_t n, double limit)
{
  const double usual = std::pow(1. / static_cast<double>(n), 1. / Axes);
  const auto check = [&](const std::string& name, const auto& extents) {
    check_work<Axes>(name, boxes_with<Axes>(n, extents), limit);
  };
  check("uniform", [=](Generator&, std::size_t, int) { return usual; });
  check("points", [](Generator&, std::size_t, int) { return 0; });
  check("power law", [=](Generator& random, std::size_t, int) {
    return (std::min)(1., usual / 4 / std::pow(uniform(random) + 1e-9, 0.7));
  });
  check("six decades", [=](Generator& random, std::size_t, int) {
    return std::pow(10., -6 * uniform(random)) * 0.3;
  });
  check("one giant", [=](Generator&, std::size_t i, int) { return i == 5 ? 1. : usual; });
  check("beams", [=](Generator&, std::size_t i, int axis) {
    return static_cast<int>(i % Axes) == axis ? 1. : usual / 50;
  });
  check("short beams", [=](Generator&, std::size_t i, int axis) {
    return static_cast<int>(i % Axes) == axis ? 0.05 : usual / 5000;
  });
  check("plates", [=](Generator&, std::size_t i, int axis) {
    return static_cast<int>(i % Axes) == axis ? usual / 50 : 0.3;
  });

  Number_boxes nested(n / 10);
  for(std::size_t i = 0; i < nested.size(); ++i)
    nested[i].fill({static_cast<double>(i), static_cast<double>(2 * n - i)});
  check_work<Axes>("nested", nested, limit);
  Number_boxes identical(n / 10);
  for(Number_box& box : identical)
    box.fill({1, 2});
  check_work<Axes>("identical", identical, limit);
  Number_boxes outlier = boxes_with<Axes>(n, [=](Generator&, std::size_t, int) { return usual; });
  outlier[3].fill({1e9, 1e9});
  check_work<Axes>("outlier", outlier, limit);
}

// Short boxes that begin at `places` places along each axis.
template <int Axes>
Number_boxes short_boxes_of_a_lattice(std::size_t n, std::uint64_t places)
{
  Generator random(n);
  Number_boxes boxes(n);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < Axes; ++axis) {
      const double low = below(random, places);
      box[axis] = {low, low + 1e-9};
    }
  return boxes;
}

// Boxes between two random places along each axis.
template <int Axes>
Number_boxes random_long_boxes(std::size_t n)
{
  Generator random(n);
  Number_boxes boxes(n);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < Axes; ++axis) {
      const double a = uniform(random), b = uniform(random);
      box[axis] = {(std::min)(a, b), (std::max)(a, b)};
    }
  return boxes;
}

// One set below a line of the plane and one above it, with corners at the line. Half of the pairs
// of both sets meet along either axis, but none along both. All boxes are long along other axes.
template <int Axes>
Number_boxes staircases(std::size_t n)
{
  Generator random(n);
  Number_boxes boxes = random_long_boxes<Axes>(n);
  for(std::size_t i = 0; i < n; ++i) {
    const double t = uniform(random);
    boxes[i][0] = i < n / 2 ? internal::Interval{0, t} : internal::Interval{t, 1};
    boxes[i][1] = i < n / 2 ? internal::Interval{0, 1 - t - 1e-9} : internal::Interval{1 - t, 1};
  }
  return boxes;
}

} // namespace

// A sweep may look at eight candidates for each pair.
BOOST_AUTO_TEST_CASE(work_is_little_in_the_plane) { check_scenes<2>(40000, 9); }
BOOST_AUTO_TEST_CASE(work_is_little_in_space) { check_scenes<3>(40000, 9); }

// Along each axis, many boxes meet that are much shorter than a piece.
BOOST_AUTO_TEST_CASE(work_is_little_on_lattices)
{
  for(const std::size_t n : {10000, 40000}) {
    check_work<2>("lattice", short_boxes_of_a_lattice<2>(n, 64), 1);
    check_work<3>("lattice", short_boxes_of_a_lattice<3>(n, 30), 0.3);
    check_work<4>("lattice", short_boxes_of_a_lattice<4>(n, 20), 0.05);
  }
}

// The tree takes over from 32 candidates per n log2 n on in the plane, and from fewer per
// n log2^(d-1) n elsewhere.
BOOST_AUTO_TEST_CASE(work_is_little_where_no_cut_helps)
{
  for(const std::size_t n : {4000, 40000}) {
    check_work<2>("half beams", half_beams(n), 1);
    check_work<2, 2>("staircases", staircases<2>(n), 33);
    check_work<3, 2>("staircases", staircases<3>(n), 33);
    check_work<4, 2>("staircases", staircases<4>(n), 33);
  }
  check_work<2>("random long boxes", random_long_boxes<2>(4000), 3);
  check_work<3>("random long boxes", random_long_boxes<3>(4000), 3);
  check_work<4>("random long boxes", random_long_boxes<4>(4000), 3);
}

// Two of three boxes are longer than the pieces that a plan by the others makes, and the sample
// does not see them.
BOOST_AUTO_TEST_CASE(copies_are_few_where_the_sample_misleads)
{
  const std::size_t n = 3 * internal::first_box_sample;
  const std::vector<bool> sampled = sampled_of_three(n);
  const Number_boxes boxes = boxes_with<2>(n, [&](Generator&, std::size_t i, int axis) {
    return sampled[i] || axis == 0 ? 0.01 : 0.5;
  });
  BOOST_CHECK_LE(check_work<2>("misleading sample", boxes, 9), 2);
}

// Most of the candidates are pairs, so neither classes nor the tree would save anything.
BOOST_AUTO_TEST_CASE(crowded_boxes_that_mostly_meet_are_swept_once)
{
  const std::size_t n = 4000;
  const Number_boxes of_one_class
    = boxes_with<2>(n, [](Generator&, std::size_t, int) { return 2; });
  BOOST_CHECK_EQUAL(check_work<2>("of one class", of_one_class, 9), 1);
  Number_boxes of_two_classes = boxes_with<2>(n, [](Generator&, std::size_t, int) { return 0; });
  for(std::size_t i = 0; i < n; ++i)
    if(i % 4 != 0)
      of_two_classes[i].fill({0, 1});
  BOOST_CHECK_EQUAL(check_work<2>("of two classes", of_two_classes, 9), 1);
}
