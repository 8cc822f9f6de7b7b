# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons of cells that a maximum distance cuts are valid for GEOS at every tolerance."""

import math
import os
import random

import pytest
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union
from shapely.validation import explain_validity

import circle_voronoi as cv

SEED = int(os.environ.get("CIRCLE_VORONOI_SEED", "1"))


def star(rng, center, least, most, corners):
    angles = [2 * math.pi * (k + 0.6 * rng.random()) / corners for k in range(corners)]
    lengths = [least + (most - least) * rng.random() for _ in angles]
    return [(center[0] + r * math.cos(a), center[1] + r * math.sin(a)) for a, r in zip(angles, lengths)]


def hole(rng, center, radius):
    """A hole near the rim of a disc: next to it, with corners on it, tangent to it, a spike, or across it."""
    x, y = center
    angle = 2 * math.pi * rng.random()

    def at(share, turn=0.0):
        return (x + share * radius * math.cos(angle + turn), y + share * radius * math.sin(angle + turn))

    kind = rng.randrange(5)
    if kind == 0:
        return [at(1 - 10 ** -rng.uniform(0.3, 9)), at(rng.uniform(0.5, 0.9), 0.1), at(rng.uniform(0.5, 0.9), 0.2)]
    if kind == 1:
        return [(x + radius, y), (x + radius // 2, y + rng.randint(1, 4)), (x + radius // 2, y - rng.randint(0, 3))]
    if kind == 2:
        width = rng.randint(1, 10)
        return [(x - width, y + radius), (x + width, y + radius), (x + rng.randint(-3, 3), y + radius - rng.randint(1, 8))]
    if kind == 3:
        narrow = 10 ** -rng.uniform(0, 7)
        return [at(rng.uniform(0.6, 1.4)), at(0.3, narrow), at(0.3, -narrow)]
    return star(rng, at(1), 0.02 * radius, 0.3 * radius, rng.randint(3, 6))


@pytest.mark.parametrize("metric", ["circles", "power"])
@pytest.mark.parametrize("seed", range(SEED, SEED + 40))
def test_polygons_within_a_distance_are_valid(seed, metric):
    rng = random.Random(seed)
    circles = [
        (rng.randint(-40, 40), rng.randint(-40, 40), rng.randint(0, 9)) for _ in range(rng.randint(1, 4))
    ]
    distance = rng.choice([5, 10, 13, 17, 20, 25, 30])
    radius = circles[0][2] + distance if metric == "circles" else math.hypot(circles[0][2], distance)
    outer = rng.choice([[(-100, -100), (100, -100), (100, 100), (-100, 100)], star(rng, (0, 0), 30, 100, 7)])
    holes = [hole(rng, circles[0][:2], radius) for _ in range(rng.randint(0, 3))]
    region = Polygon(outer, holes)
    while not region.is_valid:
        holes.pop()
        region = Polygon(outer, holes)
    diagram = cv.compute(circles, metric=metric)
    areas = diagram.areas(region=region, max_distance=distance)
    for tolerance in (1e-6 * radius, 10 ** rng.uniform(-5, 3) * radius):
        cells = diagram.polygons(region=region, max_distance=distance, tolerance=tolerance)
        for i, cell in enumerate(cells):
            if cell is None:
                assert areas[i] <= tolerance * 4 * radius
                continue
            assert cell.is_valid, f"circle {i}, seed {seed}, tolerance {tolerance}: {explain_validity(cell)}"
            assert abs(cell.area - areas[i]) <= (tolerance + 1e-9) * cell.length + 1e-9
            for other in cells[:i]:
                assert other is None or other.intersection(cell).area < 1e-9


@pytest.mark.parametrize("seed", range(SEED, SEED + 20))
def test_cells_of_a_power_diagram_are_the_union_of_their_discs(seed):
    rng = random.Random(seed)
    circles = [(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-20, 20)) for _ in range(12)]
    diagram = cv.compute(circles, metric="power", weights=True)
    for distance in (-3, 0, 2, 5):
        radii = [math.sqrt(max(weight + distance * abs(distance), 0)) for _, _, weight in circles]
        union = unary_union([Point(x, y).buffer(r, 512) for (x, y, _), r in zip(circles, radii) if r > 0])
        areas = diagram.areas(max_distance=distance)
        assert areas.sum() == pytest.approx(union.area, rel=1e-5), f"seed {seed}"
        for i, cell in enumerate(diagram.polygons(max_distance=distance, tolerance=1e-5)):
            assert (cell.area if cell else 0) == pytest.approx(areas[i], abs=1e-3)
            assert cell is None or Point(circles[i][:2]).buffer(radii[i] + 1e-4, 512).contains(cell)


def test_a_disc_that_collapses_in_coordinates_is_empty():
    diagram = cv.compute([(1, 1, 1e-17), (5, 5, 1)])
    assert diagram.polygons(max_distance=0)[0] is None
    assert diagram.areas(max_distance=0)[0] == 0
