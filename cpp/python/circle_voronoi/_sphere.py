# SPDX-License-Identifier: GPL-3.0-or-later
"""Circles on a sphere."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._arguments import Floats, Indices, column, finite_points, index, optional_number, positive, rows_from, whole
from ._errors import CircleVoronoiError
from ._frames import caps_of, is_frame
from ._polygons import nested, shapes_of

if TYPE_CHECKING:
    from ._polygons import Cell

EARTH_RADIUS = 6371.0088
"""The Earth's mean radius in kilometers."""


class FarthestPlace(NamedTuple):
    """The place that is farthest from all circles, its distance from the nearest ones, and these circles."""

    lon: float
    lat: float
    distance: float
    circles: Indices


class SphereDiagram:
    """The Voronoi diagram of n circles on a sphere. Make one with `compute_sphere`.

    A place belongs to the circle with the smallest distance along the ground to its center, minus its radius. Lengths are
    in the unit of `radius`, angles in degrees.
    """

    def __init__(self, core: _core.SphereDiagram) -> None:
        self._core = core

    def __len__(self) -> int:
        return len(self._core.caps)

    def __repr__(self) -> str:
        return f"<SphereDiagram of {len(self)} circles, radius {self.radius:g}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.circles, self.radius, self.weights)

    @property
    def circles(self) -> Floats:
        """Longitude, latitude and radius of each circle, shape (n, 3)."""
        return self._core.caps

    @property
    def radius(self) -> float:
        """The radius of the sphere."""
        return self._core.radius

    @property
    def weights(self) -> bool:
        """Whether radii are additive weights."""
        return self._core.weights

    @property
    def rounding(self) -> float:
        """The diagram is proven for circles that differ by at most this length from the given ones."""
        return self._core.rounding

    @property
    def vertices(self) -> Floats:
        """Longitude, latitude, and distance from its three circles of each vertex, shape (v, 3)."""
        return self._core.vertices

    @property
    def vertex_circles(self) -> Indices:
        """The three circles of each vertex, counter-clockwise as seen from outside, shape (v, 3)."""
        return self._core.vertex_caps

    @property
    def edges(self) -> Indices:
        """Left and right circle, first and last vertex of each edge, shape (e, 4); -1 for no vertex."""
        return self._core.edges

    @property
    def hidden(self) -> Indices:
        """The circles without a cell, each with a circle that contains it, shape (h, 2)."""
        return self._core.hidden

    def neighbors(self, circle: int) -> Indices:
        """Return the circles across the sides of a cell, counter-clockwise. A circle may recur."""
        return self._core.neighbors(index(circle, len(self), "circle"))

    def find(self, lon: Any, lat: Any = None) -> Indices:
        """Return the nearest circle to each place; -1 if there are no circles.

        Parameters
        ----------
        lon, lat : array_like, shape (m,), or one array of shape (m, 2)
        """
        places = finite_points(lon if lat is None else _columns(lon, lat), "places")
        beyond = np.abs(places[:, 1]) > 90
        if beyond.any():
            row = int(np.argmax(beyond))
            message = f"Row {row} of places has the latitude {float(places[row, 1])!r}, which is beyond 90 degrees."
            raise CircleVoronoiError(message, circle=row)
        return self._core.find(places)

    def areas(self, *, max_distance: float | None = None) -> Floats:
        """Return the area of each cell, or of its part within `max_distance` of its circle, shape (n,)."""
        return self._core.areas(_distance(max_distance))

    def perimeters(self, *, max_distance: float | None = None) -> Floats:
        """Return the length of the border of each cell, shape (n,)."""
        return self._core.perimeters(_distance(max_distance))

    def polygons(self, *, tolerance: float | None = None, max_distance: float | None = None) -> list[Cell]:
        """Return the cells as polygons in degrees, as GeoJSON (RFC 7946) has them.

        They are cut at the antimeridian, and a pole is inside the polygon that it belongs to. They are valid, and
        neighbors share their points.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance between polygons and true borders, along the ground. By default a hundred-thousandth
            of the sphere's radius, 64 m on the Earth.
        max_distance : float, optional
            Cells are cut at this distance from their circles.

        Returns
        -------
        list of length n
            See `Diagram.polygons`.
        """
        limit = None if tolerance is None else positive(tolerance, "tolerance")
        return shapes_of(nested(*self._core.polygons(_distance(max_distance), limit)))

    def farthest_place(self) -> FarthestPlace | None:
        """Return the place that is farthest from all circles; None if there are none."""
        found = self._core.farthest_place()
        return None if found is None else FarthestPlace(*found)

    def closest_pair(self) -> tuple[int, int, float] | None:
        """Return the two visible circles with the smallest gap, and the gap; None if fewer than two are visible."""
        return self._core.closest_pair()


