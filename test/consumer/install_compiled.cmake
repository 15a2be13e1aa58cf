# Installs the component of the package from the user's build in BUILD_DIR, which has the compiled
# searches, to an emptied PREFIX. Compiles the program SOURCE by what pkg-config says (if PKG_CONFIG
# names it), links the library, and runs it.
# Run by ctest: cmake -D ... -P install_compiled.cmake
#
# SPDX-License-Identifier: LGPL-3.0-or-later

cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${PREFIX})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --component Thick_intersection_d
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB libraries ${PREFIX}/${LIB_DIR}/*Thick_intersection_d.*)
if(NOT libraries)
  message(FATAL_ERROR "There is no library in ${PREFIX}/${LIB_DIR}.")
endif()

if(NOT PKG_CONFIG)
  message(STATUS "There is no pkg-config to test with.")
  return()
endif()

set(ENV{PKG_CONFIG_LIBDIR} ${PREFIX}/${DATA_DIR}/pkgconfig:${PREFIX}/${LIB_DIR}/pkgconfig)
execute_process(
  COMMAND ${PKG_CONFIG} --cflags Thick_intersection_d_compiled
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${PKG_CONFIG} --libs Thick_intersection_d_compiled
  OUTPUT_VARIABLE libraries OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT flags MATCHES "-DCGAL_THICK_INTERSECTION_D_COMPILED")
  message(FATAL_ERROR "pkg-config has the flags ${flags}.")
endif()
separate_arguments(flags)
separate_arguments(libraries)
execute_process(
  COMMAND ${COMPILER} -std=c++17 ${flags} ${SOURCE} ${libraries} -Wl,-rpath,${PREFIX}/${LIB_DIR}
          -o ${PREFIX}/program
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PREFIX}/program COMMAND_ERROR_IS_FATAL ANY)
