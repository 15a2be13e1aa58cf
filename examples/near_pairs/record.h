// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The records of a table, as text, by RFC 4180 and what is common besides.

#ifndef NEAR_PAIRS_RECORD_H
#define NEAR_PAIRS_RECORD_H

#include "input.h"

#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

// Blanks around a field are no part of it. Inside quotes, separators and line ends are text, and a
// quote is doubled; a quote inside a field that does not begin with one is text. Blank lines are
// skipped, and so are lines that begin with # before the first record. If tabs separate fields, a
// line of tabs behind this record is one of empty fields.
class Records
{
public:
  // The separator ' ' stands for any number of blanks and tabs, and 0 for the one that the first
  // record has most of; a first line of sep=; names it as well, as Excel does.
  Records(const Input& input, char separator, bool comma_numbers);

  // Reads the next record; returns false at the end.
  bool next(std::vector<std::string>& fields);

  // The fields of a text as if it were a record of one line. Throws Error if it is none.
  std::vector<std::string> fields_of(const std::string& text);

  // Whether the record in hand begins with #, as a comment does.
  bool begins_with_hash() const { return begins_with_hash_; }

  // The line before the first record, without its #, if it is a comment.
  const std::string& comment() const { return comment_; }

  bool has_blanks_between() const { return separator_ == ' '; }
  const std::string& file() const { return lines_.file(); }
  std::size_t line() const { return line_; } // that the record in hand begins at

private:
  bool next_text();
  bool take_separator_line();
  char most_used_separator();
  void split(std::vector<std::string>& fields);
  std::string take_field(std::size_t& at, std::size_t number);
  std::string take_quoted(std::size_t& at, std::size_t number);
  bool go_on_in_next_line();
  bool is_separator(std::size_t at) const;
  std::size_t behind_blanks(std::size_t at) const;
  std::size_t find_separator(std::size_t at) const;

  Lines lines_;
  char separator_;
  const bool comma_numbers_;
  std::string record_; // in hand
  std::string more_;   // the last line of a record of several lines
  std::size_t line_ = 0;
  bool is_first_ = true; // no record was read yet
  bool begins_with_hash_ = false;
  std::string comment_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_RECORD_H
