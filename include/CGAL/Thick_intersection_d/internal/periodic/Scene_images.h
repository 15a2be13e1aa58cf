// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H

// The images of points that a periodic search needs besides the points.
//
// Each point has a home: the point itself in an iso-box, or else an image of it in or near one cell
// of the lattice. An offset m between the homes of two points has components m_1, m_2, ... in the
// basis of the lattice. The pairs of homes with m = 0 are those of a search without periods. Of
// other pairs, each is that of a home and of a home moved by an offset whose first component that
// is not zero is positive, with one of two opposite offsets. So these offsets are enough, and give
// each pair once. Of two sets, the homes of one stay and those of the other are moved, by all
// offsets: that set for which there are fewer images.
//
// First, the homes near the boundary are found, and their images counted. Then the images are made
// in batches, of which one is in memory at a time. A batch has about as many images as there are
// homes near which they may be, so memory is linear in the number of points.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Cell_boundary.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Image_moves.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Images.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Scene_images
{
  using Boundary = Cell_boundary<Dimension>;
  using Fractions = typename Boundary::Fractions;

public:
  using Image_list = std::vector<Image<Dimension>>;

  // `basis` must live as long as this.
  Scene_images(const Lattice_basis<Dimension>& basis, const Boundary& boundary, bool are_two_sets)
    : moves_(basis, boundary, are_two_sets), are_two_sets_(are_two_sets)
  {}

  // Finds the homes, and counts the images. Each point is a step of progress. Returns false iff it
  // was cancelled. Throws std::length_error if a point is too many periods away, or if there are
  // too many images.
  template <class Elements, class Sets, class Progress>
  bool find(const Threads& threads, const Elements& points, const Sets& sets, Progress& progress)
  {
    std::vector<Found> found(threads.block_count());
    threads.run_numbered_blocks(
      found.size(), points.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
        add_points(points, first, last, sets, found[block], progress);
      });
    if(progress.is_cancelled())
      return false;
    collect(found, points.size());
    if(static_cast<double>(staying().size()) + count() >= static_cast<double>(max_place / 2))
      throw std::length_error("There are " + count_text(count()) + " images of points within the "
                              "bound, and a search takes less than "
                              + count_text(static_cast<double>(max_place / 2)) + ".");
    return true;
  }

  // Keeps one of the homes that are equal, the first one, of those near which images may be, and of
  // those of which there are images. less(a, b) orders the places of two homes.
  template <class Elements, class Less>
  void keep_first_of_equal_homes(const Elements& points, const Less& less)
  {
    for(Near_list& list : near_) {
      std::stable_sort(list.begin(), list.end(), [&](const Near_home& a, const Near_home& b) {
        return less(a.image, b.image);
      });
      const auto are_equal = [&](const Near_home& a, const Near_home& b) {
        return !less(a.image, b.image); // as the list is in order
      };
      list.erase(std::unique(list.begin(), list.end(), are_equal), list.end());
    }
    counts_[moving_] = 0;
    for(const Near_home& home : near_[moving_])
      moves_.for_each_image(points, home.image, home.sides, [this](const Image<Dimension>&) {
        ++counts_[moving_];
        return true;
      });
  }

  // Whether the home of a point is not the point itself. Only then there are homes.
  bool are_moved() const { return !homes_.empty(); }
  const Image_list& homes() const { return homes_; }

  // The number of homes near which images may be, and the number of these images, which are none if
  // there is no such home.
  std::size_t near_home_count() const { return staying().size(); }
  double count() const { return staying().empty() ? 0 : counts_[moving_]; }

  // Whether the images are those of the first of two sets.
  bool are_of_first() const { return are_two_sets_ && moving_ == 0; }

  // Calls task(batch, first, last) with the homes near which images may be, followed by some of
  // these images: those from the number `first` on, to before `last`. Goes on until all images were
  // in a batch, or until the task returns false, and returns what it returned.
  template <class Elements, class Task>
  bool for_each_batch(const Elements& points, const Task& task) const
  {
    Image_list batch;
    if(count() == 0)
      return true;
    for(const Near_home& home : staying())
      batch.push_back(home.image);
    double done = 0;
    const auto take_batch = [&] {
      const double first = done;
      done += static_cast<double>(batch.size() - staying().size());
      const bool goes_on = task(batch, first, done);
      batch.resize(staying().size());
      return goes_on;
    };
    const std::size_t full = staying().size() + (std::max)(min_batch, 2 * staying().size());
    for(const Near_home& home : near_[moving_])
      if(!moves_.for_each_image(points, home.image, home.sides, [&](const Image<Dimension>& image) {
           batch.push_back(image);
           return batch.size() < full || take_batch();
         }))
        return false;
    return batch.size() == staying().size() || take_batch();
  }

