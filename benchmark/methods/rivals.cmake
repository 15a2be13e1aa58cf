# Libraries that tables and the laboratory are compared with, and that have no files for CMake, or, as
# FCL, files that name targets which Debian does not install with it.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

find_path(THICK_GEOS_INCLUDE geos_c.h)
find_library(THICK_GEOS_LIBRARY geos_c)
find_library(THICK_FCL_LIBRARY fcl)
mark_as_advanced(THICK_GEOS_INCLUDE THICK_GEOS_LIBRARY THICK_FCL_LIBRARY)
