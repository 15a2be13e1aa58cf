// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H

// The points of one or two sets in the order of their slabs: the divide step of [V03], made
// multiway. [V03] is cited in Recursive_route.h.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Slabs
{
public:
  // Takes the `size` points of `source`. The source has the functions interval(axis),
  // coordinate(position, axis) and put(position, place).
  template <class ConcurrencyTag, class Source>
  Slabs(ConcurrencyTag, const Source& source, std::size_t size, double reach,
        const Point_sets& sets = Point_sets(), const Slab_tuning& tuning = Slab_tuning())
    : sets_(sets), points_(make_uninitialized<Point>(size))
  {
    const Place places = static_cast<Place>(size);
    const Interval trimmed = trim(source, places);
    const double count = piece_count(trimmed, places, reach, tuning.points_per_slab);
    const Equal_cut cut(trimmed, (std::min)(count, max_slab_count));
    distribute<ConcurrencyTag>(source, cut, places);
  }

  const Point_sets& sets() const { return sets_; }

  Place count() const { return static_cast<Place>(begins_.size()) - 1; }
  const Point* begin(Place slab) const { return points_.get() + begins_[slab]; }
  const Point* end(Place slab) const { return begin(slab + 1); }
  Place size() const { return begins_.back(); }

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
  static constexpr int axis = Point::slab_axis;

  // How many points ahead the memory that a point goes to is asked for.
  static constexpr int distance = 16;

  // Sorts the points by slabs, by counting. Each block of points has its own counts, which become
  // the places that the block writes to. There are too many slabs for the processor to have the
  // ends of all of them at hand.
  template <class ConcurrencyTag, class Source>
  BOOST_NOINLINE void distribute(const Source& source, const Equal_cut& cut, Place size)
  {
    const Place count = cut.count();
    const std::size_t blocks = block_count<ConcurrencyTag>();
    std::vector<Place> next(blocks * count, 0);
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        for(; i != end; ++i)
          ++next[block * count + cut(source.coordinate(i, axis))];
      });
    begins_ = std::vector<Place>(count + std::size_t(1), 0);
    Place sum = 0;
    for(Place slab = 0; slab < count; ++slab) {
      begins_[slab] = sum;
      for(std::size_t block = 0; block < blocks; ++block)
        sum += std::exchange(next[block * count + slab], sum);
    }
    begins_[count] = sum;
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        Place slabs[distance];
        while(i != end) {
          const std::size_t some = (std::min)(end - i, std::size_t(distance));
          for(std::size_t p = 0; p < some; ++p) {
            slabs[p] = cut(source.coordinate(i + p, axis));
            prefetch_to_write(&points_[next[block * count + slabs[p]]]);
          }
          for(std::size_t p = 0; p < some; ++p, ++i)
            source.put(i, points_[next[block * count + slabs[p]]++]);
        }
      });
  }

  // Returns the interval of the coordinates. Leaves out ends that hold hardly any points, if the
  // interval is much shorter without them.
  template <class Source>
  CGAL_RARELY_CALLED static Interval trim(const Source& source, Place size)
  {
    const Interval all = source.interval(axis);
    if(size < 4 * sample_size)
      return all;
    std::array<double, sample_size> x;
    for(Place s = 0; s < sample_size; ++s)
      x[s] = source.coordinate(static_cast<std::size_t>(s) * size / sample_size, axis);
    std::sort(x.begin(), x.end());
    const Interval sample = {x[sample_tail], x[sample_size - 1 - sample_tail]};
    if(!(all.length() > max_stretch * sample.length()) || sample.length() == 0)
      return all;
    const double margin = sample.length() * sample_margin;
    return {(std::max)(sample.low - margin, all.low), (std::min)(sample.high + margin, all.high)};
  }

  const Point_sets sets_;
  std::unique_ptr<Point[]> points_;
  std::vector<Place> begins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
