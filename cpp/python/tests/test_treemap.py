# SPDX-License-Identifier: GPL-3.0-or-later
import geopandas
import numpy as np
import pandas
import pytest
from shapely.geometry import Polygon
from shapely.ops import unary_union

import circle_voronoi as cv

LAND = Polygon([(0, 0), (50, -10), (80, 30), (40, 70), (-10, 40)])


def towns(count=60, seed=1, decades=3):
    random = np.random.default_rng(seed)
    return pandas.DataFrame(
        {
            "land": [f"land {i % 3}" for i in range(count)],
            "region": [i % 7 for i in range(count)],
            "town": [f"town {i}" for i in range(count)],
            "people": 10 ** random.uniform(0, decades, count),
        }
    )


PATH = ["land", "region", "town"]


@pytest.mark.parametrize("metric", ["power", "circles"])
def test_each_cell_has_its_share_and_is_filled_by_those_below(metric):
    table = towns()
    cells = cv.treemap(table, PATH, "people", geopandas.GeoSeries([LAND], crs="EPSG:32633"), metric=metric)
    assert cells.crs == "EPSG:32633" and cells.is_valid.all()
    total = table["people"].sum()
    assert cells["area"].to_numpy() == pytest.approx(cells["people"].to_numpy() / total * LAND.area, rel=1e-8)
    assert cells.area.to_numpy() == pytest.approx(cells["area"].to_numpy(), rel=1e-9 if metric == "power" else 0.05)
    for level in (1, 2, 3):
        rows = cells[cells["level"] == level]
        assert len(rows) == len(table[PATH[:level]].drop_duplicates())
        assert rows["people"].sum() == pytest.approx(total)
        assert unary_union(list(rows.geometry)).symmetric_difference(LAND).area < 1e-6 * LAND.area
    for land, rows in cells[cells["level"] == 2].groupby("land"):
        whole = cells[(cells["level"] == 1) & (cells["land"] == land)].geometry.iloc[0]
        assert unary_union(list(rows.geometry)).symmetric_difference(whole).area < 1e-9 * LAND.area


def test_sites_stay_where_an_earlier_treemap_had_them():
    table = towns()
    first = cv.treemap(table, PATH, "people")
    again = cv.treemap(table, PATH, "people", previous=first)
    assert all(a.equals_exact(b, 0) for a, b in zip(first.geometry, again.geometry))
    table.loc[5, "people"] *= 1.01
    table = pandas.concat([table, towns(61).iloc[60:]], ignore_index=True)
    later = cv.treemap(table, PATH, "people", previous=first)
    known = later.merge(first, on=PATH, suffixes=("", "_before"))
    moved = (known["x"] != known["x_before"]) | (known["y"] != known["y_before"])
    assert len(known) == len(first) and moved.sum() < len(first) / 3


def test_rows_of_one_path_are_added_and_zeros_have_no_cell():
    table = pandas.DataFrame({"a": ["x", "x", "y", "z"], "n": [1, 2, 3, 0]})
    cells = cv.treemap(table, "a", "n")
    assert cells["area"].tolist() == pytest.approx([0.5, 0.5, 0])
    assert cells.geometry.iloc[2] is None


def test_cells_that_an_earlier_treemap_did_not_have_begin_anew():
    square = Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    table = pandas.DataFrame({"a": ["x", "y", "z"], "n": [1.0, 0.0, 0.0]})
    first = cv.treemap(table, "a", "n", square)
    assert first["x"].isna().tolist() == [False, True, True]
    table["n"] = [1.0, 2.0, 3.0]
    later = cv.treemap(table, "a", "n", square, previous=first)
    assert later["area"].tolist() == pytest.approx([4 / 6, 8 / 6, 2])


@pytest.mark.parametrize(
    "change, row",
    [({"people": -1}, 4), ({"people": float("nan")}, 4), ({"people": float("inf")}, 4), ({"town": None}, 4)],
)
def test_errors_name_the_row(change, row):
    table = towns()
    for name, value in change.items():
        table.loc[row, name] = value
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.treemap(table, PATH, "people")
    assert caught.value.circle == row


@pytest.mark.parametrize(
    "options",
    [{"metric": "centers"}, {"relax": -1}, {"tolerance": 0}, {"previous": 5}, {"previous": towns()}, {"path": []}, {"path": ["no"]}, {"values": "no"}],
)
def test_wrong_options_are_errors(options):
    with pytest.raises(cv.CircleVoronoiError):
        cv.treemap(**{"frame": towns(), "path": PATH, "values": "people", **options})
    with pytest.raises(cv.CircleVoronoiError):
        cv.treemap(towns().assign(people=0), PATH, "people")
