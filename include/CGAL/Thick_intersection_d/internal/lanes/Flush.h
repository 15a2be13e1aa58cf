// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FLUSH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FLUSH_H

// What lanes call when they have found many pairs.


namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Does not own the function. The call returns false to stop.
class Flush
{
public:
  template <class Function>
  explicit Flush(const Function& function)
    : function_(&function),
      call_([](const void* f) { return (*static_cast<const Function*>(f))(); })
  {}

  bool operator()() const { return call_(function_); }

private:
  const void* function_;
  bool (*call_)(const void*);
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FLUSH_H
