// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_TABLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_TABLE_H

// The buckets of [L] (Closest_pair_search.h): the members of a set by their cells. The sorted order
// finds the buckets of adjacent cells.
//
// A cell has a number along each axis. The numbers may be rounded coordinates, or numbers of strips
// that comparisons have found. The number of points that fit in a cell if no two of them are close
// bounds the work of [L].

#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Cell_number = std::uint32_t;

// Numbers the strips of elements that come in order along an axis. A strip ends behind the last
// element within a distance of its first element. So elements within the distance are in one strip
// or in adjacent strips.
template <class Element, class Is_beyond>
class Strip_numbering
{
public:
  // is_beyond(b, a) returns whether b, which comes behind a, is beyond the distance from a.
  explicit Strip_numbering(const Is_beyond& is_beyond) : is_beyond_(is_beyond) {}

  // Returns the number of the strip of the next element. The first strip has number 1.
  Cell_number operator()(const Element& element)
  {
    if(number_ == 0 || is_beyond_(element, first_)) {
      ++number_;
      first_ = element;
    }
    return number_;
  }

private:
  Is_beyond is_beyond_;
  Element first_ = Element(); // the first element of the strip
  Cell_number number_ = 0;
};

// The offsets from a cell to adjacent cells, but only the lexicographically positive half: with the
// other half, each two buckets would meet twice.
class Forward_offsets
{
public:
  explicit Forward_offsets(int axis_count)
  {
    std::vector<int> offset(axis_count, -1);
    while(true) {
      if(std::vector<int>(axis_count, 0) < offset)
        offsets_.push_back(offset);
      int axis = axis_count - 1; // the next offset in lexicographic order
      for(; axis >= 0 && offset[axis] == 1; --axis)
        offset[axis] = -1;
      if(axis < 0)
        return;
      ++offset[axis];
    }
  }

  std::size_t size() const { return offsets_.size(); }
  const std::vector<int>& operator[](std::size_t i) const { return offsets_[i]; }

private:
  std::vector<std::vector<int>> offsets_;
};

class Cell_table
{
public:
  // Puts the members [0, size) into buckets, in linear time. number_of(member, axis) is from 1 to
  // 2^32 - 2. Members of a bucket keep their order.
  template <class Number_of>
  Cell_table(std::size_t size, int axis_count, const Number_of& number_of)
    : axis_count_(axis_count), items_(size)
  {
    for(std::size_t i = 0; i < size; ++i)
      items_[i] = {0, static_cast<std::uint32_t>(i)};
    begins_ = {0, size};

    // Invariant: the items are sorted by their numbers along the previous axes. The upper half of a
    // key is the rank of these numbers.
    for(int axis = 0; axis < axis_count; ++axis) {
      for(Keyed_value& item : items_)
        item.key |= number_of(item.value, axis);
      radix_sort(items_);
      rank_keys();
    }
    for(std::size_t bucket = 0; bucket < bucket_count(); ++bucket)
      for(int axis = 0; axis < axis_count; ++axis)
        numbers_.push_back(number_of(items_[begins_[bucket]].value, axis));
  }

  std::size_t bucket_count() const { return begins_.size() - 1; }
  std::size_t begin(std::size_t bucket) const { return begins_[bucket]; }
  std::size_t end(std::size_t bucket) const { return begins_[bucket + 1]; }

  // Returns the member at a place between the begin and the end of a bucket.
  std::uint32_t member(std::size_t place) const { return items_[place].value; }

  // Returns the number of the cell of a bucket along an axis.
  Cell_number number(std::size_t bucket, int axis) const
  {
    return numbers_[bucket * axis_count_ + axis];
  }

