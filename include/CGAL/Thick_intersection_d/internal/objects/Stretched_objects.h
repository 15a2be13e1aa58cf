// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_STRETCHED_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_STRETCHED_OBJECTS_H

// Two sets of objects as the box route reads them, with the segments of one set in stretches.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Stretches.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A stretch of a segment. Another object is one stretch.
struct Stretch
{
  std::size_t object;
  Place index;
  Place count; // of the stretches of the object
};

// `Objects` are like Segments_and_others. Positions are those of stretches, in the order of the
// objects.
template <class Objects>
class Stretched_objects : public Objects_in_boxes<Objects::dimension>
{
public:
  // `counts` has the number of stretches of each object of the set that begins with `first`.
  Stretched_objects(const Objects& objects, const Two_sets& sets, std::size_t first,
                    const std::vector<Place>& counts)
    : objects_(objects), sets_(sets), first_(first), begins_(counts.size() + 1)
  {
    std::partial_sum(counts.begin(), counts.end(), begins_.begin() + 1);
    stretch_objects_.reserve(begins_.back());
    for(std::size_t i = 0; i < counts.size(); ++i)
      stretch_objects_.insert(stretch_objects_.end(), counts[i], static_cast<Place>(i));
    added_ = begins_.back() - counts.size();
  }

  std::size_t size() const { return objects_.size() + added_; }

  Two_sets sets() const { return {sets_.first_size + (first_ == 0 ? added_ : 0)}; }

  // Returns the positions of two objects in their sets, by those of stretches in theirs.
  std::pair<std::size_t, std::size_t> objects_of(std::size_t i, std::size_t j) const
  {
    return {stretch_at(i).object, stretch_at(j + sets().first_size).object - sets_.first_size};
  }

  auto intervals(std::size_t position) const
  {
    return [box = objects_.box(stretch_at(position))](int axis) { return box[axis]; };
  }

  void prefetch(std::size_t position) const { objects_.prefetch(stretch_at(position).object); }

  // A pair of objects is one of the first stretch whose box meets that of the other object.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const Stretch a = stretch_at(i), b = stretch_at(j);
    return !meets_before(a, b) && !meets_before(b, a) && objects_.do_intersect(a.object, b.object);
  }

private:
  Stretch stretch_at(std::size_t position) const
  {
    if(position < first_)
      return {position, 0, 1};
    const std::size_t stretch = position - first_;
    if(stretch >= stretch_objects_.size())
      return {position - added_, 0, 1};
    const Place object = stretch_objects_[stretch], begin = begins_[object];
    return {first_ + object, static_cast<Place>(stretch) - begin, begins_[object + 1] - begin};
  }

  // Whether the box of the stretch before `a`, of the same object, meets that of `b`.
  bool meets_before(const Stretch& a, const Stretch& b) const
  {
    if(a.index == 0)
      return false;
    return do_boxes_meet(objects_.box({a.object, a.index - 1, a.count}), objects_.box(b));
  }

  const Objects& objects_;
  const Two_sets sets_;                // of objects
  const std::size_t first_;            // the first object of the set that is cut
  std::vector<Place> begins_;          // of the stretches of each object of this set
  std::vector<Place> stretch_objects_; // which object of this set a stretch is of
  std::size_t added_;                  // how many more stretches than objects there are
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_STRETCHED_OBJECTS_H
