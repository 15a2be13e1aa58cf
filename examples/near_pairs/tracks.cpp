// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rows to tracks; see tracks.h.

#include "tracks.h"

#include "error.h"
#include "point_file.h"
#include "rational.h"
#include "row_reader.h"
#include "velocity.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace near_pairs {
namespace {

CGAL::Exact_rational rational_of(std::int64_t number)
{
  return to_rational(*parse_decimal(std::to_string(number)));
}

// digits * 10^zeros, or nothing if the difference of two such numbers may be too large.
std::optional<std::int64_t> with_zeros(std::int64_t digits, int zeros)
{
  for(; zeros > 0 && digits != 0; --zeros) {
    if(std::abs(digits) > std::numeric_limits<std::int64_t>::max() / 20)
      return std::nullopt;
    digits *= 10;
  }
  return digits;
}

Error error_in(const Place& place, const std::string& what)
{
  return Error(place.input.name(), place.row.line, what);
}

// Collects what the rows tell besides their places, and makes tracks of it.
class Tracks_maker
{
public:
  explicit Tracks_maker(const Options& options) : options_(options) {}

  Tracks make()
  {
    const bool has_times = !options_.readings.front().time.empty();
    result_.scene = read_scene(options_, [&](const Place& place) {
      has_times ? add_time(place) : add_velocity(place);
    });
    result_.fixes = result_.scene.size();
    const std::size_t first_points = result_.scene.first_size.value_or(result_.fixes);
    result_.first_size = std::count_if(
      result_.tracks.begin(), result_.tracks.end(), [&](const Track& track) {
        return track.pieces.front().front().point < first_points;
      });
    if(options_.files.size() == 1 && input_ && !has_ids_)
      throw Error(options_.files.front(), "is one track; --track names the column that tells "
                                          "several apart");
    if(has_times)
      make_pieces();
    else
      look_ahead();
    return std::move(result_);
  }

private:
  // ---- places at times --------------------------------------------------------------------------

  void add_time(const Place& place)
  {
    const Time time = time_of(place);
    if(&place.input != input_) {
      numbers_.clear();
      input_ = &place.input;
    }
    if(place.reader.has_ids && place.row.id.empty())
      throw error_in(place, "the row has no track" + place.reader.advice_on_missing());
    has_ids_ = place.reader.has_ids;
    const auto [track, is_new] = numbers_.emplace(place.row.id, result_.tracks.size());
    if(is_new)
      result_.tracks.push_back({place.reader.has_ids ? place.row.id : place.input.name(), {{}}});
    result_.tracks[track->second].pieces.front().push_back({0, times_.size(), place.row.line});
    times_.push_back({time.digits, time.exponent});
    result_.scale = std::max(result_.scale, -time.exponent);
  }

  // The time of a row. The first one is an example for the others.
  Time time_of(const Place& place)
  {
    const std::string& text = place.row.motion.front();
    const std::string& name = place.reader.motion_names.front();
    const auto time = parse_time(text);
    if(!time && is_missing(text))
      throw error_in(place, name + (text.empty() ? " is empty" : ": '" + text + "' is no time")
                            + place.reader.advice_on_missing());
    if(!time)
      throw error_in(place, name + ": '" + text + "' is no time: a number, hh:mm:ss, or a date as "
                            "2018-08-01T05:00:00Z");
    if(times_.empty())
      result_.form = time->form;
    if(time->form.kind != result_.form.kind)
      throw error_in(place, name + ": '" + text + "' is not written as the first time is");
    if(!are_comparable(time->form, result_.form))
      throw error_in(place, name + ": '" + text + "' has "
                            + (time->form.zone.empty() ? "no zone, and the first time has one"
                                                       : "a zone, and the first time has none"));
    return *time;
  }

  void make_pieces()
  {
    const std::vector<std::int64_t> ticks = ticks_of_times();
    const std::int64_t first
      = ticks.empty() ? 0 : *std::min_element(ticks.begin(), ticks.end());
    result_.first_tick = first;
    for(std::size_t number = 0; number < result_.tracks.size(); ++number) {
      Track& track = result_.tracks[number];
      Piece fixes = std::move(track.pieces.front());
      for(Fix& fix : fixes)
        fix.tick = ticks[fix.point] - first;
      sort(fixes, track.id, options_.files[number < result_.first_size ? 0 : 1]);
      track.pieces = cut_at_gaps(std::move(fixes));
    }
  }

  // All times as integers at the scale.
  std::vector<std::int64_t> ticks_of_times() const
  {
    std::vector<std::int64_t> ticks;
    for(const auto& [digits, exponent] : times_) {
      const auto tick = with_zeros(digits, exponent + result_.scale);
      if(!tick)
        throw Error("times have more than 18 digits at the scale of the finest one, 10^-"
                    + std::to_string(result_.scale) + " seconds");
      ticks.push_back(*tick);
    }
    return ticks;
  }

