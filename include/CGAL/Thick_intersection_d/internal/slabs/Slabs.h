// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H

// The points of one or two sets in the order of their slabs: the divide step of [V03], made
// multiway. [V03] is cited in Recursive_route.h.

#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_columns.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Columns` are Slab_columns if slabs that are too few for all threads are to be cut into columns.
template <class Point, class Columns = One_column>
class Slabs
{
public:
  using Sets = Point_sets;

  // Takes the `size` points of `source`. The source has the functions interval(axis),
  // coordinate(position, axis) and put(position, place).
  template <class ConcurrencyTag, class Source>
  Slabs(ConcurrencyTag, const Source& source, std::size_t size, double reach,
        const Point_sets& sets = Point_sets(), const Slab_tuning& tuning = Slab_tuning())
    : sets_(sets)
  {
    find_axes(source);
    const Place places = static_cast<Place>(size);
    const Interval trimmed = trim(source, places);
    const double count = piece_count(trimmed, places, reach, tuning.points_per_slab);
    const Equal_cut cut(trimmed, (std::min)(count, max_slab_count));
    if constexpr(may_have_columns)
      if(!sets.are_two() && !are_flat() && places < Column_sets::border_bit)
        cut_columns(source.interval(column_axis), cut.count(), places, reach,
                    block_count<ConcurrencyTag>(), tuning.points_per_column);
    if(are_flat())
      distribute<ConcurrencyTag>(source, cut, places, flat_points_);
    else
      distribute<ConcurrencyTag>(source, cut, places, points_);
  }

  const Point_sets& sets() const { return sets_; }

  // The number of slabs in each column. The slabs of a column follow those of the column before.
  Place count() const { return (static_cast<Place>(begins_.size()) - 1) / columns_.count(); }
  const Columns& columns() const { return columns_; }

  Place size() const { return begins_.back(); }
  Place size(Place slab) const { return begins_[slab + 1] - begins_[slab]; }

  // Returns the first point of a slab, and sets their number. The points are in `buffer` unless
  // they are stored whole.
  const Point* points(Place slab, Buffer<Point>& buffer, Place& number) const
  {
    number = size(slab);
    if(!are_flat())
      return points_.get() + begins_[slab];
    const Flat_point* const first = flat_points_.get() + begins_[slab];
    Point* const points = buffer.require(size(slab));
    std::transform(first, first + size(slab), points, [&](const Flat_point& p) {
      Point whole;
      whole.x[0] = p.x[0];
      whole.x[1] = flat_coordinate_;
      whole.x[axis] = p.x[1];
      whole.position = p.position;
      return whole;
    });
    return points;
  }

  // Returns the slabs [first, last) of one of `count` blocks with about equal numbers of points.
  std::pair<Place, Place> block(std::size_t index, std::size_t count) const
  {
    const auto first_behind = [&](std::size_t points) {
      const auto slab = std::lower_bound(begins_.begin(), begins_.end(), points);
      return static_cast<Place>(slab - begins_.begin());
    };
    return {first_behind(index * size() / count), first_behind((index + 1) * size() / count)};
  }

private:
  using Number = typename Point::Number;

  // Points in a plane of space are stored without the axis along which they do not differ. It
  // becomes axis 1 when they leave, so that strips are whole slabs, as those of the plane are.
  struct Flat_point
  {
    std::array<Number, 2> x;
    Place position;
  };

  static constexpr int axis = Point::slab_axis;
  static constexpr int column_axis = axis - 1;
  static constexpr bool may_have_columns = !std::is_same_v<Columns, One_column>;

  // How many points ahead the memory that a point goes to is asked for.
  static constexpr int distance = 16;

  template <class Source>
  void find_axes(const Source& source)
  {
    if constexpr(Point::dimension == 3)
      for(int flat_axis = 0; flat_axis < 3 && !are_flat(); ++flat_axis)
        if(const Interval interval = source.interval(flat_axis); interval.low == interval.high) {
          flat_coordinate_ = static_cast<Number>(interval.low);
          flat_axes_ = {flat_axis == 0 ? 1 : 0, flat_axis == 2 ? 1 : 2};
        }
  }

  bool are_flat() const { return Point::dimension == 3 && flat_axes_[1] != 0; }

