// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_LIMITED_OUTPUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_LIMITED_OUTPUT_H

// Writes pairs to an output iterator of the user, from any thread, up to a number of pairs.

#include <cstddef>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Iterator>
class Limited_output
{
public:
  Limited_output(Iterator out, std::size_t max_count) : out_(out), left_(max_count) {}

  // Writes a pair if there is room for it. Returns whether there is room for another one.
  template <class T>
  bool write(const T& a, const T& b)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(left_ == 0)
      return false;
    *out_++ = std::pair<T, T>(a, b);
    --left_;
    return left_ != 0;
  }

  bool is_full() const { return left_ == 0; }
  Iterator iterator() const { return out_; }

private:
  Iterator out_;
  std::size_t left_;
  std::mutex mutex_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_LIMITED_OUTPUT_H
