// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H

// The points of one or two sets in the order of their slabs: the divide step of [V03], made
// multiway. [V03] is cited in Recursive_route.h.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_columns.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Slabs
{
  using Reader = Point_reader<Point::dimension, typename Point::Number>;

public:
  // Takes all points of `source`. Cuts slabs into columns if they are too few for all threads.
  Slabs(const Reader& source, double reach, const Point_sets& sets, const Threads& threads,
        const Slab_tuning& tuning)
    : sets_(sets), threads_(threads)
  {
    find_axes(source);
    const Place places = static_cast<Place>(source.size());
    const Interval trimmed = trim(source, places);
    const double count = piece_count(trimmed, places, reach, tuning.points_per_slab);
    const Equal_cut cut(trimmed, (std::min)(count, max_slab_count));
    if(Point::may_be_shared && may_have_columns(source))
      cut_columns(source.interval(column_axis), cut.count(), places, reach,
                  tuning.points_per_column);
    if(are_flat())
      flat_points_ = make_uninitialized<Flat_point>(places);
    else
      points_ = make_uninitialized<Point>(places);
    distribute(source, cut);
  }

  // The points of a column have a border if there are several columns.
  Point_sets sets() const { return {sets_.first_size, columns_.count() > 1}; }

  // The number of slabs in each column, and in all of them. The slabs of a column follow those of
  // the column before.
  Place count() const { return slab_count() / columns_.count(); }
  Place slab_count() const { return static_cast<Place>(begins_.size()) - 1; }
  const Slab_columns& columns() const { return columns_; }

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

  // Of a slab in its column. There are at most 1024 slabs, or as few as threads need.
  using Slab_number = std::uint16_t;

  static constexpr int axis = Point::slab_axis;
  static constexpr int column_axis = axis - 1;

  // How many points ahead the memory that a point goes to is prefetched.
  static constexpr std::size_t distance = 16;

  void find_axes(const Reader& source)
  {
    if constexpr(Point::dimension == 3)
      for(int flat_axis = 0; flat_axis < 3 && !are_flat(); ++flat_axis)
        if(const Interval interval = source.interval(flat_axis); interval.low == interval.high) {
          flat_coordinate_ = static_cast<Number>(interval.low);
          flat_axes_ = {flat_axis == 0 ? 1 : 0, flat_axis == 2 ? 1 : 2};
        }
  }

  bool are_flat() const { return Point::dimension == 3 && flat_axes_[1] != 0; }
  int slab_axis() const { return are_flat() ? flat_axes_[1] : axis; }

  // Columns need a free bit in what points are reported by (Slab_column.h).
  bool may_have_columns(const Reader& source) const
  {
    return threads_.are_many() && !sets_.are_two() && !are_flat() && !source.are_numbered()
           && source.size() < Point_sets::border_bit;
  }

  // Sorts the points by slabs, by counting. Each block of points has its own counts, which become
  // the places that the block writes to.
  void distribute(const Reader& source, const Equal_cut& cut)
  {
    const std::size_t size = source.size();
    const Place count = cut.count() * columns_.count();
    const std::size_t blocks = threads_.block_count();
    const std::unique_ptr<Place[]> next(new Place[blocks * count]);
    const auto slabs = make_uninitialized<Slab_number>(size + distance);
    std::fill_n(slabs.get() + size, distance, Slab_number(0)); // for what prefetches ahead
    threads_.run_numbered_blocks(
      blocks, size, [&](std::size_t block, std::size_t first, std::size_t last) {
        Place* const counts = next.get() + block * count;
        std::fill_n(counts, count, Place(0));
        count_points(source, cut, first, last, counts, slabs.get());
      });
    begins_ = std::vector<Place>(count + std::size_t(1), 0);
    replace_by_sums_over_blocks(threads_, next.get(), blocks, count, begins_.data());
    replace_by_prefix_sums(begins_.data(), begins_.data() + begins_.size());
    threads_.run_numbered_blocks(
      blocks, size, [&](std::size_t block, std::size_t first, std::size_t last) {
        Place* const places = next.get() + block * count;
        add_begins(places, begins_.data(), count);
        if(are_flat())
          move_points(source, first, last, slabs.get(), places, flat_points_.get());
        else
          move_points(source, first, last, slabs.get(), places, points_.get());
      });
  }

  // Counts the points [first, last) of each slab, and writes down the slab of each.
  void count_points(const Reader& source, const Equal_cut& cut, std::size_t first,
                    std::size_t last, Place* counts, Slab_number* slabs) const
  {
    const int axes = columns_.count() > 1 ? Reader::all_axes : slab_axis();
    with_slab_of(source, cut, [&](const auto& finder) {
      source.read_blocks(first, last, axes, [&](const Point_block& block) {
        const auto slab_of = finder; // stays in registers
        Slab_number* const to = slabs + block.first;
        for(std::size_t p = 0; p < block.size; ++p) {
          const Place slab = slab_of(block.point(p));
          to[p] = static_cast<Slab_number>(slab);
          ++counts[slab];
        }
      });
    });
  }

  // Moves the points [first, last) to the places of their slabs. There are too many slabs for the
  // processor to have the ends of all of them at hand.
  template <class Stored>
  void move_points(const Reader& source, std::size_t first, std::size_t last,
                   const Slab_number* slabs, Place* places, Stored* points) const
  {
    source.read_blocks(first, last, Reader::all_axes, [&](const Point_block& block) {
      const auto to_number = source.to_number(); // the copy stays in registers
      const Slab_number* const of = slabs + block.first;
      for(std::size_t p = 0; p < block.size; ++p) {
        prefetch_to_write(&points[places[of[p + distance]]]);
        put(to_number, block.point(p), block.numbers[p], points[places[of[p]]++]);
      }
    });
  }

  // Calls task(slab_of) with the function that finds the slab, in its column, that a point goes to.
  template <class Task>
  void with_slab_of(const Reader& source, const Equal_cut& cut, const Task& task) const
  {
    const int cut_axis = slab_axis();
    const auto slab_of = [cut, cut_axis, to_number = source.to_number()](const double* x) {
      return cut(to_number(x[cut_axis], cut_axis));
    };
    if constexpr(Point::may_be_shared)
      if(columns_.count() > 1)
        return task([slab_of, this, to_number = source.to_number(), count = cut.count()](
                      const double* x) {
          return slab_of(x) + count * columns_(to_number(x[column_axis], column_axis));
        });
    task(slab_of);
  }

  using To_number_of_point = To_number<Point::dimension, Number>;

  static void put(const To_number_of_point& to_number, const double* x, Place position,
                  Point& place)
  {
    for(int c = 0; c < Point::dimension; ++c)
      place.x[c] = to_number(x[c], c);
    place.position = position;
  }
  void put(const To_number_of_point& to_number, const double* x, Place position,
           Flat_point& place) const
  {
    place = {{to_number(x[flat_axes_[0]], flat_axes_[0]),
              to_number(x[flat_axes_[1]], flat_axes_[1])}, position};
  }

  // Returns the interval of the coordinates. Leaves out ends that hold hardly any points, if the
  // interval is much shorter without them.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Interval trim(const Reader& source, Place size) const
  {
    const Interval all = source.interval(slab_axis());
    if(size < 4 * sample_size)
      return all;
    std::array<double, sample_size> x;
    for(Place s = 0; s < sample_size; ++s)
      x[s] = source.coordinate(static_cast<std::size_t>(s) * size / sample_size, slab_axis());
    std::sort(x.begin(), x.end());
    const Interval sample = {x[sample_tail], x[sample_size - 1 - sample_tail]};
    if(!(all.length() > max_stretch * sample.length()) || sample.length() == 0)
      return all;
    const double margin = sample.length() * sample_margin;
    return {(std::max)(sample.low - margin, all.low), (std::min)(sample.high + margin, all.high)};
  }

  // Cuts the slabs into columns if they are fewer than threads need.
  void cut_columns(const Interval& interval, Place slabs, Place size, double reach,
                   double points_per_column)
  {
    const std::size_t blocks = threads_.block_count();
    const double most = (std::min)(slabs_per_block * static_cast<double>(blocks),
                                   double((std::numeric_limits<Slab_number>::max)()));
    if(slabs < min_slabs_per_block(Point::dimension) * static_cast<double>(blocks))
      columns_ = Slab_columns(interval, reach, (std::min)(most, size / points_per_column) / slabs);
  }

  const Point_sets sets_;
  const Threads threads_;
  Slab_columns columns_;
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
