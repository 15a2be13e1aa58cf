// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points one at a time; see point_stream.h.

#include "point_stream.h"

#include "error.h"
#include "row_numbers.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <ios>
#include <string>

namespace near_pairs {
namespace {

constexpr std::size_t bytes_per_point = 3 * sizeof(double);
constexpr std::size_t points_per_block = 4096;

// The double of eight bytes, least byte first.
double double_at(const char* bytes)
{
  std::uint64_t bits = 0;
  for(int byte = 7; byte >= 0; --byte)
    bits = bits << 8 | static_cast<unsigned char>(bytes[byte]);
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

} // namespace

Point_stream::Point_stream(const Input& input, const Read_options& options)
  : input_(input), options_(options)
{
  if(is_binary(input, options)) {
    bytes_ = input.open();
    block_.resize(points_per_block * bytes_per_point);
    dimension_ = options.dimension == 0 ? 3 : options.dimension;
  }
  else {
    reader_ = open_rows(input, options_);
    dimension_ = reader_->dimension;
  }
}

bool Point_stream::next(std::array<double, 3>& point)
{
  return reader_ ? next_row(point) : next_binary(point);
}

bool Point_stream::next_row(std::array<double, 3>& point)
{
  if(!reader_->next(row_))
    return false;
  const Place place = {input_, *reader_, row_};
  if(options_.geographic)
    point = place_on_sphere(place);
  else {
    point = {0, 0, 0};
    for(int axis = 0; axis < dimension_; ++axis)
      point[axis] = read_number(place, axis).value;
  }
  return true;
}

bool Point_stream::next_binary(std::array<double, 3>& point)
{
  if(at_ == block_size_ && !fill())
    return false;
  for(int axis = 0; axis < 3; ++axis) {
    const double value = double_at(block_.data() + at_ + axis * sizeof value);
    if(!std::isfinite(value))
      throw Error(input_.name(), "point " + std::to_string(number_) + ": "
                  + std::string(1, "xyz"[axis]) + " is no finite number");
    point[axis] = axis < dimension_ ? value : 0;
  }
  at_ += bytes_per_point;
  ++number_;
  return true;
}

bool Point_stream::fill()
{
  bytes_->read(block_.data(), static_cast<std::streamsize>(block_.size()));
  if(bytes_->bad())
    throw Error(input_.name(), "cannot be read to its end");
  block_size_ = static_cast<std::size_t>(bytes_->gcount());
  at_ = 0;
  bytes_read_ += block_size_;
  if(bytes_->eof())
    input_.check_end(bytes_read_);
  if(block_size_ % bytes_per_point != 0)
    throw Error(input_.name(), "ends inside a point: three doubles have 24 bytes");
  return block_size_ != 0;
}

} // namespace near_pairs
