// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// An archetype of traits with intervals: objects that can be moved and nothing else, functors that
// have a state and the required operator and nothing else, no predicates of the recursive route.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_INTERVAL_TRAITS_H
#define THICK_INTERSECTION_TEST_SUPPORT_INTERVAL_TRAITS_H

#include "check_pairs.h"
#include "lattice_traits.h"
#include "number_boxes.h"

#include <CGAL/thick_intersection_d.h>

namespace test_support {

// A box with a color. Neither default constructible nor copyable.
class Colored_box
{
public:
  Colored_box(const Number_box& box, int color) : box_(box), color_(color) {}
  Colored_box(const Colored_box&) = delete;
  Colored_box& operator=(const Colored_box&) = delete;
  Colored_box(Colored_box&&) = default;

  const Number_box& box() const { return box_; }
  int color() const { return color_; }

private:
  Number_box box_;
  int color_;
};

using Call_count = std::atomic<std::size_t>;

// Boxes intersect if they meet and are of different colors. Writes down how often it is asked, also
// by several threads.
class Interval_traits
{
public:
  using Object_d = Colored_box;

  Interval_traits(int dimension, Call_count& calls) : dimension_(dimension), calls_(calls) {}
  Interval_traits(const Interval_traits&) = delete;

  class Interval_d
  {
  public:
    explicit Interval_d(int dimension) : dimension_(dimension) {}
    std::pair<double, double> operator()(const Colored_box& a, int i) const
    {
      if(i < 0 || i >= dimension_)
        throw std::logic_error("There is no such axis.");
      return {a.box()[i].low, a.box()[i].high};
    }

  private:
    int dimension_;
  };

  class Do_intersect_d
  {
  public:
    Do_intersect_d(int dimension, Call_count& calls) : dimension_(dimension), calls_(&calls) {}
    Answer operator()(const Colored_box& a, const Colored_box& b) const
    {
      calls_->fetch_add(1, std::memory_order_relaxed);
      return Answer(a.color() != b.color() && do_meet(a.box(), b.box(), dimension_));
    }

  private:
    int dimension_;
    Call_count* calls_;
  };

  int dimension() const { return dimension_; }
  Interval_d interval_d_object() const { return Interval_d(dimension_); }
  Do_intersect_d do_intersect_d_object() const { return Do_intersect_d(dimension_, calls_); }

private:
  int dimension_;
  Call_count& calls_;
};

// The same with a dimension that is fixed when compiled.
template <int D>
class Fixed_interval_traits : public Interval_traits
{
public:
  using Dimension = CGAL::Dimension_tag<D>;
  explicit Fixed_interval_traits(Call_count& calls) : Interval_traits(D, calls) {}
};

// Makes boxes of three colors.
inline std::vector<Colored_box> colored(const Number_boxes& boxes)
{
  std::vector<Colored_box> result;
  for(std::size_t i = 0; i < boxes.size(); ++i)
    result.emplace_back(boxes[i], static_cast<int>(i % 3));
  return result;
}

// All pairs of such boxes.
inline Pairs pairs_of_colored(const Number_boxes& boxes, int dimension,
                              std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  for(const Pair& p : all_meeting_pairs(boxes, dimension, first_set_size))
    if(p.first % 3 != p.second % 3)
      pairs.push_back(p);
  return pairs;
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class Traits>
Pairs pairs_by_traits(const Number_boxes& boxes, const Traits& traits)
{
  Pairs pairs;
  Locked_collector collect(pairs);
  BOOST_CHECK(CGAL::thick_self_intersection_d<ConcurrencyTag>(
    colored(boxes), collect, CGAL::parameters::geom_traits(traits)));
  return pairs;
}

// Searches one set and two.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Traits>
void check_colored(const Number_boxes& boxes, const Traits& traits)
{
  const int dimension = traits.dimension();
  const std::size_t half = boxes.size() / 6 * 3; // so that colors go on in the second set
  const auto [a, b] = split(boxes, half);
  Pairs two_sets;
  Locked_collector collect(two_sets);
  BOOST_CHECK(CGAL::thick_intersection_d<ConcurrencyTag>(colored(a), colored(b), collect,
                                                         CGAL::parameters::geom_traits(traits)));
  check_pairs(std::to_string(dimension) + " axes, " + std::to_string(boxes.size()) + " boxes",
              pairs_of_colored(boxes, dimension), pairs_by_traits<ConcurrencyTag>(boxes, traits),
              two_sets, half);
}

// Boxes with extents over three decades. Some are infinite along axis 0.
inline Number_boxes boxes_of_all_sizes(int dimension, std::size_t size)
{
  Generator random(size);
  Number_boxes boxes(size);
  for(std::size_t i = 0; i < size; ++i) {
    for(int axis = 0; axis < dimension; ++axis) {
      const double low = below(random, 256) / 256;
      boxes[i][axis] = {low, low + std::pow(10, -3 * below(random, 1000) / 1000)};
    }
    if(i % 100 == 0)
      boxes[i][0].low = -infinity;
    if(i % 100 == 1)
      boxes[i][0].high = infinity;
  }
  return boxes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_INTERVAL_TRAITS_H
