# SPDX-License-Identifier: GPL-3.0-or-later
import geopandas
import numpy as np
import pandas
import pytest
import shapely
import shapely.ops
from scipy.spatial import SphericalVoronoi
from shapely.geometry import Point

import circle_voronoi as cv

CITIES = [[-134.42, 58.3, 40], [30.31, 59.94, 20], [144.96, -37.81, 0], [0, -90, 5], [30.4, 59.94, 1]]


def random_caps(count, seed, largest=0.0):
    random = np.random.default_rng(seed)
    lat = np.degrees(np.arcsin(random.uniform(-1, 1, count)))
    return np.column_stack([random.uniform(-180, 180, count), lat, random.uniform(0, largest, count)])


def vectors(lon, lat):
    lon, lat = np.radians(lon), np.radians(lat)
    return np.column_stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])


def test_points_have_the_cells_of_scipy():
    caps = random_caps(500, 1)
    diagram = cv.compute_sphere(caps, radius=1)
    scipy = SphericalVoronoi(vectors(caps[:, 0], caps[:, 1]))
    assert diagram.areas() == pytest.approx(scipy.calculate_areas(), rel=1e-9)
    ours = {frozenset(triple) for triple in diagram.vertex_circles.tolist()}
    theirs = [set() for _ in scipy.vertices]
    for cell, vertices in enumerate(scipy.regions):
        for vertex in vertices:
            theirs[vertex].add(cell)
    assert ours == {frozenset(cells) for cells in theirs}


def test_find_is_the_nearest_circle_of_brute_force():
    caps = random_caps(200, 2, 800)
    diagram = cv.compute_sphere(caps)
    places = random_caps(1000, 3)[:, :2]
    angles = np.arccos(np.clip(vectors(*places.T) @ vectors(caps[:, 0], caps[:, 1]).T, -1, 1))
    distances = angles * cv.EARTH_RADIUS - caps[:, 2]
    found = diagram.find(places)
    assert distances[np.arange(1000), found] == pytest.approx(distances.min(axis=1), abs=1e-3)
    assert (diagram.find(*places.T) == found).all()


@pytest.mark.parametrize("tolerance", [0.1, 50, 500])
@pytest.mark.parametrize("max_distance", [None, 700])
def test_polygons_are_valid_and_share_no_area(tolerance, max_distance):
    diagram = cv.compute_sphere(np.vstack([random_caps(60, 4, 2000), CITIES]))
    cells = diagram.polygons(tolerance=tolerance, max_distance=max_distance)
    whole = [cell for cell in cells if cell is not None]
    assert all(cell.is_valid for cell in whole)
    if max_distance is None:
        assert sum(cell.area for cell in whole) == pytest.approx(360 * 180, rel=1e-6)


def test_a_cell_with_a_pole_is_one_polygon_around_it_in_a_polar_map():
    diagram = cv.compute_sphere(CITIES)
    cell = diagram.polygons(tolerance=10)[3]

    def polar(lon, lat):
        distance = 90 + np.asarray(lat)
        return distance * np.cos(np.radians(lon)), distance * np.sin(np.radians(lon))

    # Once the seam at 180 degrees is dissolved.
    around = shapely.ops.unary_union(shapely.ops.transform(polar, cell).buffer(1e-7))
    assert around.geom_type == "Polygon" and around.is_valid and len(around.interiors) == 0
    assert around.contains(Point(0, 0))


def test_areas_sum_to_the_sphere_and_are_cut_at_a_distance():
    diagram = cv.compute_sphere(CITIES)
    assert diagram.areas().sum() == pytest.approx(4 * np.pi * cv.EARTH_RADIUS**2, rel=1e-12)
    cut = 2 * np.pi * cv.EARTH_RADIUS**2 * (1 - np.cos(540 / cv.EARTH_RADIUS))
    assert diagram.areas(max_distance=500)[0] == pytest.approx(cut, rel=1e-12)
    around = 2 * np.pi * cv.EARTH_RADIUS * np.sin(540 / cv.EARTH_RADIUS)
    assert diagram.perimeters(max_distance=500)[0] == pytest.approx(around, rel=1e-12)
    assert diagram.hidden.tolist() == [[4, 1]]


def test_a_geodataframe_comes_back_with_cells():
    names = [f"city {i}" for i in range(len(CITIES))]
    points = geopandas.GeoDataFrame(
        {"name": names, "km": [row[2] for row in CITIES]},
        geometry=[Point(lon, lat) for lon, lat, _ in CITIES],
        index=[f"row {i}" for i in range(len(CITIES))],
        crs="EPSG:4326",
    )
    diagram = cv.compute_sphere(points, r="km")
    assert diagram.circles.tolist() == CITIES
    cells = cv.to_geodataframe(diagram, points, tolerance=10)
    assert list(cells["name"]) == names and list(cells.index) == list(points.index) and cells.crs == points.crs
    assert cells.geometry.iloc[4] is None and cells.geometry.iloc[:4].is_valid.all()
    with pytest.raises(cv.CircleVoronoiError, match="4326"):
        cv.compute_sphere(points.to_crs("EPSG:3857"), r="km")
    with pytest.raises(cv.CircleVoronoiError, match="compute_sphere"):
        cv.compute(points, r="km")


def test_tables_arrays_and_rows_give_the_same_bits():
    expected = cv.compute_sphere(CITIES).vertices.tobytes()
    lon, lat, r = np.array(CITIES).T
    table = pandas.DataFrame({"Longitude": lon, "LAT": lat, "r": r})
    assert cv.compute_sphere(lon, lat, r).vertices.tobytes() == expected
    assert cv.compute_sphere(np.column_stack([lon, lat]), r=r).vertices.tobytes() == expected
    assert cv.compute_sphere(table).vertices.tobytes() == expected
    assert cv.compute_sphere(CITIES, threads=2).vertices.tobytes() == expected
    assert cv.compute_sphere(lon, lat).circles[:, 2].tolist() == [0] * len(lon)


def test_few_circles_have_a_diagram():
    none = cv.compute_sphere([])
    assert len(none) == 0 and none.find([[1, 2]]).tolist() == [-1]
    assert none.farthest_place() is None and none.closest_pair() is None
    one = cv.compute_sphere([[10, 20, 3]])
    assert one.polygons()[0].equals(shapely.geometry.box(-180, -90, 180, 90))
    assert one.farthest_place()[:2] == pytest.approx((-170, -20))
    two = cv.compute_sphere([[0, 90, 0], [0, -90, 100]])
    assert two.closest_pair() == (0, 1, pytest.approx(np.pi * cv.EARTH_RADIUS - 100))
    assert two.neighbors(0).tolist() == [1] and sorted(two.edges[0].tolist()) == [-1, -1, 0, 1]


def test_columns_of_places_are_arguments():
    lon, lat, r = random_caps(20, 9, 100).T
    expected = cv.compute_sphere(lon, lat, r).vertices.tobytes()
    assert cv.compute_sphere(lon=lon, lat=lat, r=r).vertices.tobytes() == expected
