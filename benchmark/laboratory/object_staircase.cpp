// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The share of wrong answers against the precision, when this package's decisions about segments,
// triangles and tetrahedra are made on a kernel of rounded numbers.
//
//   object_staircase <folder for object_staircase.csv> <questions per set>

#include "near_contacts.h"
#include "predicate_columns.h"
#include "staircase.h"

#include "measuring/Csv_file.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Otherwise rational numbers would decide.
template <unsigned Digits>
constexpr bool has_exact_predicates_v<test_support::Mpfr_number<Digits>> = true;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

namespace {

using namespace lab;

// How many answers differ when Number computes them. Coordinates are rounded if it has too few bits
// for them.
template <class Number, class Maker>
std::size_t count_wrong(Maker maker, const Object_questions& questions)
{
  const auto objects = objects_of<CGAL::Simple_cartesian<Number>>(maker, questions.objects);
  CGAL::Arithmetic_tier tier = CGAL::Arithmetic_tier::FILTERED_EXACT;
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < questions.pairs.size(); ++i) {
    const auto& [a, b] = questions.pairs[i];
    wrong += CGAL::Thick_intersection_d::internal::do_objects_intersect_by_kernel(
               objects[a], objects[b], tier)
             != (questions.answers[i] != 0);
  }
  return wrong;
}

// A row for each precision.
template <class Maker, unsigned... Digits>
void write_rows(Maker maker, int input_bits, const char* set, const Object_questions& questions,
                thick_benchmark::Csv_file& csv, std::integer_sequence<unsigned, Digits...>)
{
  const int degree = Maker::dimension;
  const int bits_by_theory = degree == 2 ? 2 * input_bits + 1 : 3 * input_bits + 3;
  const auto write = [&](int precision, std::size_t wrong) {
    csv.row(questions.objects.kind.name, degree, input_bits, bits_by_theory, set, precision,
            questions.pairs.size(), questions.true_pairs(), wrong);
  };
  (write(bits_of<Digits>(), count_wrong<test_support::Mpfr_number<Digits>>(maker, questions)),
   ...);
}

} // namespace

int main(int, char** arguments)
{
  thick_benchmark::Csv_file csv(
    arguments[1], "object_staircase.csv",
    "the origin in the hull of differences, in GMP integers (test/support/hull_oracle.h)",
    "kind,degree,input_bits,bits_by_theory,set,precision,questions,true_pairs,wrong");
  const std::size_t count = std::stoul(arguments[2]);
  for(int input_bits : {10, 16, 24})
    for(const Kind& kind : kinds())
      for(bool is_near : {true, false}) {
        const Object_questions questions = contacts(kind, input_bits, is_near, count);
        with_maker(kind, [&](auto maker) {
          write_rows(maker, input_bits, is_near ? "touching, or nearly" : "random", questions, csv,
                     Precisions());
        });
      }
}
