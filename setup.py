# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the extension module of the Python package with CMake."""

import re
import sys
from pathlib import Path

import pybind11
from skbuild import setup
from skbuild.cmaker import get_cmake_version
from skbuild.exceptions import SKBuildError

CMAKE = (3, 25)
VERSION = re.search(r"project\(circle_voronoi VERSION ([0-9.]+)", Path("CMakeLists.txt").read_text())[1]


def has_cmake() -> bool:
    """Return whether the system has a CMake that is new enough. Otherwise pip brings one."""
    try:
        return tuple(map(int, re.findall(r"\d+", get_cmake_version())[:2])) >= CMAKE
    except SKBuildError:
        return False


setup(
    version=VERSION,
    packages=["circle_voronoi"],
    package_dir={"": "cpp/python"},
    package_data={"circle_voronoi": ["py.typed", "*.pyi"]},
    zip_safe=False,
    setup_requires=[] if has_cmake() else ["cmake>=" + ".".join(map(str, CMAKE))],
    cmake_install_dir="cpp/python",
    cmake_args=[
        "-DCIRCLE_VORONOI_PYTHON=ON",
        "-DCIRCLE_VORONOI_BUILD_CLI=OFF",
        "-DCIRCLE_VORONOI_BUILD_TESTS=OFF",
        "-DCIRCLE_VORONOI_INSTALL=OFF",
        f"-DPython3_EXECUTABLE={sys.executable}",
        f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
    ],
)
