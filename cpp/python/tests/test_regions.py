# SPDX-License-Identifier: GPL-3.0-or-later
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import program, random_circles, table
from shapely import wkt
from shapely.geometry import MultiPolygon, Polygon, box, mapping
from shapely.ops import unary_union

import circle_voronoi as cv

ROOM = Polygon([(0, 0), (100, 0), (100, 40), (50, 40), (50, 100), (0, 100)], [[(10, 10), (10, 20), (20, 20), (20, 10)]])


@pytest.mark.parametrize(
    "shape",
    [
        ROOM,
        mapping(ROOM),
        {"type": "Feature", "properties": {}, "geometry": mapping(ROOM)},
        ROOM.wkt,
        f" {ROOM.wkb_hex.lower()}\n",
        json.dumps(mapping(ROOM)),
        [np.array(ROOM.exterior.coords), np.array(ROOM.interiors[0].coords)],
        [list(ring.coords)[:-1] for ring in (ROOM.exterior, *ROOM.interiors)],
        cv.Region(ROOM),
    ],
    ids=["shapely", "mapping", "feature", "wkt", "wkb", "geojson", "arrays", "lists", "region"],
)
def test_a_region_comes_in_every_form(shape):
    diagram = cv.compute(random_circles(50, 1))
    areas = diagram.areas(region=shape)
    assert areas.sum() == pytest.approx(ROOM.area, rel=1e-12)
    assert areas.tobytes() == diagram.areas(region=ROOM).tobytes()


def test_a_region_comes_from_a_file_and_goes_back_to_shapely():
    path = Path("room.wkt")
    path.write_text(ROOM.wkt)
    region = cv.Region(path)
    from shapely.geometry import shape

    assert shape(region).equals(MultiPolygon([ROOM]))
    assert region.area == ROOM.area and region.bounds == ROOM.bounds


@pytest.mark.parametrize("name, text", [("room.geojson", json.dumps(mapping(ROOM))), ("room (1).wkt", ROOM.wkt)])
def test_a_region_is_the_name_of_a_file(name, text):
    Path(name).write_text(text)
    diagram = cv.compute(random_circles(50, 1))
    assert diagram.areas(region=name).tobytes() == diagram.areas(region=ROOM).tobytes()
    assert diagram.to_bytes("geojson", region=name) == diagram.to_bytes("geojson", region=ROOM)
    Path(name).write_text("nothing")
    with pytest.raises(cv.CircleVoronoiError) as caught:
        diagram.areas(region=name)
    assert str(caught.value).startswith(f"{name}:1:")


def test_polygons_in_a_region_are_valid_and_cover_it():
    cells = cv.compute(random_circles(80, 2)).polygons(region=ROOM)
    parts = [cell for cell in cells if cell is not None]
    assert all(cell.is_valid for cell in parts)
    assert sum(cell.area for cell in parts) == pytest.approx(ROOM.area, rel=1e-9)
    assert unary_union(parts).symmetric_difference(ROOM).area < 1e-6


def test_areas_in_a_region_are_those_that_the_program_writes():
    circles = random_circles(60, 3)
    Path("room.wkt").write_text(ROOM.wkt)
    written = json.loads(program("compute", table(circles), "--region", "room.wkt", "--format", "geojson"))
    expected = [feature["properties"]["area"] for feature in written["features"]]
    assert cv.compute(circles).areas(region=ROOM).tolist() == expected


def test_fitted_areas_are_those_asked_for():
    points = random_circles(20, 4)[:, :2] * 0.9
    areas = np.arange(1, 21)
    fit = cv.fit_areas(points, areas, ROOM, shares=True)
    assert fit.areas == pytest.approx(areas * ROOM.area / areas.sum(), rel=1e-8)
    assert fit.diagram.areas(region=ROOM) == pytest.approx(fit.areas)
    assert fit.weights.min() == 0 and fit.error < 1e-8
    again = cv.fit_areas(points, fit.areas, ROOM, weights=fit.weights)
    assert again.steps <= 1
    assert cv.fit_areas(points, "equal", ROOM).areas == pytest.approx(ROOM.area / 20, rel=1e-8)
    straight = cv.fit_areas(points, areas, ROOM, shares=True, metric="power")
    assert straight.areas == pytest.approx(fit.areas, rel=1e-8)
    assert straight.diagram.metric == "power" and straight.diagram.certified


