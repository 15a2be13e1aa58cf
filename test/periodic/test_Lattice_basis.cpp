// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Short vectors of lattices: a search needs few images only if no vector is much longer than the
// distance of its layer from the next one.

#include "support/unit_test.h"

#include <CGAL/Periodic_lattice_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>

BOOST_AUTO_TEST_SUITE(Lattice_basis)

using namespace test_support;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
using Basis = CGAL::Thick_intersection_d::internal::Lattice_basis<3>;

// The vectors in lengths of the distance of layers, which is that of dual vectors from 0.
void check_basis(const Vector_3& u, const Vector_3& v, const Vector_3& w)
{
  const Basis basis(CGAL::Periodic_lattice_d(u, v, w));
  for(int k = 0; k < 3; ++k) {
    const double squares = CGAL::to_double(internal::dot_product(basis.vector(k), basis.vector(k)))
                           * CGAL::to_double(internal::dot_product(basis.dual(k), basis.dual(k)));
    BOOST_CHECK_LE(squares, 2.0001);
    for(int axis = 0; axis < 3; ++axis) {
      const auto steps = basis.steps(k);
      const double sum = static_cast<double>(steps[0]) * u[axis]
                         + static_cast<double>(steps[1]) * v[axis]
                         + static_cast<double>(steps[2]) * w[axis];
      BOOST_CHECK_EQUAL(sum, CGAL::to_double(basis.vector(k)[axis]));
    }
  }
}

// None is shortened by one other vector, and their sum is very short.
BOOST_AUTO_TEST_CASE(three_vectors_nearly_cancel)
{
  for(const double h : {0x1p-3, 0x1p-10, 0x1p-40}) {
    check_basis({1, -1, 0}, {0, 1, -1}, {-1 + h, h, 1 + h});
    check_basis({1, -1, 0}, {0, -1, 1}, {-1 + h, h, 1 + h});
    check_basis({-1, 1, 0}, {0, 1, -1}, {-1 + h, h, 1 + h});
  }
}

BOOST_AUTO_TEST_CASE(random_vectors_become_short)
{
  Random random(1);
  const auto draw = [&] { return static_cast<double>(random.below(41)) - 20; };
  const auto vector = [&] {
    const double x = draw(), y = draw();
    return Vector_3(x, y, draw());
  };
  for(int i = 0; i < 500; ++i) {
    const Vector_3 u = vector(), v = vector(), w = vector();
    if(CGAL::determinant(u, v, w) != 0)
      check_basis(u, v, w);
  }
}

BOOST_AUTO_TEST_SUITE_END()
