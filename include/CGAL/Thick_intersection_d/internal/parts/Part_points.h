// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_POINTS_H

// The points of a part, with their ids, and the bytes that they are sent as.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
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

// Returns two ids, the lesser one first. There is no branch: it would be mispredicted for half of
// the pairs, and take a quarter of a search.
inline std::pair<std::uint64_t, std::uint64_t> ids_in_order(std::uint64_t i, std::uint64_t j)
{
  const std::uint64_t difference = (i ^ j) & (0 - static_cast<std::uint64_t>(j < i));
  return {i ^ difference, j ^ difference};
}

// The points of one set that a part has: its own come first, then those it has received because
// they are near. Ids are in a column of their own: a search reports positions, and each pair looks
// up two ids.
template <class Carried>
struct Part_points
{
  std::vector<Carried> points;
  std::vector<std::uint64_t> ids;
  std::size_t own_size = 0;
  std::uint64_t first_id = 0;
  std::size_t consecutive_size = 0; // the ids of so many points follow each other

  std::size_t size() const { return points.size(); }

  // Looks up an id only if it has to: two ids for each pair are as much work as the pair itself.
  std::uint64_t id(std::size_t i) const { return i < consecutive_size ? first_id + i : ids[i]; }

  void reserve(std::size_t size)
  {
    reserve_huge_pages(points, size);
    reserve_huge_pages(ids, size);
  }

  void resize(std::size_t size)
  {
    points.resize(size);
    ids.resize(size);
  }

  void add(Carried point, std::uint64_t id)
  {
    points.push_back(std::move(point));
    ids.push_back(id);
  }

  // Moves a point to another place. A point that stays is left alone: vectors do not survive a move
  // to themselves.
  void move(std::size_t from, std::size_t to)
  {
    if(from == to)
      return;
    points[to] = std::move(points[from]);
    ids[to] = ids[from];
  }

  static std::size_t packed_size(int dimension)
  {
    return sizeof(std::uint64_t) + Carried::packed_size(dimension);
  }

  void pack(std::size_t i, std::vector<char>& bytes) const
  {
    write_bytes(&ids[i], 1, bytes);
    points[i].pack(bytes);
  }

  // Adds all points that were packed.
  void unpack(const std::vector<char>& bytes, int dimension)
  {
    for(Byte_reader reader(bytes); !reader.is_at_end();) {
      std::uint64_t id;
      reader.read(&id, 1);
      ids.push_back(id);
      points.emplace_back();
      points.back().unpack(reader, dimension);
    }
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_POINTS_H
