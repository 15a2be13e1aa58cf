// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_PROFILE_H
#define CGAL_DISTRIBUTED_PROFILE_H

// Where the points of a distributed search are, and what the search has cost.

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

says which process of a distributed search searches a point.
*/
enum class Point_distribution {
  BALANCED, ///< Space is cut into parts of about the same work, and points move to the process of
            ///< their part.
  AS_IS     ///< Points stay on the process that has them. This is for processes whose points are
            ///< near each other already: only points near those of another process are sent.
};

/*!
\ingroup PkgThickIntersectionDRef

names the phases of a distributed search.
*/
enum class Distributed_phase {
  CHECK,     ///< The points and the bound are read and checked.
  PARTITION, ///< Samples decide where to cut space.
  MIGRATION, ///< Points move to the process that searches them.
  HALO,      ///< Points near those of another process are sent to it.
  SEARCH,    ///< Each process searches its points.
  LISTS      ///< Lists of neighbors, if wanted, are sent to the processes whose points they are of.
};

/*!
\ingroup PkgThickIntersectionDRef

says how the points of a distributed search are to be distributed, and describes the search
afterwards, on each process.

\sa `distributed_fixed_radius_near_neighbors()`
\sa `distributed_fixed_radius_neighbor_lists()`
*/
class Distributed_profile
{
public:
  /// constructs the profile of no search.
  explicit Distributed_profile(Point_distribution distribution = Point_distribution::BALANCED)
    : distribution_(distribution)
  {}

  /// returns how the points are distributed.
  Point_distribution distribution() const { return distribution_; }

  /// returns the time that a phase has taken on this process, with the time it waited for others.
  double seconds(Distributed_phase phase) const { return seconds_[index(phase)]; }

  /// returns the number of bytes that this process has sent in a phase, in messages with points
  /// or lists.
  std::uint64_t bytes_sent(Distributed_phase phase) const { return bytes_sent_[index(phase)]; }

  /// returns the number of points that this process has searched, of both sets if there are two.
  std::size_t size_of_points() const { return point_count_; }

  /// returns the number of points that other processes have sent to this one because they are near.
  std::size_t size_of_halo() const { return halo_count_; }

#ifndef DOXYGEN_RUNNING
  void set_seconds(Distributed_phase phase, double seconds) { seconds_[index(phase)] = seconds; }
  void set_bytes_sent(Distributed_phase phase, std::uint64_t bytes)
  {
    bytes_sent_[index(phase)] = bytes;
  }
  void set_sizes(std::size_t points, std::size_t halo)
  {
    point_count_ = points;
    halo_count_ = halo;
  }
#endif

private:
  static std::size_t index(Distributed_phase phase) { return static_cast<std::size_t>(phase); }

  Point_distribution distribution_;
  std::array<double, 6> seconds_{};
  std::array<std::uint64_t, 6> bytes_sent_{};
  std::size_t point_count_ = 0;
  std::size_t halo_count_ = 0;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_PROFILE_H
