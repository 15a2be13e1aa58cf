# What `cmake --install` puts in place: the headers, the licence texts, the library of compiled
# searches if it is built, and the files that find_package(Thick_intersection_d) and `pkg-config
# Thick_intersection_d` read.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

include(CMakePackageConfigHelpers)

# The rules are always written: a project above this one can export libraries that link this package
# only if an export set has its target. Without THICK_INTERSECTION_INSTALL, nothing is installed
# unless the component is asked for by name.
set(in_component COMPONENT Thick_intersection_d)
if(NOT THICK_INTERSECTION_INSTALL)
  list(APPEND in_component EXCLUDE_FROM_ALL)
endif()

# The headers do not depend on the processor, hence share/ and ARCH_INDEPENDENT. The library does.
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/Thick_intersection_d)
set(independence ARCH_INDEPENDENT)
if(THICK_INTERSECTION_COMPILED)
  set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Thick_intersection_d)
  set(independence "")
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/CGAL
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${in_component}
  FILES_MATCHING PATTERN "*.h" PATTERN "*.inc")

# In a subdirectory, CMAKE_INSTALL_DOCDIR may be the folder of the project above, with its license.
set(doc_dir ${CMAKE_INSTALL_DOCDIR})
if(NOT PROJECT_IS_TOP_LEVEL)
  set(doc_dir ${CMAKE_INSTALL_DATAROOTDIR}/doc/Thick_intersection_d)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSE.GPL
  DESTINATION ${doc_dir} ${in_component})

install(TARGETS Thick_intersection_d EXPORT Thick_intersection_dTargets)
if(THICK_INTERSECTION_COMPILED)
  install(TARGETS Thick_intersection_d_compiled EXPORT Thick_intersection_dTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${in_component}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ${in_component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${in_component})
  configure_file(
    ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_d_compiled.pc.in
    ${PROJECT_BINARY_DIR}/Thick_intersection_d_compiled.pc
    @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/Thick_intersection_d_compiled.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${in_component})
endif()
install(EXPORT Thick_intersection_dTargets
  NAMESPACE Thick_intersection_d::
  DESTINATION ${package_dir} ${in_component})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_dConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)

# While the major number is 0, a new minor number may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
  ${independence})

install(FILES
  ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_dMPI.cmake
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfig.cmake
  ${PROJECT_BINARY_DIR}/Thick_intersection_dConfigVersion.cmake
  DESTINATION ${package_dir} ${in_component})

# The file finds the headers from its own folder, so that an installation can be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR
  BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
  OUTPUT_VARIABLE thick_include_from_pc)
configure_file(
  ${CMAKE_CURRENT_LIST_DIR}/Thick_intersection_d.pc.in
  ${PROJECT_BINARY_DIR}/Thick_intersection_d.pc
  @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/Thick_intersection_d.pc
  DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig ${in_component})

# On request: cmake --install <build> --component examples, or doc. A project above this one may have
# components of these names.
if(PROJECT_IS_TOP_LEVEL)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/
    DESTINATION ${doc_dir}/examples COMPONENT examples EXCLUDE_FROM_ALL
    PATTERN CMakeLists.txt EXCLUDE)

  set(manual ${PROJECT_SOURCE_DIR}/build/doc)
  install(CODE "
    if(NOT EXISTS \"${manual}/index.html\")
      message(FATAL_ERROR \"There is no manual in ${manual}: run scripts/doc first.\")
    endif()"
    COMPONENT doc EXCLUDE_FROM_ALL)
  install(DIRECTORY ${manual}/ DESTINATION ${doc_dir}/html COMPONENT doc EXCLUDE_FROM_ALL)
endif()
