// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles, tetrahedra and iso-boxes of random vertices, degenerate or not, against the
// oracle.

#include "support/lattice_hulls.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/iso_boxes.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(shapes)

using namespace test_support;

template <std::size_t Dimension>
using Doubles = std::array<double, Dimension>;

template <class Vertex>
void set(Vertex& vertex, const Doubles<2>& x)
{
  vertex = Vertex(x[0], x[1]);
}
template <class Vertex>
void set(Vertex& vertex, const Doubles<3>& x)
{
  vertex = Vertex(x[0], x[1], x[2]);
}
void set(internal::Staged_orientation<2>::Vertex& vertex, const Doubles<2>& x) { vertex.x = x; }
void set(internal::Staged_orientation<3>::Vertex& vertex, const Doubles<3>& x) { vertex.x = x; }

// Calls predicate(orientation, a, b) with A points and the B points behind them. `Orientation` is
// Staged_orientation or Kernel_orientation.
template <class Orientation, std::size_t A, std::size_t B, class Predicate>
bool ask(const std::array<Doubles<Orientation::dimension>, A + B>& points,
         const Predicate& predicate)
{
  typename Orientation::template Vertices<A + B> vertices;
  for(std::size_t k = 0; k < A + B; ++k)
    set(vertices[k], points[k]);
  internal::Simplex<Orientation, A> a;
  internal::Simplex<Orientation, B> b;
  for(std::size_t k = 0; k < A + B; ++k)
    (k < A ? a[k % A] : b[(k - A) % B]) = typename Orientation::Point(vertices[k]);
  Orientation orientation(vertices);
  return predicate(orientation, a, b);
}

// The predicate of points, segments, triangles and tetrahedra.
constexpr auto do_simplices_intersect = [](auto& orientation, const auto& a, const auto& b) {
  if constexpr(std::decay_t<decltype(orientation)>::dimension == 2)
    return internal::do_intersect_in_plane(orientation, a, b);
  else
    return internal::do_intersect_in_space(orientation, a, b);
};

// ---- simplices ----------------------------------------------------------------------------------

// Where vertices are: integers, along each axis in units of a power of two of its own. They are
// doubles without rounding.
struct Vertex_source
{
  std::string name;
  std::function<std::int64_t(Random&)> draw;
  std::array<int, 3> exponents = {};
};

// Integers below `range`.
Vertex_source small_integers(std::size_t range, std::array<int, 3> exponents = {})
{
  return {"integers below " + std::to_string(range),
          [=](Random& random) { return static_cast<std::int64_t>(random.below(range)); },
          exponents};
}

// Multiples of .1, rounded to doubles, and some of them moved by a last bit. The unit is 2^-58.
Vertex_source decimals(std::size_t range)
{
  return {"decimals",
          [=](Random& random) {
            const double x = 0.1 * static_cast<double>(random.below(range));
            const double moved = random.below(8) == 0 ? std::nextafter(x, random.below(2)) : x;
            return static_cast<std::int64_t>(std::ldexp(moved < 0x1p-5 ? x : moved, 58));
          },
          {-58, -58, -58}};
}

// What was asked about.
struct Simplex_counts
{
  std::size_t wrong = 0, intersecting = 0, degenerate = 0;
};

// The vertices of a point (1), segment (2), triangle (3) or tetrahedron (4) each.
template <class Integer, int Dimension, std::size_t A, std::size_t B>
class Simplex_question
{
  using Vectors = Hull_vectors<Integer>;

public:
  Simplex_question(Random& random, const Vertex_source& source)
  {
    for(std::size_t k = 0; k < A + B; ++k) {
      Hull_vector<Integer> v = {};
      for(std::size_t axis = 0; axis < Dimension; ++axis) {
        const std::int64_t x = source.draw(random);
        v[axis] = Integer(x);
        doubles_[k][axis] = std::ldexp(static_cast<double>(x), source.exponents[axis]);
      }
      (k < A ? a_ : b_).push_back(v);
    }
  }

  bool truth() const { return do_hulls_intersect(a_, b_); }
  bool is_degenerate() const { return is_flat(a_) || is_flat(b_); }

