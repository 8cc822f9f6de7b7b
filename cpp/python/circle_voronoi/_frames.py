# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of pandas and geopandas."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arguments import Floats, column
from ._errors import CircleVoronoiError

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

    from ._diagram import Diagram
    from ._sphere import SphereDiagram


LONGITUDES = ("lon", "longitude", "lng", "long")
LATITUDES = ("lat", "latitude")


def is_frame(data: Any) -> bool:
    """Return whether `data` is a DataFrame or a GeoDataFrame."""
    return hasattr(data, "columns") and hasattr(data, "iloc")


def circles_of(frame: Any, x: Any, y: Any, r: Any) -> Floats:
    """Return the circles of a table. `x`, `y` and `r` name its columns; a GeoDataFrame has its points as geometry."""
    if hasattr(frame, "geometry"):
        if x is not None or y is not None:
            raise CircleVoronoiError("A GeoDataFrame has its points as geometry; give no x and y.", "badOption")
        crs = getattr(frame, "crs", None)
        if crs is not None and crs.is_geographic:
            raise CircleVoronoiError(
                f"The coordinates are degrees ({crs.to_string()}), in which distances mean nothing in a plane. Use"
                " compute_sphere, or project them, for example with frame.to_crs(frame.estimate_utm_crs()).",
                "badInput",
            )
        points = _points(frame)
    else:
        points = np.column_stack([column_of(frame, x or "x"), column_of(frame, y or "y")])
        if _are_degrees(x, y, points):
            warnings.warn(
                f"The columns {x} and {y} look like degrees, in which distances mean nothing in a plane. Use"
                " compute_sphere, or project them.",
                stacklevel=4,
            )
    return np.column_stack([points, _radii(frame, r)])


def caps_of(frame: Any, lat: Any, r: Any, lon: Any) -> Floats:
    """Return the circles of a table in degrees. A GeoDataFrame has its points as geometry."""
    if hasattr(frame, "geometry"):
        if lon is not None or lat is not None:
            raise CircleVoronoiError("A GeoDataFrame has its points as geometry; give no lon and lat.", "badOption")
        crs = getattr(frame, "crs", None)
        if crs is not None and not crs.is_geographic:
            raise CircleVoronoiError(
                f"The coordinates are not degrees ({crs.to_string()}). Convert them with frame.to_crs(4326).", "badInput"
            )
        places = _points(frame)
    else:
        names = [_first(frame, lon, LONGITUDES), _first(frame, lat, LATITUDES)]
        places = np.column_stack([column_of(frame, name) for name in names])
    return np.column_stack([places, _radii(frame, r)])


def _are_degrees(x: Any, y: Any, points: Floats) -> bool:
    """Return whether columns are called longitude and latitude, and their numbers are in the range of these."""
    is_named = str(x).lower() in LONGITUDES and str(y).lower() in LATITUDES
    return is_named and bool((np.abs(points) <= (360, 90)).all())


def _radii(frame: Any, r: Any) -> Floats:
    return column_of(frame, r or "r") if r is None or isinstance(r, str) else column(r, len(frame), "r")


def _first(frame: Any, given: Any, usual: tuple[str, ...]) -> Any:
    """Return the name of a column that the user gave, or the first of the usual names that the table has in any case."""
    if given is not None:
        return given
    for name in usual:
        for one in frame.columns:
            if str(one).lower() == name:
                return one
    return usual[0]


def to_geodataframe(diagram: Diagram | SphereDiagram, frame: Any, **limits: Any) -> GeoDataFrame:
    """Return a copy of a GeoDataFrame with the cells as its geometry.

    Parameters
    ----------
    diagram : Diagram or SphereDiagram
        The diagram of the rows of `frame`, in their order.
    frame : geopandas.GeoDataFrame
        The table. The copy has the same rows, columns, index and crs.
    **limits
        The arguments of `Diagram.polygons` or `SphereDiagram.polygons`.

    Returns
    -------
    geopandas.GeoDataFrame
        The geometry of a row without a cell is None.

    Raises
    ------
    CircleVoronoiError
        The table does not have a row for each circle, or what `Diagram.polygons` raises.

    Examples
    --------
    >>> import geopandas
    >>> points = geopandas.points_from_xy([0, 10], [0, 0])
    >>> shops = geopandas.GeoDataFrame({"name": ["Center", "East"]}, geometry=points, crs="EPSG:32633")
    >>> cells = cv.to_geodataframe(cv.compute(shops, r=0), shops, bounds=(-5, -5, 15, 5))
    >>> cells.area.tolist()
    [100.0, 100.0]
    """
    try:
        import geopandas  # noqa: F401
    except ImportError:
        raise ImportError("to_geodataframe needs geopandas. Install it with your package manager or pip.") from None
    if len(frame) != len(diagram):
        raise CircleVoronoiError(f"The table has {len(frame)} rows, the diagram {len(diagram)} circles.")
    cells = np.empty(len(frame), dtype=object)
    cells[:] = diagram.polygons(**limits)
    crs = getattr(frame, "crs", None)
    return frame.set_geometry(geopandas.GeoSeries(cells, index=frame.index, crs=crs))


def check_crs(crs: Any, other: Any) -> None:
    """Refuse a region whose coordinates are not those of the circles."""
    if crs is not None and other is not None and crs != other:
        raise CircleVoronoiError(
            f"The region is in {other.to_string()}, the circles in {crs.to_string()}. Convert it with geopandas:"
            f" to_crs({crs.to_string()!r}).",
            "badOption",
        )


def records_of(frame: Any) -> list[dict[Any, Any]]:
    """Return the rows of a table as mappings, without its geometry."""
    if hasattr(frame, "geometry"):
        frame = frame.drop(columns=frame.geometry.name)
    names = list(frame.columns)
    if len(set(names)) < len(names):
        raise CircleVoronoiError(f"The table has several columns of the same name. Its columns are {', '.join(map(str, names))}.")
    return [dict(zip(names, row)) for row in frame.itertuples(index=False, name=None)]


def column_of(frame: Any, name: str) -> Floats:
    """Return the numbers of a column."""
    if name not in frame.columns:
        names = ", ".join(str(one) for one in frame.columns)
        raise CircleVoronoiError(f"The table has no column {name!r}. Its columns are {names}.")
    values = frame[name]
    missing = np.asarray(values.isna())
    if missing.any():
        raise row_error(frame, int(np.argmax(missing)), f"{name} is missing")
    try:
        return column(values.to_numpy(), len(frame), name)
    except CircleVoronoiError as error:
        if error.circle is None:
            raise
        row = error.circle
        raise row_error(frame, row, f"{name} is not a number (got {values.iloc[row]!r})") from None


def _points(frame: Any) -> Floats:
    points = np.empty((len(frame), 2))
    for row, geometry in enumerate(frame.geometry):
        if geometry is None or geometry.is_empty:
            raise row_error(frame, row, "there is no geometry")
        if geometry.geom_type == "MultiPoint" and len(geometry.geoms) == 1:
            geometry = geometry.geoms[0]
        if geometry.geom_type != "Point":
            raise row_error(frame, row, f"the geometry is a {geometry.geom_type}, not a Point")
        points[row] = geometry.x, geometry.y
    return points


def row_error(frame: Any, row: int, what: str) -> CircleVoronoiError:
    """Return an error that names a row by its position and its label."""
    label = frame.index[row]
    name = f"Row {row}" if label == row else f"Row {row} (index {label!r})"
    return CircleVoronoiError(f"{name}: {what}.", circle=row)
