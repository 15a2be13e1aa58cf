// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The columns of the tables of objects: predicates that tell whether two segments, triangles or
// tetrahedra intersect, as they are, with radii, without their boundaries, or as solids. Ours and
// others.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_PREDICATE_COLUMNS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_PREDICATE_COLUMNS_H

#include "object_makers.h"
#include "object_questions.h"
#include "run_in_child.h"

#include "measuring/timing.h"

#include <CGAL/intersections.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace lab {

enum Answer : char { NO, YES, UNDECIDED };

// What a predicate says about the pairs (i, j) of the questions, and about the pairs (j, i).
struct Answers
{
  std::vector<char> in_order;
  std::vector<char> reversed;
  double nanoseconds = 0; // per question
};

struct Predicate_column
{
  std::string name;
  std::string group; // "form", "kernel", "library", "ours"
  std::function<bool(const Kind&)> knows;
  std::function<Answers(const Object_questions&, double milliseconds)> ask;
};

using test_support::Pair;

using Predicate_columns = std::vector<Predicate_column>;

// In the order in which the table has them. Each kernel is compiled in one file.
Predicate_columns plain_predicates();   // in doubles, and with intervals of them
Predicate_columns library_predicates(); // GEOS
Predicate_columns cgal_predicates();    // CGAL's exact ones
Predicate_columns package_predicates(); // ours

// About objects with radii, open objects and solids.
Predicate_columns thick_predicates(); // ours, and CGAL's distances
Predicate_columns thick_rivals();     // doubles, Polygon_mesh_processing, Boolean sets, GEOS, FCL
Predicate_columns track_predicates(); // of points that move: ours, and formulas

// ---- to make them -------------------------------------------------------------------------------

// The time of f(), which returns some number, for each of so many questions. It is not measured in
// zero milliseconds.
template <class Function>
double nanoseconds_of(const Function& f, std::size_t questions, double milliseconds)
{
  if(milliseconds == 0)
    return 0;
  volatile std::size_t sink = 0;
  double seconds = 0, rounds = 0;
  do {
    seconds += thick_benchmark::processor_seconds_of([&] { sink = sink + f(); });
    ++rounds;
  } while(1000 * seconds < milliseconds);
  return 1e9 * seconds / (rounds * static_cast<double>(questions));
}

// Of answer(i, j).
template <class Function>
Answers answers_to(const Object_questions& questions, double milliseconds, const Function& answer)
{
  Answers answers;
  for(const auto& [i, j] : questions.pairs) {
    answers.in_order.push_back(static_cast<char>(answer(i, j)));
    answers.reversed.push_back(static_cast<char>(answer(j, i)));
  }
  const auto ask_all = [&] {
    std::size_t count = 0;
    for(const auto& [i, j] : questions.pairs)
      count += static_cast<std::size_t>(answer(i, j));
    return count;
  };
  answers.nanoseconds = nanoseconds_of(ask_all, questions.pairs.size(), milliseconds);
  return answers;
}

// Calls f(maker) with the maker of a kind (object_makers.h).
template <class Function>
auto with_maker(const Kind& kind, const Function& f)
{
  if(kind.vertices == 4)
    return f(Tetrahedra_3());
  if(kind.dimension == 2)
    return kind.vertices == 2 ? f(Segments_2()) : f(Triangles_2());
  return kind.vertices == 2 ? f(Segments_3()) : f(Triangles_3());
}

// The same of open objects and solids, and of capsules.
template <class Function>
auto with_thick_maker(const Kind& kind, const Function& f)
{
  if(kind.vertices == 4)
    return f(Tetrahedra_3());
  return f(Triangles_2());
}
template <class Function>
auto with_segments_maker(const Kind& kind, const Function& f)
{
  return kind.dimension == 2 ? f(Segments_2()) : f(Segments_3());
}

inline bool knows_closed(const Kind& kind) { return kind.meaning == Meaning::CLOSED; }

template <class Kernel, class Maker>
auto objects_of(Maker, const Object_set& set)
{
  std::vector<decltype(Maker::template make<Kernel>(set.object(0)))> objects;
  for(std::size_t i = 0; i < set.size(); ++i)
    objects.push_back(Maker::template make<Kernel>(set.object(i)));
  return objects;
}

// Of make_predicate(objects), the predicate about the objects of a kernel.
template <class Kernel, class Make_predicate>
Predicate_column predicate_column(const std::string& name, const std::string& group,
                                  const Make_predicate& make_predicate)
{
  const auto ask = [make_predicate](const Object_questions& questions, double milliseconds) {
    return with_maker(questions.objects.kind, [&](auto maker) {
      const auto objects = objects_of<Kernel>(maker, questions.objects);
      const auto predicate = make_predicate(objects);
      return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
        return predicate(objects[i], objects[j]);
      });
    });
  };
  return {name, group, knows_closed, ask};
}

// CGAL's predicate.
inline auto by_do_intersect()
{
  return [](const auto&) {
    return [](const auto& a, const auto& b) { return CGAL::do_intersect(a, b); };
  };
}

// Of find(), which returns the sorted pairs that a search reports. The time includes that for
// finding the pairs of boxes.
template <class Find>
Answers answers_of_search(const Object_questions& questions, double milliseconds, const Find& find)
{
  const Pairs found = find();
  Answers answers = answers_to(questions, 0, [&](std::size_t i, std::size_t j) {
    return std::binary_search(found.begin(), found.end(), Pair(std::minmax(i, j)));
  });
  answers.nanoseconds
    = nanoseconds_of([&] { return find().size(); }, questions.pairs.size(), milliseconds);
  const auto found_in_order
    = std::count(answers.in_order.begin(), answers.in_order.end(), static_cast<char>(YES));
  if(static_cast<std::size_t>(found_in_order) != found.size())
    throw std::logic_error("a pair is reported twice, or its boxes do not meet");
  return answers;
}

// ---- to ask them --------------------------------------------------------------------------------

// How many answers are wrong.
struct Wrong_answers
{
  std::size_t missing = 0, extra = 0, undecided = 0;
  std::size_t asymmetric = 0; // (i, j) and (j, i) have different answers
  double nanoseconds = 0;

  std::size_t count() const { return missing + extra + undecided + asymmetric; }
};

inline Wrong_answers wrong_answers(const Object_questions& questions, const Answers& answers)
{
  Wrong_answers wrong;
  wrong.nanoseconds = answers.nanoseconds;
  for(std::size_t i = 0; i < questions.answers.size(); ++i) {
    const char answer = answers.in_order[i];
    wrong.undecided += answer == UNDECIDED;
    wrong.missing += answer == NO && questions.answers[i] != 0;
    wrong.extra += answer == YES && questions.answers[i] == 0;
    wrong.asymmetric += answer != answers.reversed[i];
  }
  return wrong;
}

// In a process of its own, because some of them crash. One value, if there is one.
inline Child_result<Wrong_answers> ask_in_child(const Predicate_column& column,
                                                const Object_questions& questions,
                                                double milliseconds)
{
  constexpr unsigned int limit = 60; // seconds
  return run_in_child(limit, [&] {
    return std::vector<Wrong_answers>{
      wrong_answers(questions, column.ask(questions, milliseconds))};
  });
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_PREDICATE_COLUMNS_H
