// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files of points, one row at a time: where the numbers of each point stand, as text, and on
// which line. What the text means is left to point_file.cpp.

#ifndef NEAR_PAIRS_ROW_READER_H
#define NEAR_PAIRS_ROW_READER_H

#include "cell.h"
#include "frame.h"
#include "input.h"
#include "read_options.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

struct Row
{
  std::size_t line = 0;
  std::array<std::string, 3> coordinates; // as many as the reader's dimension
  std::string id;                         // empty if the file has no ids
  std::vector<std::string> motion = {};   // the time, or speed, course and climb, if wanted
  std::size_t position = 0; // among the rows of the file, with those that are skipped
};

class Row_reader
{
public:
  virtual ~Row_reader() = default;

  // Reads the next row; returns false at the end.
  virtual bool next(Row& row) = 0;

  // The cell that the file tells, known from the end of the rows. Throws Error if it is none.
  virtual std::optional<Cell> cell() const { return std::nullopt; }
  std::size_t line_of_cell = 0;

  // Coordinates per row, known from the beginning.
  int dimension = 0;

  // Their names, for messages and axes, and their unit if the file tells it.
  std::array<std::string, 3> names = {"x", "y", "z"};
  std::string unit;

  // If the coordinates are degrees, the axis of the latitude, and otherwise -1.
  int latitude_axis = -1;

  // Of what Row::motion has, and the meters in a unit of the third coordinate behind degrees.
  std::vector<std::string> motion_names;
  double altitude_unit = 1;

  bool has_ids = false;
  bool is_table = false;
  bool are_guessed = false; // the columns of a table, by their names
  bool may_skip_missing = false; // whether --skip-missing is taken for the file
  std::size_t skipped = 0; // rows that were left out, up to now

  // What to do with rows without coordinates; empty where they cannot be left out.
  std::string advice_on_missing() const
  {
    return may_skip_missing ? "; --skip-missing leaves such rows out" : "";
  }

  // The one that is read; the count is known from the end of the rows.
  Frame frame;

protected:
  // Throws Error if the file has no such frame.
  void require_frame(const std::string& file) const;
};

// Reads the input by options.format or, if that is empty, by its extension.
// With --geographic the coordinates of a row are latitude and longitude, in this order.
std::unique_ptr<Row_reader> open_rows(const Input& input, const Read_options& options);

// The names of the columns that were guessed, for a summary, or an empty text.
std::string guessed_columns(const Row_reader& reader);

// The format that a file is read by: an extension, without its point.
std::string format_of(const std::string& file, const Read_options& options);

// Whether the file is a table: the options of these are for no others.
bool is_table(const std::string& file, const Read_options& options);

// Throws Error if there is one of them. Nodes of .tsp may be in degrees, too.
void refuse_options_for_tables(const Input& input, const Read_options& options,
                               bool are_degrees = false);

// Whether a format is CIF, which is read into memory as a whole.
bool is_cif(const std::string& format);

// Whether the file may have several frames, or models of a molecule.
bool has_frames(const std::string& file, const Read_options& options);

// Whether the input is no text, but three doubles for each point (.bin).
bool is_binary(const Input& input, const Read_options& options);

// The extension of a file name, in lower case, with its point.
std::string extension(const std::string& file);

// The first words of a line that is separated by blanks, at most `most`: a line may be as long as a
// file, and each word takes more memory than its text.
std::vector<std::string> words(const std::string& line, std::size_t most);

// "1 word" or "2 words".
std::string plural(std::size_t count, const std::string& word);

// Reads a count as the heads of files have it, of at most 18 digits.
std::optional<std::size_t> parse_count(const std::string& text);

} // namespace near_pairs

#endif // NEAR_PAIRS_ROW_READER_H
