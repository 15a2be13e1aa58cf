// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_OBJECT_TRAITS_D_H
#define CGAL_THICK_OBJECT_TRAITS_D_H

// Objects that have a bounding box: segments, triangles, iso-boxes, tetrahedra, with radii or not,
// and variants.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDTraits

is the traits class for bounded objects with `bbox()` and `do_intersect()`. For objects of a kernel
of \cgal, the intersection test is that of the package, and exact on the coordinates that the
objects hold. Objects are closed sets: those that touch intersect. They may be degenerate: a segment
of length zero is a point, a flat triangle a segment or a point, and a flat tetrahedron a polygon, a
segment or a point. The test has degree 2 in the plane and 3 in space. If the coordinates are
doubles, whatever their type, a filter in doubles, integers and exact numbers decide, in this order.
Otherwise the orientations of the kernel decide if they are exact, or else those of rational
numbers. For objects of other classes, the test is the function `do_intersect()` in the namespace of
the class.

A search reads the bounding boxes of the objects as intervals, and tests the pairs whose boxes meet.
So objects may have any sizes. A `Bbox_2` or `Bbox_3`, and an iso-rectangle or iso-cuboid whose
coordinates are doubles, is its own box, and needs no further test.

The predicates of `ThickIntersectionTraits_d` compare the lower corners of the boxes. The reach
along an axis is the largest extent of a box along the axis: the lower corners of two boxes that
overlap are not farther apart \cgalCite{v-riato-03}. A search by boxes has no use for them.

A `std::pair` of such an object and a radius is the object *thickened* by the radius: all points
within the radius of it. So a point with a radius is a closed ball, and a segment with a radius, as
pipes, cables and roads have one each, is a capsule. Thickened objects intersect iff the distance of
the objects is at most the sum of the radii, which is not rounded. The test compares the squared
distance with the squared sum, in degree 4 in the plane and 6 in space, or 2 for two balls or a ball
and a point: a filter in doubles, integers of 128 bits and exact numbers decide, in this order. A
radius of zero thickens nothing. For balls alone, `Thick_ball_traits_d` is faster. Circles and
spheres are refused. `do_intersect()` takes them as curves and surfaces, so a circle within another
circle would not intersect it.

A `std::variant` of such types is an object: it is what it holds.

Objects of this class may be used by several threads at once.

An object of a class that derives from one of these, as a segment with an id does, is what its base
is. If `do_intersect()` takes the class itself, this is the test, as for objects of other classes.

Traits that derive from these may have other functors, which are asked in the place of the inherited
ones.

A radius may be of any number type, but of an integer type only if the coordinates are of this type:
a pair of an object and another integer may be an object with an index, and is refused when it is
compiled.

\tparam Object is `Point_2`, `Segment_2`, `Triangle_2`, `Iso_rectangle_2`, `Point_3`, `Segment_3`,
`Triangle_3`, `Iso_cuboid_3`, `Tetrahedron_3`, `Bbox_2`, `Bbox_3`, a pair of one of these and a
radius, a `std::variant` of all these types, or another type. Another type has a member function
`bbox()` that returns a `Bbox_2` or `Bbox_3` around the object, and a function
`do_intersect(const Object&, const Object&)` in its namespace. If it is a class of a kernel, the
predicates of the kernel must be exact.

\cgalModels{ThickIntersectionTraits_d}
\cgalModels{ThickIntersectionIntervalTraits_d}
*/
template <class Object>
class Thick_object_traits_d
{
  using Box = Thick_intersection_d::internal::Bounding_box_t<Object>;
  static constexpr int dimension_ = std::is_same_v<Box, Bbox_2> ? 2 : 3;
  using Extents = std::array<double, dimension_>;
  using Counts = Thick_intersection_d::internal::Shared_decision_counts;

  static_assert(!Thick_intersection_d::internal::Kinds<Object>::template is_any<
                  Thick_intersection_d::internal::Is_hypersphere>,
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
      return (box(a).min)(i) < (box(b).min)(i);
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
      const auto [low, high] = std::minmax({(box(a).min)(i), (box(b).min)(i)});
      return high - low <= reaches_[i];
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
      return do_overlap(box(a), box(b)) && decide(a, b);
    }

#ifndef DOXYGEN_RUNNING
    // The same of objects whose boxes meet.
    bool decide(const Object& a, const Object& b) const
    {
      Arithmetic_tier tier = do_boxes_decide ? Arithmetic_tier::DOUBLE : least_tier_;
      const bool do_intersect
        = do_boxes_decide || Thick_intersection_d::internal::do_objects_intersect(a, b, tier);
      if(counts_ != nullptr)
        counts_->add(tier);
      return do_intersect;
    }
#endif

  private:
    friend class Thick_object_traits_d;
    Arithmetic_tier least_tier_ = Arithmetic_tier::INT64;
    Counts* counts_ = nullptr;
  };

  /// gives the bounding box of an object, one axis at a time.
  class Interval_d
  {
  public:
    /// returns the ends of the box of `a` along axis `i`.
    std::pair<double, double> operator()(const Object& a, int i) const
    {
      const Box& box_of_a = box(a);
      return {(box_of_a.min)(i), (box_of_a.max)(i)};
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
  // Throws if a coordinate of `object` is NaN or infinite. If the objects are those of two ranges,
  // `object` is of the type of one of them. Traits that derive from these may have other objects.
  template <class Given,
            class = std::enable_if_t<
              Thick_intersection_d::internal::Is_object_of<Given, Object>::value>>
  void check(const Given& object, std::size_t position) const
  {
    Thick_intersection_d::internal::settle(object);
    Thick_intersection_d::internal::check_object(object, position);
  }

  // For the box route, which asks for whole boxes. If objects are boxes of doubles themselves,
  // their boxes decide whether they intersect.
  static decltype(auto) box(const Object& object)
  {
    return Thick_intersection_d::internal::bounding_box(object);
  }
  static constexpr bool do_boxes_decide
    = Thick_intersection_d::internal::Kinds<Object>::template are_all<
        Thick_intersection_d::internal::Is_box_of_doubles>
      && !Thick_intersection_d::internal::has_own_tests_v<Object>;

  // From now on, the intersection test takes `tier` as the first arithmetic after the filter, and
  // counts which arithmetic decides.
  void decide_by(Arithmetic_tier tier, Counts& counts)
  {
    do_intersect_.least_tier_ = tier;
    do_intersect_.counts_ = &counts;
  }
  bool is_counting() const { return do_intersect_.counts_ != nullptr; }
#endif

  /// \name Operations
  /// @{

  /// returns the dimension of the objects.
  int dimension() const { return dimension_; }

  /// returns the comparison of lower corners along axes.
  Less_coordinate_d less_coordinate_d_object() const { return Less_coordinate_d(); }

  /// returns the test for close lower corners.
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return Is_close_along_axis_d(reaches_);
  }

  /// returns the test for objects that intersect.
  Do_intersect_d do_intersect_d_object() const { return do_intersect_; }

  /// returns the functor of intervals.
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
      const Box box_of_object = box(object);
      for(int i = 0; i < dimension_; ++i)
        reaches_[i]
          = (std::max)(reaches_[i], (box_of_object.max)(i) - (box_of_object.min)(i));
    }
  }

  Extents reaches_ = {};
  Do_intersect_d do_intersect_;
};

} // namespace CGAL

#endif // CGAL_THICK_OBJECT_TRAITS_D_H
