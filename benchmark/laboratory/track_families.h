// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Families of points that move and come as near as the bound, exactly, or nearly so.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_TRACK_FAMILIES_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_TRACK_FAMILIES_H

#include "thick_families.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lab {

inline std::vector<Kind> moving_kinds()
{
  return {{"legs, plane", 2, 2, Meaning::MOVING}, {"legs, space", 3, 2, Meaning::MOVING}};
}

// A multiple of all lengths of Orthogonal_vectors of small numbers.
constexpr std::int64_t bound_of_meetings = 7280;

// Pairs of points that are as near as the bound at a time, and then no nearer.
class Meetings
{
public:
  // One of the points is at a place below 2^bits then.
  Meetings(const Kind& kind, std::uint64_t seed, int bits = 20)
    : kind_(kind), bits_(bits), random_(seed)
  {}

  // How the two points move at the time.
  enum Motion {
    PASSING,     // it is between the ends of both legs, and they are farther before and after
    APPROACHING, // it is the last one of a leg, and they come nearer until then
    STANDING     // neither moves
  };

  struct Leg
  {
    Places places;
    std::array<std::int64_t, 2> times;
  };

  enum Times {
    OWN,
    TOUCHING, // one leg ends when the other one begins
    COMMON
  };

  std::array<Leg, 2> meeting(Motion motion, Times times = OWN)
  {
    const Orthogonal_vectors vectors(kind_, 2, random_);
    Place place = {}, velocity = {};
    for(int axis = 0; axis < kind_.dimension; ++axis) {
      place[axis] = below(std::size_t(1) << bits_);
      velocity[axis] = motion == STANDING ? 0 : below(17) - 8;
    }
    const Place& across = vectors.axes[kind_.dimension == 2 ? 1 : 2];
    const Place other_place = moved(place, across, bound_of_meetings / vectors.length);
    Place other_velocity = velocity;
    if(motion != STANDING)
      other_velocity = moved(velocity, vectors.axes[0], 1 + below(3));
    if(motion == APPROACHING)
      other_velocity = moved(other_velocity, across, -1 - below(3));
    const std::int64_t time = 100 + below(1000);
    const bool is_last = motion == APPROACHING || times == TOUCHING;
    const std::int64_t before = 1 + below(10), after = is_last ? 0 : 1 + below(10);
    const Leg first = leg(place, velocity, time, before, after);
    if(times == COMMON)
      return {first, leg(other_place, other_velocity, time, before, after)};
    const std::int64_t other_before = times == TOUCHING ? 0 : 1 + below(10);
    return {first, leg(other_place, other_velocity, time, other_before, 1 + below(10))};
  }

private:
  std::int64_t below(std::size_t count) { return static_cast<std::int64_t>(random_.below(count)); }

  // The leg of a point that is at a place at a time, before it and after it.
  static Leg leg(const Place& place, const Place& velocity, std::int64_t time, std::int64_t before,
                 std::int64_t after)
  {
    return {{moved(place, velocity, -before), moved(place, velocity, after)},
            {time - before, time + after}};
  }

  Kind kind_;
  int bits_;
  Random random_;
};

// The units of places and times. Each leg of a pair is made by pair().
template <class Make_pair>
Object_set legs_of(const Kind& kind, const std::string& family, double unit, double time_unit,
                   const Make_pair& pair)
{
  Object_set set = {kind, family, {}};
  Meetings meetings(kind, family.size());
  while(set.size() < objects_per_family)
    for(const Meetings::Leg& leg : pair(meetings)) {
      const double bound = unit * bound_of_meetings;
      add_capsule(set, leg.places, unit, bound / 2);
      for(const std::int64_t time : leg.times)
        set.times.push_back(time_unit * static_cast<double>(time));
    }
  return set;
}

// Legs that begin and end anywhere, during common times or not.
inline Object_set general_legs(const Kind& kind)
{
  Object_set set = Family_maker(kind).general();
  Random random(1);
  set.radii.assign(set.size(), 0.05);
  for(std::size_t i = 0; i < set.size(); ++i) {
    const double begin = i % 3 == 0 ? 0 : random.uniform();
    set.times.push_back(begin);
    set.times.push_back(i % 3 == 0 ? 1 : begin + random.uniform());
  }
  return set;
}

// The second leg of each pair is moved by a step along an axis, or not.
inline std::array<Meetings::Leg, 2> off_by_a_step(std::array<Meetings::Leg, 2> pair, Random& random)
{
  const auto axis = random.below(2);
  const auto step = static_cast<std::int64_t>(random.below(3)) - 1;
  for(Place& place : pair[1].places)
    place[axis] += step;
  return pair;
}

// Each coordinate and time stays, or goes to the next double up or down.
inline Object_set shifted_legs(Object_set set)
{
  Random random(2);
  shift_by_an_ulp(set.numbers, random);
  shift_by_an_ulp(set.times, random);
  return set;
}

// The unit of 32 bits makes integers of 53 bits, so that shares of legs are rounded.
inline std::vector<Object_set> track_families(const Kind& kind)
{
  constexpr double unit = 0x9E3779B9p0, time_unit = 0x9E3779B9p0;
  const auto passing = [](Meetings& m) { return m.meeting(Meetings::PASSING); };
  const auto approaching = [](Meetings& m) { return m.meeting(Meetings::APPROACHING); };
  const auto standing = [](Meetings& m) { return m.meeting(Meetings::STANDING); };
  Random random(3);
  return {
    general_legs(kind),
    legs_of(kind, "in between, small integers", 1, 1, passing),
    legs_of(kind, "in between, 53 bits", unit, 1, passing),
    legs_of(kind, "in between, tenths", .1, .1, passing),
    legs_of(kind, "at an end, 53 bits", unit, 1, approaching),
    legs_of(kind, "at an end, tenths", .1, .1, approaching),
    legs_of(kind, "standing still, 53 bits", unit, 1, standing),
    legs_of(kind, "standing still, tenths", .1, .1, standing),
    legs_of(kind, "times that touch", .1, .1,
            [](Meetings& m) { return m.meeting(Meetings::PASSING, Meetings::TOUCHING); }),
    legs_of(kind, "long durations", unit, time_unit, passing),
    legs_of(kind, "off by a step", unit, 1,
            [&](Meetings& m) { return off_by_a_step(m.meeting(Meetings::PASSING), random); }),
    shifted_legs(legs_of(kind, "shifted by an ulp", unit, 1, passing)),
  };
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_TRACK_FAMILIES_H
