# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions in the forms that Python programs have them."""

from __future__ import annotations

import json
from os import PathLike, fspath
from os.path import isfile
from pathlib import Path
from re import fullmatch
from typing import Any, Mapping

import numpy as np

from . import _core
from ._arguments import Floats, array_of, box, items_of, matrix
from ._errors import CircleVoronoiError
from ._frames import check_crs


class Region:
    """Polygons with holes, to which cells are clipped.

    Every function with an argument `region` takes what this class takes. Make a `Region` to use it several times.

    Parameters
    ----------
    shape
        A polygon or several polygons: a shapely geometry, a GeoSeries or GeoDataFrame, a GeoJSON mapping (Polygon,
        MultiPolygon, Feature, FeatureCollection), the text of GeoJSON or well-known text, well-known binary in
        hexadecimal digits as PostGIS prints it, the path of such a file, or a list of rings. A ring is an array of
        shape (k, 2). A point belongs to the region if an odd number of rings contain it. A string is a path if there
        is such a file.
    dissolve : bool
        Whether polygons may overlap and share borders, as administrative areas do. The region is then their union.

    Raises
    ------
    CircleVoronoiError
        The rings cross, overlap or have fewer than three points. The message names the ring and the point.

    Attributes
    ----------
    crs : pyproj.CRS or None
        The coordinate reference system of a GeoSeries or GeoDataFrame, or the one that the member `crs` of GeoJSON names.
        Circles with another one are refused.

    Examples
    --------
    >>> town = cv.Region("POLYGON ((0 0, 40 0, 40 30, 0 30))")
    >>> town.area
    1200.0
    >>> cv.compute([[10, 10, 2], [30, 20, 0]]).areas(region=town).round(1).tolist()
    [643.7, 556.3]
    """

    def __init__(self, shape: Any, *, dissolve: bool = False) -> None:
        self._core, self.crs = _read(shape, dissolve)

    @property
    def area(self) -> float:
        """The area, in square units of the input."""
        return self._core.area

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The bounding box: least x and y, largest x and y."""
        return self._core.bounds

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """A GeoJSON MultiPolygon, which shapely and geopandas read."""
        points, rings, polygons = self._core.points, self._core.ring_offsets, self._core.polygon_offsets

        def closed(ring: int) -> tuple[tuple[float, float], ...]:
            corners = [(float(x), float(y)) for x, y in points[rings[ring] : rings[ring + 1]]]
            return (*corners, corners[0])

        coordinates = tuple(
            tuple(closed(ring) for ring in range(first, end)) for first, end in zip(polygons[:-1], polygons[1:])
        )
        return {"type": "MultiPolygon", "coordinates": coordinates}

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.__geo_interface__, self.crs)

    def __repr__(self) -> str:
        return f"<Region of {len(self._core.polygon_offsets) - 1} polygons, area {self.area:.6g}>"


def region_of(bounds: Any, region: Any, crs: Any = None) -> _core.Region | None:
    """Return the region that a box or a shape describes, or None if there is neither.

    A shape that has a crs has that of the circles, if they have one.
    """
    if bounds is not None and region is not None:
        raise CircleVoronoiError("Give either bounds or region, not both.", "badOption")
    if bounds is not None:
        return _core.region_of_box(box(bounds, "bounds"))
    if region is None:
        return None
    shape = region if isinstance(region, Region) else Region(region)
    check_crs(crs, shape.crs)
    return shape._core


def _unpickled(shape: Any, crs: Any) -> Region:
    region = Region(shape)
    region.crs = crs
    return region


def _read(shape: Any, dissolve: bool) -> tuple[_core.Region, Any]:
    """Return a region and its crs."""
    if isinstance(shape, (str, PathLike)):
        text, name = _text_of(shape)
        return _core.read_region(text, name, dissolve), _crs_in(text)
    if isinstance(shape, Mapping):
        return _core.read_region(_json(shape), "region", dissolve), _crs_named(shape)
    if hasattr(shape, "geometry") and hasattr(shape.geometry, "iloc"):  # a GeoSeries or a GeoDataFrame
        geometries = list(shape.geometry)
        for row, geometry in enumerate(geometries):
            if geometry is None or geometry.is_empty:
                raise CircleVoronoiError(f"Row {row} of region has no geometry.", circle=row)
        features = [
            {"type": "Feature", "properties": {}, "geometry": geometry.__geo_interface__} for geometry in geometries
        ]
        collection = json.dumps({"type": "FeatureCollection", "features": features})
        return _core.read_region(collection, "region", dissolve), getattr(shape, "crs", None)
    if hasattr(shape, "__geo_interface__"):
        return _core.read_region(_json(shape.__geo_interface__), "region", dissolve), None
    return _core.region_of_rings(_rings(shape), dissolve), None


def _text_of(shape: str | PathLike[str]) -> tuple[bytes, str]:
    """Return the text of a region, which is UTF-8, and the name that errors call it."""
    if not isinstance(shape, str) or isfile(shape):
        return Path(shape).read_bytes(), fspath(shape)
    # GeoJSON has braces, well-known text has parentheses or says that there are no polygons, and binary has digits alone.
    is_geometry = any(sign in shape.upper() for sign in ("{", "(", "EMPTY")) or fullmatch(r"\s*0[01][0-9A-Fa-f]+\s*", shape)
    if shape.strip() and not is_geometry:
        raise CircleVoronoiError(f"region is neither a file nor GeoJSON nor well-known text (got {shape!r}).")
    return shape.encode(errors="surrogatepass"), "region"


def _crs_in(text: bytes) -> Any:
    """Return the crs that GeoJSON names, if any; GeoJSON lines name none. The text has been read as a region."""
    if b'"crs"' not in text:
        return None
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return _crs_named(value)


def _crs_named(shape: Mapping[str, Any]) -> Any:
    """Return the crs of the member `crs` that GeoJSON had before RFC 7946, and that GDAL still writes."""
    member = shape.get("crs")
    if member is None:
        return None
    try:
        from pyproj import CRS
        from pyproj.exceptions import CRSError
    except ImportError:  # Without pyproj, no circles have a crs.
        return None
    try:
        return CRS.from_user_input(member["properties"]["name"])
    except (KeyError, TypeError, CRSError) as error:
        raise CircleVoronoiError(f"The member crs of region names no coordinate reference system: {error}.") from error


def _json(shape: Any) -> str:
    try:
        return json.dumps(shape)
    except (TypeError, ValueError, RecursionError) as error:
        raise CircleVoronoiError(f"region is no GeoJSON: {error}.") from error


def _rings(shape: Any) -> list[Floats]:
    if isinstance(shape, memoryview):
        shape = array_of(shape, "region")
    if isinstance(shape, bytes) or not hasattr(shape, "__iter__") or getattr(shape, "ndim", 1) == 0:
        raise CircleVoronoiError(
            f"region must be a geometry, GeoJSON, well-known text or a list of rings (got {type(shape).__name__})."
        )
    items = items_of(shape, "region")
    is_one_ring = len(items) > 0 and np.ndim(array_of(items[0], "the first ring of region")) == 1
    return [
        matrix(ring, ("x", "y"), f"ring {number} of region") for number, ring in enumerate([items] if is_one_ring else items)
    ]
