// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_VERSION_H
#define CGAL_THICK_INTERSECTION_D_VERSION_H

// The version of this package. CMake reads it from here, and .ci/check_version.sh compares it with
// the files that have to repeat it. The header includes nothing, so that it may be asked first.

/*!
\ingroup PkgThickIntersectionDRef

is the version of the package as a string: the major, the minor and the patch number of
https://semver.org.
*/
#define CGAL_THICK_INTERSECTION_D_VERSION "0.2.0"

/*!
\ingroup PkgThickIntersectionDRef

is the version as a number, which grows with each release. It is made like `CGAL_VERSION_NR`, so
that `CGAL_VERSION_NUMBER(major, minor, patch)` of `<CGAL/config.h>` gives numbers to compare with.
*/
#define CGAL_THICK_INTERSECTION_D_VERSION_NR 1000201000

#endif // CGAL_THICK_INTERSECTION_D_VERSION_H