  // Puts the fixes of a track in the order of time. A row that repeats another one is no fix.
  void sort(Piece& fixes, const std::string& id, const std::string& file) const
  {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const Fix& a, const Fix& b) { return a.tick < b.tick; });
    const auto end = std::unique(fixes.begin(), fixes.end(), [&](const Fix& a, const Fix& b) {
      if(a.tick != b.tick)
        return false;
      if(!are_at_one_place(a.point, b.point))
        throw Error(file, b.line, "track " + id + " is at another place at the same time on line "
                                  + std::to_string(a.line));
      return true;
    });
    fixes.erase(end, fixes.end());
  }

  bool are_at_one_place(std::size_t p, std::size_t q) const
  {
    const Scene& scene = result_.scene;
    for(int axis = 0; axis < scene.dimension; ++axis) {
      const std::size_t a = p * scene.dimension + axis, b = q * scene.dimension + axis;
      if(scene.exact.empty() ? scene.doubles[a] != scene.doubles[b]
                             : scene.exact[a].value != scene.exact[b].value)
        return false;
    }
    return true;
  }

  std::vector<Piece> cut_at_gaps(Piece fixes) const
  {
    if(!options_.max_gap)
      return {std::move(fixes)};
    const CGAL::Exact_rational most = (*options_.max_gap)->value * power_of_ten(result_.scale);
    std::vector<Piece> pieces;
    for(const Fix& fix : fixes) {
      if(pieces.empty() || rational_of(fix.tick - pieces.back().back().tick) > most)
        pieces.emplace_back();
      pieces.back().push_back(fix);
    }
    return pieces;
  }

  // ---- velocities -------------------------------------------------------------------------------

  void add_velocity(const Place& place)
  {
    if(place.row.motion.size() == 3 && place.reader.dimension == 2)
      throw error_in(place, "--velocity names a climb, and the points have two coordinates");
    const Velocity velocity = read_velocity(place, options_.geographic);
    result_.standing += !velocity.is_known;
    result_.tracks.push_back({place.row.id, {{{0, velocities_.size(), place.row.line}}}});
    velocities_.push_back(velocity);
  }

  // Adds the points after the time, behind all others.
  void look_ahead()
  {
    Scene& scene = result_.scene;
    const double seconds = to_double(options_.until);
    for(std::size_t point = 0; point < velocities_.size(); ++point) {
      std::array<double, 3> place = {0, 0, 0};
      for(int axis = 0; axis < scene.dimension; ++axis)
        place[axis] = scene.coordinate(point, axis);
      place = (scene.is_geographic ? place_on_sphere_after : place_after)(
        place, velocities_[point], seconds);
      Piece& fixes = result_.tracks[point].pieces.front();
      const std::size_t line = fixes.front().line;
      for(double coordinate : place)
        if(!std::isfinite(coordinate))
          throw Error(options_.files[point < result_.first_size ? 0 : 1], line,
                      "the point moves beyond the numbers of a computer");
      fixes.push_back({1, scene.size(), line});
      scene.doubles.insert(scene.doubles.end(), place.begin(), place.begin() + scene.dimension);
    }
    result_.are_looked_ahead = true;
    scene.rounding = 0; // other numbers than decimals are compared
    result_.look_ahead = seconds;
  }

  const Options& options_;
  Tracks result_;
  const Input* input_ = nullptr; // of the row in hand, if it has a time
  bool has_ids_ = false;         // of the same
  std::map<std::string, std::size_t> numbers_; // of the tracks of a file
  std::vector<std::pair<std::int64_t, int>> times_; // of the points: digits and exponents
  std::vector<Velocity> velocities_; // of the points
};

} // namespace

std::size_t Tracks::position(std::size_t track) const
{
  if(are_looked_ahead)
    return scene.position(track);
  return track < first_size ? track : track - first_size;
}

std::array<double, 3> Tracks::place_at(std::size_t track, double tick) const
{
  const std::vector<Piece>& pieces = tracks[track].pieces;
  const auto piece = std::find_if(pieces.begin(), std::prev(pieces.end()), [&](const Piece& one) {
    return tick <= static_cast<double>(one.back().tick);
  });
  const auto begins_before = [&](const Fix& fix) { return static_cast<double>(fix.tick) < tick; };
  const auto next = std::partition_point(piece->begin(), std::prev(piece->end()), begins_before);
  const Fix& from = next == piece->begin() ? *next : *std::prev(next);
  const double part = next == piece->begin()
    ? 0 : (tick - static_cast<double>(from.tick)) / static_cast<double>(next->tick - from.tick);
  std::array<double, 3> place = {0, 0, 0};
  for(int axis = 0; axis < scene.dimension; ++axis) {
    const double begin = scene.coordinate(from.point, axis);
    place[axis] = begin + part * (scene.coordinate(next->point, axis) - begin);
  }
  return place;
}

std::string Tracks::time_text(std::int64_t tick, double part) const
{
  if(are_looked_ahead)
    return seconds_text((static_cast<double>(tick) + part) * look_ahead);
  return near_pairs::time_text({first_tick + tick, part, scale}, form);
}

double Tracks::longest_leg() const
{
  double longest = 0;
  for(const Track& track : tracks)
    for(const Piece& piece : track.pieces)
      for(std::size_t fix = 1; fix < piece.size(); ++fix)
        longest = std::max(longest, scene.distance(piece[fix - 1].point, piece[fix].point, {}));
  return longest;
}

bool have_tracks(const Options& options)
{
  return std::any_of(options.readings.begin(), options.readings.end(),
                     [](const Read_options& reading) {
                       return !reading.time.empty() || !reading.velocity.empty();
                     });
}

Tracks read_tracks(const Options& options)
{
  return Tracks_maker(options).make();
}

} // namespace near_pairs
