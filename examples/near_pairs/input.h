// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where the bytes of points come from: a file, the standard input or a pipe, compressed or not.

#ifndef NEAR_PAIRS_INPUT_H
#define NEAR_PAIRS_INPUT_H

#include <cstddef>
#include <istream>
#include <memory>
#include <string>

namespace near_pairs {

class Input
{
public:
  // "-" is the standard input. Throws Error if there is nothing to read from.
  explicit Input(const std::string& name, bool shows_progress = false);

  // The bytes from the first one on, each time; they are decompressed if they begin like a gzip
  // file. The stream must not outlive this object.
  std::unique_ptr<std::istream> open() const;

  // All these bytes, without a mark of UTF-8 before them.
  std::string text() const;

  const std::string& name() const { return name_; }

  // Throws Error unless a stream that ends had so many bytes: another program may cut the file, or
  // write to it, while it is read.
  void check_end(std::size_t bytes) const;

  // Shows that so many bytes of the stream have been read, if that is wanted.
  void show_bytes(std::size_t bytes) const;

private:
  std::string name_;
  bool shows_progress_;
  std::size_t size_ = 0; // in bytes; 0: not known
  bool is_kept_ = false;
  bool is_compressed_ = false;
  std::string bytes_; // what can be read only once, if is_kept_
};

// Takes off the mark that some programs begin UTF-8 files with. Throws Error if the file is in
// UTF-16.
void take_mark(std::string& line, const std::string& file);

// The lines of an input, with their numbers and without line ends: LF, CR LF, or CR if the
// beginning of the input has no LF.
class Lines
{
public:
  explicit Lines(const Input& input);

  bool next(std::string& line);

  // What follows the last line, as bytes. They return whether the file has so many.
  bool read_bytes(std::string& bytes, std::size_t count);
  bool skip_bytes(std::size_t count);

  std::size_t number() const { return number_; }
  const std::string& file() const { return input_.name(); }

private:
  bool get_line(std::string& line);

  const Input& input_;
  std::unique_ptr<std::istream> stream_;
  std::size_t number_ = 0;
  std::size_t bytes_ = 0; // up to now
  char end_; // of a line
};

} // namespace near_pairs

#endif // NEAR_PAIRS_INPUT_H
