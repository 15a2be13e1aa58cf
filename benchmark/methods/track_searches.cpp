// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "leg_forms.h"
#include "on_objects.h"
#include "track_methods.h"

#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/thick_box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace {

template <class Point>
using Tracks_of = std::vector<std::vector<std::pair<double, Point>>>;

// Of search(tracks, r, answer), on tracks of EPICK.
template <class Answer, class Point, class Search>
Run<Answer> run_on_tracks(const Track_scene& scene, const Search& search)
{
  const auto tracks = std::make_shared<Tracks_of<Point>>();
  for(const Track& track : scene.tracks) {
    tracks->emplace_back();
    for(const Place_at_time& fix : track)
      tracks->back().emplace_back(fix.time, point_at<Point>(fix.place.data()));
  }
  return [tracks, search, r = scene.r] {
    Answer answer;
    search(std::as_const(*tracks), r, answer);
    return answer;
  };
}

template <class Answer, class Search>
auto on_tracks(const Search& search)
{
  return [search](const Track_scene& scene) {
    return scene.dimension == 2 ? run_on_tracks<Answer, Epick::Point_2>(scene, search)
                                : run_on_tracks<Answer, Epick::Point_3>(scene, search);
  };
}

// ---- boxes --------------------------------------------------------------------------------------

template <std::size_t Axes>
struct Leg_box
{
  std::array<double, Axes> low, high;

  static constexpr int dimension() { return Axes; }
  double min_coord(int axis) const { return low[static_cast<std::size_t>(axis)]; }
  double max_coord(int axis) const { return high[static_cast<std::size_t>(axis)]; }
};

template <class Fix>
auto box_of_leg(const Fix& first, const Fix& last, double r)
{
  constexpr std::size_t dimension = CGAL::Ambient_dimension<typename Fix::second_type>::value;
  Leg_box<dimension + 1> box;
  for(std::size_t axis = 0; axis < dimension; ++axis) {
    const double x = first.second[static_cast<int>(axis)], y = last.second[static_cast<int>(axis)];
    box.low[axis] = (std::min)(x, y) - r / 2;
    box.high[axis] = (std::max)(x, y) + r / 2;
  }
  box.low[dimension] = first.first;
  box.high[dimension] = last.first;
  return box;
}

template <class Tracks>
auto boxes_of(const Tracks& tracks, double r)
{
  std::vector<decltype(box_of_leg(tracks[0][0], tracks[0][0], r))> boxes;
  for(const auto& track : tracks)
    for(std::size_t k = 1; k < track.size(); ++k)
      boxes.push_back(box_of_leg(track[k - 1], track[k], r));
  return boxes;
}

// ---- doubles ------------------------------------------------------------------------------------

// A leg, and its box.
template <std::size_t N>
struct Boxed_leg : Leg_box<N + 1>
{
  std::size_t track;
  Plain_leg<double, N> leg;
};

template <std::size_t N, class Tracks>
std::vector<Boxed_leg<N>> boxed_legs(const Tracks& tracks, double r)
{
  std::vector<Boxed_leg<N>> legs;
  for(std::size_t i = 0; i < tracks.size(); ++i)
    for(std::size_t k = 1; k < tracks[i].size(); ++k) {
      const auto &first = tracks[i][k - 1], &last = tracks[i][k];
      Plain_leg<double, N> leg = {{first.first, last.first}, {}};
      for(std::size_t axis = 0; axis < N; ++axis)
        leg.ends[0][axis] = first.second[static_cast<int>(axis)],
        leg.ends[1][axis] = last.second[static_cast<int>(axis)];
      legs.push_back({box_of_leg(first, last, r), i, leg});
    }
  return legs;
}

template <std::size_t Axes>
bool do_meet(const Leg_box<Axes>& a, const Leg_box<Axes>& b)
{
  for(std::size_t axis = 0; axis < Axes; ++axis)
    if(a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis])
      return false;
  return true;
}

// Sorts the pairs and drops those that are there already.
void drop_copies(Pair_list& list)
{
  std::sort(list.pairs.begin(), list.pairs.end());
  list.pairs.erase(std::unique(list.pairs.begin(), list.pairs.end()), list.pairs.end());
}

