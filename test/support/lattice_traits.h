// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// An archetype of ThickIntersectionTraits_d: objects that can be moved and nothing else, functors
// that have a state and the required operator and nothing else. Counts what it is asked.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_LATTICE_TRAITS_H
#define THICK_INTERSECTION_TEST_SUPPORT_LATTICE_TRAITS_H

#include "pairs.h"

namespace test_support {

// A point with integer coordinates. Neither default constructible nor copyable.
class Site
{
public:
  explicit Site(std::vector<long> coordinates) : coordinates_(std::move(coordinates)) {}
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  Site(Site&&) = default;

  long coordinate(int i) const { return coordinates_[static_cast<std::size_t>(i)]; }
  int dimension() const { return static_cast<int>(coordinates_.size()); }

private:
  std::vector<long> coordinates_;
};

struct Calls
{
  std::size_t less = 0;
  std::size_t is_close = 0;
  std::size_t do_intersect = 0;
};

// What a predicate may return instead of bool: convertible to it.
class Answer
{
public:
  explicit Answer(bool value) : value_(value) {}
  operator bool() const { return value_; }

private:
  bool value_;
};

inline long squared_distance(const Site& a, const Site& b)
{
  long sum = 0;
  for(int i = 0; i < a.dimension(); ++i)
    sum += (a.coordinate(i) - b.coordinate(i)) * (a.coordinate(i) - b.coordinate(i));
  return sum;
}

// Sites that intersect if they are within a distance. The reach may be larger than that.
class Lattice_traits
{
public:
  using Object_d = Site;

  Lattice_traits(int dimension, long distance, long reach, Calls& calls)
    : dimension_(dimension), distance_(distance), reach_(reach), calls_(calls)
  {}
  Lattice_traits(const Lattice_traits&) = delete;

  class Less_coordinate_d
  {
  public:
    explicit Less_coordinate_d(Calls& calls) : calls_(&calls) {}
    Answer operator()(const Site& a, const Site& b, int i) const
    {
      ++calls_->less;
      return Answer(a.coordinate(i) < b.coordinate(i));
    }

  private:
    Calls* calls_;
  };

  class Is_close_along_axis_d
  {
  public:
    Is_close_along_axis_d(long reach, Calls& calls) : reach_(reach), calls_(&calls) {}
    Answer operator()(const Site& a, const Site& b, int i) const
    {
      ++calls_->is_close;
      return Answer(std::abs(a.coordinate(i) - b.coordinate(i)) <= reach_);
    }

  private:
    long reach_;
    Calls* calls_;
  };

  class Do_intersect_d
  {
  public:
    Do_intersect_d(long distance, Calls& calls) : distance_(distance), calls_(&calls) {}
    Answer operator()(const Site& a, const Site& b) const
    {
      ++calls_->do_intersect;
      return Answer(squared_distance(a, b) <= distance_ * distance_);
    }

  private:
    long distance_;
    Calls* calls_;
  };

  int dimension() const { return dimension_; }
  Less_coordinate_d less_coordinate_d_object() const { return Less_coordinate_d(calls_); }
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return Is_close_along_axis_d(reach_, calls_);
  }
  Do_intersect_d do_intersect_d_object() const { return Do_intersect_d(distance_, calls_); }

private:
  int dimension_;
  long distance_;
  long reach_;
  Calls& calls_;
};

// All pairs of sites within a distance, without the package.
inline Pairs pairs_of_sites(const std::vector<Site>& sites, long distance)
{
  Pairs pairs;
  for(std::size_t i = 0; i < sites.size(); ++i)
    for(std::size_t j = i + 1; j < sites.size(); ++j)
      if(squared_distance(sites[i], sites[j]) <= distance * distance)
        pairs.emplace_back(i, j);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_LATTICE_TRAITS_H
