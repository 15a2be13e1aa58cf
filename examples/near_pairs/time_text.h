// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Times as tables have them: numbers, which are seconds; clocks, as 17:05 or 17:05:30.5; and dates
// with or without a clock, as ISO 8601 has them.

#ifndef NEAR_PAIRS_TIME_TEXT_H
#define NEAR_PAIRS_TIME_TEXT_H

#include <cstdint>
#include <optional>
#include <string>

namespace near_pairs {

// How a time is written.
struct Time_form
{
  enum Kind { NUMBER, CLOCK, DATE };

  Kind kind = NUMBER;
  char separator = 'T'; // between date and clock
  std::string zone;     // behind a date with a clock, as it is written, or empty
};

// digits * 10^exponent seconds: of a date, since the first second of 1970; of a clock, since
// midnight.
struct Time
{
  std::int64_t digits;
  int exponent;
  Time_form form;
};

// Reads a time without rounding. Clocks may go on beyond 24 hours, as timetables do. Returns
// nothing if the text is no time, or if it has more than 18 digits.
std::optional<Time> parse_time(const std::string& text);

// A time in ticks of 10^-scale seconds, and a part of the next one, from 0 to 1.
struct Moment
{
  std::int64_t tick;
  double part;
  int scale; // not negative
};

// The text of a time in this form. Ticks are not rounded. A part of one is: a number has 16 digits,
// or as many as its ticks, and a clock milliseconds, or ticks that are finer.
std::string time_text(const Moment& moment, const Time_form& form);

// The text of seconds that are rounded already, with 13 digits.
std::string seconds_text(double seconds);

// Whether times of the two forms can be compared: they have the same kind, and dates have zones, or
// have none.
bool are_comparable(const Time_form& a, const Time_form& b);

} // namespace near_pairs

#endif // NEAR_PAIRS_TIME_TEXT_H
