# The port for vcpkg. As an overlay it takes the source tree that it is in:
#
#   vcpkg install thick-intersection-d --overlay-ports=packaging/vcpkg
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# Where a release is downloaded from, and the SHA512 of the archive. A port in a registry has both.
set(release_url "")
set(release_sha512 "")

if(release_url)
  vcpkg_download_distfile(archive
    URLS "${release_url}"
    FILENAME "${PORT}-${VERSION}.tar.gz"
    SHA512 "${release_sha512}")
  vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
else()
  get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
endif()

# There are headers only, so one build type is enough.
set(VCPKG_BUILD_TYPE release)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DBUILD_TESTING=OFF -DTHICK_INTERSECTION_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(
  PACKAGE_NAME Thick_intersection_d CONFIG_PATH share/cmake/Thick_intersection_d)
vcpkg_fixup_pkgconfig()

# vcpkg has the license texts in one file.
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSE.GPL")
