// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs written to an output iterator, up to a number of pairs.

#include <CGAL/Thick_intersection_d/internal/meshes/Limited_output.h>

#include <boost/test/unit_test.hpp>

#include <iterator>
#include <utility>
#include <vector>

namespace internal = CGAL::Thick_intersection_d::internal;

BOOST_AUTO_TEST_SUITE(limited_output)

namespace {

using Letters = std::vector<std::pair<char, char>>;

} // namespace

BOOST_AUTO_TEST_CASE(writes_as_many_pairs_as_there_is_room_for)
{
  Letters letters;
  internal::Limited_output output(std::back_inserter(letters), 2);
  BOOST_CHECK(!output.is_full());
  BOOST_CHECK(output.write('a', 'b'));
  BOOST_CHECK(!output.is_full());
  BOOST_CHECK(!output.write('b', 'c'));
  BOOST_CHECK(output.is_full());
  BOOST_CHECK(!output.write('c', 'd'));
  BOOST_CHECK(letters == Letters({{'a', 'b'}, {'b', 'c'}}));
}

BOOST_AUTO_TEST_CASE(room_for_no_pair_is_full)
{
  Letters letters;
  internal::Limited_output output(std::back_inserter(letters), 0);
  BOOST_CHECK(output.is_full());
  BOOST_CHECK(!output.write('a', 'b'));
  BOOST_CHECK(letters.empty());
}

BOOST_AUTO_TEST_CASE(gives_the_iterator_behind_the_last_pair)
{
  Letters letters(3);
  internal::Limited_output output(letters.begin(), 3);
  output.write('a', 'b');
  output.write('a', 'c');
  BOOST_CHECK(output.iterator() == letters.begin() + 2);
}

BOOST_AUTO_TEST_SUITE_END()
