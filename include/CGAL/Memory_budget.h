// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_MEMORY_BUDGET_H
#define CGAL_MEMORY_BUDGET_H

// How much memory a search may take, and where it may write what does not fit.

#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

states how many bytes of memory a search may take for its own data, and the folder for the file that
holds the rest.

\sa `external_fixed_radius_near_neighbors()`
*/
class Memory_budget
{
public:
  /// constructs a budget of so many bytes. The default folder is that of the system for temporary
  /// files, which the environment variable `TMPDIR` names on POSIX systems.
  /// \throws std::system_error if there is no such folder.
  explicit Memory_budget(std::size_t bytes, std::filesystem::path directory = default_directory())
    : bytes_(bytes), directory_(std::move(directory))
  {}

  /// returns the number of bytes.
  std::size_t bytes() const { return bytes_; }

  /// returns the folder.
  const std::filesystem::path& directory() const { return directory_; }

private:
  // The message of the standard library names neither what is wanted nor how to name another one.
  static std::filesystem::path default_directory()
  {
    std::error_code error;
    std::filesystem::path directory = std::filesystem::temp_directory_path(error);
    if(error)
      throw std::system_error(error, "There is no folder for temporary files, which TMPDIR names");
    return directory;
  }

  std::size_t bytes_;
  std::filesystem::path directory_;
};

} // namespace CGAL

#endif // CGAL_MEMORY_BUDGET_H
