# SPDX-License-Identifier: GPL-3.0-or-later
import json
import pickle
import warnings

import geopandas
import numpy as np
import pandas
import pytest
from conftest import random_circles
from shapely.geometry import MultiPoint, Point, Polygon

import circle_voronoi as cv


def frame(crs="EPSG:32633"):
    circles = random_circles(12, 1)
    return geopandas.GeoDataFrame(
        {"name": [f"s{i}" for i in range(12)], "radius": circles[:, 2]},
        geometry=[Point(x, y) for x, y in circles[:, :2]],
        index=[f"row {i}" for i in range(12)],
        crs=crs,
    )


def test_a_geodataframe_keeps_rows_index_and_crs():
    points = frame()
    diagram = cv.compute(points, r="radius")
    cells = cv.to_geodataframe(diagram, points, bounds=(0, 0, 100, 100))
    assert list(cells.index) == list(points.index) and list(cells["name"]) == list(points["name"])
    assert cells.crs == points.crs and points.geometry.iloc[0].geom_type == "Point"
    assert np.nan_to_num(cells.area) == pytest.approx(diagram.areas(bounds=(0, 0, 100, 100)), abs=0.1)
    hidden = diagram.hidden[:, 0]
    assert all(cells.geometry.iloc[i] is None for i in hidden)


def test_a_dataframe_gives_its_columns():
    circles = random_circles(12, 2)
    table = pandas.DataFrame(circles, columns=["east", "north", "size"])
    expected = cv.compute(circles).vertices.tobytes()
    assert cv.compute(table, x="east", y="north", r="size").vertices.tobytes() == expected
    assert cv.compute(table.set_axis(["x", "y", "r"], axis=1)).vertices.tobytes() == expected
    assert cv.compute(table, x="east", y="north", r=0).circles[:, 2].tolist() == [0] * 12


