// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the laboratory must find about segments, triangles and tetrahedra: no wrong answer in our
// columns, and some in those of plain doubles. The same with radii, open, as solids, and for points
// that move.

#include <boost/test/unit_test.hpp>

#include "predicate_columns.h"
#include "thick_families.h"
#include "track_families.h"

#include <vector>

namespace {

const std::vector<lab::Object_questions>& all_questions()
{
  static const std::vector<lab::Object_questions> all = [] {
    std::vector<lab::Object_questions> result;
    for(const lab::Kind& kind : lab::kinds())
      for(const lab::Object_set& set : lab::object_families(kind))
        result.push_back(lab::questions_about(set));
    return result;
  }();
  return all;
}

// Columns of others are in the list as well.
void check_our_answers(const lab::Object_questions& questions,
                       const lab::Predicate_columns& columns)
{
  BOOST_TEST(!questions.pairs.empty());
  for(const lab::Predicate_column& column : columns) {
    if(column.group != "ours" || !column.knows(questions.objects.kind))
      continue;
    const auto result = lab::ask_in_child(column, questions, 0);
    BOOST_TEST(result.status == "ok");
    BOOST_TEST((result.is_ok() && result.values[0].count() == 0u),
               column.name << " on " << questions.objects.kind.name << ", "
                           << questions.objects.family);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(our_answers_are_right_in_all_families_of_objects)
{
  for(const lab::Object_questions& questions : all_questions())
    check_our_answers(questions, lab::package_predicates());
}

BOOST_AUTO_TEST_CASE(our_answers_are_right_in_all_families_of_thick_objects)
{
  std::size_t wrong = 0;
  for(const lab::Kind& kind : lab::thick_kinds())
    for(const lab::Object_set& set : lab::thick_families(kind)) {
      const lab::Object_questions questions = lab::questions_about(set);
      check_our_answers(questions, lab::thick_predicates());
      if(kind.meaning == lab::Meaning::THICK)
        wrong += lab::ask_in_child(lab::thick_predicates()[0], questions, 0).values[0].count();
    }
  BOOST_TEST(wrong > 0u); // by rounded distances
}

BOOST_AUTO_TEST_CASE(our_answers_are_right_in_all_families_of_points_that_move)
{
  std::size_t wrong = 0;
  for(const lab::Kind& kind : lab::moving_kinds())
    for(const lab::Object_set& set : lab::track_families(kind)) {
      const lab::Object_questions questions = lab::questions_about(set);
      check_our_answers(questions, lab::track_predicates());
      wrong += lab::ask_in_child(lab::track_predicates()[0], questions, 0).values[0].count();
    }
  BOOST_TEST(wrong > 0u); // by doubles
}

BOOST_AUTO_TEST_CASE(plain_doubles_are_wrong_where_objects_touch)
{
  std::size_t wrong = 0;
  for(const lab::Object_questions& questions : all_questions()) {
    const auto result = lab::ask_in_child(lab::plain_predicates()[0], questions, 0);
    wrong += result.is_ok() ? result.values[0].count() : 0;
  }
  BOOST_TEST(wrong > 0u);
}
