// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the laboratory must find about objects of all sizes: no wrong pair in our columns, and some
// in those of others.

#include <boost/test/unit_test.hpp>

#include "families_of_sizes.h"
#include "object_columns.h"
#include "wrong_pairs.h"

namespace {

using test_support::Pairs_difference;

std::vector<lab::Family> families() { return lab::families_of_sizes(500, 60); }

Pairs_difference wrong_pairs_of(const lab::Object_column& column, const lab::Family& family)
{
  const lab::Outcome outcome = lab::find_in_child<lab::Object_scene>(column, family.scene, 60);
  BOOST_TEST(outcome.status == "ok");
  return wrong_pairs(outcome, lab::true_pairs(family.scene));
}

// Of the methods of a name in all families.
std::size_t count_wrong_pairs(const std::string& name)
{
  std::size_t count = 0;
  for(const lab::Family& family : families())
    for(const lab::Object_column& column : lab::object_columns(family.scene.shape))
      if(column.name == name) {
        const Pairs_difference wrong = wrong_pairs_of(column, family);
        count += wrong.missing.size() + wrong.extra.size();
      }
  return count;
}

} // namespace

BOOST_AUTO_TEST_CASE(our_columns_are_zero_on_objects_of_all_sizes)
{
  for(const lab::Family& family : families())
    for(const lab::Object_column& column : lab::object_columns(family.scene.shape))
      if(column.group == "ours") {
        const Pairs_difference wrong = wrong_pairs_of(column, family);
        BOOST_TEST(wrong.empty(), column.name << " on " << family.shape << ", " << family.name
                                              << ": " << wrong);
      }
}

BOOST_AUTO_TEST_CASE(boxes_rounded_outwards_before_an_exact_test_are_zero)
{
  BOOST_TEST(count_wrong_pairs("boxes, cutoff 10") == 0u);
  BOOST_TEST(count_wrong_pairs("boxes, cutoff 1000") == 0u);
}

BOOST_AUTO_TEST_CASE(half_open_and_rounded_methods_are_wrong)
{
  BOOST_TEST(count_wrong_pairs("boxes, half-open") > 0u);
  BOOST_TEST(count_wrong_pairs("boxes of floats") > 0u);
  BOOST_TEST(count_wrong_pairs("boxes, test in double") > 0u);
}
