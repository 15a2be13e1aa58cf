# Functions for the programs of this package (examples and tests); users of the library never see
# this file.
#
#   thick_add_program(<name> <source>... [HEADERS_ALONE] [SUPPORT <library>...])
#
# builds a program with warnings. It links the compiled searches, unless it says HEADERS_ALONE, and
# the further libraries it names:
#
#   TBB               CGAL::TBB_support: CGAL::Parallel_tag runs in parallel
#   Eigen3            CGAL::Eigen3_support: CGAL::Epick_d, CGAL::Epeck_d
#   GMP MPFR          the number libraries themselves, for a program that calls them directly
#   MPI               an implementation of MPI, without its C++ bindings
#   Program_options   Boost.Program_options
#   Iostreams         Boost.Iostreams, with its filters for gzip
#   JSON              nlohmann's library of JSON, which has headers only
#   Gemmi             the library gemmi of molecules, of which only headers are taken
#   Unit_test         Boost.Test, linked dynamically, with a main function
#
# When one of them is missing the target is not made, and the reason is printed; with
# THICK_INTERSECTION_REQUIRE_ALL=ON that is an error.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# One interface target thick_support_<library> for each library that was found.
function(thick_provide_support name)
  add_library(thick_support_${name} INTERFACE)
  target_link_libraries(thick_support_${name} INTERFACE ${ARGN})
endfunction()

find_package(TBB QUIET)
include(CGAL_TBB_support)
if(TARGET CGAL::TBB_support)
  thick_provide_support(TBB CGAL::TBB_support)
endif()

find_package(Eigen3 3.1.0 QUIET)
include(CGAL_Eigen3_support)
if(TARGET CGAL::Eigen3_support)
  thick_provide_support(Eigen3 CGAL::Eigen3_support)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_dMPI.cmake)
if(TARGET Thick_intersection_d::MPI)
  thick_provide_support(MPI Thick_intersection_d::MPI)
endif()

foreach(library IN ITEMS GMP MPFR)
  string(TOLOWER ${library} file)
  find_library(THICK_${library}_LIBRARY ${file})
  mark_as_advanced(THICK_${library}_LIBRARY)
  if(THICK_${library}_LIBRARY)
    thick_provide_support(${library} ${THICK_${library}_LIBRARY})
  endif()
endforeach()

set(Boost_USE_STATIC_LIBS OFF)
find_package(Boost QUIET OPTIONAL_COMPONENTS program_options iostreams unit_test_framework)
if(TARGET Boost::program_options)
  thick_provide_support(Program_options Boost::program_options)
endif()
if(TARGET Boost::iostreams)
  thick_provide_support(Iostreams Boost::iostreams)
endif()
find_package(nlohmann_json QUIET)
if(TARGET nlohmann_json::nlohmann_json)
  thick_provide_support(JSON nlohmann_json::nlohmann_json)
endif()
# The headers of gemmi need those of PEGTL, which Debian has apart, and others among them.
find_path(THICK_GEMMI_INCLUDE_DIR gemmi/cif.hpp)
find_path(THICK_PEGTL_INCLUDE_DIR tao/pegtl.hpp
  HINTS ${THICK_GEMMI_INCLUDE_DIR}/gemmi/third_party)
mark_as_advanced(THICK_GEMMI_INCLUDE_DIR THICK_PEGTL_INCLUDE_DIR)
if(THICK_GEMMI_INCLUDE_DIR AND THICK_PEGTL_INCLUDE_DIR)
  add_library(thick_gemmi INTERFACE)
  target_include_directories(thick_gemmi SYSTEM INTERFACE
    ${THICK_GEMMI_INCLUDE_DIR} ${THICK_PEGTL_INCLUDE_DIR})
  thick_provide_support(Gemmi thick_gemmi)
endif()
if(TARGET Boost::unit_test_framework)
  add_library(thick_test_main STATIC EXCLUDE_FROM_ALL
    ${CMAKE_CURRENT_LIST_DIR}/../test/support/test_main.cpp)
  target_link_libraries(thick_test_main PUBLIC Boost::unit_test_framework)
  target_compile_definitions(thick_test_main PUBLIC "BOOST_TEST_DYN_LINK=")
  thick_provide_support(Unit_test thick_test_main)
endif()

# Warnings for our own sources and headers. Those of CGAL and Boost are system headers to the
# compiler. Whether a warning is an error is the builder's choice: CMAKE_COMPILE_WARNING_AS_ERROR.
function(thick_enable_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic>
    $<$<CXX_COMPILER_ID:MSVC>:/W4>)
endfunction()

# Sets `result` to whether all the libraries named after the program are there.
function(thick_has_support result program)
  set(missing)
  foreach(library IN LISTS ARGN)
    if(NOT TARGET thick_support_${library})
      list(APPEND missing ${library})
    endif()
  endforeach()

  if(missing)
    list(JOIN missing ", " missing)
    if(THICK_INTERSECTION_REQUIRE_ALL)
      message(FATAL_ERROR "${program} needs ${missing}; see scripts/install-dependencies")
    endif()
    message(STATUS "${program} is left out, it needs ${missing}; see scripts/install-dependencies")
    set(${result} FALSE PARENT_SCOPE)
  else()
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

function(thick_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "HEADERS_ALONE" "" "SUPPORT")
  thick_has_support(is_possible ${name} ${ARG_SUPPORT})
  if(is_possible)
    add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
    list(TRANSFORM ARG_SUPPORT PREPEND thick_support_)
    set(package compiled)
    if(ARG_HEADERS_ALONE)
      set(package Thick_intersection_d)
    endif()
    target_link_libraries(${name} PRIVATE Thick_intersection_d::${package} ${ARG_SUPPORT})
    thick_enable_warnings(${name})
    thick_take_precompiled(${name})
  endif()
endfunction()
