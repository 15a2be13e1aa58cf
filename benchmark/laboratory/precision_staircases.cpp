// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The share of wrong answers against the precision: of predicates of degree 1, 2, 4 and 5, and when
// this package's decisions about segments, triangles and tetrahedra are made on a kernel of rounded
// numbers.
//
//   precision_staircases <folder for staircase.csv and object_staircase.csv>
//                        <questions per set> <questions about objects per set>

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

// ---- predicates about points --------------------------------------------------------------------

template <class Predicate>
void measure(int input_bits, bool is_near, std::size_t count, thick_benchmark::Csv_file& csv)
{
  const Questions<Predicate> questions(input_bits, is_near, count);
  for_each_precision(
    questions,
    [&](int precision, std::size_t wrong) {
      csv.row(Predicate::name, Predicate::degree, input_bits, Predicate::bits(input_bits),
              is_near ? "near-degenerate" : "random", precision, questions.size(), wrong);
    },
    Precisions());
}

void write_staircase(const std::string& folder, std::size_t count)
{
  thick_benchmark::Csv_file csv(
    folder, "staircase.csv", "the same polynomial in GMP integers (staircase.h, Questions)",
    "predicate,degree,input_bits,bits_by_theory,set,precision,questions,wrong");
  for(int input_bits : {10, 16, 24})
    for(bool is_near : {true, false}) {
      measure<Compare_x>(input_bits, is_near, count, csv);
      measure<Compare_distance>(input_bits, is_near, count, csv);
      measure<Compare_distance_of_disks>(input_bits, is_near, count, csv);
      measure<Side_of_circle>(input_bits, is_near, count, csv);
      measure<Side_of_circle_by_products>(input_bits, is_near, count, csv);
      measure<Side_of_sphere>(input_bits, is_near, count, csv);
    }
}

// ---- objects ------------------------------------------------------------------------------------

// How many answers differ when Number computes them. Coordinates are rounded if it has too few bits
// for them.
template <class Number, class Maker>
std::size_t count_wrong(Maker maker, const Object_questions& questions)
{
  namespace internal = CGAL::Thick_intersection_d::internal;
  const auto objects = objects_of<CGAL::Simple_cartesian<Number>>(maker, questions.objects);
  CGAL::Arithmetic_tier tier = CGAL::Arithmetic_tier::FILTERED_EXACT;
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < questions.pairs.size(); ++i) {
    const auto& [a, b] = questions.pairs[i];
    const bool do_intersect = internal::ask_by_kernel(internal::Do_vertices_intersect(),
                                                      objects[a], objects[b], tier);
    wrong += do_intersect != (questions.answers[i] != 0);
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

void write_object_staircase(const std::string& folder, std::size_t count)
{
  thick_benchmark::Csv_file csv(
    folder, "object_staircase.csv",
    "the origin in the hull of differences, in GMP integers (test/support/hull_oracle.h)",
    "kind,degree,input_bits,bits_by_theory,set,precision,questions,true_pairs,wrong");
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

} // namespace

int main(int, char** arguments)
{
  write_staircase(arguments[1], std::stoul(arguments[2]));
  write_object_staircase(arguments[1], std::stoul(arguments[3]));
}