  // Compares the cell of a bucket with the cell of another bucket, shifted by an offset. Returns a
  // negative number, zero or a positive number if the first cell is before, equal or after.
  int compare(std::size_t bucket, std::size_t other, const std::vector<int>& offset) const
  {
    for(int axis = 0; axis < axis_count_; ++axis) {
      const Cell_number x = number(bucket, axis);
      const Cell_number y = number(other, axis) + offset[axis];
      if(x != y)
        return x < y ? -1 : 1;
    }
    return 0;
  }

private:
  // Finds the buckets of the sorted items, and sets the upper half of each key to the rank of the
  // bucket.
  void rank_keys()
  {
    begins_.clear();
    std::uint64_t previous = 0;
    for(std::size_t place = 0; place < items_.size(); ++place) {
      const std::uint64_t key = items_[place].key;
      if(place == 0 || key != previous)
        begins_.push_back(place);
      previous = key;
      items_[place].key = std::uint64_t(begins_.size() - 1) << 32;
    }
    begins_.push_back(items_.size());
  }

  int axis_count_;
  std::vector<Keyed_value> items_;
  std::vector<std::size_t> begins_;
  std::vector<Cell_number> numbers_;
};

// Finds buckets by the sorted order. For each offset, the buckets to find come in order as well. So
// a finger per offset moves forward only, and finding all buckets takes linear time. The fingers
// start at the first bucket that is asked for: the buckets to find are behind it.
class Sorted_bucket_finder
{
public:
  Sorted_bucket_finder(const Cell_table& table, const Forward_offsets& offsets, std::size_t first)
    : table_(table), offsets_(offsets), fingers_(offsets.size(), first)
  {}

  // Returns the bucket at offset `i` from `bucket`, or bucket_count() if it is empty. Calls are to
  // pass increasing buckets.
  std::size_t operator()(std::size_t bucket, std::size_t i)
  {
    std::size_t& finger = fingers_[i];
    while(finger != table_.bucket_count() && table_.compare(finger, bucket, offsets_[i]) < 0)
      ++finger;
    return finger != table_.bucket_count() && table_.compare(finger, bucket, offsets_[i]) == 0
             ? finger
             : table_.bucket_count();
  }

private:
  const Cell_table& table_;
  const Forward_offsets& offsets_;
  std::vector<std::size_t> fingers_;
};

// Returns N = (floor(sqrt(D)) + 1)^D, or a large number if N is larger: 4 in the plane, 8 in space.
//
// Lemma. Of more than N points in a closed cube of side r in dimension D, two are closer than r.
// Proof: divide the edges of the cube into m = floor(sqrt(D)) + 1 equal parts. Two of the points
// are in one of the m^D small closed cubes. Their distance is at most r sqrt(D) / m < r.
//
// So N serves closed bounds, where pairs at distance r are close, and open bounds. It also serves
// cubes that are larger than r by less than the factor m / sqrt(D). In the plane the best constants
// differ. For an open bound 4 points fit, the corners of the square. For a closed bound 3 points
// fit: among any 4 points in the plane, some three have an angle of 90 degrees or more. If all
// distances are more than r, the distance of the outer two points is more than sqrt(2) r, the
// diagonal of the square.
inline std::size_t max_points_per_cell(int dimension)
{
  const double parts = std::floor(std::sqrt(static_cast<double>(dimension))) + 1;
  return static_cast<std::size_t>((std::min)(std::pow(parts, dimension), 1e9));
}

// Returns the number of cells of the strip that touch a cell, itself included: the strip of the
// divide and conquer is cut along all axes but the first and the last.
inline double touching_cell_count(int dimension)
{
  return std::pow(3., (std::max)(dimension - 2, 0));
}

// Returns a bound on the number of points that a point of the strip is compared with.
// Closest_pair_divide.h proves it.
inline std::size_t max_candidate_count(int dimension)
{
  const double candidates = 2 * static_cast<double>(max_points_per_cell(dimension))
                            * touching_cell_count(dimension) - 1;
  return static_cast<std::size_t>((std::min)(candidates, 1e9));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_TABLE_H
