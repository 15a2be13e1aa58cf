# Installs the build in BUILD_DIR to an emptied PREFIX, and fails unless exactly the headers of
# SOURCE_DIR arrived. Run by ctest: cmake -D ... -P install.cmake
#
# SPDX-License-Identifier: LGPL-3.0-or-later

cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${PREFIX})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --config "${CONFIG}"
  COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE expected RELATIVE ${SOURCE_DIR}/include ${SOURCE_DIR}/include/*.h)
file(GLOB_RECURSE installed RELATIVE ${PREFIX}/${INCLUDE_DIR} ${PREFIX}/${INCLUDE_DIR}/*)
if(NOT expected OR NOT expected STREQUAL installed)
  message(FATAL_ERROR "Headers: expected\n  ${expected}\ninstalled\n  ${installed}")
endif()
