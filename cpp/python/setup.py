# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the package with the CMake files of the repository."""

import re
import sys
from pathlib import Path

from skbuild import setup

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(circle_voronoi VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

setup(
    name="circle-voronoi",
    version=VERSION,
    description="Voronoi diagrams of circles, exact and certified",
    license="GPL-3.0-or-later",
    python_requires=">=3.9",
    install_requires=["numpy"],
    extras_require={"all": ["shapely", "geopandas", "matplotlib"]},
    packages=["circle_voronoi"],
    package_data={"circle_voronoi": ["py.typed", "*.pyi"]},
    zip_safe=False,
    cmake_source_dir="../..",
    cmake_args=[
        "-DCIRCLE_VORONOI_PYTHON=ON",
        "-DCIRCLE_VORONOI_BUILD_CLI=OFF",
        "-DCIRCLE_VORONOI_BUILD_TESTS=OFF",
        "-DCIRCLE_VORONOI_INSTALL=OFF",
        "-DCIRCLE_VORONOI_WARNINGS_AS_ERRORS=OFF",
        f"-DPython3_EXECUTABLE={sys.executable}",
    ],
)
