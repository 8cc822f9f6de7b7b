# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions in the forms that Python programs have them."""

from __future__ import annotations

import json
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Mapping

import numpy as np

from . import _core
from ._arguments import Floats, array_of, box, items_of, matrix
from ._errors import CircleVoronoiError


class Region:
    """Polygons with holes, to which cells are clipped.

    Every function with an argument `region` takes what this class takes. Make a `Region` to use it several times.

    Parameters
    ----------
    shape
        A polygon or several polygons: a shapely geometry, a GeoSeries or GeoDataFrame, a GeoJSON mapping (Polygon,
        MultiPolygon, Feature, FeatureCollection), the text of GeoJSON or well-known text, the path of such a file
        (`os.PathLike`), or a list of rings. A ring is an array of shape (k, 2). A point belongs to the region if an odd
        number of rings contain it.
    dissolve : bool
        Whether polygons may overlap and share borders, as administrative areas do. The region is then their union.

    Raises
    ------
    CircleVoronoiError
        The rings cross, overlap or have fewer than three points. The message names the ring and the point.
    """

    def __init__(self, shape: Any, *, dissolve: bool = False) -> None:
        self._core = _read(shape, dissolve)

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

    def __repr__(self) -> str:
        return f"<Region of {len(self._core.polygon_offsets) - 1} polygons, area {self.area:.6g}>"


def region_of(bounds: Any, region: Any) -> _core.Region | None:
    """Return the region that a box or a shape describes, or None if there is neither."""
    if bounds is not None and region is not None:
        raise CircleVoronoiError("Give either bounds or region, not both.", "badOption")
    if bounds is not None:
        return _core.region_of_box(box(bounds, "bounds"))
    if region is None:
        return None
    return region._core if isinstance(region, Region) else Region(region)._core


def _read(shape: Any, dissolve: bool) -> _core.Region:
    if isinstance(shape, str):
        return _core.read_region(shape, "region", dissolve)
    if isinstance(shape, PathLike):
        return _core.read_region(Path(shape).read_bytes(), fspath(shape), dissolve)
    if isinstance(shape, Mapping):
        return _core.read_region(_json(shape), "region", dissolve)
    if hasattr(shape, "geometry") and hasattr(shape.geometry, "iloc"):  # a GeoSeries or a GeoDataFrame
        geometries = list(shape.geometry)
        for row, geometry in enumerate(geometries):
            if geometry is None or geometry.is_empty:
                raise CircleVoronoiError(f"Row {row} of region has no geometry.", circle=row)
        features = [
            {"type": "Feature", "properties": {}, "geometry": geometry.__geo_interface__} for geometry in geometries
        ]
        return _core.read_region(json.dumps({"type": "FeatureCollection", "features": features}), "region", dissolve)
    if hasattr(shape, "__geo_interface__"):
        return _core.read_region(_json(shape.__geo_interface__), "region", dissolve)
    return _core.region_of_rings(_rings(shape), dissolve)


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
