// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_UNINITIALIZED_MEMORY_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_UNINITIALIZED_MEMORY_H

// Memory that the program writes before it reads it.

#include <CGAL/Thick_intersection_d/internal/machine/huge_pages.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns memory that is not cleared.
template <class T>
std::unique_ptr<T[]> make_uninitialized(std::size_t size)
{
  std::unique_ptr<T[]> memory(new T[size]);
  advise_huge_pages(memory.get(), size * sizeof(T));
  return memory;
}

// Makes room for values, as `reserve()` does. Most of the time of moving them there is that of
// touching fresh memory.
template <class Value>
void reserve_huge_pages(std::vector<Value>& values, std::size_t size)
{
  if(size <= values.capacity())
    return;
  values.reserve(size);
  advise_huge_pages(values.data() + values.size(), (size - values.size()) * sizeof(Value));
}

template <class Value>
std::vector<Value> zeros_on_huge_pages(std::size_t size)
{
  std::vector<Value> zeros;
  reserve_huge_pages(zeros, size);
  zeros.resize(size);
  return zeros;
}

// Memory that is used again and again, and grows when more is required.
template <class T>
class Buffer
{
public:
  // Returns memory for `size` elements. Elements that were there before may be lost.
  T* require(std::size_t size)
  {
    if(!data_ || size > size_) { // moved from, or too small
      data_.reset(); // before the allocation, so that only one array exists at a time
      size_ = size + size / 64; // sizes of slabs differ a little
      data_ = make_uninitialized<T>(size_);
    }
    return data_.get();
  }

  T* data() const { return data_.get(); }

private:
  std::unique_ptr<T[]> data_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_UNINITIALIZED_MEMORY_H
