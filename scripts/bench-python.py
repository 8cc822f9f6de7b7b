# SPDX-License-Identifier: GPL-3.0-or-later
"""Times the package against the program and against what people do with scipy, in one run on the same input.

`npm run bench -- --python` builds the package and runs this script. Times are medians; ratios are those of the pairs of runs.
"""

import statistics
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import scipy.spatial
from shapely.geometry import Polygon

import circle_voronoi as cv

PROGRAM = Path(__file__).resolve().parents[1] / "build/native/circle-voronoi"
REPETITIONS = 3


def seconds(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def row(name, ours, other, what, result=""):
    ratio = statistics.median(a / b for a, b in zip(ours, other))
    print(f"{name:34} {statistics.median(ours):9.3f} s  {statistics.median(other):9.3f} s  {ratio:6.2f} times {what}  {result}")


def run_and_measure(command):
    """Return seconds and peak memory in MB of a process."""
    code = (
        "import resource, subprocess, sys, time; start = time.perf_counter();"
        "subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL);"
        "print(time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024)"
    )
    output = subprocess.run([sys.executable, "-c", code, *map(str, command)], check=True, capture_output=True, text=True)
    return tuple(map(float, output.stdout.split()))


def uniform(count, seed=1):
    random = np.random.default_rng(seed)
    return np.column_stack([random.random((count, 2)), 0.3 / count**0.5 * random.random(count)])


def against_the_program(count):
    with TemporaryDirectory() as folder:
        path = Path(folder) / "circles.csv"
        np.savetxt(path, uniform(count), delimiter=",", header="x,y,r", comments="")
        script = "import sys, circle_voronoi as cv; cv.compute(cv.read(sys.argv[1]))"
        ours, program = [], []
        for _ in range(REPETITIONS):
            ours.append(run_and_measure([sys.executable, "-c", script, path]))
            program.append(run_and_measure([PROGRAM, "compute", path, "--format", "stats"]))
    memory = statistics.median(a[1] / b[1] for a, b in zip(ours, program))
    row(f"read and compute {count:,}", *([t for t, _ in times] for times in (ours, program)), "the program",
        f"memory {memory:.2f} times")


def find(count):
    diagram = cv.compute(uniform(count))
    points = np.random.default_rng(2).random((1_000_000, 2))
    diagram.find(points[:1])
    tree = scipy.spatial.cKDTree(diagram.circles[:, :2])
    ours, other = [], []
    for _ in range(REPETITIONS):
        ours.append(seconds(lambda: diagram.find(points))[0])
        other.append(seconds(lambda: tree.query(points))[0])
    row(f"find 1,000,000 points among {count:,}", ours, other, "scipy's cKDTree of the centers")


def areas_of(voronoi, count):
    """The usual recipe: the shoelace formula on each region, whose corners scipy gives in order in the plane."""
    areas = np.empty(count)
    for i in range(count):
        corners = voronoi.vertices[voronoi.regions[voronoi.point_region[i]]]
        x, y = (corners - corners[0]).T
        areas[i] = abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) / 2
    return areas


def nine_copies(count):
    points = np.random.default_rng(3).random((count, 2))
    shifts = np.array([(0, 0)] + [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0)])

    def by_copies():
        copies = (shifts[:, None] + points[None]).reshape(-1, 2)
        return areas_of(scipy.spatial.Voronoi(copies), count)

    def periodic():
        circles = np.column_stack([points, np.zeros(count)])
        return cv.compute_periodic(circles, (1, 0), (0, 1)).areas()

    ours, other = [], []
    for _ in range(REPETITIONS):
        time_ours, areas = seconds(periodic)
        time_other, expected = seconds(by_copies)
        ours.append(time_ours)
        other.append(time_other)
    row(f"areas of {count:,} points, periodic", ours, other, "nine copies with scipy",
        f"largest difference {np.abs(areas - expected).max():.1e}")


def cells_in_a_region(count):
    """The method of geovoronoi: scipy's regions with distant points around, each intersected with a polygon by shapely."""
    points = np.random.default_rng(4).random((count, 2))
    angle = np.linspace(0, 2 * np.pi, 500, endpoint=False)
    radius = 0.42 + 0.06 * np.sin(9 * angle)
    region = Polygon(np.column_stack([0.5 + radius * np.cos(angle), 0.5 + radius * np.sin(angle)]))

    def by_intersections():
        far = np.array([(-9, -9), (-9, 10), (10, -9), (10, 10)])
        voronoi = scipy.spatial.Voronoi(np.concatenate([points, far]))
        corners = (voronoi.vertices[voronoi.regions[voronoi.point_region[i]]] for i in range(count))
        return [Polygon(one).intersection(region) for one in corners]

    ours, other = [], []
    for _ in range(REPETITIONS):
        time_ours, cells = seconds(lambda: cv.compute(points, r=0).polygons(region=region))
        time_other, expected = seconds(by_intersections)
        ours.append(time_ours)
        other.append(time_other)
    difference = max(abs((0 if a is None else a.area) - b.area) for a, b in zip(cells, expected))
    row(f"{count:,} cells in a polygon of 500 sides", ours, other, "scipy and shapely", f"largest difference {difference:.1e}")


if __name__ == "__main__":
    print(f"{'':34} {'ours':>11}  {'other':>11}")
    against_the_program(1_000_000)
    for size in (1000, 100_000, 1_000_000):
        find(size)
    nine_copies(100_000)
    cells_in_a_region(5000)
