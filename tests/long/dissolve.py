#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares --dissolve with GEOS, which shapely calls.

Usage: dissolve.py PROGRAM [COUNT [SEED]]. Each case is some valid polygons; the region that the program clips the whole
plane to has to be valid and equal to their union.
"""
import json
import math
import random
import subprocess
import sys
import tempfile

from shapely.geometry import MultiPolygon, Polygon, box, shape
from shapely.ops import unary_union

PROGRAM = sys.argv[1]
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else random.randrange(2**31)


def star(random, coordinate):
    """A polygon around a point, of any number of corners."""
    x, y = coordinate(), coordinate()
    angles = sorted(random.uniform(0, 2 * math.pi) for _ in range(random.randint(3, 9)))
    return Polygon([(x + random.uniform(1, 9) * math.cos(a), y + random.uniform(1, 9) * math.sin(a)) for a in angles])


def rounded(polygon, digits):
    return Polygon([(round(x, digits), round(y, digits)) for x, y in polygon.exterior.coords])


def boxes(random):
    """Boxes on a grid that share corners, and sides or parts of sides."""
    for _ in range(random.randint(2, 12)):
        x, y = random.randint(0, 9), random.randint(0, 9)
        yield box(x, y, x + random.randint(1, 4), y + random.randint(1, 4))


def integers(random):
    for _ in range(random.randint(2, 7)):
        yield rounded(star(random, lambda: random.randint(0, 12)), 0)


def stars(random):
    for _ in range(random.randint(2, 8)):
        yield star(random, lambda: random.uniform(0, 20))


def holes(random):
    """Boxes with holes that other boxes fill exactly, partly or nearly."""
    for _ in range(random.randint(1, 4)):
        x, y = random.randint(0, 6), random.randint(0, 6)
        hole = box(x + 1, y + 1, x + 3, y + 2 + random.randint(0, 1))
        yield Polygon(box(x, y, x + 4, y + 4).exterior.coords, [hole.exterior.coords])
        if random.random() < 0.7:
            yield hole
        if random.random() < 0.3:
            yield box(x + 2, y + 1, x + 3, y + 5)


def slivers(random):
    """Fields of a map whose borders deviate in the last digit."""
    near = lambda value: value + random.choice([0, 0, 1, -1, 3]) * 2.0**-50 * max(1, value)
    step = random.choice([1, 0.1, 1 / 3])
    for i in range(random.randint(1, 4)):
        for j in range(random.randint(1, 4)):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            yield Polygon([(near(x * step), near(y * step)) for x, y in corners])


def same(random):
    """A polygon repeated with other first corners and directions."""
    polygon = star(random, lambda: random.uniform(0, 9))
    corners = list(polygon.exterior.coords)[:-1]
    for _ in range(random.randint(2, 4)):
        k = random.randrange(len(corners))
        turned = corners[k:] + corners[:k]
        yield Polygon(turned if random.random() < 0.5 else turned[::-1])


def needles(random):
    """Long and thin polygons that are nearly parallel."""
    for _ in range(random.randint(2, 6)):
        y = random.uniform(0, 1e-3)
        yield Polygon([(0, y), (1000, random.uniform(0, 1e-3)), (1000, random.uniform(2e-3, 3e-3)), (0, y + 1e-3)])


KINDS = [boxes, integers, stars, holes, slivers, same, needles]


def dissolved(folder, polygons):
    """Writes the region as the cell of one circle in it."""
    with open(f"{folder}/region.geojson", "w", encoding="utf-8") as file:
        json.dump(MultiPolygon(polygons).__geo_interface__, file)
    command = [PROGRAM, "compute", f"{folder}/circle.csv", "--region", f"{folder}/region.geojson", "--dissolve"]
    run = subprocess.run(command + ["--format", "geojson"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return run.stderr
    return shape(json.loads(run.stdout)["features"][0]["geometry"])


def main():
    source = random.Random(SEED)
    wrong = 0
    compared = 0
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/circle.csv", "w", encoding="utf-8") as file:
            file.write("x,y,r\n0,0,1\n")
        for case in range(COUNT):
            kind = KINDS[case % len(KINDS)]
            polygons = [polygon for polygon in kind(source) if polygon.is_valid and polygon.area > 0]
            if not polygons:
                continue
            compared += 1
            ours = dissolved(folder, polygons)
            union = unary_union(polygons)
            if isinstance(ours, str):
                problem = ours.strip()
            elif not ours.is_valid:
                problem = "not valid"
            elif kind is boxes and ours.area != union.area:
                problem = f"area {ours.area}, not {union.area}"
            elif ours.symmetric_difference(union).area > 1e-12 * max(1, union.length * max(map(abs, union.bounds))):
                problem = f"off by {ours.symmetric_difference(union).area}"
            else:
                continue
            wrong += 1
            print(f"{kind.__name__}, case {case}: {problem}: {MultiPolygon(polygons).wkt}")
    print(f"{compared} unions compared, {wrong} wrong (seed {SEED})")
    sys.exit(1 if wrong or not compared else 0)


main()
