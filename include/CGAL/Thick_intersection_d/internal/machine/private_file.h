// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PRIVATE_FILE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PRIVATE_FILE_H

// A file that no other user may open. The folder for temporary files is one for all users, and the
// standard library makes files that others may read, unless the user forbids it for all files.

#include <cstdio>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Makes an empty file that did not exist, for its owner alone where the system allows this. Returns
// false and sets errno if it cannot be made.
inline bool make_private_file(const char* name)
{
#if defined(__unix__) || defined(__APPLE__)
  const int file = ::open(name, O_WRONLY | O_CREAT | O_EXCL, 0600);
  return file != -1 && ::close(file) == 0;
#else
  std::FILE* const file = std::fopen(name, "wbx");
  return file != nullptr && std::fclose(file) == 0;
#endif
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PRIVATE_FILE_H
