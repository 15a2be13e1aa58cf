# The recipe for Conan 2. It takes the source tree that it is in:
#
#   conan create packaging/conan
#
# A recipe in a registry has source() instead of export_sources(), with the address and the checksum
# of a release.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, load
from conan.tools.layout import basic_layout

HEADER = "include/CGAL/Thick_intersection_d/version.h"


class ThickIntersectionDRecipe(ConanFile):
    name = "thick-intersection-d"
    description = "All intersecting pairs among thick objects, all pairs of points within a distance"
    license = "LGPL-3.0-or-later"
    topics = ("cgal", "computational-geometry", "nearest-neighbors", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    @property
    def _top(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        text = load(self, os.path.join(self._top, HEADER))
        self.version = re.search(r'_VERSION "([0-9.]+)"', text).group(1)

    def export_sources(self):
        for pattern in ("include/*.h", "include/*.inc", "LICENSE*"):
            copy(self, pattern, self._top, self.export_sources_folder)

    def layout(self):
        basic_layout(self)

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)

    def package_id(self):
        self.info.clear()

    def validate(self):
        check_min_cppstd(self, 17)

    def package(self):
        copy(self, "LICENSE*", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for pattern in ("include/*.h", "include/*.inc"):
            copy(self, pattern, self.source_folder, self.package_folder)

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "Thick_intersection_d")
        self.cpp_info.set_property("cmake_target_name", "Thick_intersection_d::Thick_intersection_d")
        self.cpp_info.set_property("pkg_config_name", "Thick_intersection_d")
        # Without it, the interval filters of CGAL are not reliable. The recipe of CGAL gives it to
        # users of CMake only.
        if self.settings.compiler == "gcc":
            self.cpp_info.cxxflags = ["-frounding-math"]
