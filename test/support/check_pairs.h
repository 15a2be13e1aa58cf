// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Checks the pairs of a search, of one set and of two, and what it refuses.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_PAIRS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_PAIRS_H

#include "pairs.h"
#include "unit_test.h"

namespace test_support {

// Tells what is missing and what is too much.
template <class What>
void check_pairs(const What& what, const Pairs& expected, const Pairs& found)
{
  const Pairs_difference difference = compare(expected, found);
  BOOST_CHECK_MESSAGE(difference.empty(), what << ": " << difference);
}

// The same of objects as one set and as two, of which the first has `first_size` of them. The pairs
// of two sets are found as positions in each.
template <class What>
void check_pairs(const What& what, const Pairs& expected, const Pairs& of_one, const Pairs& of_two,
                 std::size_t first_size)
{
  BOOST_TEST_CONTEXT(what)
  {
    check_pairs("one set", expected, of_one);
    check_pairs("two sets", of_two_sets(expected, first_size), of_two);
  }
}

// The text of the exception that f throws; "" if it throws none.
template <class Exception = std::invalid_argument, class Function>
std::string refusal(const Function& f)
{
  try {
    f();
  }
  catch(const Exception& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_PAIRS_H
