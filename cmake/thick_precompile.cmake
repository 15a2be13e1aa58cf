# With THICK_INTERSECTION_PRECOMPILE, the headers of the kernel that most programs include are
# compiled once, not once for each file. It is for checks, which run programs for a moment: some
# have less optimization.
#
#   thick_take_precompiled(<target>)
#
# gives them to a target that is already linked with its libraries, but not to one with Eigen, which
# the headers of CGAL take notice of. If a target has further options that change what the headers
# are compiled to, it must set the property DISABLE_PRECOMPILE_HEADERS.
#
# A file that forgets to include such a header is found by the builds without this option.
# Boost.Test is among the headers, and so it is among the libraries of all these targets.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

option(THICK_INTERSECTION_PRECOMPILE
  "Compile for checks: some programs with -Og, headers of the kernel once, in 0.9 GB of disk" OFF)

set(thick_boost_test $<TARGET_NAME_IF_EXISTS:thick_support_Unit_test>)

# The tags of CGAL differ with oneTBB, so the headers are compiled with it and without.
function(thick_precompile name)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE
    Thick_intersection_d::Thick_intersection_d ${thick_boost_test} ${ARGN})
  thick_enable_warnings(${name})
  target_precompile_headers(${name} PRIVATE
    <CGAL/Exact_predicates_exact_constructions_kernel.h>
    <CGAL/Exact_predicates_inexact_constructions_kernel.h>
    <CGAL/Exact_rational.h>
    <CGAL/Simple_cartesian.h>
    <algorithm>
    <array>
    <boost/multiprecision/cpp_int.hpp>
    $<$<BOOL:${thick_boost_test}>:<boost/test/unit_test.hpp$<ANGLE-R>>
    <cmath>
    <iostream>
    <optional>
    <random>
    <string>
    <vector>)
endfunction()

if(THICK_INTERSECTION_PRECOMPILE)
  thick_precompile(thick_precompiled)
  if(TARGET CGAL::TBB_support)
    thick_precompile(thick_precompiled_with_TBB CGAL::TBB_support)
  endif()
endif()

function(thick_take_precompiled target)
  if(NOT THICK_INTERSECTION_PRECOMPILE)
    return()
  endif()
  get_target_property(libraries ${target} LINK_LIBRARIES)
  if(libraries MATCHES "Eigen3")
    return()
  endif()
  target_link_libraries(${target} PRIVATE ${thick_boost_test})
  if(libraries MATCHES "TBB")
    target_precompile_headers(${target} REUSE_FROM thick_precompiled_with_TBB)
  else()
    target_precompile_headers(${target} REUSE_FROM thick_precompiled)
  endif()
endfunction()
