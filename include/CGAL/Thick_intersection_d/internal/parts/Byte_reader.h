// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BYTE_READER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BYTE_READER_H

// Reads what was written to a sequence of bytes.

#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers are written as they are in memory: all processes of a job are of one program.
template <class Number>
void write_bytes(const Number* numbers, std::size_t count, std::vector<char>& bytes)
{
  const char* const first = reinterpret_cast<const char*>(numbers);
  bytes.insert(bytes.end(), first, first + count * sizeof(Number));
}

class Byte_reader
{
public:
  explicit Byte_reader(const std::vector<char>& bytes)
    : next_(bytes.data()), end_(bytes.data() + bytes.size())
  {}

  bool is_at_end() const { return next_ == end_; }

  template <class Number>
  void read(Number* numbers, std::size_t count)
  {
    std::memcpy(numbers, next_, count * sizeof(Number));
    next_ += count * sizeof(Number);
  }

private:
  const char* next_;
  const char* end_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BYTE_READER_H
