# Thick_intersection_d::MPI: the package together with MPI, for programs that include
# CGAL/distributed_fixed_radius_near_neighbors.h. Not defined if there is no MPI.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

if(NOT TARGET Thick_intersection_d::MPI)
  set(MPI_CXX_SKIP_MPICXX TRUE) # the C interface is enough
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND)
    add_library(Thick_intersection_d::MPI INTERFACE IMPORTED)
    target_link_libraries(Thick_intersection_d::MPI INTERFACE
      Thick_intersection_d::Thick_intersection_d MPI::MPI_CXX)
  endif()
endif()
