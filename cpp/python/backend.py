# SPDX-License-Identifier: GPL-3.0-or-later
"""The build backend of setuptools, from the packages of the system or of the environment that pip runs in.

pip hides these packages from a build, so that it can install what pyproject.toml requires. Here nothing is required, and
nothing is downloaded.
"""

import os
import subprocess
import sys


def _packages_outside() -> list[str]:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [sys.executable, "-c", "import sys; print(*sys.path[1:], sep='\\n')"]
    return subprocess.run(command, env=environment, capture_output=True, check=True, text=True).stdout.split("\n")


sys.path += [path for path in _packages_outside() if path]

from setuptools.build_meta import *  # noqa: E402, F401, F403


def get_requires_for_build_wheel(config_settings: object = None) -> list[str]:
    """Return no requirements: setuptools would request wheel, which is already installed."""
    return []
