// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The doubles around moved coordinates, against rational numbers.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

BOOST_AUTO_TEST_SUITE(Periods)

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Moves = internal::Periods<2, internal::Exact_number_t<double>>;

// The numbers enclose the exact sum, and are equal if it is a double.
void check_bounds(const std::pair<double, double>& bounds, const Rational& exact)
{
  BOOST_CHECK(Rational(bounds.first) <= exact);
  BOOST_CHECK(exact <= Rational(bounds.second));
  if(Rational(static_cast<double>(exact)) == exact)
    BOOST_CHECK_EQUAL(bounds.first, bounds.second);
  else
    BOOST_CHECK_LT(bounds.first, bounds.second);
}

BOOST_AUTO_TEST_CASE(doubles_enclose_moved_coordinates_in_every_rounding_mode)
{
  Random random(1);
  const auto draw = [&] { // a number of few bits, or of many
    const double x = random.uniform() - 0.5;
    return std::ldexp(random.below(2) == 0 ? std::floor(x * 16) : x,
                      static_cast<int>(random.below(60)) - 30);
  };
  for(const int mode : rounding_modes)
    for(int i = 0; i < 300; ++i) {
      const Kernel::Vector_2 v(draw(), draw()), w(draw(), draw());
      const Kernel::Point_2 p(draw(), draw());
      const Moves periods(CGAL::Periodic_lattice_d(v, w));
      for(const internal::Offset<2>& offset :
          {internal::Offset<2>{0, 0}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {3, 0}, {-3, 5}})
        for(int axis = 0; axis < 2; ++axis) {
          const Rational exact = Rational(p[axis]) + offset[0] * Rational(v[axis])
                                 + offset[1] * Rational(w[axis]);
          std::optional<Rounding_mode> in_mode(mode);
          const auto bounds = periods.moved_bounds(p, offset, axis);
          in_mode.reset();
          check_bounds(bounds, exact);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
