# Installs the build in BUILD_DIR to an emptied PREFIX, and fails unless exactly the headers of
# SOURCE_DIR arrived. Run by ctest: cmake -D ... -P install.cmake
#
# SPDX-License-Identifier: LGPL-3.0-or-later

cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${PREFIX})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --config "${CONFIG}"
  COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE expected RELATIVE ${SOURCE_DIR}/include
  ${SOURCE_DIR}/include/*.h ${SOURCE_DIR}/include/*.inc)
file(GLOB_RECURSE installed RELATIVE ${PREFIX}/${INCLUDE_DIR} ${PREFIX}/${INCLUDE_DIR}/*)
set(missing ${expected})
list(REMOVE_ITEM missing ${installed})
set(unexpected ${installed})
list(REMOVE_ITEM unexpected ${expected})
if(NOT expected OR missing OR unexpected)
  message(FATAL_ERROR "Headers: missing\n  ${missing}\nunexpected\n  ${unexpected}")
endif()
