// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The share of wrong answers against the precision, when this package's decision about two points
// that move uniformly is made on rounded numbers.
//
//   track_staircase <folder for track_staircase.csv> <questions per set>

#include "staircase.h"
#include "track_families.h"

#include "measuring/Csv_file.h"

#include "support/track_oracle.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>

#include <algorithm>

namespace {

using namespace lab;
using CGAL::Exact_rational;
using Legs = std::array<Meetings::Leg, 2>;

struct Question_about_legs
{
  Legs legs;
  std::int64_t bound;
};

// Makes pairs of legs whose coordinates and times are integers of so many bits, 14 at least.
class Leg_pairs
{
public:
  Leg_pairs(const Kind& kind, Meetings::Times times, int bits)
    : kind_(kind), times_(times), bits_(bits), random_(bits), meetings_(kind, bits, 13)
  {}

  // Legs that are as near as the bound, or one step of one end nearer or farther.
  Question_about_legs near()
  {
    Legs legs = meetings_.meeting(Meetings::PASSING, times_);
    const std::int64_t unit = odd_number(bits_ - 14), time_unit = odd_number(bits_ - 11);
    for(Meetings::Leg& leg : legs) {
      for(Place& place : leg.places)
        for(std::int64_t& x : place)
          x *= unit;
      for(std::int64_t& time : leg.times)
        time *= time_unit;
    }
    return {off_by_a_step(legs, random_), unit * bound_of_meetings};
  }

  Question_about_legs random()
  {
    Legs legs;
    for(Meetings::Leg& leg : legs) {
      leg.places.resize(2);
      for(Place& place : leg.places)
        for(int axis = 0; axis < kind_.dimension; ++axis)
          place[static_cast<std::size_t>(axis)] = number();
      leg.times = {number(), number()};
      std::sort(leg.times.begin(), leg.times.end());
    }
    if(times_ == Meetings::COMMON)
      legs[1].times = legs[0].times;
    return {legs, number() / 2};
  }

private:
  std::int64_t number()
  {
    return static_cast<std::int64_t>(random_.below(std::size_t(1) << bits_));
  }

  std::int64_t odd_number(int bits)
  {
    return bits <= 0 ? 1 : static_cast<std::int64_t>(random_.below(std::size_t(1) << bits)) | 1;
  }

  Kind kind_;
  Meetings::Times times_;
  int bits_;
  Random random_;
  Meetings meetings_;
};

bool exact_answer(const Question_about_legs& question)
{
  std::array<test_support::Lattice_track, 2> tracks;
  for(std::size_t k = 0; k < 2; ++k) {
    const Meetings::Leg& leg = question.legs[k];
    for(std::size_t end = 0; end < (leg.times[0] == leg.times[1] ? 1 : 2); ++end) {
      test_support::Lattice_fix fix = {static_cast<int>(leg.times[end]), {}};
      std::copy(leg.places[end].begin(), leg.places[end].end(), fix.place.begin());
      tracks[k].push_back(fix);
    }
  }
  const auto approach = test_support::approach_of(tracks[0], tracks[1]);
  const Exact_rational bound(question.bound);
  return approach && approach->square <= bound * bound;
}

// Coordinates and times are rounded if the number has too few bits for them.
template <class Number, std::size_t N>
bool rounded_answer(const Question_about_legs& question)
{
  namespace internal = CGAL::Thick_intersection_d::internal;
  std::array<internal::Exact_leg<Number, N>, 2> legs;
  for(std::size_t k = 0; k < 2; ++k)
    for(std::size_t end = 0; end < 2; ++end) {
      legs[k].times[end] = Number(question.legs[k].times[end]);
      for(std::size_t axis = 0; axis < N; ++axis)
        legs[k].ends[end][axis] = Number(question.legs[k].places[end][axis]);
    }
  const Number bound(question.bound), square(bound * bound);
  const internal::Relative_motion<Number, N> motion(legs[0], legs[1]);
  const auto [n, d] = motion.least_square();
  return motion.has_time() && n <= Number(square * d);
}

template <class Number>
std::size_t count_wrong(const Kind& kind, const std::vector<Question_about_legs>& questions,
                        const std::vector<bool>& answers)
{
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < questions.size(); ++i)
    wrong += answers[i]
             != (kind.dimension == 2 ? rounded_answer<Number, 2>(questions[i])
                                     : rounded_answer<Number, 3>(questions[i]));
  return wrong;
}

// A number of b bits is less than 2^b. So |w_i| < 2^b and |v_i| < 2^(b + 1) if times are common,
// and |w_i| < 3 * 2^(3b) and |v_i| < 2^(2b + 1) if not (Relative_motion.h). The square of a
// coordinate of w x v is less than 2^(4b + 4), or than 9 * 2^(10b + 4).
int bits_by_theory(const Kind& kind, bool are_common, int bits)
{
  const int of_square = are_common ? 4 * bits + 4 : 10 * bits + 8;
  return kind.dimension == 2 ? of_square : of_square + 2;
}

template <unsigned... Digits>
void write_rows(const Kind& kind, Meetings::Times times, int bits, bool is_near, std::size_t count,
                thick_benchmark::Csv_file& csv, std::integer_sequence<unsigned, Digits...>)
{
  Leg_pairs pairs(kind, times, bits);
  std::vector<Question_about_legs> questions;
  std::vector<bool> answers;
  while(questions.size() < count) {
    questions.push_back(is_near ? pairs.near() : pairs.random());
    answers.push_back(exact_answer(questions.back()));
  }
  const bool are_common = times == Meetings::COMMON;
  const auto write = [&](int precision, std::size_t wrong) {
    csv.row(kind.name + (are_common ? ", common times" : ", own times"), are_common ? 4 : 10, bits,
            bits_by_theory(kind, are_common, bits), is_near ? "near the bound" : "random",
            precision, count, std::count(answers.begin(), answers.end(), true), wrong);
  };
  (write(bits_of<Digits>(),
         count_wrong<test_support::Mpfr_number<Digits>>(kind, questions, answers)), ...);
}

// Up to 261 bits.
using Leg_precisions
  = std::integer_sequence<unsigned, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 24, 27, 30, 33, 36, 39, 42,
                          46, 50, 54, 58, 62, 66, 70, 74, 78>;

} // namespace

int main(int, char** arguments)
{
  thick_benchmark::Csv_file csv(
    arguments[1], "track_staircase.csv",
    "parabolas through three values in rationals (test/support/track_oracle.h)",
    "kind,degree,input_bits,bits_by_theory,set,precision,questions,true_pairs,wrong");
  for(int bits : {14, 19, 24})
    for(const Kind& kind : moving_kinds())
      for(const Meetings::Times times : {Meetings::COMMON, Meetings::OWN})
        for(bool is_near : {true, false})
          write_rows(kind, times, bits, is_near, std::stoul(arguments[2]), csv, Leg_precisions());
}
