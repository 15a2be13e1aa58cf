// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REMOTE_ERROR_H
#define CGAL_REMOTE_ERROR_H

// What the processes of a distributed search throw if another process has thrown.

#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

is thrown by a distributed search on each process that has not failed itself, if another process
has. The process that has failed throws its own exception.

\sa `distributed_fixed_radius_near_neighbors()`
*/
class Remote_error : public std::runtime_error
{
public:
  /// constructs the error of a process.
  Remote_error(int rank, const std::string& message)
    : std::runtime_error("Rank " + std::to_string(rank) + ": " + message), rank_(rank)
  {}

  /// returns the rank of the process that has failed, the first one if there are several.
  int rank() const { return rank_; }

private:
  int rank_;
};

} // namespace CGAL

#endif // CGAL_REMOTE_ERROR_H
