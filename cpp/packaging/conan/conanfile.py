# SPDX-License-Identifier: GPL-3.0-or-later
"""The C++ libraries for Conan 2. The sources are the checkout that contains this recipe."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class CircleVoronoi(ConanFile):
    name = "circle-voronoi"
    description = "Voronoi diagrams of circles, exact and certified"
    license = "GPL-3.0-or-later"
    url = homepage = "https://github.com/circle-voronoi/circle-voronoi"
    topics = ("voronoi", "apollonius", "delaunay", "computational-geometry")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    implements = ["auto_shared_fpic"]

    @property
    def _checkout(self):
        return Path(self.recipe_folder).parents[2]

    def set_version(self):
        text = (self._checkout / "CMakeLists.txt").read_text()
        self.version = re.search(r"project\(circle_voronoi VERSION ([0-9.]+)", text)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cpp/*"):
            copy(self, pattern, self._checkout, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/3.4.0", visible=False)
        self.requires("fast_float/6.1.5", visible=False)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["CIRCLE_VORONOI_BUILD_CLI"] = False
        toolchain.cache_variables["CIRCLE_VORONOI_BUILD_TESTS"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The package's own CMake files are used, as without Conan.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/circle_voronoi"]
        self.cpp_info.libs = [
            "circle_voronoi_io",
            "circle_voronoi_fit",
            "circle_voronoi_families",
            "circle_voronoi",
        ]