  // Sorts the points by slabs, by counting. Each block of points has its own counts, which become
  // the places that the block writes to. There are too many slabs for the processor to have the
  // ends of all of them at hand.
  template <class ConcurrencyTag, class Source, class Stored>
  BOOST_NOINLINE void distribute(const Source& source, const Equal_cut& cut, Place size,
                                 std::unique_ptr<Stored[]>& points)
  {
    points = make_uninitialized<Stored>(size);
    const int slab_axis = std::is_same_v<Stored, Flat_point> ? flat_axes_[1] : axis;
    const Place count = cut.count() * columns_.count();
    const std::size_t blocks = block_count<ConcurrencyTag>();
    const std::unique_ptr<Place[]> next(new Place[blocks * count]);
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        Place* const counts = next.get() + block * count;
        std::fill_n(counts, count, Place(0));
        for(; i != end; ++i)
          ++counts[slab_of(source, cut, slab_axis, i)];
      });
    begins_ = std::vector<Place>(count + std::size_t(1), 0);
    replace_by_sums_over_blocks<ConcurrencyTag>(next.get(), blocks, count, begins_.data());
    replace_by_prefix_sums(begins_.data(), begins_.data() + begins_.size());
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        Place* const places = next.get() + block * count;
        add_begins(places, begins_.data(), count);
        Place slabs[distance];
        while(i != end) {
          const std::size_t some = (std::min)(end - i, std::size_t(distance));
          for(std::size_t p = 0; p < some; ++p) {
            slabs[p] = slab_of(source, cut, slab_axis, i + p);
            prefetch_to_write(&points[places[slabs[p]]]);
          }
          for(std::size_t p = 0; p < some; ++p, ++i)
            put(source, i, points[places[slabs[p]]++]);
        }
      });
  }

  // Returns the slab, in its column, that a point goes to.
  template <class Source>
  Place slab_of(const Source& source, const Equal_cut& cut, int slab_axis, std::size_t i) const
  {
    const Place slab = cut(source.coordinate(i, slab_axis));
    if constexpr(may_have_columns)
      if(columns_.count() > 1)
        return slab + cut.count() * columns_(source.coordinate(i, column_axis));
    return slab;
  }

  template <class Source>
  void put(const Source& source, std::size_t position, Point& place) const
  {
    source.put(position, place);
  }
  template <class Source>
  void put(const Source& source, std::size_t position, Flat_point& place) const
  {
    Point point;
    source.put(position, point);
    place = {{point.x[flat_axes_[0]], point.x[flat_axes_[1]]}, point.position};
  }

  // Returns the interval of the coordinates. Leaves out ends that hold hardly any points, if the
  // interval is much shorter without them.
  template <class Source>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Interval trim(const Source& source, Place size) const
  {
    const int slab_axis = are_flat() ? flat_axes_[1] : axis;
    const Interval all = source.interval(slab_axis);
    if(size < 4 * sample_size)
      return all;
    std::array<double, sample_size> x;
    for(Place s = 0; s < sample_size; ++s)
      x[s] = source.coordinate(static_cast<std::size_t>(s) * size / sample_size,
                               slab_axis);
    std::sort(x.begin(), x.end());
    const Interval sample = {x[sample_tail], x[sample_size - 1 - sample_tail]};
    if(!(all.length() > max_stretch * sample.length()) || sample.length() == 0)
      return all;
    const double margin = sample.length() * sample_margin;
    return {(std::max)(sample.low - margin, all.low), (std::min)(sample.high + margin, all.high)};
  }

  // Cuts the slabs into columns if they are fewer than threads need.
  void cut_columns(const Interval& interval, Place slabs, Place size, double reach,
                   std::size_t blocks, double points_per_column)
  {
    if(2 * static_cast<std::size_t>(slabs) < blocks)
      columns_ = Columns(interval, reach, (std::min)(slabs_per_block * static_cast<double>(blocks),
                                                     size / points_per_column) / slabs);
  }

  const Point_sets sets_;
  Columns columns_;
  std::array<int, 2> flat_axes_ = {}; // the axes along which flat points differ
  Number flat_coordinate_ = 0;
  std::unique_ptr<Flat_point[]> flat_points_; // or else
  std::unique_ptr<Point[]> points_;
  std::vector<Place> begins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
