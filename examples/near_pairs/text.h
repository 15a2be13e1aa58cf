// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Text that other programs read: UTF-8 without control characters, and numbers without a digit too
// many.

#ifndef NEAR_PAIRS_TEXT_H
#define NEAR_PAIRS_TEXT_H

#include <cstddef>
#include <string>

namespace near_pairs {

// A text that may have any bytes, with ? for each one that is not allowed.
std::string readable(const std::string& text);

// Whether the bytes may be those of a compressed file, or of a program.
bool is_no_text(const std::string& bytes);

// The text in UTF-8, which it is in already, or else in Latin-1.
std::string utf8(const std::string& text);

// The text with small letters in the place of the capitals of ASCII.
std::string lower_case(std::string text);

// How many letters a text of UTF-8 has.
std::size_t letters(const std::string& text);

// The beginning of a text, with an ellipsis behind it if the text has more than `most` letters.
std::string shortened(const std::string& text, std::size_t most);

// The shortest text that is read as this number.
std::string shortest_text(double value);

// A field of a CSV file, in quotes if it needs them.
std::string csv_field(const std::string& text);

// A string of a JSON file, with its quotes.
std::string json_string(const std::string& text);

} // namespace near_pairs

#endif // NEAR_PAIRS_TEXT_H
