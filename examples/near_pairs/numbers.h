// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The numbers of a mesh, one after the other, as words or in binary. Words stand between blanks and
// line ends, wherever these are: formats of meshes are free in this.

#ifndef NEAR_PAIRS_NUMBERS_H
#define NEAR_PAIRS_NUMBERS_H

#include "error.h"
#include "input.h"
#include "read_options.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace near_pairs {

struct Number_type
{
  std::size_t bytes;
  enum Kind { UNSIGNED, SIGNED, FLOATING } kind;
};

class Numbers
{
public:
  // A comment goes from its sign to the end of the line; 0: there are none.
  Numbers(const Input& input, const Read_options& options, char comment = 0);

  // The head of the file, as lines or as words. They return false at the end of the file, or of the
  // line.
  bool next_line(std::string& line) { return lines_.next(line); }
  bool next_word();
  bool next_word_of_line();
  std::string_view word() const { return std::string_view(line_).substr(begin_, end_ - begin_); }
  void shorten_word(std::size_t letters) { end_ = begin_ + letters; } // the next one is the rest
  std::size_t count_words_of_line(std::size_t most) const; // behind the word in hand

  // Numbers behind the line in hand are bytes. Throws Error if --decimal wants texts.
  enum Byte_order { LEAST_FIRST, MOST_FIRST };
  void become_binary(Byte_order order);
  bool are_binary() const { return are_binary_; }

  // The next numbers are of item `item` of so many, as errors are to say.
  void begin(const std::string& name, std::size_t item, std::size_t promised);

  // The next number. Throws Error at the end of the file.
  void take(Number_type type);
  void skip(std::size_t count, Number_type type);

  // The number in hand. Throw Error if it is none of this kind; a text in a file may be any.
  std::string coordinate() const;
  std::size_t count() const;

  // Throws Error if the file goes on.
  void expect_end();

  // Says what is wrong with the word or the item in hand.
  Error wrong(const std::string& what) const;
  std::size_t line() const { return lines_.number(); }

private:
  double value() const; // in binary
  Error cut_off() const;

  const Input& input_;
  const bool is_decimal_, may_be_missing_, may_skip_missing_;
  const char comment_;
  Lines lines_;
  std::string line_;                // the line in hand, without its comment
  std::size_t begin_ = 0, end_ = 0; // of the word in hand

  bool are_binary_ = false;
  Byte_order order_ = LEAST_FIRST;
  Number_type type_ = {};
  std::string bytes_; // of the number in hand

  std::string name_; // of the item in hand; empty: the head
  std::size_t item_ = 0, promised_ = 0;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_NUMBERS_H
