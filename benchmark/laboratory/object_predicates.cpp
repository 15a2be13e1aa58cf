// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// All families of segments, triangles and tetrahedra by all predicates: wrong answers about the
// pairs whose boxes meet, and the time of one answer. And which arithmetic decides these pairs, and
// which one would be enough for all determinants of the scene. The same of objects with radii, of
// open objects, of solids and of points that move, but for the arithmetic.
//
//   object_predicates <folder for object_families.csv, object_stages.csv, thick_families.csv and
//                      track_families.csv> <milliseconds per measurement>

#include "predicate_columns.h"
#include "thick_families.h"
#include "track_families.h"

#include "measuring/Csv_file.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/thick_intersection_d.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace {

using namespace lab;

Predicate_columns all_predicates()
{
  Predicate_columns all;
  for(const auto& make :
      {plain_predicates, library_predicates, cgal_predicates, package_predicates, thick_rivals,
       thick_predicates, track_predicates})
    for(Predicate_column& column : make())
      all.push_back(std::move(column));
  return all;
}

using Results = std::vector<Child_result<Wrong_answers>>;

// The least times of all methods. They take turns, so what slows the machine down for a while slows
// all of them.
Results ask_all(const Predicate_columns& columns, const Object_questions& questions,
                double milliseconds)
{
  constexpr int rounds = 4;
  Results results;
  for(int round = 0; round < rounds; ++round)
    for(std::size_t i = 0; i < columns.size(); ++i) {
      if(round > 0 && !results[i].is_ok())
        continue; // one that never ends takes long enough once
      const auto result = ask_in_child(columns[i], questions, milliseconds / rounds);
      if(round == 0)
        results.push_back(result);
      else if(result.is_ok())
        results[i].values[0].nanoseconds
          = std::min(results[i].values[0].nanoseconds, result.values[0].nanoseconds);
    }
  return results;
}

void write_rows(const Object_questions& questions, double milliseconds,
                thick_benchmark::Csv_file& csv)
{
  const Kind& kind = questions.objects.kind;
  std::cout << kind.name << ", " << questions.objects.family << std::endl;
  Predicate_columns columns;
  for(const Predicate_column& column : all_predicates())
    if(column.knows(kind))
      columns.push_back(column);
  const Results results = ask_all(columns, questions, milliseconds);
  for(std::size_t i = 0; i < columns.size(); ++i) {
    const Wrong_answers wrong = results[i].is_ok() ? results[i].values[0] : Wrong_answers();
    csv.row(kind.dimension, kind.name, questions.objects.family, questions.pairs.size(),
            questions.true_pairs(), columns[i].name, columns[i].group, results[i].status,
            wrong.missing, wrong.extra, wrong.undecided, wrong.asymmetric, wrong.nanoseconds);
  }
}

// ---- which arithmetic decides -------------------------------------------------------------------

CGAL::Scene_profile profile_of(const Object_set& set)
{
  return with_maker(set.kind, [&](auto maker) {
    CGAL::Scene_profile profile;
    CGAL::thick_self_intersection_d(objects_of<CGAL::Simple_cartesian<double>>(maker, set),
                                    [](std::size_t, std::size_t) {}, profile);
    return profile;
  });
}

std::string name_of(CGAL::Arithmetic_tier tier)
{
  std::ostringstream name;
  name << tier;
  return name.str();
}

void write_stages(const Object_set& set, thick_benchmark::Csv_file& csv)
{
  using CGAL::Arithmetic_tier;
  const CGAL::Scene_profile profile = profile_of(set);
  csv.row(set.kind.dimension, set.kind.name, set.family, profile.degree(),
          profile.difference_bits(), profile.bits(), name_of(profile.needed_tier()),
          profile.decided(Arithmetic_tier::DOUBLE), profile.decided(Arithmetic_tier::INT64),
          profile.decided(Arithmetic_tier::INT128), profile.decided(Arithmetic_tier::INT192),
          profile.decided(Arithmetic_tier::FILTERED_EXACT));
}

constexpr const char* columns
  = "dimension,kind,family,questions,true_pairs,method,group,status,missing,extra,undecided,"
    "asymmetric,ns";

void measure_objects(const std::string& folder, double milliseconds)
{
  thick_benchmark::Csv_file csv(
    folder, "object_families.csv",
    "the origin in the hull of differences, in GMP integers (test/support/hull_oracle.h)",
    columns);
  thick_benchmark::Csv_file stages(folder, "object_stages.csv",
                                   "none: the profiles of searches (CGAL/Scene_profile.h, decided)",
                                   "dimension,kind,family,degree,difference_bits,bits,needed_tier,"
                                   "double,int64,int128,int192,exact");
  for(const Kind& kind : kinds())
    for(const Object_set& set : object_families(kind)) {
      write_rows(questions_about(set), milliseconds, csv);
      write_stages(set, stages);
    }
}

void measure_thick_objects(const std::string& folder, double milliseconds)
{
  thick_benchmark::Csv_file csv(
    folder, "thick_families.csv",
    "hulls of differences, in GMP integers and fractions (test/support/distance_oracle.h)",
    columns);
  for(const Kind& kind : thick_kinds())
    for(const Object_set& set : thick_families(kind))
      write_rows(questions_about(set), milliseconds, csv);
}

void measure_tracks(const std::string& folder, double milliseconds)
{
  thick_benchmark::Csv_file csv(
    folder, "track_families.csv",
    "hulls of differences, in GMP integers and fractions (test/support/distance_oracle.h)",
    columns);
  for(const Kind& kind : moving_kinds())
    for(const Object_set& set : track_families(kind))
      write_rows(questions_about(set), milliseconds, csv);
}

} // namespace

int main(int, char** arguments)
{
  const double milliseconds = std::stod(arguments[2]);
  measure_thick_objects(arguments[1], milliseconds);
  measure_objects(arguments[1], milliseconds);
  measure_tracks(arguments[1], milliseconds);
}