// Of the sum of all lengths along an axis.
template <class Legs>
double share_of_space(const Legs& legs, std::size_t axis)
{
  double low = legs[0].low[axis], high = legs[0].high[axis], sum = 0;
  for(const auto& leg : legs) {
    low = (std::min)(low, leg.low[axis]);
    high = (std::max)(high, leg.high[axis]);
    sum += leg.high[axis] - leg.low[axis];
  }
  return sum / (high - low);
}

template <std::size_t N, class Tracks>
void sweep(const Tracks& tracks, double r, Pair_list& pairs)
{
  std::vector<Boxed_leg<N>> legs = boxed_legs<N>(tracks, r);
  const std::size_t axis = share_of_space(legs, 0) < share_of_space(legs, N) ? 0 : N;
  std::sort(legs.begin(), legs.end(),
            [=](const auto& a, const auto& b) { return a.low[axis] < b.low[axis]; });
  for(auto a = legs.begin(); a != legs.end(); ++a)
    for(auto b = a + 1; b != legs.end() && b->low[axis] <= a->high[axis]; ++b)
      if(a->track != b->track && do_meet(*a, *b) && come_within(a->leg, b->leg, r))
        pairs((std::min)(a->track, b->track), (std::max)(a->track, b->track));
  drop_copies(pairs);
}

// ---- minutes ------------------------------------------------------------------------------------

// The tracks that there are at one time, and where.
template <class Point>
struct Instant
{
  std::vector<Point> points;
  std::vector<std::size_t> tracks;
};

template <class Point>
Point place_at(double time, const std::pair<double, Point>& a, const std::pair<double, Point>& b)
{
  return a.second + (b.second - a.second) * ((time - a.first) / (b.first - a.first));
}

template <class Point>
std::map<double, Instant<Point>> minutes_of(const Tracks_of<Point>& tracks)
{
  std::map<double, Instant<Point>> minutes;
  for(std::size_t i = 0; i < tracks.size(); ++i)
    for(std::size_t k = 1; k < tracks[i].size(); ++k) {
      const auto &first = tracks[i][k - 1], &last = tracks[i][k];
      const bool is_last = k + 1 == tracks[i].size(); // otherwise the next leg has the last time
      for(double t = std::ceil(first.first); t < last.first || (is_last && t == last.first); ++t) {
        minutes[t].points.push_back(place_at(t, first, last));
        minutes[t].tracks.push_back(i);
      }
    }
  return minutes;
}

} // namespace

Track_method tracks_ours()
{
  return {"fixed_radius_near_tracks",
          on_tracks<Pair_list>([](const auto& tracks, double r, Pair_list& pairs) {
            CGAL::fixed_radius_near_tracks(tracks, CGAL::within_distance(r), pairs);
          })};
}

Method<Tally, Track_scene> boxes_of_legs()
{
  return {"boxes of legs alone", on_tracks<Tally>([](const auto& tracks, double r, Tally& tally) {
            const auto boxes = boxes_of(tracks, r);
            const auto position = [&](const auto& box) {
              return static_cast<std::size_t>(&box - boxes.data());
            };
            CGAL::thick_box_self_intersection_d(
              boxes.begin(), boxes.end(),
              [&](const auto& a, const auto& b) { tally(position(a), position(b)); });
          })};
}

Track_method tracks_by_sweep()
{
  return {"sweep in doubles",
          on_tracks<Pair_list>([](const auto& tracks, double r, Pair_list& pairs) {
            using Point = typename std::decay_t<decltype(tracks[0][0])>::second_type;
            sweep<CGAL::Ambient_dimension<Point>::value>(tracks, r, pairs);
          })};
}

Track_method tracks_by_minutes()
{
  return {"positions each minute",
          on_tracks<Pair_list>([](const auto& tracks, double r, Pair_list& pairs) {
            for(const auto& [time, instant] : minutes_of(tracks))
              CGAL::fixed_radius_near_neighbors(
                instant.points, CGAL::within_distance(r),
                [&, &which = instant.tracks](std::size_t i, std::size_t j) {
                  pairs((std::min)(which[i], which[j]), (std::max)(which[i], which[j]));
                });
            drop_copies(pairs);
          })};
}

} // namespace thick_benchmark
