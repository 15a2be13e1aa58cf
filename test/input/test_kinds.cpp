// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What an object is, if it may be of several kinds: a variant, or one of two ranges.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/kinds.h>

#include <CGAL/Simple_cartesian.h>

BOOST_AUTO_TEST_SUITE(kinds)

using namespace test_support;

using Word_or_number = std::variant<std::string, double>;
using One = internal::One_of_two<const Word_or_number&, int>;

// Names the kinds that a test gets, in its order.
struct Names
{
  static std::string name(const std::string&) { return "word"; }
  static std::string name(double) { return "number"; }
  static std::string name(int) { return "integer"; }
  template <class A, class B>
  bool operator()(const A& a, const B& b) const
  {
    text = name(a) + " " + name(b);
    return true;
  }
  mutable std::string text;
};

BOOST_AUTO_TEST_CASE(objects_of_the_first_range_come_first)
{
  const Word_or_number word = "a", number = .5;
  const One first(std::in_place_index<0>, word), second(std::in_place_index<1>, 7);
  const One other(std::in_place_index<0>, number);
  Names names;
  BOOST_CHECK(internal::with_kinds(first, second, names));
  BOOST_CHECK_EQUAL(names.text, "word integer");
  BOOST_CHECK(internal::with_kinds(second, other, names));
  BOOST_CHECK_EQUAL(names.text, "number integer");
  BOOST_CHECK(internal::with_kinds(number, word, names));
  BOOST_CHECK_EQUAL(names.text, "number word");
}

BOOST_AUTO_TEST_CASE(objects_are_referred_to_or_held)
{
  const Word_or_number word = "a";
  const One first(std::in_place_index<0>, word), second(std::in_place_index<1>, 7);
  BOOST_CHECK(first.is_first() && !second.is_first());
  BOOST_CHECK_EQUAL(&first.first(), &word);
  BOOST_CHECK_EQUAL(second.second(), 7);
  BOOST_CHECK(internal::with_kind(first, [](const auto& kind) { return Names::name(kind); })
              == "word");
  BOOST_CHECK(internal::with_kind(second, [](const auto& kind) { return Names::name(kind); })
              == "integer");
}

template <class Kind>
struct Is_word : std::is_same<Kind, std::string> {};

BOOST_AUTO_TEST_CASE(kinds_of_variants_of_variants)
{
  using Object = internal::One_of_two<const std::variant<Word_or_number, char>&, std::string>;
  BOOST_CHECK((std::is_same_v<internal::Kinds_of<Object>::type,
                              std::tuple<std::string, double, char, std::string>>));
  BOOST_CHECK(internal::Kinds<Object>::is_any<Is_word>);
  BOOST_CHECK(!internal::Kinds<Object>::are_all<Is_word>);
  BOOST_CHECK(internal::Kinds<std::string>::are_all<Is_word>);
  BOOST_CHECK(!internal::Kinds<double>::is_any<Is_word>);
}

BOOST_AUTO_TEST_CASE(a_pair_of_an_object_and_a_number_is_thickened)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  BOOST_CHECK((internal::Is_thickened<std::pair<Kernel::Point_2, double>>::value));
  BOOST_CHECK((internal::Is_thickened<std::pair<Kernel::Tetrahedron_3, float>>::value));
  BOOST_CHECK((internal::Is_thickened<std::pair<CGAL::Bbox_2, double>>::value));
  BOOST_CHECK((!internal::Is_thickened<std::pair<Kernel::Segment_2, int>>::value)); // an index
  BOOST_CHECK((!internal::Is_thickened<std::pair<Kernel::Circle_2, double>>::value));
  BOOST_CHECK((!internal::Is_thickened<std::pair<std::string, double>>::value));
  BOOST_CHECK(!internal::Is_thickened<Kernel::Point_2>::value);
}

BOOST_AUTO_TEST_SUITE_END()
