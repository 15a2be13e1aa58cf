// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A share of a file; see file_share.h.

#include "file_share.h"

#include "decimal.h"
#include "error.h"
#include "input.h"
#include "row_reader.h"
#include "text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string_view>

namespace near_pairs {
namespace {

using Points = std::vector<std::array<double, 3>>;

// The first of `count` things that part `part` has.
std::uint64_t begin_of(std::uint64_t count, int part, int part_count)
{
  const auto parts = static_cast<std::uint64_t>(part_count);
  const auto before = static_cast<std::uint64_t>(part);
  return count / parts * before + std::min(before, count % parts);
}

std::ifstream open_at(const std::string& file, std::uint64_t byte)
{
  std::ifstream stream(file, std::ios::binary);
  if(!stream)
    throw Error(file, std::strerror(errno));
  stream.seekg(static_cast<std::streamoff>(byte));
  return stream;
}

double double_of(const unsigned char* bytes)
{
  std::uint64_t bits = 0;
  for(int byte = 7; byte >= 0; --byte)
    bits = bits << 8 | bytes[byte];
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

Points read_binary(const std::string& file, std::uint64_t size, int part, int part_count)
{
  constexpr std::uint64_t bytes_per_point = 24;
  if(size % bytes_per_point != 0)
    throw Error(file, "ends inside a point: three doubles have 24 bytes");
  const std::uint64_t first = begin_of(size / bytes_per_point, part, part_count);
  const std::uint64_t last = begin_of(size / bytes_per_point, part + 1, part_count);
  std::ifstream stream = open_at(file, first * bytes_per_point);
  Points points(last - first);
  for(std::array<double, 3>& point : points) {
    std::array<unsigned char, bytes_per_point> bytes;
    if(!stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size()))
      throw Error(file, "cannot be read to its end");
    for(std::size_t axis = 0; axis < 3; ++axis)
      point[axis] = double_of(bytes.data() + axis * sizeof(double));
  }
  return points;
}

// Returns the first words of a line, as many as points have coordinates, and one more.
std::vector<std::string> fields_of(std::string line)
{
  const auto is_separator
    = [](char letter) { return letter == ',' || letter == ';' || letter == '\r'; };
  std::replace_if(line.begin(), line.end(), is_separator, ' ');
  return words(line, 4);
}

// Whether a separator has nothing before it, or nothing behind it. Many blanks are one.
bool has_empty_field(const std::string& line)
{
  const auto has = [&](char letter) { return line.find(letter) != std::string::npos; };
  const char separator = has(',') ? ',' : has(';') ? ';' : '\t';
  std::size_t begin = 0, end;
  do {
    end = std::min(line.find(separator, begin), line.size());
    if(line.find_first_not_of(" \t\r", begin) >= end)
      return true;
    begin = end + 1;
  } while(end != line.size());
  return false;
}

// Messages give the byte that the line begins at: no process knows how many lines come before it.
std::array<double, 3> point_of(const std::string& file, std::uint64_t byte,
                               const std::string& line)
{
  const std::vector<std::string> fields = fields_of(line);
  const std::string place = "the line at byte " + std::to_string(byte);
  if(fields.size() != 2 && fields.size() != 3)
    throw Error(file, place + " has not two or three numbers");
  if(line.find(',') != std::string::npos && line.find(';') != std::string::npos)
    throw Error(file, place + " has ',' and ';': one of them is to separate, and decimals have a "
                "point");
  if(has_empty_field(line))
    throw Error(file, place + " has an empty field");
  std::array<double, 3> point = {0, 0, 0};
  for(std::size_t axis = 0; axis < fields.size(); ++axis) {
    if(!parse_decimal(fields[axis]))
      throw Error(file, place + ": '" + fields[axis] + "' is no number");
    point[axis] = nearest_double(fields[axis]);
  }
  return point;
}

// A line belongs to the part that it begins in.
Points read_lines(const std::string& file, std::uint64_t size, int part, int part_count)
{
  std::uint64_t byte = begin_of(size, part, part_count);
  const std::uint64_t last = begin_of(size, part + 1, part_count);
  std::ifstream stream = open_at(file, byte == 0 ? 0 : byte - 1);
  std::string line;
  if(byte != 0) { // the rest of a line of the part before
    std::getline(stream, line);
    byte += line.size();
  }
  Points points;
  while(byte < last && std::getline(stream, line)) {
    const std::uint64_t begin = byte;
    byte += line.size() + 1;
    if(begin == 0)
      take_mark(line, file);
    const std::vector<std::string> fields = fields_of(line);
    const bool is_comment = fields.empty() || fields.front().front() == '#';
    const bool is_header
      = begin == 0 && !is_comment && std::none_of(fields.begin(), fields.end(), parse_decimal);
    if(is_header && is_no_text(line))
      throw Error(file, "is no text; unpack it if it is compressed, or name it .bin");
    if(!is_comment && !is_header)
      points.push_back(point_of(file, begin, line));
  }
  if(stream.bad())
    throw Error(file, "cannot be read to its end");
  return points;
}

} // namespace

std::vector<std::array<double, 3>> read_share(const std::string& file, int part, int part_count)
{
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if(error)
    throw Error(file, error.message());
  return extension(file) == ".bin" ? read_binary(file, size, part, part_count)
                                   : read_lines(file, size, part, part_count);
}

} // namespace near_pairs
