# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that the package returns can be copied and pickled."""

import copy
import pickle

import numpy as np
import pytest
from conftest import random_circles
from shapely.geometry import MultiPolygon, Polygon, box

import circle_voronoi as cv

PARTS = MultiPolygon([box(0, 0, 100, 40), box(0.1, 50, 33.3, 99.9), Polygon([(60, 60), (90, 60), (75, 90)], [[(74, 65), (76, 65), (75, 70)]])])
POINTS = random_circles(12, 1)[:, :2]


def arrays_of(result):
    """The arrays and numbers of a result."""
    if isinstance(result, tuple):
        return [array for item in result for array in arrays_of(item)]
    if isinstance(result, cv.Diagram):
        return [result.circles, result.vertices, result.edges, result.ids, result.metric, result.weights]
    if isinstance(result, cv.SphereDiagram):
        return [result.circles, result.vertices, result.edges, result.radius, result.weights]
    if isinstance(result, cv.PeriodicDiagram):
        return [result.periods, result.image_circles, result.image_shifts, *arrays_of(result.images)]
    if isinstance(result, cv.Region):
        return [result.__geo_interface__, result.area, result.crs]
    return [result]


@pytest.mark.parametrize(
    "make",
    [
        lambda: cv.Region(PARTS),
        lambda: cv.Region({**box(0, 0, 1, 1).__geo_interface__, "crs": {"type": "name", "properties": {"name": "EPSG:32633"}}}),
        lambda: cv.compute(random_circles(60, 2)),
        lambda: cv.compute(random_circles(60, 3), metric="power"),
        lambda: cv.compute(random_circles(60, 4)).update(remove=[3]),
        lambda: cv.compute_sphere(random_circles(60, 5) * [3.6, 0.9, 0.1], radius=20),
        lambda: cv.compute_sphere([[1, 2, -3], [50, 2, 4]], weights=True),
        lambda: cv.compute_periodic(random_circles(60, 6), (100, 0.1), (30, 90)),
        lambda: cv.compute_periodic(random_circles(60, 7) - [0, 0, 1], (100, 0), (0, 90), metric="power", weights=True),
        lambda: cv.fit_areas(POINTS, "equal", box(0, 0, 100, 100)),
        lambda: cv.fit_areas_periodic(POINTS, "equal", (100, 0), (0, 100)),
        lambda: cv.compute_periodic(random_circles(60, 8), (100, 0), (0, 100)).contacts(),
        lambda: cv.compute(random_circles(60, 9)).largest_empty_disc(),
    ],
    ids=["region", "crs", "diagram", "power", "updated", "sphere", "weights", "periodic", "periodic power", "fit", "periodic fit", "contacts", "disc"],
)
@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda result: pickle.loads(pickle.dumps(result))], ids=["copy", "deepcopy", "pickle"])
def test_a_copy_has_the_same_bits(make, copied):
    result = make()
    pairs = list(zip(arrays_of(result), arrays_of(copied(result))))
    assert len(pairs) > 0
    for given, kept in pairs:
        if isinstance(given, np.ndarray):
            assert given.tobytes() == kept.tobytes()
        else:
            assert given == kept