def test_options_of_a_fit():
    points = random_circles(20, 5)[:, :2] * 0.9
    areas = np.arange(1, 21)
    coarse = cv.fit_areas(points, areas, ROOM, shares=True, tolerance=0.2)
    fine = cv.fit_areas(points, areas, ROOM, shares=True)
    assert 1e-9 < coarse.error < 0.2 and coarse.steps < fine.steps and fine.error < 1e-9
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.fit_areas(points, areas, ROOM, shares=True, max_steps=1)
    assert caught.value.code == "notConverged"
    assert np.array_equal(fine.diagram.circles, np.column_stack([points, fine.weights]))
    relaxed = cv.fit_areas(points, areas, ROOM, shares=True, relax=1)
    assert np.abs(relaxed.diagram.circles[:, :2] - points).max() > 1
    assert relaxed.areas == pytest.approx(fine.areas, rel=1e-8)


def test_fits_far_from_the_origin_and_in_parts_that_touch_in_corners():
    for far in (5e6, -1e12):
        square = box(far, far, far + 1, far + 1)
        points = far + np.round(np.random.default_rng(6).random((10, 2)) * 1024) / 1024
        fit = cv.fit_areas(points, np.arange(1, 11), square, shares=True)
        assert fit.error <= fit.tolerance == 1e-9
        assert fit.areas == pytest.approx(np.arange(1, 11) / 55, rel=1e-9)
        assert np.array_equal(fit.diagram.circles[:, :2], points)
    parts = MultiPolygon([box(0, 0, 1, 1), box(1, 1, 2, 2)])
    assert cv.fit_areas([[0, 0], [2, 2]], [3, 1], parts, shares=True).areas == pytest.approx([1.5, 0.5])


def test_a_region_may_be_a_union():
    halves = MultiPolygon([box(0, 0, 60, 100), box(40, 0, 100, 100)])
    with pytest.raises(cv.CircleVoronoiError):
        cv.Region(halves)
    for shape in (halves, mapping(halves), halves.wkt, json.dumps(mapping(halves))):
        union = cv.Region(shape, dissolve=True)
        assert (union.area, union.bounds) == (10000, (0, 0, 100, 100))
    assert repr(union) == "<Region of 1 polygons, area 10000>"
    Path("halves.wkt").write_text(halves.wkt)
    assert cv.Region(Path("halves.wkt"), dissolve=True).area == 10000


@pytest.mark.parametrize(
    "areas, words",
    [([1, 2], "2 numbers; expected 3"), ([1, -1, 1], "Area 1 must be positive"), ([1, 1, 1], "sum"), ("other", "one of equal"), (["1", 2, 3], "number")],
)
def test_areas_that_do_not_fit_are_one_error(areas, words):
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.fit_areas([[10, 30], [70, 20], [30, 70]], areas, ROOM)
    assert words in str(caught.value), str(caught.value)


@pytest.mark.parametrize("nothing", [None, Polygon()])
def test_rows_without_a_geometry_are_no_region(nothing):
    geopandas = pytest.importorskip("geopandas")
    series = geopandas.GeoSeries([ROOM, nothing])
    with pytest.raises(cv.CircleVoronoiError, match="Row 1 of region has no geometry") as caught:
        cv.Region(series)
    assert caught.value.circle == 1
    assert cv.Region(series[:1]).area == ROOM.area


def test_lines_with_a_property_crs_name_no_reference_system():
    ring = [[0, 0], [4, 0], [4, 4], [0, 0]]
    feature = {"type": "Feature", "properties": {"crs": 1}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    other = {**feature, "geometry": {"type": "Polygon", "coordinates": [[[9, 9], [9, 8], [8, 8], [9, 9]]]}}
    region = cv.Region(json.dumps(feature) + "\n" + json.dumps(other))
    assert region.crs is None
