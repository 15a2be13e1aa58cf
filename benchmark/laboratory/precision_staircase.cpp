// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The share of wrong answers against the precision, for predicates of degree 1, 2, 4 and 5.
//
//   precision_staircase <folder for staircase.csv> <questions per set>

#include "staircase.h"

#include "measuring/Csv_file.h"

#include <string>

namespace {

using thick_benchmark::Csv_file;

template <class Predicate>
void measure(int input_bits, bool is_near, std::size_t count, Csv_file& csv)
{
  const lab::Questions<Predicate> questions(input_bits, is_near, count);
  lab::for_each_precision(
    questions,
    [&](int precision, std::size_t wrong) {
      csv.row(Predicate::name, Predicate::degree, input_bits, Predicate::bits(input_bits),
              is_near ? "near-degenerate" : "random", precision, questions.size(), wrong);
    },
    lab::Precisions());
}

} // namespace

int main(int, char** arguments)
{
  Csv_file csv(arguments[1], "staircase.csv",
               "the same polynomial in GMP integers (staircase.h, Questions)",
               "predicate,degree,input_bits,bits_by_theory,set,precision,questions,wrong");
  const std::size_t count = std::stoul(arguments[2]);
  for(int input_bits : {10, 16, 24})
    for(bool is_near : {true, false}) {
      measure<lab::Compare_x>(input_bits, is_near, count, csv);
      measure<lab::Compare_distance>(input_bits, is_near, count, csv);
      measure<lab::Compare_distance_of_disks>(input_bits, is_near, count, csv);
      measure<lab::Side_of_circle>(input_bits, is_near, count, csv);
      measure<lab::Side_of_circle_by_products>(input_bits, is_near, count, csv);
      measure<lab::Side_of_sphere>(input_bits, is_near, count, csv);
    }
}
