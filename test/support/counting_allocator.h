// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Replaces the global operator new and delete by ones that count bytes, and that fail when told to.
// To be included by exactly one source file of one test program: replacements cannot be inline.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_COUNTING_ALLOCATOR_H
#define THICK_INTERSECTION_TEST_SUPPORT_COUNTING_ALLOCATOR_H

#include "standard_library.h"

namespace test_support {

inline std::atomic<std::size_t> current_byte_count{0};
inline std::atomic<std::size_t> peak_byte_count{0};

inline std::size_t current_bytes() { return current_byte_count; }

// The most bytes that were allocated at one time since the last reset_peak(), those included that
// were there already.
inline std::size_t peak_bytes() { return peak_byte_count; }

inline void reset_peak() { peak_byte_count = current_byte_count.load(); }

// The most bytes that f takes at one time. It gives all of them back.
template <class Function>
std::size_t bytes_taken_by(const Function& f)
{
  reset_peak();
  const std::size_t before = current_bytes();
  f();
  if(current_bytes() != before)
    throw std::logic_error("Bytes are lost.");
  return peak_bytes() - before;
}

inline std::atomic<std::size_t> allocations_left{static_cast<std::size_t>(-1)};

// While it lives, memory runs out after so many allocations.
class Memory_that_runs_out
{
public:
  explicit Memory_that_runs_out(std::size_t allocations) { allocations_left = allocations; }
  ~Memory_that_runs_out() { allocations_left = static_cast<std::size_t>(-1); }
  Memory_that_runs_out(const Memory_that_runs_out&) = delete;
  Memory_that_runs_out& operator=(const Memory_that_runs_out&) = delete;
};

// Throws if memory has run out.
inline void take_allocation()
{
  if(allocations_left == static_cast<std::size_t>(-1))
    return;
  if(allocations_left == 0)
    throw std::bad_alloc();
  --allocations_left;
}

inline void count_allocation(std::size_t size)
{
  const std::size_t now = current_byte_count += size;
  std::size_t peak = peak_byte_count;
  while(now > peak && !peak_byte_count.compare_exchange_weak(peak, now)) {}
}

// The size asked for is kept in front of each block, in a room that preserves the alignment.
inline std::size_t header_size(std::size_t alignment)
{
  return alignment < sizeof(std::size_t) ? sizeof(std::size_t) : alignment;
}

inline void* counted_allocate(std::size_t size, std::size_t alignment)
{
  take_allocation();
  const std::size_t header = header_size(alignment);
  if(size > static_cast<std::size_t>(-1) - 2 * header)
    throw std::bad_alloc();
  const std::size_t whole = (size + 2 * header - 1) / header * header; // a multiple, as C11 asks
  char* block = static_cast<char*>(std::aligned_alloc(header, whole));
  if(block == nullptr)
    throw std::bad_alloc();
  std::memcpy(block, &size, sizeof(size));
  count_allocation(size);
  return block + header;
}

inline void* counted_allocate_or_null(std::size_t size, std::size_t alignment) noexcept
{
  try {
    return counted_allocate(size, alignment);
  }
  catch(const std::bad_alloc&) {
    return nullptr;
  }
}

inline void counted_deallocate(void* pointer, std::size_t alignment) noexcept
{
  if(pointer == nullptr)
    return;
  char* block = static_cast<char*>(pointer) - header_size(alignment);
  std::size_t size;
  std::memcpy(&size, block, sizeof(size));
  current_byte_count -= size;
  std::free(block);
}

} // namespace test_support

// All forms are replaced, not only those that the others of the standard library call: a sanitizer
// brings its own others, and a block must be freed by the family that allocated it.

void* operator new(std::size_t size)
{
  return test_support::counted_allocate(size, alignof(std::max_align_t));
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return test_support::counted_allocate_or_null(size, alignof(std::max_align_t));
}

void operator delete(void* pointer) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void operator delete(void* pointer, std::size_t) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void operator delete(void* pointer, const std::nothrow_t&) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  return test_support::counted_allocate(size, static_cast<std::size_t>(alignment));
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return test_support::counted_allocate_or_null(size, static_cast<std::size_t>(alignment));
}

void operator delete(void* pointer, std::align_val_t alignment) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

void operator delete(void* pointer, std::size_t, std::align_val_t alignment) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

void operator delete(void* pointer, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

void* operator new[](std::size_t size)
{
  return test_support::counted_allocate(size, alignof(std::max_align_t));
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return test_support::counted_allocate_or_null(size, alignof(std::max_align_t));
}

void operator delete[](void* pointer) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void operator delete[](void* pointer, std::size_t) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void operator delete[](void* pointer, const std::nothrow_t&) noexcept
{
  test_support::counted_deallocate(pointer, alignof(std::max_align_t));
}

void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return test_support::counted_allocate(size, static_cast<std::size_t>(alignment));
}

void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return test_support::counted_allocate_or_null(size, static_cast<std::size_t>(alignment));
}

void operator delete[](void* pointer, std::align_val_t alignment) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

void operator delete[](void* pointer, std::size_t, std::align_val_t alignment) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

void operator delete[](void* pointer, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  test_support::counted_deallocate(pointer, static_cast<std::size_t>(alignment));
}

#endif // THICK_INTERSECTION_TEST_SUPPORT_COUNTING_ALLOCATOR_H
