// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_OBJECT_TRAITS_D_H
#define CGAL_THICK_OBJECT_TRAITS_D_H

// Objects of a kernel that have a bounding box: segments, triangles, iso-boxes, tetrahedra.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/input/check_vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDTraits

is the traits class for bounded objects of a kernel of \cgal with `bbox()` and `do_intersect()`. The
intersection test is exact on the coordinates that the objects hold. It is the test of the kernel if
the kernel has exact predicates. Otherwise, as for `Simple_cartesian<double>`, it is the test of a
kernel with exact predicates.

A search reads the bounding boxes of the objects as intervals, and tests the pairs whose boxes meet.
So objects may have any sizes. Iso-rectangles and iso-cuboids whose coordinates are doubles are
their own boxes, and need no further test.

The predicates of `ThickIntersectionTraits_d` compare the lower corners of the boxes. The reach
along an axis is the largest extent of a box along the axis: the lower corners of two boxes that
overlap are not farther apart \cgalCite{v-riato-03}. A search uses these predicates for
2<sup>31</sup> objects or more, which the numbers of boxes do not count.

Circles and spheres are refused. `do_intersect()` takes them as curves and surfaces, so a circle
within another circle would not intersect it. Use `Thick_ball_traits_d`.

Objects of this class may be used by several threads at once.

\tparam Object is `Segment_2`, `Triangle_2`, `Iso_rectangle_2`, `Segment_3`, `Triangle_3`,
`Iso_cuboid_3`, `Tetrahedron_3`, or another type with `bbox()`, `do_intersect()` and
`Kernel_traits`.

\cgalModels{ThickIntersectionTraits_d}
\cgalModels{ThickIntersectionIntervalTraits_d}
*/
template <class Object>
class Thick_object_traits_d
{
  using Box = decltype(std::declval<const Object&>().bbox());
  static constexpr int dimension_ = std::is_same_v<Box, Bbox_2> ? 2 : 3;
  using Extents = std::array<double, dimension_>;

  static_assert(!Thick_intersection_d::internal::Is_hypersphere<Object>::value,
                "do_intersect() takes circles and spheres as curves and surfaces: "
                "use Thick_ball_traits_d.");

public:
  /// \name Types
  /// @{

  /// the objects.
  using Object_d = Object;

  /// compares the lower corners of the boxes of two objects along an axis.
  class Less_coordinate_d
  {
  public:
    /// returns whether the box of `a` begins before the box of `b` along axis `i`.
    bool operator()(const Object& a, const Object& b, int i) const
    {
      return (a.bbox().min)(i) < (b.bbox().min)(i);
    }
  };

  /// bounds the distance of the lower corners of the boxes of two objects along an axis.
  class Is_close_along_axis_d
  {
  public:
    /// returns whether the lower corners differ by at most the reach along axis `i`. Difference and
    /// reach are rounded in the same way.
    bool operator()(const Object& a, const Object& b, int i) const
    {
      return std::fabs((a.bbox().min)(i) - (b.bbox().min)(i)) <= reaches_[i];
    }

  private:
    friend class Thick_object_traits_d;
    explicit Is_close_along_axis_d(const Extents& reaches) : reaches_(reaches) {}
    Extents reaches_;
  };

  /// decides whether two objects intersect.
  class Do_intersect_d
  {
  public:
    /// returns whether `a` and `b` have a point in common.
    bool operator()(const Object& a, const Object& b) const
    {
      return do_overlap(a.bbox(), b.bbox())
             && Thick_intersection_d::internal::do_objects_intersect(a, b);
    }
  };

  /// gives the bounding box of an object, one axis at a time.
  class Interval_d
  {
  public:
    /// returns the ends of the box of `a` along axis `i`.
    std::pair<double, double> operator()(const Object& a, int i) const
    {
      const auto box = Thick_object_traits_d::box(a);
      return {(box.min)(i), (box.max)(i)};
    }
  };

  /// the dimension of the objects.
  using Dimension = Dimension_tag<dimension_>;

  /// @}
  /// \name Creation
  /// @{

  /// constructs the traits for the objects of the given ranges, in one pass over their boxes.
  template <class... ObjectRange>
  explicit Thick_object_traits_d(const ObjectRange&... objects)
  {
    (add(objects), ...);
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  // Throws if a coordinate of `object` is NaN or infinite.
  void check(const Object& object, std::size_t position) const
  {
    Thick_intersection_d::internal::settle(object);
    Thick_intersection_d::internal::check_vertices(object, position);
  }

  // For the box route, which asks for whole boxes. If objects are boxes of doubles themselves,
  // their boxes decide whether they intersect.
  static Box box(const Object& object) { return object.bbox(); }
  static constexpr bool do_boxes_decide
    = Thick_intersection_d::internal::Is_box_of_doubles<Object>::value;
#endif

  /// \name Operations
  /// @{

  /// returns the dimension of the objects.
  int dimension() const { return dimension_; }

  Less_coordinate_d less_coordinate_d_object() const { return Less_coordinate_d(); }
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return Is_close_along_axis_d(reaches_);
  }
  Do_intersect_d do_intersect_d_object() const { return Do_intersect_d(); }
  Interval_d interval_d_object() const { return Interval_d(); }

  /// @}

private:
  // Extents are rounded like the differences that are compared with them. Rounding is monotone, so
  // a lower corner within the true extent is within the rounded extent as well.
  template <class ObjectRange>
  void add(const ObjectRange& objects)
  {
    for(const Object& object : objects) {
      Thick_intersection_d::internal::settle(object);
      const Box box = object.bbox();
      for(int i = 0; i < dimension_; ++i)
        reaches_[i] = (std::max)(reaches_[i], (box.max)(i) - (box.min)(i));
    }
  }

  Extents reaches_ = {};
};

} // namespace CGAL

#endif // CGAL_THICK_OBJECT_TRAITS_D_H