def test_columns_in_degrees_are_told():
    places = pandas.DataFrame({"Lon": [8.6, 13.4, 2.3], "lat": [50.1, 52.5, 48.9]})
    with pytest.warns(UserWarning, match="compute_sphere"):
        cv.compute(places, x="Lon", y="lat", r=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cv.compute(places * 100, x="Lon", y="lat", r=0)
        cv.compute(places.set_axis(["x", "y"], axis=1), r=0)


@pytest.mark.parametrize(
    "use",
    [
        lambda diagram, region: diagram.areas(region=region),
        lambda diagram, region: diagram.neighbors(0, region=region),
        lambda diagram, region: diagram.to_bytes("geojson", region=region),
        lambda diagram, region: diagram.update(remove=[3]).polygons(region=region),
        lambda diagram, region: pickle.loads(pickle.dumps(diagram)).perimeters(region=region),
        lambda diagram, region: cv.to_geodataframe(diagram, frame(), region=region),
    ],
)
def test_a_region_in_another_crs_is_refused(use):
    shape = geopandas.GeoSeries([Polygon([(0, 0), (90, 0), (0, 90)])], crs="EPSG:32633")
    use(cv.compute(frame(), r="radius"), shape)
    use(cv.compute(frame(), r="radius"), geopandas.GeoSeries(list(shape)))
    with pytest.raises(cv.CircleVoronoiError, match="to_crs") as refused:
        use(cv.compute(frame(), r="radius"), shape.to_crs("EPSG:4326"))
    assert refused.value.code == "badOption"


def in_crs(code):
    """A region in a crs, in each form that has one."""
    shape = geopandas.GeoSeries([Polygon([(0, 0), (90, 0), (0, 90)])], crs=code)
    collection = {**json.loads(shape.to_json()), "crs": {"type": "name", "properties": {"name": f"urn:ogc:def:crs:{code.replace(':', '::')}"}}}
    shape.to_file("region.geojson", driver="GeoJSON")
    return [shape, geopandas.GeoDataFrame(geometry=shape), cv.Region(shape), collection, json.dumps(collection), "region.geojson"]


@pytest.mark.parametrize("form", range(6), ids=["series", "frame", "region", "mapping", "text", "file"])
def test_a_region_knows_its_crs(form):
    diagram = cv.compute(frame(), r="radius")
    assert diagram.areas(region=in_crs("EPSG:32633")[form]).sum() == pytest.approx(4050)
    with pytest.raises(cv.CircleVoronoiError, match="EPSG:32632.*EPSG:32633.*to_crs") as refused:
        diagram.areas(region=in_crs("EPSG:32632")[form])
    assert refused.value.code == "badOption"


def test_a_crs_that_is_none_is_one_error():
    shape = {**Polygon([(0, 0), (90, 0), (0, 90)]).__geo_interface__, "crs": {"type": "name", "properties": {"name": "nowhere"}}}
    with pytest.raises(cv.CircleVoronoiError, match="The member crs of region"):
        cv.Region(shape)
    assert cv.Region({**shape, "crs": None}).crs is None


def test_a_table_has_the_attributes():
    points = frame().iloc[:5].assign(
        count=np.array([1, 2, 3, 4, 5], dtype=np.int64),
        height=[1.5, np.nan, 2, 3, 4],
        opened=pandas.to_datetime(["2024-05-01 12:00", None, "2024-05-03", "2024-05-04", "2024-05-05"]),
        level=pandas.array([1, None, 3, 4, 5], dtype="Int64"),
        kind=pandas.Categorical(["a", "b", "a", "a", "b"]),
    )
    diagram = cv.compute(points, r=1)
    properties = [one["properties"] for one in json.loads(diagram.to_bytes("geojson", attributes=points))["features"]]
    expected = {"name": "s0", "count": 1, "height": 1.5, "opened": "2024-05-01T12:00:00", "level": 1, "kind": "a"}
    assert {name: properties[0][name] for name in expected} == expected
    assert {name: properties[1][name] for name in ("height", "opened", "level")} == dict.fromkeys(("height", "opened", "level"))
    with pytest.raises(cv.CircleVoronoiError, match="several columns of the same name"):
        diagram.to_bytes("json", attributes=pandas.DataFrame([[1, 2]] * 5, columns=["a", "a"]))


def with_geometry(row, geometry):
    points = frame()
    points.geometry = [geometry if i == row else one for i, one in enumerate(points.geometry)]
    return points


@pytest.mark.parametrize(
    "table, row, words",
    [
        (with_geometry(3, None), 3, "Row 3 (index 'row 3'): there is no geometry"),
        (with_geometry(3, Point()), 3, "there is no geometry"),
        (with_geometry(4, MultiPoint([(0, 0), (1, 1)])), 4, "MultiPoint"),
        (with_geometry(5, Polygon([(0, 0), (1, 0), (0, 1)])), 5, "Polygon"),
        (frame("EPSG:4326"), None, "degrees"),
        (frame().assign(radius=[1.0] * 7 + [np.nan] + [1.0] * 4), 7, "radius is missing"),
        (frame().assign(radius=["1"] * 12), 0, "radius is not a number"),
        (frame().drop(columns="radius"), None, "no column 'radius'"),
    ],
    ids=["null", "empty", "multi", "polygon", "degrees", "missing", "text", "no column"],
)
def test_a_bad_row_is_one_error_that_names_it(table, row, words):
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.compute(table, r="radius")
    assert caught.value.circle == row and words in str(caught.value)


def test_a_multipoint_of_one_point_is_a_point():
    assert cv.compute(with_geometry(2, MultiPoint([(7, 8)])), r="radius").circles[2, :2].tolist() == [7, 8]


def test_a_region_is_a_geodataframe():
    areas = geopandas.GeoDataFrame(geometry=[Polygon([(0, 0), (50, 0), (50, 50)]), Polygon([(60, 0), (90, 0), (90, 50)])])
    assert cv.compute(random_circles(9, 3)).areas(region=areas).sum() == pytest.approx(1250 + 750)


def test_other_tables_are_refused():
    points = frame()
    with pytest.raises(cv.CircleVoronoiError, match="11 rows, the diagram 12"):
        cv.to_geodataframe(cv.compute(points, r="radius"), points.iloc[:11])