private:
  // The points are still in the cache when the few near the boundary are read again.
  static constexpr std::size_t points_at_once = 1024;

  // A search of so few images takes a fraction of a second.
  static constexpr std::size_t min_batch = std::size_t(1) << 18;

  // A home, and the sides of the range of homes that it is near.
  struct Near_home
  {
    Image<Dimension> image;
    unsigned sides;
  };
  using Near_list = std::vector<Near_home>;

  // So many homes, each of which is written down, and kept or not.
  struct Kept_homes
  {
    std::array<Near_home, points_at_once> homes;
    std::size_t count = 0;

    void put(const Near_home& home, bool is_kept)
    {
      homes[count] = home;
      count += is_kept;
    }
    void move_to(Near_list& list)
    {
      list.insert(list.end(), homes.begin(), homes.begin() + count);
      count = 0;
    }
  };

  // The homes near the boundary: of two sets, those of each set. Of one set, the homes that stay
  // and those that are moved. Then the images of each.
  struct Found
  {
    Image_list moved_homes; // those that are not the points themselves
    std::array<Near_list, 2> near;
    std::array<Kept_homes, 2> next; // which follow in the two lists
    std::array<double, 2> counts = {};
  };

  template <class Elements, class Sets, class Progress>
  void add_points(const Elements& points, std::size_t first, std::size_t last, const Sets& sets,
                  Found& found, Progress& progress) const
  {
    std::array<Place, points_at_once> positions;
    for(bool goes_on = true; goes_on && first < last; first += points_at_once) {
      const std::size_t end = (std::min)(first + points_at_once, last);
      const std::size_t count = moves_.boundary().find_near(points, first, end, positions.data());
      for(std::size_t i = 0; i < count; ++i)
        add(points[positions[i]], positions[i], sets, found);
      for(int k = 0; k < 2; ++k)
        found.next[k].move_to(found.near[k]);
      goes_on = progress.advance(end - first);
    }
  }

  // Adds the home of a point, where others may be near it or images of it. No processor could
  // foresee which sides a home is near, so there are few jumps.
  template <class Point, class Sets>
  BOOST_NOINLINE
  void add(const Point& point, Place position, const Sets& sets, Found& found) const
  {
    Fractions cell;
    const Fractions f = moves_.boundary().fractions_in_cell(point, cell);
    Near_home home = {{position, {}}, moves_.boundary().sides(f)};
    if(cell != Fractions{}) {
      for(double& x : cell)
        x = -x;
      home.image.offset = moves_.steps_of(cell, position);
      found.moved_homes.push_back(home.image);
    }
    const double count = moves_.count(f, home.sides, position);
    if constexpr(Sets::are_two) {
      const bool is_of_second = position >= sets.first_size;
      found.next[is_of_second].put(home, home.sides != 0);
      found.counts[is_of_second] += count;
    }
    else {
      found.next[0].put(home, (home.sides & Boundary::high_sides) != 0);
      found.next[1].put(home, count != 0);
      found.counts[1] += count;
    }
  }

  void collect(const std::vector<Found>& found, std::size_t size)
  {
    for(const Found& part : found)
      for(int k = 0; k < 2; ++k) {
        near_[k].insert(near_[k].end(), part.near[k].begin(), part.near[k].end());
        counts_[k] += part.counts[k];
      }
    const auto work = [this](int moving) {
      return static_cast<double>(near_[1 - moving].size()) + counts_[moving];
    };
    moving_ = are_two_sets_ && work(0) < work(1) ? 0 : 1;
    for(const Found& part : found)
      for(const Image<Dimension>& home : part.moved_homes)
        set_home(size, home);
  }

  // Homes are kept if one of them is not the point itself.
  void set_home(std::size_t size, const Image<Dimension>& home)
  {
    if(homes_.empty())
      for(std::size_t i = 0; i < size; ++i)
        homes_.push_back({static_cast<Place>(i), {}});
    homes_[home.position] = home;
  }

  const Near_list& staying() const { return near_[1 - moving_]; }

  const Image_moves<Dimension> moves_;
  const bool are_two_sets_;
  Image_list homes_;
  std::array<Near_list, 2> near_; // as in Found
  std::array<double, 2> counts_ = {};
  int moving_ = 1; // which of the lists is moved
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_SCENE_IMAGES_H
