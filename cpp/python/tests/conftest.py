# SPDX-License-Identifier: GPL-3.0-or-later
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build/native/circle-voronoi"


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def random_circles(count, seed, size=100.0):
    """Circles that intersect, hide one another, or are points."""
    random = np.random.default_rng(seed)
    radii = random.choice([0, 0.2, 1, 3], count) * size / count**0.5 * random.random(count)
    return np.column_stack([random.random((count, 2)) * size, radii])


def program(*arguments):
    """The output of the program."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=True)
    return run.stdout


def table(circles, path="circles.csv"):
    """Write circles with all digits; return the path."""
    Path(path).write_text("x,y,r\n" + "".join(",".join(map(repr, map(float, row))) + "\n" for row in circles))
    return path


def program_json(*arguments):
    return json.loads(program(*arguments, "--format", "json"))


def program_geojson(circles):
    return json.loads(program("compute", table(circles), "--format", "geojson"))
