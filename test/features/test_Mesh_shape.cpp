// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether faces are closed, as hashes of their edges tell, and as the sorted edges do; and which
// faces are connected.

#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Thick_intersection_d/internal/features/Closed_meshes.h>
#include <CGAL/Thick_intersection_d/internal/features/Mesh_shape.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Mesh_shape)

using namespace test_support;

template <class Point>
using Soup = std::pair<std::vector<Point>, std::vector<std::array<std::size_t, 3>>>;

template <class Kernel>
internal::Mesh_shape shape_of(const Soup<typename Kernel::Point_3>& soup)
{
  const auto face_at = [&](std::size_t i) {
    const auto& [p, q, r] = soup.second[i];
    return typename Kernel::Triangle_3(soup.first[p], soup.first[q], soup.first[r]);
  };
  return internal::Mesh_shape(soup.second.size(), face_at);
}

template <class Kernel>
bool is_closed(const Soup<typename Kernel::Point_3>& soup)
{
  return shape_of<Kernel>(soup).is_closed();
}

// A cube between 0 and `size`. Faces without `size` have a zero of each sign.
Soup<Epick::Point_3> cube(double size)
{
  Soup<Epick::Point_3> cube;
  const auto add_face = [&](const std::array<int, 3>& corners) {
    const double zero = cube.second.size() % 2 == 0 ? 0. : -0.;
    for(const int corner : corners) {
      const auto x = [&](int axis) { return (corner >> axis) % 2 != 0 ? size : zero; };
      cube.first.emplace_back(x(0), x(1), x(2));
    }
    const std::size_t count = cube.first.size();
    cube.second.push_back({count - 3, count - 2, count - 1});
  };
  for(const auto& [a, b, c, d] : {std::array{0, 1, 3, 2}, std::array{4, 5, 7, 6},
                                  std::array{0, 1, 5, 4}, std::array{2, 3, 7, 6},
                                  std::array{0, 2, 6, 4}, std::array{1, 3, 7, 5}}) {
    add_face({a, b, c});
    add_face({c, d, a});
  }
  return cube;
}

// Each set of faces of a cube, which is closed if it has all of them or none.
BOOST_AUTO_TEST_CASE(faces_have_an_odd_edge_if_they_are_not_closed)
{
  for(const double size : {1., 1e-300, .1}) {
    const Soup<Epick::Point_3> whole = cube(size);
    for(unsigned set = 0; set < 1u << 12; ++set) {
      Soup<Epick::Point_3> some = {whole.first, {}};
      for(unsigned face = 0; face < 12; ++face)
        if((set >> face) % 2 != 0)
          some.second.push_back(whole.second[face]);
      const bool is_all_or_none = set == 0 || set == (1u << 12) - 1;
      BOOST_REQUIRE_EQUAL(is_closed<Epick>(some), is_all_or_none);
      BOOST_REQUIRE_EQUAL(internal::has_odd_edge(some, 0), !is_all_or_none);
    }
  }
}

BOOST_AUTO_TEST_CASE(edges_of_length_zero_do_not_count)
{
  Soup<Epick::Point_3> soup = cube(3);
  for(const std::array<std::size_t, 3> face : {std::array<std::size_t, 3>{0, 1, 1},
                                               {5, 2, 5}, {7, 7, 0}, {4, 4, 4}}) {
    soup.second.push_back(face);
    BOOST_CHECK(is_closed<Epick>(soup));
    BOOST_CHECK(!internal::has_odd_edge(soup, 0));
  }
  soup.second.push_back({0, 1, 2});
  BOOST_CHECK(!is_closed<Epick>(soup));
  BOOST_CHECK(internal::has_odd_edge(soup, 0));
}

// The bounds of equal numbers may differ.
BOOST_AUTO_TEST_CASE(numbers_that_are_no_doubles_are_sorted)
{
  using Point = Epeck::Point_3;
  const Epeck::FT third = Epeck::FT(1) / 3, same = 1 - Epeck::FT(2) / 3;
  const Point p(third, 0, 0), q(same, 0, 0), r(0, 1, 0), s(0, 0, 1);
  const Soup<Point> twice = {{p, q, r, s}, {{0, 2, 3}, {1, 2, 3}}};
  BOOST_CHECK(!internal::has_odd_edge(twice, 0));
  BOOST_CHECK(is_closed<Epeck>(twice));
  const Soup<Point> once = {twice.first, {{0, 2, 3}}};
  const Epeck::Segment_3 source(Point(.1, .1, -1), Point(.1, .1, 0)); // below the face
  BOOST_CHECK(!internal::Closed_meshes<Epeck::Triangle_3>(once, 0).is_inside(source));
}

// Their bounds in doubles are equal.
BOOST_AUTO_TEST_CASE(vertices_that_differ_by_less_than_doubles_are_not_equal)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / 3, more = third + 0x1p-200;
  const Soup<Kernel::Point_3> soup
    = {{{third, 0, 0}, {more, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 3}, {1, 2, 3}}};
  const Soup<Kernel::Point_3> twice = {soup.first, {{0, 2, 3}, {0, 2, 3}}};
  BOOST_CHECK(!is_closed<Kernel>(soup));
  BOOST_CHECK(is_closed<Kernel>(twice));
}

BOOST_AUTO_TEST_CASE(any_common_vertex_connects_faces)
{
  Soup<Epick::Point_3> soup = {{}, {{0, 1, 2}, {1, 3, 4}, {9, 8, 7}, {2, 5, 6}}};
  for(int k = 0; k < 10; ++k)
    soup.first.emplace_back(k / 2, k, k * k);
  BOOST_CHECK((shape_of<Epick>(soup).part_numbers() == std::vector<internal::Place>{0, 0, 1, 0}));
}

BOOST_AUTO_TEST_CASE(features_have_an_inside_if_one_of_their_meshes_may_be_closed)
{
  const Soup<Epick::Point_3> closed = cube(1), open = {closed.first, {{0, 1, 2}}};
  const auto may_have_inside = [](const std::vector<Soup<Epick::Point_3>>& feature) {
    return internal::may_have_inside(feature, 0);
  };
  BOOST_CHECK(!may_have_inside({open, open}));
  BOOST_CHECK(may_have_inside({open, closed}));
  BOOST_CHECK(may_have_inside({closed, open}));
}

BOOST_AUTO_TEST_SUITE_END()
