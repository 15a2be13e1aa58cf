// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PLAIN_ARRAY_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PLAIN_ARRAY_H

// An array of numbers that is not cleared before they are written. One thread would clear a vector,
// while all others wait.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The numbers are in the vector that they came in, or in memory of the array's own. An array that
// was moved from is empty.
template <class T>
class Plain_array
{
public:
  using value_type = T;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = const T&;
  using const_reference = const T&;
  using iterator = const T*;
  using const_iterator = const T*;

  Plain_array() = default;
  Plain_array(std::vector<T> numbers)
    : vector_(std::move(numbers)), data_(vector_.data()), size_(vector_.size()), capacity_(size_)
  {}
  Plain_array(const Plain_array& other) : Plain_array(std::vector<T>(other)) {}
  Plain_array(Plain_array&& other) noexcept { swap(other); }
  Plain_array& operator=(Plain_array other) noexcept
  {
    swap(other);
    return *this;
  }

  // Makes room for so many numbers, and returns where to write them. Those before are lost.
  T* require(std::size_t size)
  {
    if(size > capacity_) {
      *this = Plain_array(); // before the allocation, so that only one array exists at a time
      own_ = make_uninitialized<T>(size);
      data_ = own_.get();
      capacity_ = size;
    }
    size_ = size;
    return data_;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T* data() const { return data_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  const T& front() const { return data_[0]; }
  const T& back() const { return data_[size_ - 1]; }

  operator std::vector<T>() const& { return std::vector<T>(begin(), end()); }

  // Moves a vector out that the numbers are in.
  operator std::vector<T>() &&
  {
    if(own_)
      return std::vector<T>(begin(), end());
    Plain_array moved(std::move(*this));
    moved.vector_.resize(moved.size_);
    return std::move(moved.vector_);
  }

  friend bool operator==(const Plain_array& a, const Plain_array& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  friend bool operator!=(const Plain_array& a, const Plain_array& b) { return !(a == b); }

private:
  void swap(Plain_array& other) noexcept
  {
    vector_.swap(other.vector_);
    own_.swap(other.own_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  std::vector<T> vector_;
  std::unique_ptr<T[]> own_;
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PLAIN_ARRAY_H
