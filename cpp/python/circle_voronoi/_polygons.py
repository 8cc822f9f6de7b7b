# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons as lists of arrays, and as shapes of shapely."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from ._arguments import Floats, Indices

if TYPE_CHECKING:
    from shapely.geometry import MultiPolygon, Polygon

    # Type checkers take shapes for Any where shapely is not installed and cells are lists.
    Cell = Optional[Union[Polygon, MultiPolygon]]


def nested(polygons: Indices, rings: Indices, points: Indices, coordinates: Floats) -> list[list[list[Floats]]]:
    """Return for each row of flat arrays its polygons, each a list of rings."""
    loops = np.split(coordinates, points[1:-1]) if len(points) > 1 else []
    shapes = [loops[first:end] for first, end in zip(rings[:-1], rings[1:])]
    return [shapes[first:end] for first, end in zip(polygons[:-1], polygons[1:])]


def shapes_of(rows: list[list[list[Floats]]]) -> list[Cell]:
    """Return each row as a Polygon, a MultiPolygon or None; without shapely, return the rows themselves."""
    try:
        from shapely.geometry import MultiPolygon, Polygon
    except ImportError:
        return rows  # type: ignore[return-value]
    shapes: list[Cell] = []
    for row in rows:
        parts = [Polygon(rings[0], rings[1:]) for rings in row]
        shapes.append(None if not parts else parts[0] if len(parts) == 1 else MultiPolygon(parts))
    return shapes
