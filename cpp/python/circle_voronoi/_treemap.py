# SPDX-License-Identifier: GPL-3.0-or-later
"""Treemaps of tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arguments import Floats, Indices, choice, positive, whole
from ._diagram import FIT_METRICS
from ._errors import CircleVoronoiError
from ._frames import column_of, is_frame, row_error
from ._polygons import nested, shapes_of
from ._regions import Region

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

SITE = ("x", "y", "weight")
UNIT_SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def treemap(
    frame: Any,
    path: Sequence[str],
    values: str,
    region: Any = None,
    *,
    metric: str = "power",
    relax: int | None = None,
    tolerance: float = 1e-9,
    previous: Any = None,
) -> GeoDataFrame:
    """Divide a region among the rows of a table, by the levels of a hierarchy, with areas in proportion to their values.

    Parameters
    ----------
    frame : pandas.DataFrame
    path : sequence of str
        The columns with the levels of the hierarchy, the highest first. Values of rows with the same path are added.
    values : str
        The column with the values, which are not negative. A path without a value has no cell.
    region
        See `Region`. The unit square by default.
    metric : {"power", "circles"}
        Whether the borders between the cells of the last level are straight or curved. Other borders are straight.
    relax : int, optional
        How often sites move to the centers of mass of their cells, which makes cells rounder. By default 8, and 0 for
        cells that `previous` has.
    tolerance : float
        The largest relative error of an area.
    previous : geopandas.GeoDataFrame, optional
        An earlier result. The cells below a path keep its sites, unless one of them is new or lies outside now.

    Returns
    -------
    geopandas.GeoDataFrame
        A row for each cell of each level, parents first: the columns of `path`, with None below the level of the row;
        `values`; "level", from 1; "area"; the site "x", "y" and its "weight"; and the cell as geometry. Site and geometry
        are missing where there is no cell.

    Raises
    ------
    CircleVoronoiError
        A column is missing, a value is missing, negative or not finite, all are zero, or what `fit_areas` raises. The
        message names the row.

    Examples
    --------
    >>> import pandas
    >>> towns = pandas.DataFrame({"region": ["North", "North", "South"], "town": ["A", "B", "C"], "people": [40, 20, 20]})
    >>> cells = cv.treemap(towns, path=["region", "town"], values="people")
    >>> cells[["region", "town"]].assign(share=cells.area.round(6)).values.tolist()
    [['North', None, 0.75], ['South', None, 0.25], ['North', 'A', 0.5], ['North', 'B', 0.25], ['South', 'C', 0.25]]
    """
    try:
        import geopandas
    except ImportError:
        raise ImportError("treemap needs geopandas. Install it with your package manager or pip.") from None
    if not is_frame(frame):
        raise CircleVoronoiError(f"treemap needs a DataFrame (got {type(frame).__name__}).")
    names = [path] if isinstance(path, str) else list(path)
    if not names:
        raise CircleVoronoiError("path must name one column or more.", "badOption")
    paths, parents, numbers = _tree(frame, names, values)
    earlier = np.empty((0, 3)) if previous is None else _sites(previous, names, paths)
    if not isinstance(region, Region):
        region = Region(UNIT_SQUARE if region is None else region)
    try:
        sums, areas, sites, polygons, rings, points, corners = _core.treemap(
            parents,
            numbers,
            region._core,
            choice(metric, FIT_METRICS, "metric"),
            None if relax is None else whole(relax, 0, 2**31 - 1, "relax"),
            positive(tolerance, "tolerance"),
            earlier,
        )
    except CircleVoronoiError as error:
        node = error.circle
        if node is None:
            raise
        message = str(error).replace(f"node {node}", repr(list(paths[node])) if node else "the whole region")
        raise CircleVoronoiError(message, error.code) from None
    rows = range(1, len(paths))
    shapes = shapes_of(nested(polygons, rings, points, corners))[1:]
    columns: dict[str, Any] = {
        name: [paths[i][level] if level < len(paths[i]) else None for i in rows] for level, name in enumerate(names)
    }
    columns[values] = sums[1:]
    columns["level"] = [len(paths[i]) for i in rows]
    columns["area"] = areas[1:]
    sites = np.where(sums[:, np.newaxis] > 0, sites, np.nan)
    columns |= {name: sites[1:, k] for k, name in enumerate(SITE)}
    return geopandas.GeoDataFrame(columns, geometry=geopandas.GeoSeries(shapes, crs=region.crs))


def _tree(frame: Any, names: Sequence[str], values: str) -> tuple[list[tuple[Any, ...]], Indices, Floats]:
    """Return the path of each node, its parent and its value, level by level. The root has the empty path."""
    numbers = column_of(frame, values)
    for row, number in enumerate(numbers):
        if not (np.isfinite(number) and number >= 0):
            raise row_error(frame, row, f"{values} must be finite and not negative (got {number:g})")
    levels = []
    for name in names:
        if name not in frame.columns:
            raise CircleVoronoiError(f"The table has no column {name!r}.")
        missing = np.asarray(frame[name].isna())
        if missing.any():
            raise row_error(frame, int(np.argmax(missing)), f"{name} is missing")
        levels.append(frame[name].tolist())
    paths = list(zip(*levels))
    node_of: dict[tuple[Any, ...], int] = {(): 0}
    for level in range(1, len(names) + 1):
        for path in paths:
            node_of.setdefault(path[:level], len(node_of))
    sums = np.zeros(len(node_of))
    for path, number in zip(paths, numbers):
        sums[node_of[path]] += number
    parents = [-1 if not key else node_of[key[:-1]] for key in node_of]
    return list(node_of), np.array(parents, dtype=np.int32), sums


def _sites(previous: Any, names: Sequence[str], paths: Sequence[tuple[Any, ...]]) -> Floats:
    """Return the sites of the nodes in an earlier treemap; NaN for new ones."""
    if not is_frame(previous) or not {*names, *SITE, "level"} <= set(previous.columns):
        raise CircleVoronoiError("previous must be the result of an earlier treemap.", "badOption")
    previous = previous.dropna(subset=list(SITE))
    places = np.column_stack([column_of(previous, name) for name in SITE])
    keys = zip(*(previous[name].tolist() for name in names), previous["level"].tolist())
    site_of = {tuple(key[: key[-1]]): place for key, place in zip(keys, places)}
    missing = np.full(3, np.nan)
    return np.array([site_of.get(key, missing) for key in paths])
