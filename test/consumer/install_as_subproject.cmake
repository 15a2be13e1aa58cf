# Installs the user's project in BUILD_DIR, which has the package as a subdirectory, to an emptied
# PREFIX. Fails if the package comes uninvited, or does not come when its component is asked for.
# Run by ctest: cmake -D ... -P install_as_subproject.cmake
#
# SPDX-License-Identifier: LGPL-3.0-or-later

cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${PREFIX})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX}
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE installed RELATIVE ${PREFIX} ${PREFIX}/*)
if(NOT installed STREQUAL "share/cmake/consumer/consumer_targets.cmake")
  message(FATAL_ERROR "The user's project installs\n  ${installed}")
endif()

execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --component Thick_intersection_d
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE found
  ${PREFIX}/version.h ${PREFIX}/Thick_intersection_dTargets.cmake ${PREFIX}/Thick_intersection_d.pc)
if(EXISTS ${PREFIX}/share/doc/Thick_intersection_d/LICENSE)
  list(APPEND found LICENSE)
endif()
list(LENGTH found count)
if(NOT count EQUAL 4)
  message(FATAL_ERROR "Of the component, there is only\n  ${found}")
endif()
