// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The one exception type of near_pairs: what the user has to be told, as one line, when a command
// line or a file cannot be used. main() prints it and ends with status 2.

#ifndef NEAR_PAIRS_ERROR_H
#define NEAR_PAIRS_ERROR_H

#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace near_pairs {

// The beginning of a text that may quote any bytes of a file: without line ends, and without other
// characters that end a text or move the cursor.
inline std::string one_line(const std::string& text)
{
  const std::size_t most = 500;
  std::string line = text.substr(0, most);
  for(char& letter : line)
    if(std::iscntrl(static_cast<unsigned char>(letter)))
      letter = '?';
  return text.size() > most ? line + "..." : line;
}

class Error : public std::runtime_error
{
public:
  explicit Error(const std::string& message) : std::runtime_error(one_line(message)) {}

  Error(const std::string& file, const std::string& message) : Error(file + ": " + message) {}

  Error(const std::string& file, std::size_t line, const std::string& message)
    : Error(file + ":" + std::to_string(line) + ": " + message)
  {}

  // The column is that of a byte, from 1.
  Error(const std::string& file, std::size_t line, std::size_t column, const std::string& message)
    : Error(file + ":" + std::to_string(line), column, message)
  {}
};

} // namespace near_pairs

#endif // NEAR_PAIRS_ERROR_H
