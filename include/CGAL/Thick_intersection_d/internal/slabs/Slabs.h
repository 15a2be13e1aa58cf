// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H

// Cuts points into slabs: the divide step of [V03], made multiway.

#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers parts of equal height by a monotone function of the coordinate, so that parts follow each
// other along their axis. Nothing else is asked of its rounding: a sweep relies on the ranges of
// coordinates that parts are found to have, not on those they should have.
class Equal_cut
{
public:
  // Cuts a range into `count` parts; into one if that cannot be computed. Coordinates outside
  // belong to the first or to the last part.
  Equal_cut(const Range& range, double count)
  {
    const double scale = std::floor(count) / (range.high - range.low);
    if(!(count >= 2) || !(scale > 0) || !std::isfinite(scale))
      return; // Case 1 of [V03]: not cut
    range_ = range;
    scale_ = scale;
    last_ = static_cast<Place>(count) - 1;
  }

  Place count() const { return last_ + 1; }

  // Compiled to minima and maxima: a branch would often be guessed wrong in parts of few points.
  Place operator()(double x) const
  {
    const double inside = (std::min)((std::max)(x, range_.low), range_.high);
    const double part = (inside - range_.low) * scale_;
    return (std::min)(static_cast<Place>(static_cast<std::int64_t>(part)), last_);
  }

private:
  Range range_ = {0, 0};
  double scale_ = 0;
  Place last_ = 0;
};

// The height of slabs and strips, in reaches. Higher ones have more pairs to look at inside, lower
// ones have more points that are near other slabs.
constexpr double usual_height = 2;

// The height, in reaches, from which on points far from each other may crowd in a part. Parts of
// points that are not sparse are lower.
constexpr double greatest_height = 2 * usual_height;

// How many points parts have at least, on average: with fewer, there is more to do per part than
// per point. Tests set small ones, to have many parts of few points.
struct Part_sizes
{
  Place slab = 1024;
  Place strip = 8;          // or part of a slab in which points crowd
  Place sorted_part = 12;   // of a strip or part in which they still do
  Place large_slab = 16384; // is cut again, to fit into a cache
  double crowd = 1 << 24;   // of pairs that a sweep looks at; of more it takes shares
};

// Returns how many parts `size` points in `range` are cut into: at least the usual height high, and
// not so many that they are nearly empty.
inline double part_count(const Range& range, Place size, double reach, Place part_size)
{
  return (std::min)((range.high - range.low) / (usual_height * reach),
                    static_cast<double>(size / part_size + 1));
}

template <int Dimension>
std::array<Range, Dimension> box_of(const Slab_point<Dimension>* first,
                                    const Slab_point<Dimension>* last)
{
  std::array<Range, Dimension> box;
  for(; first != last; ++first)
    for(int axis = 0; axis < Dimension; ++axis)
      box[axis].add(first->x[axis]);
  return box;
}

// The points of a set, in the order of the slabs that they are in.
template <int Dimension>
class Slabs
{
public:
  using Point = Slab_point<Dimension>;
  static constexpr int axis = Dimension - 1; // that slabs are cut along
  static constexpr double greatest_count = 1024;

  // Takes the points at the positions [first, last), whose coordinates along the axis are in
  // `range`.
  template <class ConcurrencyTag, class Doubles>
  Slabs(ConcurrencyTag, const Doubles& doubles, std::size_t first, std::size_t last,
        const Range& range, double reach, const Part_sizes& sizes = Part_sizes())
    : points_(make_uninitialized<Point>(last - first))
  {
    const Place size = static_cast<Place>(last - first);
    const Range trimmed = trim(doubles, first, size, range);
    cut_ = Equal_cut(trimmed,
                     (std::min)(part_count(trimmed, size, reach, sizes.slab), greatest_count));
    const Place count = cut_.count();

    // Each block of points has its own counts, which become the places that it writes to.
    const std::size_t blocks = block_count<ConcurrencyTag>();
    std::vector<Place> next(blocks * count, 0);
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        for(; i != end; ++i)
          ++next[block * count + cut_(doubles.at(first + i, axis))];
      });
    Place sum = 0;
    for(Place part = 0; part < count; ++part) {
      begins_.push_back(sum);
      for(std::size_t block = 0; block < blocks; ++block)
        sum += std::exchange(next[block * count + part], sum);
    }
    begins_.push_back(sum);
    for_each_numbered_block<ConcurrencyTag>(
      blocks, size, [&](std::size_t block, std::size_t i, std::size_t end) {
        for(; i != end; ++i) {
          const std::array<double, Dimension> p = doubles.template at<Dimension>(first + i);
          points_[next[block * count + cut_(p[axis])]++] = {p, static_cast<Place>(first + i)};
        }
      });
  }

  Place count() const { return static_cast<Place>(begins_.size()) - 1; }
  const Point* begin(Place slab) const { return points_.get() + begins_[slab]; }
  const Point* end(Place slab) const { return begin(slab + 1); }
  Place size() const { return begins_.back(); }

  // Returns the slabs [first, last) of one of `count` blocks, which have about as many points each.
  std::pair<Place, Place> block(std::size_t index, std::size_t count) const
  {
    const auto first_behind = [&](std::size_t points) {
      const auto slab = std::lower_bound(begins_.begin(), begins_.end(), points);
      return static_cast<Place>(slab - begins_.begin());
    };
    return {first_behind(index * size() / count), first_behind((index + 1) * size() / count)};
  }

  // No point whose coordinate is at least x is in a slab before this one.
  Place slab_of(double x) const { return cut_(x); }

private:
  // Leaves away ends of the range in which hardly any of the points are, if that makes it much
  // shorter: a single outlier would leave all others in one slab.
  template <class Doubles>
  static Range trim(const Doubles& doubles, std::size_t first, Place size, const Range& range)
  {
    constexpr Place samples = 512;
    if(size < 4 * samples)
      return range;
    std::array<double, samples> x;
    for(Place s = 0; s < samples; ++s)
      x[s] = doubles.at(first + static_cast<std::size_t>(s) * size / samples, axis);
    std::sort(x.begin(), x.end());
    const double low = x[samples / 64];
    const double high = x[samples - 1 - samples / 64];
    const double margin = (high - low) / 16;
    if(!(range.high - range.low > 4 * (high - low)) || low == high)
      return range;
    return {(std::max)(low - margin, range.low), (std::min)(high + margin, range.high)};
  }

  Equal_cut cut_{Range(), 1};
  std::unique_ptr<Point[]> points_;
  std::vector<Place> begins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_H
