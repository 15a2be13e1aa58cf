// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The share of wrong answers against the precision: of predicates of degree 1, 2, 4 and 5, and when
// this package's decisions about segments, triangles and tetrahedra, and about segments with radii,
// are made on a kernel of rounded numbers.
//
//   precision_staircases <folder for staircase.csv, object_staircase.csv and thick_staircase.csv>
//                        <questions per set> <questions about objects per set>

#include "near_contacts.h"
#include "predicate_columns.h"
#include "staircase.h"
#include "thick_families.h"

#include "measuring/Csv_file.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

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

// By the predicates of the kernel, without a filter.
template <class Object>
bool do_intersect_by_kernel(const Object& a, const Object& b)
{
  using namespace CGAL::Thick_intersection_d::internal;
  CGAL::Arithmetic_tier tier = CGAL::Arithmetic_tier::FILTERED_EXACT;
  return ask_by_kernel(Do_vertices_intersect(), a, b, tier);
}

// How many answers differ when Number computes them. Coordinates are rounded if it has too few bits
// for them.
template <class Number, class Maker>
std::size_t count_wrong(Maker maker, const Object_questions& questions)
{
  const auto objects = objects_of<CGAL::Simple_cartesian<Number>>(maker, questions.objects);
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < questions.pairs.size(); ++i) {
    const auto& [a, b] = questions.pairs[i];
    wrong += do_intersect_by_kernel(objects[a], objects[b]) != (questions.answers[i] != 0);
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

// ---- segments with radii ------------------------------------------------------------------------

// Whether the segments, which do not intersect, are within the sum of the radii.
template <class Number, std::size_t Dimension>
bool are_within_radii(const Object_set& set, std::size_t i, std::size_t j)
{
  using Vector = std::array<Number, Dimension>;
  const auto ends = [&](std::size_t object) {
    std::vector<Vector> ends(2);
    for(std::size_t k = 0; k < 2 * Dimension; ++k)
      ends[k / Dimension][k % Dimension] = Number(set.object(object)[k]);
    return ends;
  };
  const Number sum(set.radius(i) + set.radius(j)); // which doubles hold
  const auto within
    = [&](const Number& n, const Number& d) { return n <= Number(d * Number(sum * sum)); };
  return CGAL::Thick_intersection_d::internal::Exact_hull_distance<
    Number, Dimension, decltype(within)>(within)(ends(i), ends(j));
}

template <class Number, class Maker>
std::size_t count_wrong_of_capsules(Maker maker, const Object_questions& questions)
{
  const auto segments = objects_of<CGAL::Simple_cartesian<Number>>(maker, questions.objects);
  std::size_t wrong = 0;
  for(std::size_t k = 0; k < questions.pairs.size(); ++k) {
    const auto& [i, j] = questions.pairs[k];
    const bool do_intersect
      = do_intersect_by_kernel(segments[i], segments[j])
        || are_within_radii<Number, Maker::dimension>(questions.objects, i, j);
    wrong += do_intersect != (questions.answers[k] != 0);
  }
  return wrong;
}

// A row for each precision. The squared distance is of degree 4 in the plane and 6 in space.
template <class Maker, unsigned... Digits>
void write_capsules(Maker maker, int input_bits, const char* set, const Object_questions& questions,
                    thick_benchmark::Csv_file& csv, std::integer_sequence<unsigned, Digits...>)
{
  const int degree = 2 * Maker::dimension;
  const int bits_by_theory = degree == 4 ? 4 * input_bits + 3 : 6 * input_bits + 6;
  const auto write = [&](int precision, std::size_t wrong) {
    csv.row(questions.objects.kind.name, degree, input_bits, bits_by_theory, set, precision,
            questions.pairs.size(), questions.true_pairs(), wrong);
  };
  (write(bits_of<Digits>(),
         count_wrong_of_capsules<test_support::Mpfr_number<Digits>>(maker, questions)), ...);
}

void write_thick_staircase(const std::string& folder, std::size_t count)
{
  thick_benchmark::Csv_file csv(
    folder, "thick_staircase.csv",
    "squared distances in GMP integers and fractions (test/support/distance_oracle.h)",
    "kind,degree,input_bits,bits_by_theory,set,precision,questions,true_pairs,wrong");
  for(int input_bits : {10, 16, 24})
    for(const Kind& kind : thick_kinds())
      for(bool is_near : {true, false}) {
        if(kind.meaning != Meaning::THICK)
          continue;
        Object_questions questions = {capsule_pairs(kind, input_bits, is_near, count), {}, {}};
        ask_about_neighbors(questions);
        with_segments_maker(kind, [&](auto maker) {
          write_capsules(maker, input_bits, is_near ? "touching, or nearly" : "random", questions,
                         csv, Long_precisions());
        });
      }
}

} // namespace

int main(int, char** arguments)
{
  write_staircase(arguments[1], std::stoul(arguments[2]));
  write_object_staircase(arguments[1], std::stoul(arguments[3]));
  write_thick_staircase(arguments[1], std::stoul(arguments[3]));
}
