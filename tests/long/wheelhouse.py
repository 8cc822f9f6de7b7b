# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes wheels of Debian's Python packages: `wheelhouse.py FOLDER NAME=PACKAGE,...`, for pip where no index is reached."""

import subprocess
import sys
import zipfile
from importlib.metadata import distribution
from pathlib import Path

SITE = Path("/usr/lib/python3/dist-packages")
# Requirements that are in the metadata on PyPI, but not in Debian's.
REQUIREMENTS = {"scikit-build": ["distro", "packaging", "setuptools", "wheel"]}


def files_of(package: str) -> list[Path]:
    listed = subprocess.run(["dpkg", "-L", package], capture_output=True, check=True, text=True).stdout.splitlines()
    return [path for path in map(Path, listed) if SITE in path.parents and path.is_file()]


def make_wheel(folder: Path, name: str, packages: list[str]) -> None:
    found = distribution(name)
    stem = f"{name.replace('-', '_')}-{found.version}"
    required = [*REQUIREMENTS.get(name, ()), *(one for one in found.requires or () if "extra ==" not in one)]
    members = {
        "METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {found.version}\n"
        + "".join(f"Requires-Dist: {one}\n" for one in required),
        "WHEEL": "Wheel-Version: 1.0\nGenerator: wheelhouse\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        # setuptools finds the command of wheel by it.
        "entry_points.txt": found.read_text("entry_points.txt") or "",
    }
    with zipfile.ZipFile(folder / f"{stem}-py3-none-any.whl", "w") as wheel:
        for path in [path for package in packages for path in files_of(package)]:
            member = path.relative_to(SITE)
            if not member.parts[0].endswith((".egg-info", ".dist-info")):
                wheel.write(path, member)
        for member, text in members.items():
            wheel.writestr(f"{stem}.dist-info/{member}", text)
        names = [*wheel.namelist(), f"{stem}.dist-info/RECORD"]
        wheel.writestr(names[-1], "".join(f"{one},,\n" for one in names))


folder, *pairs = sys.argv[1:]
for name, packages in (pair.split("=") for pair in pairs):
    make_wheel(Path(folder), name, packages.split(","))
