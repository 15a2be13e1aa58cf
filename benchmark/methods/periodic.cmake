# The methods of periodic searches, for periodic_table and for the laboratory, which may be built
# without the other. The sources of vesin are no package of Debian.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

include_guard(GLOBAL)

set(THICK_INTERSECTION_VESIN "" CACHE PATH
  "Folder of vesin's sources, with include/vesin.h and src; the benchmarks leave it out without")
mark_as_advanced(THICK_INTERSECTION_VESIN)

add_library(thick_benchmark_periodic OBJECT EXCLUDE_FROM_ALL
  ${CMAKE_CURRENT_LIST_DIR}/periodic_ours.cpp)
target_link_libraries(thick_benchmark_periodic PUBLIC Thick_intersection_d::compiled)
target_include_directories(thick_benchmark_periodic PRIVATE ${PROJECT_SOURCE_DIR}/benchmark)
thick_enable_warnings(thick_benchmark_periodic)

# What programs link that search by vesin as well.
add_library(thick_benchmark_vesin INTERFACE)
if(EXISTS "${THICK_INTERSECTION_VESIN}/src/cpu_cell_list.cpp")
  find_package(Threads REQUIRED)
  add_library(thick_vesin STATIC EXCLUDE_FROM_ALL
    ${THICK_INTERSECTION_VESIN}/src/cpu_cell_list.cpp
    ${THICK_INTERSECTION_VESIN}/src/verlet.cpp
    ${THICK_INTERSECTION_VESIN}/src/vesin.cpp
    ${THICK_INTERSECTION_VESIN}/src/vesin_cuda_stub.cpp)
  target_compile_features(thick_vesin PRIVATE cxx_std_17)
  target_include_directories(thick_vesin SYSTEM PUBLIC ${THICK_INTERSECTION_VESIN}/include)
  target_link_libraries(thick_vesin PUBLIC Threads::Threads)
  target_sources(thick_benchmark_periodic PRIVATE ${CMAKE_CURRENT_LIST_DIR}/periodic_by_vesin.cpp)
  target_link_libraries(thick_benchmark_periodic PRIVATE thick_vesin)
  target_link_libraries(thick_benchmark_vesin INTERFACE thick_vesin)
  target_compile_definitions(thick_benchmark_vesin INTERFACE THICK_BENCHMARK_HAS_VESIN)
else()
  message(STATUS "periodic_table and periodic_pairs leave out vesin "
                 "(https://github.com/Luthaf/vesin), whose folder is THICK_INTERSECTION_VESIN")
endif()
