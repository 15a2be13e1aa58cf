// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The images of points, without a search: how many there are, wherever the scene lies, and whether
// those that are counted are those that are made.

#include "support/unit_test.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Scene_images.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

BOOST_AUTO_TEST_SUITE(Scene_images)

using namespace test_support;

using Plain = CGAL::Simple_cartesian<double>;

// The number of homes near images, and of images, as they are counted and as they are made.
struct Counts
{
  std::size_t homes = 0;
  std::size_t counted = 0;
  std::size_t made = 0;
  bool are_moved = false;

  friend bool operator==(const Counts& a, const Counts& b)
  {
    return std::tie(a.homes, a.counted, a.made, a.are_moved)
           == std::tie(b.homes, b.counted, b.made, b.are_moved);
  }
  friend std::ostream& operator<<(std::ostream& out, const Counts& counts)
  {
    return out << counts.homes << " homes, " << counts.counted << " counted, " << counts.made
               << " made, " << counts.are_moved;
  }
};

// Calls task(images, threads, elements) for points anywhere, before their images are found.
template <class Points, class Lattice, class Sets, class Task>
void with_images(const Points& points, const Lattice& lattice, double reach, const Sets&,
                 const Task& task)
{
  const internal::Threads threads;
  const auto elements = internal::make_elements(points, CGAL::parameters::default_values());
  const internal::Scene scene = internal::scan_points(elements, "point");
  const internal::Lattice_basis<Lattice::dimension> basis(lattice);
  const internal::Cell_boundary<Lattice::dimension> boundary(threads, basis, elements, scene, reach,
                                                             true);
  internal::Scene_images<Lattice::dimension> images(basis, boundary, Sets::are_two);
  task(images, threads, elements);
}

// Of points anywhere. With two sets, the first `first_size` points are one.
template <class Points, class Lattice, class Sets = internal::One_set>
Counts counts_of(const Points& points, const Lattice& lattice, double reach,
                 const Sets& sets = Sets())
{
  Counts counts;
  with_images(points, lattice, reach, sets, [&](auto& images, auto& threads, auto& elements) {
    internal::Unwatched_progress progress;
    BOOST_CHECK(images.find(threads, elements, sets, progress));
    counts = {images.near_home_count(), static_cast<std::size_t>(images.count()), 0,
              images.are_moved()};
    images.for_each_batch(elements, [&](const auto& batch, double first, double last) {
      BOOST_CHECK_EQUAL(static_cast<double>(counts.made), first);
      counts.made += batch.size() - counts.homes;
      BOOST_CHECK_EQUAL(static_cast<double>(counts.made), last);
      return true;
    });
  });
  BOOST_CHECK_EQUAL(counts.made, counts.counted);
  return counts;
}

// On multiples of 2^-6 below 1, so that doubles hold them up to 2^46.
std::vector<Coordinates> cell_points()
{
  std::vector<Coordinates> points;
  Random random(1);
  for(int i = 0; i < 500; ++i) {
    points.emplace_back();
    for(int axis = 0; axis < 3; ++axis)
      points.back().push_back(static_cast<double>(random.below(64)) / 64);
  }
  return points;
}

using Vector = Plain::Vector_3;
using Lattice = CGAL::Periodic_lattice_d<Vector>;
const std::array<Vector, 3> vectors_of_layers = {Vector(1, 0, 0), Vector(.3, 1, 0),
                                                   Vector(0, 0, 0)};
const std::vector<Lattice> lattices = {
  Lattice(Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)),
  Lattice(Vector(0, 1, 0), Vector(0, 0, -1), Vector(1, 0, 0)),
  Lattice(Vector(1, 0, 0), Vector(.3, 1, 0), Vector(.7, -.3, 1)),
  Lattice(Vector(40, 1, 0), Vector(39, 1, 0), Vector(0, 7, 1 / 3.)),
  Lattice(vectors_of_layers, {true, true, false})};

BOOST_AUTO_TEST_CASE(there_are_as_many_images_anywhere)
{
  for(const auto& lattice : lattices)
    for(const double reach : {.1, .5, 3.})
      for(const double place : {0x1p10, -0x1p30, 0x1p46}) {
        std::vector<Plain::Point_3> points, far;
        for(const Coordinates& c : cell_points()) {
          points.emplace_back(c[0], c[1], c[2]);
          far.emplace_back(c[0] + place, c[1] - place, c[2] + 3 * place / 4);
        }
        BOOST_CHECK_EQUAL(counts_of(far, lattice, reach), counts_of(points, lattice, reach));
        const internal::Two_sets sets{100};
        BOOST_CHECK_EQUAL(counts_of(far, lattice, reach, sets),
                          counts_of(points, lattice, reach, sets));
      }
}

// In a cell, or across the boundary of one.
BOOST_AUTO_TEST_CASE(points_that_fit_into_a_cell_are_their_own_homes)
{
  const CGAL::Periodic_lattice_d lattice(Plain::Vector_3(1, 0, 0), Plain::Vector_3(.5, 1, 0),
                                         Plain::Vector_3(0, .5, 1));
  for(const double place : {0., .75, 1000.25}) {
    std::vector<Plain::Point_3> points;
    for(const Coordinates& c : cell_points())
      points.emplace_back(place + c[0] + .5 * c[1], c[1] + .5 * c[2], c[2] - place);
    BOOST_CHECK(!counts_of(points, lattice, .1).are_moved);
    points.emplace_back(points.front() + Plain::Vector_3(3, 0, 0));
    BOOST_CHECK(counts_of(points, lattice, .1).are_moved);
  }
}

// Far from where the points would come again.
BOOST_AUTO_TEST_CASE(points_in_a_part_of_a_cell_need_no_image)
{
  const CGAL::Periodic_lattice_d lattice(Plain::Vector_2(1, 0), Plain::Vector_2(.25, 1));
  const std::vector<Plain::Point_2> points = {{7.1, .1}, {7.2, .3}, {7.3, .2}, {7.4, .1}};
  BOOST_CHECK_EQUAL(counts_of(points, lattice, .25, internal::Two_sets{2}).counted, 0u);
}

// One corner is moved to the right, up, and both, to where two points are near the boundary.
BOOST_AUTO_TEST_CASE(a_box_has_the_images_that_are_near_it)
{
  const CGAL::Periodic_lattice_d lattice(Plain::Vector_2(1, 0), Plain::Vector_2(0, 1));
  const std::vector<Plain::Point_2> points = {{.1, .1}, {.5, .5}, {.9, .5}, {.9, .9}};
  const Counts counts = counts_of(points, lattice, .25);
  BOOST_CHECK_EQUAL(counts.counted, 3u);
  BOOST_CHECK_EQUAL(counts.homes, 2u);
}

// The progress of a search that is cancelled when it is told for the first time.
struct Cancelled_at_once
{
  int tells = 0;
  bool advance(std::size_t)
  {
    ++tells;
    return false;
  }
  bool is_cancelled() const { return tells > 0; }
};

BOOST_AUTO_TEST_CASE(no_point_is_read_after_the_search_is_cancelled)
{
  const std::vector<Plain::Point_2> points(10000, Plain::Point_2(.5, .5));
  const CGAL::Periodic_lattice_d lattice(Plain::Vector_2(1, 0), Plain::Vector_2(0, 1));
  const internal::One_set sets;
  with_images(points, lattice, .25, sets, [&](auto& images, auto& threads, auto& elements) {
    Cancelled_at_once progress;
    BOOST_CHECK(!images.find(threads, elements, sets, progress));
    BOOST_CHECK_EQUAL(progress.tells, 1);
  });
}

BOOST_AUTO_TEST_SUITE_END()
