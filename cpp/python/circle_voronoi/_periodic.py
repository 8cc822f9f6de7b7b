# SPDX-License-Identifier: GPL-3.0-or-later
"""Diagrams in a box whose opposite sides are glued together."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._arguments import Floats, Indices, choice, finite_points, index, point, whole
from ._diagram import METRICS, Diagram, circles_from, fit_arguments, fit_options

if TYPE_CHECKING:
    from pandas import DataFrame

    from ._polygons import Cell


class Contacts(NamedTuple):
    """The contact table of a packing.

    The first five arrays have a row for each border of each visible circle, so each pair of circles occurs twice.
    `circle`, `neighbor` and `shift` (shape (k, 2)) name the two circles: the neighbor is moved by shift[0] times the first
    period and shift[1] times the second one. `length` is the length of the border, and `gap` the distance between the two
    circles, negative if they overlap. `area` and `packing_fraction` have a row for each circle: the area of its cell,
    and the share of its cell that it covers. If it overlaps another circle and the metric is not "circles", this is NaN.
    """

    circle: Indices
    neighbor: Indices
    shift: Indices
    length: Floats
    gap: Floats
    area: Floats
    packing_fraction: Floats

    def to_dataframe(self) -> DataFrame:
        """Return the borders as a table with the columns circle, neighbor, shift_a, shift_b, length and gap.

        Returns
        -------
        pandas.DataFrame

        Examples
        --------
        >>> packing = cv.compute_periodic([[1, 1, 0.5], [3, 1, 1]], (4, 0), (0, 2))
        >>> packing.contacts().to_dataframe().columns.tolist()
        ['circle', 'neighbor', 'shift_a', 'shift_b', 'length', 'gap']
        """
        try:
            from pandas import DataFrame
        except ImportError:
            raise ImportError("to_dataframe needs pandas. Install it with your package manager or pip.") from None
        shift_a, shift_b = self.shift.T
        columns = {"circle": self.circle, "neighbor": self.neighbor, "shift_a": shift_a, "shift_b": shift_b}
        return DataFrame({**columns, "length": self.length, "gap": self.gap})


class PeriodicDiagram:
    """The Voronoi diagram of n circles that repeat with two periods. Make one with `compute_periodic`.

    Attributes
    ----------
    images : Diagram
        The certified diagram of the given circles, which come first, and of the images that decide their cells.
    """

    def __init__(self, core: _core.PeriodicDiagram) -> None:
        self._core = core
        self.images = Diagram(core.diagram)

    def __len__(self) -> int:
        return self._core.circle_count

    def __repr__(self) -> str:
        a, b = self.periods
        return f"<PeriodicDiagram of {len(self)} circles, periods {tuple(a.tolist())} and {tuple(b.tolist())}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.circles, *self.periods.tolist(), self.images.metric, self.images.weights)

    @property
    def circles(self) -> Floats:
        """The given circles, shape (n, 3), rounded so that images are exact."""
        return self.images.circles[: len(self)]

    @property
    def periods(self) -> Floats:
        """The two periods, shape (2, 2)."""
        return np.array(self._core.lattice).reshape(2, 2)

    @property
    def image_circles(self) -> Indices:
        """For each circle of `images` the given circle of which it is an image."""
        return self._core.circle_of

    @property
    def image_shifts(self) -> Indices:
        """For each circle of `images` how many times each period is added to the given circle, shape (m, 2)."""
        return self._core.shift_of

    def areas(self) -> Floats:
        """Return the area of each cell, shape (n,). They sum to the area of the box."""
        return self.images.areas()[: len(self)]

    def centroids(self) -> Floats:
        """Return the center of mass of each cell, shape (n, 2)."""
        return self.images.centroids()[: len(self)]

    def perimeters(self) -> Floats:
        """Return the length of the outline of each cell, shape (n,)."""
        return self.images.perimeters()[: len(self)]

    def polygons(self, *, tolerance: float | None = None) -> list[Cell]:
        """Return the cells of the given circles as polygons: see `Diagram.polygons`. They may cross the box."""
        return self.images.polygons(tolerance=tolerance)[: len(self)]

    def neighbors(self, circle: int) -> tuple[Indices, Indices]:
        """Return the neighbors of a circle, counter-clockwise, and their shifts.

        A circle can be its own neighbor, with a shift that is not zero.

        Parameters
        ----------
        circle : int

        Returns
        -------
        circles : ndarray of int32, shape (k,)
        shifts : ndarray of int32, shape (k, 2)
            How many times each period is added to the neighbor.
        """
        return self._core.neighbors(index(circle, len(self), "circle"))

    def find(self, points: Any) -> tuple[Indices, Indices]:
        """Return the nearest circle to each point of the plane, and the shift of the image that is nearest.

        Parameters
        ----------
        points : array_like, shape (m, 2)

        Returns
        -------
        circles : ndarray of int32, shape (m,)
        shifts : ndarray of int32, shape (m, 2)

        Raises
        ------
        CircleVoronoiError
            `badInput` if a shift is 2^30 periods or more.
        """
        return self._core.find(finite_points(points, "points"))

    def contacts(self) -> Contacts:
        """Return borders, gaps, areas and packing fractions as arrays. Linear time."""
        return Contacts(*self._core.contacts())


class PeriodicAreaFit(NamedTuple):
    """The result of `fit_areas_periodic`.

    `weights` has the weight of each point, the least one 0. `periodic` is the certified periodic diagram of the points with
    these weights. `areas` are the areas of its cells, and `error` is the largest relative error of an area.
    `steps` is the number of Newton steps, and `tolerance` the error that was allowed (see `AreaFit`).
    """

    weights: Floats
    periodic: PeriodicDiagram
    areas: Floats
    error: float
    steps: int
    tolerance: float


def compute_periodic(
    circles: Any,
    a: Any,
    b: Any,
    *,
    x: Any = None,
    y: Any = None,
    r: Any = None,
    metric: str = "circles",
    weights: bool = False,
    threads: int = 1,
) -> PeriodicDiagram:
    """Compute the Voronoi diagram of circles in a box whose opposite sides are glued together.

    Parameters
    ----------
    circles : array_like, shape (n, 3), or (n, 2) with `r`, or a table
        They may lie anywhere, overlap, and be larger than the box.
    a, b : array_like, shape (2,)
        The periods: the sides of the box, which is any parallelogram.
    x, y : str, optional
        The columns of a table.
    r, metric, weights, threads : optional
        See `compute`.

    Returns
    -------
    PeriodicDiagram

    Raises
    ------
    CircleVoronoiError
        The periods are zero, parallel or not finite, or what `compute` raises.

    Examples
    --------
    >>> packing = cv.compute_periodic([[1, 1, 0.5], [3, 1, 1]], a=(4, 0), b=(0, 2))
    >>> packing.areas().round(3).tolist()
    [2.843, 5.157]
    """
    core = _core.compute_periodic(
        circles_from(circles, x, y, r),
        point(a, "a"),
        point(b, "b"),
        choice(metric, METRICS, "metric"),
        bool(weights),
        whole(threads, 0, 1024, "threads"),
    )
    return PeriodicDiagram(core)


def fit_areas_periodic(
    points: Any,
    areas: Any,
    a: Any,
    b: Any,
    *,
    metric: str = "circles",
    shares: bool = False,
    tolerance: float = 1e-9,
    max_steps: int = 500,
    relax: int = 0,
    weights: Any = 0.0,
) -> PeriodicAreaFit:
    """Find weights for which the cell of each point has a given area in a box whose opposite sides are glued together.

    Parameters
    ----------
    points : array_like, shape (n, 2)
        They may lie anywhere, but no two may differ by whole periods.
    areas : array_like, shape (n,), or "equal"
        Positive areas that sum to that of the box.
    a, b : array_like, shape (2,)
        The periods: the sides of the box, which is any parallelogram.
    metric, shares, tolerance, max_steps, relax, weights
        See `fit_areas`.

    Returns
    -------
    PeriodicAreaFit

    Raises
    ------
    CircleVoronoiError
        What `compute_periodic` or `fit_areas` raises.

    Examples
    --------
    >>> fit = cv.fit_areas_periodic([[1, 1], [3, 1]], [1, 3], (4, 0), (0, 2), shares=True)
    >>> fit.areas.round(6).tolist()
    [2.0, 6.0]
    """
    options = fit_options(areas, metric, shares, tolerance, max_steps, relax)
    found = _core.fit_areas_in_box(*fit_arguments(points, areas, weights), point(a, "a"), point(b, "b"), options)
    return PeriodicAreaFit(found[0], PeriodicDiagram(found[1]), *found[2:])


def _unpickled(circles: Floats, a: list[float], b: list[float], metric: str, weights: bool) -> PeriodicDiagram:
    return compute_periodic(circles, a, b, metric=metric, weights=weights)