  // The answer of the package.
  template <class Orientation>
  bool answer() const
  {
    return ask<Orientation, A, B>(doubles_, do_simplices_intersect);
  }

private:
  Vectors a_, b_;
  std::array<Doubles<Dimension>, A + B> doubles_;
};

template <class Integer, class Orientation, int Dimension, std::size_t A, std::size_t B>
Simplex_counts count_answers(const Vertex_source& source, std::size_t count)
{
  Random random(static_cast<unsigned int>(count));
  Simplex_counts counts;
  for(std::size_t i = 0; i < count; ++i) {
    const Simplex_question<Integer, Dimension, A, B> question(random, source);
    const bool truth = question.truth();
    counts.wrong += truth != question.template answer<Orientation>();
    counts.intersecting += truth;
    counts.degenerate += question.is_degenerate();
  }
  return counts;
}

// Checks `count` questions of small integers at several scales, and fewer with decimals and with
// rational numbers. A share of all questions is about degenerate objects, and of small integers
// many intersect.
template <int Dimension, std::size_t A, std::size_t B>
void check_simplices(std::size_t count)
{
  using Stages = internal::Staged_orientation<Dimension>;
  using Rationals
    = internal::Kernel_orientation<CGAL::Simple_cartesian<CGAL::Exact_rational>, Dimension>;
  using Long_integer = boost::multiprecision::int512_t;
  const auto check = [&](const Vertex_source& source, const Simplex_counts& counts) {
    BOOST_CHECK_MESSAGE(counts.wrong == 0, A << " and " << B << " vertices, " << source.name << ": "
                                             << counts.wrong << " wrong");
    BOOST_CHECK_GT(counts.degenerate, 0u);
    BOOST_CHECK_GT(counts.intersecting, 0u);
  };
  const std::array<int, 3> exponents[]
    = {{0, 0, 0}, {-1074, -1074, -1074}, {1019, 1019, 1019}, {-1074, 900, 0}, {-500, 3, -330}};
  for(const std::size_t range : {2, 3, 4})
    for(const std::array<int, 3>& e : exponents) {
      const Vertex_source source = small_integers(range, e);
      check(source, count_answers<std::int64_t, Stages, Dimension, A, B>(source, count));
    }
  check(decimals(5),
        count_answers<Long_integer, Stages, Dimension, A, B>(decimals(5), count / 10));
  const Vertex_source source = small_integers(3);
  check(source, count_answers<std::int64_t, Rationals, Dimension, A, B>(source, count / 50));
}

BOOST_AUTO_TEST_CASE(segments_in_the_plane) { check_simplices<2, 2, 2>(60000); }
BOOST_AUTO_TEST_CASE(segment_and_triangle_in_the_plane) { check_simplices<2, 2, 3>(60000); }
BOOST_AUTO_TEST_CASE(triangles_in_the_plane) { check_simplices<2, 3, 3>(60000); }
BOOST_AUTO_TEST_CASE(segments_in_space) { check_simplices<3, 2, 2>(60000); }
BOOST_AUTO_TEST_CASE(segment_and_triangle_in_space) { check_simplices<3, 2, 3>(60000); }
BOOST_AUTO_TEST_CASE(triangles_in_space) { check_simplices<3, 3, 3>(60000); }
BOOST_AUTO_TEST_CASE(triangle_and_tetrahedron) { check_simplices<3, 3, 4>(20000); }
BOOST_AUTO_TEST_CASE(tetrahedra) { check_simplices<3, 4, 4>(20000); }

// Objects within a tetrahedron meet no face of it.
template <std::size_t Count>
bool is_found_within(const std::array<Doubles<3>, Count>& object)
{
  std::array<Doubles<3>, Count + 4> points = {};
  std::copy(object.begin(), object.end(), points.begin());
  for(std::size_t axis = 0; axis < 3; ++axis)
    points[Count + axis][axis] = 99; // and the origin
  return ask<internal::Staged_orientation<3>, Count, 4>(points, do_simplices_intersect);
}

