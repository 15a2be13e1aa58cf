// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Texts to times and back; see time_text.h.

#include "time_text.h"

#include "decimal.h"

#include <boost/date_time/gregorian/gregorian_types.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace near_pairs {
namespace {

using Calendar = boost::gregorian::gregorian_calendar;

constexpr int most_digits = 18; // of 63 bits

// The difference of two such times has 63 bits. In nanoseconds, it is in the year 2116.
constexpr std::int64_t largest_time = std::numeric_limits<std::int64_t>::max() / 2;

std::int64_t days_before_1970()
{
  return Calendar::day_number({1970, 1, 1});
}

// Reads a text from its beginning to its end. Whatever fails returns false, or -1.
class Time_scanner
{
public:
  explicit Time_scanner(std::string_view rest) : rest_(rest) {}

  bool is_at_end() const { return rest_.empty(); }
  std::string rest() const { return std::string(rest_); }

  bool take(char letter)
  {
    const bool has_letter = !rest_.empty() && rest_.front() == letter;
    rest_.remove_prefix(has_letter);
    return has_letter;
  }

  // A number of so many digits that is at most `most`.
  int take_number(std::size_t least_digits, std::size_t most_digits, int most)
  {
    const std::string digits = take_digits(most_digits);
    const int number = digits.size() < least_digits ? -1 : std::atoi(digits.c_str());
    return number > most ? -1 : number;
  }

