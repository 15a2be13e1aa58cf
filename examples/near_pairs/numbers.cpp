// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Words and bytes to numbers; see numbers.h.

#include "numbers.h"

#include "row_numbers.h"
#include "row_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace near_pairs {
namespace {

const char* const blanks_of_words = " \t\r\v\f";

template <class Float, class Bits>
double floating(Bits bits)
{
  Float value;
  static_assert(sizeof value == sizeof bits);
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// The text that nearest_double() reads as the same number.
std::string text_of(double value)
{
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::general, 17).ptr};
}

} // namespace

Numbers::Numbers(const Input& input, const Read_options& options, char comment)
  : input_(input), is_decimal_(options.decimal), may_be_missing_(options.skip_missing),
    may_skip_missing_(options.may_skip_missing), comment_(comment), lines_(input)
{}

bool Numbers::next_word()
{
  while(!next_word_of_line()) {
    if(!lines_.next(line_))
      return false;
    if(comment_ != 0)
      line_.erase(std::min(line_.find(comment_), line_.size()));
    begin_ = end_ = 0;
  }
  return true;
}

bool Numbers::next_word_of_line()
{
  begin_ = std::min(line_.find_first_not_of(blanks_of_words, end_), line_.size());
  end_ = std::min(line_.find_first_of(blanks_of_words, begin_), line_.size());
  return begin_ < end_;
}

std::size_t Numbers::count_words_of_line(std::size_t most) const
{
  return words(line_.substr(end_), most).size();
}

void Numbers::become_binary(Byte_order order)
{
  if(is_decimal_)
    throw Error(input_.name(), "--decimal needs coordinates as text, and this file is binary");
  are_binary_ = true;
  order_ = order;
}

void Numbers::begin(const std::string& name, std::size_t item, std::size_t promised)
{
  name_ = name;
  item_ = item;
  promised_ = promised;
}

void Numbers::take(Number_type type)
{
  type_ = type;
  if(!(are_binary_ ? lines_.read_bytes(bytes_, type.bytes) : next_word()))
    throw cut_off();
}

// Every number that is skipped has a word or a byte, so that the time depends on the size of the
// file and not on what its head promises.
void Numbers::skip(std::size_t count, Number_type type)
{
  if(are_binary_ && !lines_.skip_bytes(count * type.bytes))
    throw cut_off();
  for(; !are_binary_ && count > 0; --count)
    take(type);
}

std::string Numbers::coordinate() const
{
  if(!are_binary_)
    return std::string(word());
  const double number = value();
  if(!std::isfinite(number) && !(may_be_missing_ && std::isnan(number)))
    throw wrong(!std::isnan(number) ? "has an infinite coordinate"
                : may_skip_missing_ ? "has a coordinate that is no number; --skip-missing leaves "
                                      "such ones out"
                                    : "has a coordinate that is no number");
  return std::isnan(number) ? "nan" : text_of(number);
}

std::size_t Numbers::count() const
{
  if(!are_binary_) {
    if(const auto number = parse_count(std::string(word())))
      return *number;
    throw wrong("'" + std::string(word()) + "' is no count");
  }
  const double number = value();
  if(number < 0)
    throw wrong("has a count below 0");
  return static_cast<std::size_t>(number);
}

void Numbers::expect_end()
{
  if(are_binary_ ? lines_.read_bytes(bytes_, 1) : next_word())
    throw are_binary_ ? Error(input_.name(), "bytes are left over behind the numbers that the head "
                                             "promises")
                      : wrong("'" + std::string(word()) + "' is left over behind the numbers that "
                              "the head promises");
}

Error Numbers::wrong(const std::string& what) const
{
  if(are_binary_)
    return Error(input_.name(), name_ + " " + std::to_string(item_) + " (from 0) " + what);
  return Error(input_.name(), lines_.number(), begin_ + 1, what);
}

Error Numbers::cut_off() const
{
  return Error(input_.name(), lines_.number(), name_.empty() ? "the file ends in its head"
               : "the file ends after " + name_ + " " + std::to_string(item_) + " of "
                 + std::to_string(promised_));
}

double Numbers::value() const
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < type_.bytes; ++i) {
    const std::size_t from_high = order_ == MOST_FIRST ? i : type_.bytes - 1 - i;
    bits = bits << 8 | static_cast<unsigned char>(bytes_[from_high]);
  }
  if(type_.kind == Number_type::FLOATING)
    return type_.bytes == 8 ? floating<double>(bits)
                            : floating<float>(static_cast<std::uint32_t>(bits));
  const double number = static_cast<double>(bits); // of 32 bits at most
  const bool is_negative = type_.kind == Number_type::SIGNED && bits >> (8 * type_.bytes - 1) != 0;
  return is_negative ? number - std::ldexp(1., static_cast<int>(8 * type_.bytes)) : number;
}

} // namespace near_pairs
