// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_ELEMENT_CALLBACK_H
#define CGAL_ELEMENT_CALLBACK_H

// A callback that takes the user's elements instead of their positions.

#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

marks a callback that takes the elements of ranges instead of their positions. `with_elements()`
makes it.

\tparam Callback is the type of the callback, or a reference to it.
*/
template <class Callback>
class Element_callback
{
public:
  /// takes the callback, or refers to it.
  explicit Element_callback(Callback&& callback) : callback_(std::forward<Callback>(callback)) {}

  /// returns the callback.
  Callback& callback() { return callback_; }

  /// returns the callback. It is constant unless the mark refers to it.
  std::add_const_t<Callback>& callback() const { return callback_; }

private:
  Callback callback_;
};

/*!
\ingroup PkgThickIntersectionDRef

returns a callback that hands over two elements of the user's ranges instead of their positions, for
all searches that report pairs: of points, objects, boxes, features, tracks or images.

The elements are what the iterators of the ranges refer to. A property map given as `point_map`
does not change them. So a search of the vertices of a mesh hands over descriptors of vertices:

\code{.cpp}
std::vector<std::pair<Vertex, Vertex>> pairs;
CGAL::fixed_radius_near_neighbors(
  mesh.vertices(), CGAL::within_distance(0.1), CGAL::with_elements(std::back_inserter(pairs)),
  CGAL::parameters::point_map(mesh.points()));
\endcode

An element is looked up when its pair is reported. This costs nothing else if the iterators have
random access.

\param callback is a functor that takes two elements, or an output iterator that takes `std::pair`
of copies of them. The functor returns `void`, or `bool` to stop the search by returning `false`. If
the argument is an lvalue, the result refers to it.
*/
template <class Callback>
Element_callback<Callback> with_elements(Callback&& callback)
{
  return Element_callback<Callback>(std::forward<Callback>(callback));
}

} // namespace CGAL

#endif // CGAL_ELEMENT_CALLBACK_H
