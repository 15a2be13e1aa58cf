// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Text that other programs read; see text.h.

#include "text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace near_pairs {
namespace {

bool begins_letter(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

// Whether each byte above 127 belongs to a letter of UTF-8, in its shortest form, and neither to
// half of a letter of UTF-16 nor to a number beyond all letters.
bool is_utf8(const std::string& text)
{
  std::size_t missing = 0;
  unsigned char first = 0x80, last = 0xBF; // what the next missing byte may be
  for(char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if(missing != 0) {
      if(byte < first || byte > last)
        return false;
      --missing;
      first = 0x80;
      last = 0xBF;
    }
    else if(byte >= 0x80) {
      if(byte < 0xC2 || byte > 0xF4)
        return false;
      missing = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
      first = byte == 0xE0 ? 0xA0 : byte == 0xF0 ? 0x90 : 0x80;
      last = byte == 0xED ? 0x9F : byte == 0xF4 ? 0x8F : 0xBF;
    }
  }
  return missing == 0;
}

} // namespace

std::string readable(const std::string& text)
{
  const unsigned char last = is_utf8(text) ? 255 : 126;
  std::string result = text;
  for(char& letter : result) {
    const auto byte = static_cast<unsigned char>(letter);
    if(byte < 32 || byte == 127 || byte > last)
      letter = '?';
  }
  return result;
}

bool is_no_text(const std::string& bytes)
{
  return std::any_of(bytes.begin(), bytes.end(), [](unsigned char byte) {
    return std::iscntrl(byte) != 0 && std::isspace(byte) == 0;
  });
}

std::string utf8(const std::string& text)
{
  if(is_utf8(text))
    return text;
  std::string result;
  for(char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if(byte < 0x80)
      result += letter;
    else
      result.append({static_cast<char>(0xC0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3F))});
  }
  return result;
}

std::string lower_case(std::string text)
{
  for(char& letter : text)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

std::size_t letters(const std::string& text)
{
  return std::count_if(text.begin(), text.end(), begins_letter);
}

std::string shortened(const std::string& text, std::size_t most)
{
  std::size_t count = 0;
  for(std::size_t at = 0; at < text.size(); ++at)
    if(begins_letter(text[at]) && ++count > most)
      return text.substr(0, at) + "\u2026";
  return text;
}

std::string shortest_text(double value)
{
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.).ptr;
  return std::string(text.data(), end);
}

std::string csv_field(const std::string& text)
{
  if(text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for(char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::string json_string(const std::string& text)
{
  const char* const digits = "0123456789abcdef";
  std::string quoted = "\"";
  for(char letter : utf8(text)) {
    const auto byte = static_cast<unsigned char>(letter);
    if(byte < 32 || byte == 127)
      quoted += std::string("\\u00") + digits[byte >> 4] + digits[byte & 15];
    else
      quoted += letter == '"' || letter == '\\' ? std::string("\\") + letter
                                                : std::string(1, letter);
  }
  return quoted + "\"";
}

} // namespace near_pairs
