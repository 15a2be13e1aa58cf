// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles and tetrahedra of random vertices, degenerate or not, against the oracle.

#include "support/hull_oracle.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <functional>

BOOST_AUTO_TEST_SUITE(simplices)

using namespace test_support;

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

  // The answer of the package. `Orientation` is Staged_orientation or Kernel_orientation.
  template <class Orientation>
  bool answer() const
  {
    typename Orientation::template Vertices<A + B> vertices;
    for(std::size_t k = 0; k < A + B; ++k)
      set(vertices[k], doubles_[k]);
    internal::Simplex<Orientation, A> a;
    internal::Simplex<Orientation, B> b;
    for(std::size_t k = 0; k < A + B; ++k)
      (k < A ? a[k % A] : b[(k - A) % B]) = typename Orientation::Point(vertices[k]);
    Orientation orientation(vertices);
    if constexpr(Dimension == 2)
      return internal::do_intersect_in_plane(orientation, a, b);
    else
      return internal::do_intersect_in_space(orientation, a, b);
  }

private:
  using Doubles = std::array<double, Dimension>;

  template <class Vertex>
  static void set(Vertex& vertex, const Doubles& x)
  {
    if constexpr(Dimension == 2)
      vertex = Vertex(x[0], x[1]);
    else
      vertex = Vertex(x[0], x[1], x[2]);
  }
  static void set(typename internal::Staged_orientation<Dimension>::Vertex& vertex,
                  const Doubles& x)
  {
    vertex.x = x;
  }

  // Whether all vertices are in a hyperplane of the objects of this size.
  static bool is_flat(const Vectors& v)
  {
    const auto from_first = [&](std::size_t k) { return difference(v[k], v[0]); };
    return v.size() == 2   ? is_null(from_first(1))
           : v.size() == 3 ? is_null(cross(from_first(1), from_first(2)))
           : v.size() == 4 ? dot(cross(from_first(1), from_first(2)), from_first(3)) == 0
                           : false;
  }

  Vectors a_, b_;
  std::array<Doubles, A + B> doubles_;
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
  using Doubles = internal::Staged_orientation<Dimension>;
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
      check(source, count_answers<std::int64_t, Doubles, Dimension, A, B>(source, count));
    }
  check(decimals(5),
        count_answers<Long_integer, Doubles, Dimension, A, B>(decimals(5), count / 10));
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
bool is_found_within(const std::array<std::array<double, 3>, Count>& object)
{
  using Orientation = internal::Staged_orientation<3>;
  const std::array<double, 3> corners[] = {{0, 0, 0}, {99, 0, 0}, {0, 99, 0}, {0, 0, 99}};
  Orientation::Vertices<Count + 4> vertices;
  internal::Simplex<Orientation, Count> inner;
  internal::Simplex<Orientation, 4> outer;
  for(std::size_t k = 0; k < Count + 4; ++k) {
    vertices[k].x = k < Count ? object[k] : corners[k - Count];
    (k < Count ? inner[k % Count] : outer[(k + 4 - Count) % 4])
      = Orientation::Point(vertices[k]);
  }
  Orientation orientation(vertices);
  return internal::do_intersect_in_space(orientation, inner, outer);
}

BOOST_AUTO_TEST_CASE(what_is_within_a_tetrahedron_intersects_it)
{
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {21, 20, 20}, {20, 22, 25}}}));
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {20, 20, 20}, {20, 20, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 25}}}));
}

BOOST_AUTO_TEST_SUITE_END()
