# Installs the build in BUILD_DIR to an emptied PREFIX, and fails unless exactly the headers of
# SOURCE_DIR arrived, and pkg-config (if PKG_CONFIG names it) finds them there in their VERSION.
# Examples and manual are to arrive if they are asked for.
# Run by ctest: cmake -D ... -P install.cmake
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

function(expect_file is_there name)
  file(GLOB_RECURSE found ${PREFIX}/${name})
  if((is_there AND NOT found) OR (found AND NOT is_there))
    message(FATAL_ERROR "The files ${name} in ${PREFIX}: '${found}'")
  endif()
endfunction()

function(install_component component result)
  execute_process(
    COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --component ${component}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}") # CMake breaks lines where paths are long
  set(${result} "${status} ${said}" PARENT_SCOPE)
endfunction()

expect_file(FALSE near_points.cpp)
install_component(examples result)
expect_file(TRUE near_points.cpp)
expect_file(TRUE spot.obj)
install_component(doc result)
if(EXISTS ${SOURCE_DIR}/build/doc/index.html)
  expect_file(TRUE Thick_intersection_d.tag)
elseif(NOT result MATCHES "^1 .*run scripts/doc first")
  message(FATAL_ERROR "Without a manual, its installation ends with ${result}")
endif()

if(NOT PKG_CONFIG)
  message(STATUS "There is no pkg-config to test with.")
  return()
endif()

# Asks only for what is installed in PREFIX.
set(ENV{PKG_CONFIG_LIBDIR} ${PREFIX}/${DATA_DIR}/pkgconfig)
function(ask_pkg_config result)
  execute_process(
    COMMAND ${PKG_CONFIG} ${ARGN} Thick_intersection_d
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  set(${result} ${answer} PARENT_SCOPE)
endfunction()

ask_pkg_config(version --modversion)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config finds version ${version} instead of ${VERSION}.")
endif()
ask_pkg_config(flags --cflags)
string(REGEX MATCH "-I([^ ]+)" option "${flags}")
file(REAL_PATH "${CMAKE_MATCH_1}" folder)
file(REAL_PATH ${PREFIX}/${INCLUDE_DIR} expected)
if(NOT folder STREQUAL expected)
  message(FATAL_ERROR "pkg-config has the flags ${flags}, which do not name ${expected}.")
endif()