BOOST_AUTO_TEST_CASE(what_is_within_a_tetrahedron_intersects_it)
{
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {21, 20, 20}, {20, 22, 25}}}));
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {20, 20, 20}, {20, 20, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 25}}}));
}

// ---- iso-boxes ----------------------------------------------------------------------------------

// All corners of a box, or the lower one and the upper one.
template <int Dimension>
Integers box(Random& random, std::size_t side, bool has_all_corners)
{
  const Lattice lattice = {Dimension, side};
  const auto p = lattice_point(random, lattice), q = lattice_point(random, lattice);
  const auto corner = [&](std::size_t bits) {
    Hull_vector<std::int64_t> x = {};
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      const auto [low, high] = std::minmax(p[axis], q[axis]);
      x[axis] = (bits >> axis & 1) == 0 ? low : high;
    }
    return x;
  };
  const std::size_t last = (std::size_t(1) << Dimension) - 1;
  if(!has_all_corners)
    return {corner(0), corner(last)};
  Integers corners;
  for(std::size_t bits = 0; bits <= last; ++bits)
    corners.push_back(corner(bits));
  return corners;
}

// Asks about vertices in units of 2^exponent.
template <int Dimension, std::size_t A, std::size_t B, class Predicate>
bool ask_about(const Integers& a, const Integers& b, int exponent, const Predicate& predicate)
{
  std::array<Doubles<Dimension>, A + B> points;
  for(std::size_t k = 0; k < A + B; ++k)
    points[k] = as_doubles<Dimension>(k < A ? a[k] : b[k - A], std::ldexp(1., exponent));
  return ask<internal::Staged_orientation<Dimension>, A, B>(points, predicate);
}

// Objects of vertices on a lattice. Most are near a side of the box.
template <int Dimension, std::size_t Count>
void check_objects()
{
  constexpr std::size_t corner_count = std::size_t(1) << Dimension;
  const auto predicate = [](auto& orientation, const auto& object, const auto& corners) {
    return internal::does_meet_iso_box(orientation, object, corners);
  };
  Random random(Count);
  std::size_t wrong = 0, intersecting = 0, asked = 0;
  for(const std::size_t side : {2, 3, 5, 9, 14})
    for(int i = 0; i < 4000; ++i) {
      const Integers object = lattice_hull(random, {Dimension, side}, Count);
      const Integers corners = box<Dimension>(random, side, true);
      const bool truth = do_hulls_intersect(object, corners);
      const int exponent = random.below(2) == 0 ? 0 : -1074;
      wrong += ask_about<Dimension, Count, corner_count>(object, corners, exponent, predicate)
               != truth;
      intersecting += truth;
      ++asked;
    }
  BOOST_TEST_CONTEXT(Count << " vertices and a box in dimension " << Dimension)
  {
    BOOST_CHECK_EQUAL(wrong, 0u);
    BOOST_CHECK_GT(intersecting, 1000u);
    BOOST_CHECK_GT(asked - intersecting, 1000u);
  }
}

BOOST_AUTO_TEST_CASE(objects_and_an_iso_box_of_the_plane)
{
  check_objects<2, 2>();
  check_objects<2, 3>();
}

BOOST_AUTO_TEST_CASE(objects_and_an_iso_box_of_space)
{
  check_objects<3, 2>();
  check_objects<3, 3>();
  check_objects<3, 4>();
}

template <int Dimension>
void check_two_boxes()
{
  const auto predicate = [](auto& orientation, const auto& a, const auto& b) {
    return internal::do_iso_boxes_intersect<std::decay_t<decltype(orientation)>>(a, b);
  };
  Random random(Dimension);
  for(int i = 0; i < 3000; ++i) {
    const Integers a = box<Dimension>(random, 5, false), b = box<Dimension>(random, 5, false);
    bool truth = true;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      truth = truth && a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis];
    BOOST_CHECK_EQUAL((ask_about<Dimension, 2, 2>(a, b, 0, predicate)), truth);
  }
}

BOOST_AUTO_TEST_CASE(two_iso_boxes)
{
  check_two_boxes<2>();
  check_two_boxes<3>();
}

BOOST_AUTO_TEST_SUITE_END()
