// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The one exception type of near_pairs: what the user has to be told, as one line, when a command
// line or a file cannot be used. main() prints it and ends with status 2.

#ifndef NEAR_PAIRS_ERROR_H
#define NEAR_PAIRS_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace near_pairs {

class Error : public std::runtime_error
{
public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}

  Error(const std::string& file, const std::string& message)
    : std::runtime_error(file + ": " + message)
  {}

  Error(const std::string& file, std::size_t line, const std::string& message)
    : std::runtime_error(file + ":" + std::to_string(line) + ": " + message)
  {}
};

} // namespace near_pairs

#endif // NEAR_PAIRS_ERROR_H
