# The library of searches that programs link instead of compiling them. It names no thread and no
# kernel: programs with oneTBB and without link the same library.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# The programs of this tree link it in any case, so it may be built only for these.
set(thick_only_for_programs EXCLUDE_FROM_ALL)
if(THICK_INTERSECTION_COMPILED)
  set(thick_only_for_programs)
endif()

add_library(Thick_intersection_d_compiled ${thick_only_for_programs}
  ${PROJECT_SOURCE_DIR}/src/arithmetic.cpp
  ${PROJECT_SOURCE_DIR}/src/boxes.cpp
  ${PROJECT_SOURCE_DIR}/src/closest_pair.cpp
  ${PROJECT_SOURCE_DIR}/src/hash.cpp
  ${PROJECT_SOURCE_DIR}/src/lists.cpp
  ${PROJECT_SOURCE_DIR}/src/near_points.cpp
  ${PROJECT_SOURCE_DIR}/src/objects.cpp)
add_library(Thick_intersection_d::compiled ALIAS Thick_intersection_d_compiled)
target_link_libraries(Thick_intersection_d_compiled PUBLIC Thick_intersection_d)
target_compile_definitions(Thick_intersection_d_compiled
  INTERFACE CGAL_THICK_INTERSECTION_D_COMPILED)

# Headers and library fit each other only if they are of one version.
set_target_properties(Thick_intersection_d_compiled PROPERTIES
  EXPORT_NAME compiled
  OUTPUT_NAME Thick_intersection_d
  POSITION_INDEPENDENT_CODE ON
  SOVERSION ${PROJECT_VERSION}
  VERSION ${PROJECT_VERSION}
  WINDOWS_EXPORT_ALL_SYMBOLS ON)
