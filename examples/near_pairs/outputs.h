// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files that appear whole or not at all.

#ifndef NEAR_PAIRS_OUTPUTS_H
#define NEAR_PAIRS_OUTPUTS_H

#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace near_pairs {

// The file that a name leads to by links, whether it is there or not.
std::filesystem::path target_of(const std::filesystem::path& file);

// Writes to a temporary file in the same directory, which takes the wanted name when commit() is
// called, and is removed if it is not. "-" is the standard output; a device is written directly.
class Output_file
{
public:
  // Throws Error if the file cannot be written, or if it is an input file.
  Output_file(const std::string& file, const std::vector<std::string>& inputs);
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file();

  std::ostream& stream();

  // Throws Error if something could not be written.
  void check();

  // Throws Error if something could not be written, and leaves no file then.
  void commit();

private:
  void open_temporary();

  std::string name_; // as the user wrote it
  std::filesystem::path target_;
  std::filesystem::path temporary_; // empty if the target is written directly
  std::ofstream file_;
};

// Returns nothing if the name is empty.
std::unique_ptr<Output_file> open_output(const std::string& file,
                                         const std::vector<std::string>& inputs);

} // namespace near_pairs

#endif // NEAR_PAIRS_OUTPUTS_H
