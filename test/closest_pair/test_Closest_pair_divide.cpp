// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the divide and conquer: comparisons, and the candidates of a point of a strip.

#include "support/check_closest_pair.h"
#include "support/plain_points.h"

BOOST_AUTO_TEST_SUITE(Closest_pair_divide)

using namespace test_support;

struct Work_of_division
{
  std::size_t comparisons = 0;         // of coordinates and of distances
  std::size_t max_candidates = 0;      // of a point in a strip
  std::map<std::size_t, std::size_t> candidates; // by point, in the strip that is scanned
};

template <class Elements>
class Counting_minimum : public internal::Pair_minimum<Elements>
{
  using Base = internal::Pair_minimum<Elements>;

public:
  Counting_minimum(const Elements& points, const internal::Scene& scene,
                   Work_of_division& work)
    : Base(points, scene), work_(work)
  {}

  bool less(std::size_t i, std::size_t j, int axis) const
  {
    ++work_.comparisons;
    return Base::less(i, j, axis);
  }

  // A new strip begins when points are compared along axis 0.
  bool is_beyond(std::size_t i, std::size_t j, int axis) const
  {
    ++work_.comparisons;
    if(axis == 0)
      work_.candidates.clear();
    return Base::is_beyond(i, j, axis);
  }

  // The first point is the one that others are candidates of.
  void offer(std::size_t i, std::size_t j)
  {
    ++work_.comparisons;
    work_.max_candidates = (std::max)(work_.max_candidates, ++work_.candidates[i]);
    Base::offer(i, j);
  }

private:
  Work_of_division& work_;
};

template <class Elements>
Work_of_division work_of(const Elements& elements, int dimension)
{
  Work_of_division work;
  Counting_minimum<Elements> minimum(elements, scene_of(elements), work);
  internal::Unwatched_progress progress;
  internal::divide_and_conquer(elements.size(), dimension, internal::Threads(), minimum, progress);
  return work;
}

template <int Dimension>
void check_work(const std::string& name, const Points& scene, double max_comparisons)
{
  const auto points = make_points<Epick_points<Dimension>>(scene);
  const Work_of_division work
    = work_of(Elements_of<typename Epick_points<Dimension>::Point>(points), Dimension);
  const double n = static_cast<double>(points.size());
  const double comparisons = static_cast<double>(work.comparisons) / (n * std::log2(n));
  BOOST_TEST_MESSAGE(name << ' ' << Dimension << "D: " << comparisons
                          << " comparisons per n log n, " << work.max_candidates
                          << " candidates of a point at most");
  BOOST_CHECK_MESSAGE(comparisons <= max_comparisons, name << ": " << comparisons);
  BOOST_CHECK_MESSAGE(work.max_candidates <= internal::max_candidate_count(Dimension),
                      name << ": " << work.max_candidates << " candidates");
  BOOST_CHECK_GT(work.max_candidates, 0u);
}

// All points close to the dividing line at each division: distances along axis 0 vanish against
// those along the others.
Points flattened(Points points)
{
  for(Coordinates& c : points)
    c[0] *= 1. / 1048576;
  return points;
}

BOOST_AUTO_TEST_CASE(division_makes_n_log_n_comparisons_in_the_plane)
{
  BOOST_CHECK_EQUAL(internal::max_candidate_count(2), 7u);
  const Points lattice = lattice_points(2, 150, 1);
  check_work<2>("uniform", uniform_points(2, 20000, 0, 1, 9), 8);
  check_work<2>("lattice", lattice, 12);
  check_work<2>("shuffled lattice", shuffled(lattice, 10), 12);
  check_work<2>("flat uniform", flattened(uniform_points(2, 20000, 0, 1, 11)), 12);
  check_work<2>("line across the cuts", axis_points(2, 20000, 0, 0, 1), 12);
  check_work<2>("line along the cuts", axis_points(2, 20000, 1, 0, 1), 12);
  check_work<2>("clusters", clustered_points(2, 20000, 10, 1. / 4096, 12), 12);
}

BOOST_AUTO_TEST_CASE(division_makes_n_log_n_comparisons_in_space)
{
  BOOST_CHECK_EQUAL(internal::max_candidate_count(3), 47u);
  const Points lattice = lattice_points(3, 28, 1);
  check_work<3>("uniform", uniform_points(3, 20000, 0, 1, 13), 12);
  check_work<3>("lattice", lattice, 30);
  check_work<3>("shuffled lattice", shuffled(lattice, 14), 30);
  check_work<3>("flat lattice", flattened(lattice_points(3, 28, 1)), 60);
  check_work<3>("plane", embedded(lattice_points(2, 150, 1), 3), 20);
  Points wall; // the plane x = 0: every point is in every strip
  for(const Coordinates& c : lattice_points(2, 150, 1))
    wall.push_back({0, c[0], c[1]});
  check_work<3>("wall", wall, 30);
  for(int axis = 0; axis < 3; ++axis)
    check_work<3>("line", axis_points(3, 20000, axis, 0, 1), 20);
}

// All points are in each strip, and the same along the axis of the scan.
BOOST_AUTO_TEST_CASE(flat_points_in_dimension_5_take_the_work_of_uniform_points)
{
  for(const std::size_t n : {2000, 8000}) {
    const Points uniform = uniform_points(5, n, 0, 1, 15);
    Points flat = uniform;
    for(Coordinates& c : flat)
      c.front() = c.back() = 0;
    const auto comparisons = [](const Points& points) {
      return static_cast<double>(work_of(plain_points(points), 5).comparisons);
    };
    const double factor = comparisons(flat) / comparisons(uniform);
    BOOST_TEST_MESSAGE("flat points in dimension 5, " << n << " points: " << factor);
    BOOST_CHECK_LE(factor, 8);
  }
}

// All points are close to each cut, so half of the closest pairs are found in the strip of the
// first one. In half of those in two cells, the upper point is in the first cell.
BOOST_AUTO_TEST_CASE(closest_pairs_between_cells_of_a_plate_are_found)
{
  for(std::uint64_t seed = 0; seed < 40; ++seed) {
    Points plate = uniform_points(3, 300, 0, 1, seed);
    for(Coordinates& c : plate)
      c[0] *= 1e-6;
    const Pair expected = closest_of_doubles(plate).pair;
    BOOST_CHECK(closest_by_division(make_points<Epick_points<3>>(plate)) == expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
