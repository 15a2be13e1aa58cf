# Sets `thick_version` to the version in CGAL/Thick_intersection_d/version.h, the one place that
# says it. A change of the header configures the build again.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

set(thick_version_header
  ${CMAKE_CURRENT_LIST_DIR}/../include/CGAL/Thick_intersection_d/version.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${thick_version_header})

file(STRINGS ${thick_version_header} thick_version_line
  REGEX "^#define CGAL_THICK_INTERSECTION_D_VERSION \"[0-9]+\\.[0-9]+\\.[0-9]+\"$")
if(NOT thick_version_line MATCHES "\"(.*)\"")
  message(FATAL_ERROR "${thick_version_header} defines no version.")
endif()
set(thick_version ${CMAKE_MATCH_1})