def compute_sphere(
    circles: Any = None,
    lat: Any = None,
    r: Any = None,
    *,
    lon: Any = None,
    radius: float = EARTH_RADIUS,
    weights: bool = False,
    threads: int = 1,
) -> SphereDiagram:
    """Compute the Voronoi diagram of circles on a sphere.

    Parameters
    ----------
    circles : array_like, shape (n, 3), or (n, 2) with `r`, or shape (n,) with `lat`, or a table
        Rows of longitude, latitude and radius; or places with `r` apart; or longitudes alone. A GeoDataFrame has points
        in degrees (EPSG:4326) as geometry, and its radii are the column `r`. A DataFrame has columns that `lon`, `lat`
        and `r` name, by default these words or longitude and latitude.
    lon, lat, r : array_like, shape (n,), or a number for `r`; for tables a name of a column
        Degrees, and radii along the ground in the unit of `radius`. With `lat` and without `r`, radii are 0. Without
        `circles`, they are the columns of the circles: ``compute_sphere(lon=lon, lat=lat, r=r)``.
    radius : float
        The radius of the sphere: by default the Earth's mean radius in kilometers.
    weights : bool
        Whether radii are additive weights, which may be negative.
    threads : int
        The number of threads that may work at the same time; 0 means one for each hardware thread.

    Returns
    -------
    SphereDiagram

    Raises
    ------
    CircleVoronoiError
        A number is missing or not finite, a latitude is beyond 90 degrees, a radius is negative or not below half of the
        circumference. The message names the row.

    Warns
    -----
    UserWarning
        More than a quarter of the circles are hidden inside others, perhaps because radii have another unit than
        `radius`.

    Examples
    --------
    >>> diagram = cv.compute_sphere([[-149.99, 61.17, 3], [8.57, 50.03, 5], [103.99, 1.36, 5]])
    >>> diagram.find([[77.1, 28.6]]).tolist()
    [2]
    >>> (diagram.areas() / 1e6).round(1).tolist()
    [162.2, 155.8, 192.1]
    """
    core = _core.compute_sphere(
        _caps(circles, lat, r, lon), positive(radius, "radius"), bool(weights), whole(threads, 0, 1024, "threads")
    )
    if core.hidden_warning:
        warnings.warn(core.hidden_warning, stacklevel=2)
    return SphereDiagram(core)


def _caps(circles: Any, lat: Any, r: Any, lon: Any) -> Floats:
    if is_frame(circles):
        return caps_of(circles, lat, r, lon)
    return rows_from(circles, lon, lat, r, ("lon", "lat", "r"), "compute_sphere", 0.0)


def _columns(lon: Any, lat: Any) -> Floats:
    longitudes = column(lon, None, "lon")
    return np.column_stack([longitudes, column(lat, len(longitudes), "lat")])


def _distance(value: float | None) -> float | None:
    number = optional_number(value, "max_distance")
    if number is not None and not np.isfinite(number):
        raise CircleVoronoiError(f"max_distance must be a finite number (got {value!r}).", "badOption")
    return number


def _unpickled(circles: Floats, radius: float, weights: bool) -> SphereDiagram:
    return SphereDiagram(_core.compute_sphere(circles, radius, weights, 1))
