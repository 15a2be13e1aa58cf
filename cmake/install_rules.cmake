# What `cmake --install` puts in place: the headers, the licence texts, and the files that
# find_package(Thick_intersection_d) and `pkg-config Thick_intersection_d` read.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

include(CMakePackageConfigHelpers)

# Nothing here depends on the processor, hence share/ and ARCH_INDEPENDENT.
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/Thick_intersection_d)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/CGAL
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*.inc")

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSE.GPL
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS Thick_intersection_d EXPORT Thick_intersection_dTargets)
install(EXPORT Thick_intersection_dTargets
  NAMESPACE Thick_intersection_d::
  DESTINATION ${package_dir})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_dConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)

# While the major number is 0, a new minor number may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

install(FILES
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfig.cmake
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfigVersion.cmake
  DESTINATION ${package_dir})

# The file finds the headers from its own folder, so that an installation can be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR
  BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
  OUTPUT_VARIABLE thick_include_from_pc)
configure_file(
  ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_d.pc.in
  ${PROJECT_BINARY_DIR}/Thick_intersection_d.pc
  @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/Thick_intersection_d.pc
  DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)
