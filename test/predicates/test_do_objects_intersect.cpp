// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which arithmetic decides about objects of a kernel, and that it gives the answer for each.

#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>

#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(do_objects_intersect)

using namespace test_support;
using CGAL::Arithmetic_tier;

// Two segments that cross, of which one ends on the other if `do_touch`.
template <class Kernel>
bool do_cross(bool do_touch, const typename Kernel::FT& unit, Arithmetic_tier& tier)
{
  using FT = typename Kernel::FT;
  const auto point = [&](int x, int y) {
    return typename Kernel::Point_2(FT(FT(x) * unit), FT(FT(y) * unit));
  };
  const typename Kernel::Segment_2 a(point(0, 0), point(6, 9));
  const typename Kernel::Segment_2 b(point(do_touch ? 2 : 1, do_touch ? 3 : 4), point(4, 0));
  return internal::do_objects_intersect(a, b, tier);
}

template <class Kernel>
void check_kernel(const typename Kernel::FT& unit, Arithmetic_tier tie_tier)
{
  Arithmetic_tier tier = Arithmetic_tier::INT64;
  BOOST_CHECK(do_cross<Kernel>(true, unit, tier));
  BOOST_CHECK(tier == tie_tier);
  tier = Arithmetic_tier::INT64;
  BOOST_CHECK(do_cross<Kernel>(false, unit, tier));
}

BOOST_AUTO_TEST_CASE(doubles_are_decided_in_stages_whatever_their_type)
{
  check_kernel<CGAL::Simple_cartesian<double>>(1, Arithmetic_tier::INT64);
  check_kernel<CGAL::Simple_cartesian<float>>(1, Arithmetic_tier::INT64);
  check_kernel<Epeck>(1, Arithmetic_tier::INT64);
}

BOOST_AUTO_TEST_CASE(other_numbers_are_decided_exactly)
{
  check_kernel<Epeck>(Epeck::FT(1) / 3, Arithmetic_tier::FILTERED_EXACT);
  check_kernel<CGAL::Simple_cartesian<long long>>((1LL << 58) + 1, Arithmetic_tier::FILTERED_EXACT);
  check_kernel<CGAL::Simple_cartesian<long double>>(0.1L, Arithmetic_tier::FILTERED_EXACT);
  using Homogeneous = CGAL::Homogeneous<CGAL::Exact_integer>;
  check_kernel<Homogeneous>(Homogeneous::FT(1, 3), Arithmetic_tier::FILTERED_EXACT);
}

BOOST_AUTO_TEST_CASE(numbers_that_overflow_are_not_exact)
{
  BOOST_CHECK(internal::has_exact_predicates_v<CGAL::Exact_rational>);
  BOOST_CHECK(internal::has_exact_predicates_v<Epeck::FT>);
  BOOST_CHECK(internal::has_exact_predicates_v<CGAL::Quotient<CGAL::Exact_integer>>);
  BOOST_CHECK(!internal::has_exact_predicates_v<double>);
  BOOST_CHECK(!internal::has_exact_predicates_v<long long>);
  BOOST_CHECK(!internal::has_exact_predicates_v<CGAL::Quotient<long long>>);
  BOOST_CHECK(!internal::has_exact_predicates_v<boost::multiprecision::int128_t>);
}

BOOST_AUTO_TEST_CASE(objects_with_a_common_vertex_need_no_determinant)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const Kernel::Triangle_3 a({0, 0, 0}, {1, 0, 1}, {0, 1, 1}); // in the plane z = x + y, as b
  const Kernel::Triangle_3 b({5, 3, 8}, {1, 0, 1}, {2, 5, 7});
  Arithmetic_tier tier = Arithmetic_tier::INT64;
  BOOST_CHECK(internal::do_objects_intersect(a, b, tier));
  BOOST_CHECK(tier == Arithmetic_tier::DOUBLE);
}

BOOST_AUTO_TEST_CASE(boxes_of_exact_numbers_are_compared)
{
  using Box = Epeck::Iso_cuboid_3;
  const Epeck::FT third = Epeck::FT(1) / 3;
  const auto box = [](const Epeck::FT& low, const Epeck::FT& high) {
    return Box(Epeck::Point_3(low, 0, 0), Epeck::Point_3(high, 1, 1));
  };
  Arithmetic_tier tier = Arithmetic_tier::INT64;
  BOOST_CHECK(internal::do_objects_intersect(box(0, third), box(third, 1), tier));
  BOOST_CHECK(!internal::do_objects_intersect(box(0, third), box(2 * third, 1), tier));
}

BOOST_AUTO_TEST_SUITE_END()