  std::string take_digits(std::size_t most)
  {
    const std::size_t end = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    const std::string digits(rest_.substr(0, std::min(end, most)));
    rest_.remove_prefix(digits.size());
    return digits;
  }

private:
  std::string_view rest_;
};

// Adds a fraction to whole seconds. NumPy writes nine decimals, which are often zeros.
std::optional<Time> with_fraction(std::int64_t seconds, std::string fraction,
                                  const Time_form& form)
{
  fraction.erase(fraction.find_last_not_of('0') + 1);
  for(const char decimal : fraction) {
    if(std::abs(seconds) >= largest_time / 10)
      return std::nullopt;
    seconds = 10 * seconds + (decimal - '0');
  }
  return Time{seconds, -static_cast<int>(fraction.size()), form};
}

// Takes hh:mm or hh:mm:ss, and a fraction of the seconds, but not one of the minutes: in 17:05.5,
// people may mean it, or 5.5 seconds. Returns the whole seconds, or -1.
int take_clock(Time_scanner& text, std::size_t digits_of_hours, int most_hours,
               std::string& fraction)
{
  const int hours = text.take_number(1, digits_of_hours, most_hours);
  const int minutes = hours != -1 && text.take(':') ? text.take_number(2, 2, 59) : -1;
  if(minutes == -1 || !text.take(':'))
    return minutes == -1 ? -1 : 3600 * hours + 60 * minutes;
  const int seconds = text.take_number(2, 2, 59);
  if(seconds == -1)
    return -1;
  if(text.take('.') || text.take(',')) {
    fraction = text.take_digits(most_digits);
    if(fraction.empty())
      return -1;
  }
  return 3600 * hours + 60 * minutes + seconds;
}

// The seconds of Z, +hh, +hhmm or +hh:mm.
std::optional<int> parse_zone(const std::string& zone)
{
  Time_scanner text(zone);
  if(zone.empty() || text.take('Z'))
    return text.is_at_end() ? std::optional<int>(0) : std::nullopt;
  const bool is_west = text.take('-');
  if(!is_west && !text.take('+'))
    return std::nullopt;
  const int hours = text.take_number(2, 2, 23);
  const bool has_minutes = text.take(':') || !text.is_at_end();
  const int minutes = has_minutes ? text.take_number(2, 2, 59) : 0;
  if(hours == -1 || minutes == -1 || !text.is_at_end())
    return std::nullopt;
  return (is_west ? -60 : 60) * (60 * hours + minutes);
}

// Takes yyyy-mm-dd. Returns the days since 1970, or nothing. The first year and the last one of the
// calendar are left out, so that it has the days beside the date.
std::optional<std::int64_t> take_date(Time_scanner& text)
{
  const int year = text.take_number(4, 4, 9998);
  const int month = text.take('-') ? text.take_number(2, 2, 12) : -1;
  const int day = text.take('-') ? text.take_number(2, 2, 31) : -1;
  if(year < 1401 || month < 1 || day < 1 || day > Calendar::end_of_month_day(year, month))
    return std::nullopt;
  return Calendar::day_number({static_cast<unsigned short>(year),
                               static_cast<unsigned short>(month),
                               static_cast<unsigned short>(day)}) - days_before_1970();
}

std::optional<Time> parse_date(const std::string& date)
{
  Time_scanner text(date);
  Time_form form;
  form.kind = Time_form::DATE;
  const auto days = take_date(text);
  if(!days || text.is_at_end())
    return days ? with_fraction(*days * 86400, "", form) : std::nullopt;
  form.separator = text.take(' ') ? ' ' : 'T';
  if(form.separator == 'T' && !text.take('T'))
    return std::nullopt;
  std::string fraction;
  const int clock = take_clock(text, 2, 23, fraction);
  form.zone = trimmed(text.rest());
  const std::optional<int> zone = parse_zone(form.zone);
  if(clock == -1 || !zone)
    return std::nullopt;
  return with_fraction(*days * 86400 + clock - *zone, fraction, form);
}

std::optional<Time> parse_clock(const std::string& clock)
{
  Time_scanner text(clock);
  Time_form form;
  form.kind = Time_form::CLOCK;
  std::string fraction;
  const int seconds = take_clock(text, 4, 9999, fraction);
  return seconds == -1 || !text.is_at_end() ? std::nullopt
                                            : with_fraction(seconds, fraction, form);
}

std::optional<Time> parse_seconds(const Decimal& decimal)
{
  if(decimal.digits.size() + std::max(decimal.exponent, 0) > most_digits)
    return std::nullopt;
  const std::int64_t digits = std::atoll(decimal.digits.c_str());
  return Time{decimal.negative ? -digits : digits, decimal.exponent, {}};
}

std::string padded(std::int64_t number, std::size_t digits)
{
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

std::int64_t power_of_ten_in_bits(int exponent)
{
  std::int64_t power = 1;
  for(; exponent > 0; --exponent)
    power *= 10;
  return power;
}

// The time in finer ticks, to the nearest one.
std::int64_t finer_ticks(const Moment& moment, int more_digits)
{
  const std::int64_t finer = power_of_ten_in_bits(more_digits);
  return moment.tick * finer + std::llround(moment.part * static_cast<double>(finer));
}

std::string number_text(const Moment& moment)
{
  const int digits = static_cast<int>(std::to_string(std::abs(moment.tick)).size());
  const int more_digits = moment.part == 0 ? 0 : std::max(0, 16 - digits);
  const std::int64_t ticks = finer_ticks(moment, more_digits);
  const auto decimals = static_cast<std::size_t>(moment.scale + more_digits);
  if(decimals > 2 * most_digits)
    return std::to_string(ticks) + "e-" + std::to_string(decimals);
  std::string text = padded(std::abs(ticks), decimals + 1);
  if(decimals != 0) {
    text.insert(text.size() - decimals, ".");
    text.erase(text.find_last_not_of('0') + 1);
    if(text.back() == '.')
      text.pop_back();
  }
  return (ticks < 0 ? "-" : "") + text;
}

// The fraction is in ticks of so many decimals.
std::string clock_text(std::int64_t seconds, std::int64_t fraction, int decimals)
{
  std::string text = padded(seconds / 3600, 2) + ':' + padded(seconds / 60 % 60, 2) + ':'
                     + padded(seconds % 60, 2);
  if(fraction != 0)
    text += '.' + padded(fraction, decimals);
  return text;
}

std::int64_t remainder_of(std::int64_t number, std::int64_t divisor)
{
  return (number % divisor + divisor) % divisor;
}

} // namespace

std::optional<Time> parse_time(const std::string& text)
{
  if(const std::optional<Decimal> decimal = parse_decimal(text))
    return parse_seconds(*decimal);
  const std::optional<Time> date = parse_date(text);
  return date ? date : parse_clock(text);
}

std::string time_text(const Moment& moment, const Time_form& form)
{
  if(form.kind == Time_form::NUMBER)
    return number_text(moment);
  const int decimals = std::max(3, moment.scale);
  const std::int64_t ticks = finer_ticks(moment, decimals - moment.scale);
  const std::int64_t second = power_of_ten_in_bits(decimals);
  const std::int64_t fraction = remainder_of(ticks, second);
  std::int64_t seconds = (ticks - fraction) / second;
  if(form.kind == Time_form::CLOCK)
    return clock_text(seconds, fraction, decimals);
  seconds += *parse_zone(form.zone);
  const std::int64_t day = 86400, of_clock = remainder_of(seconds, day);
  const auto date = Calendar::from_day_number(static_cast<Calendar::date_int_type>(
    (seconds - of_clock) / day + days_before_1970()));
  return padded(date.year, 4) + '-' + padded(date.month, 2) + '-' + padded(date.day, 2)
         + form.separator + clock_text(of_clock, fraction, decimals) + form.zone;
}

std::string seconds_text(double seconds)
{
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), seconds + 0.,
                                     std::chars_format::general, 13).ptr};
}

bool are_comparable(const Time_form& a, const Time_form& b)
{
  return a.kind == b.kind && a.zone.empty() == b.zone.empty();
}

} // namespace near_pairs
