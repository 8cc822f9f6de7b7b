# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams of circles."""

from __future__ import annotations

import json
import warnings
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _figure, _plot
from ._arguments import (
    Floats,
    Indices,
    box,
    choice,
    column,
    finite_points,
    index,
    indices,
    items_of,
    json_object,
    mapping,
    matrix,
    optional_number,
    point,
    positive,
    rows_from,
    whole,
)
from ._errors import CircleVoronoiError
from ._frames import circles_of, is_frame, records_of
from ._polygons import nested, shapes_of
from ._regions import region_of

if TYPE_CHECKING:
    from os import PathLike

    from ._polygons import Cell

METRICS = ("circles", "centers", "power")
# Metrics with weights.
FIT_METRICS = ("circles", "power")
METHODS = ("auto", "touching-disc", "flip")
CANDIDATES = ("dynamic", "uniform", "all-pairs")
FORMATS = ("json", "csv", "cells", "svg", "geojson", "geojsonl", "wkt", "obj")
# The formats that are not clipped to bounds, and those that say more about circles than x, y and r.
_UNCLIPPED = ("json", "csv")
_ATTRIBUTED = ("json", "cells", "svg", "geojson", "geojsonl")
_XYR = ("x", "y", "r")


class Certificate(NamedTuple):
    """The verdict on a diagram: proven to be right, or the first flaw.

    `circle`, `vertex` and `edge` are the indices concerned, or None. `message` is one sentence; it is empty if the
    diagram is certified.
    """

    certified: bool
    flaw: str
    circle: int | None
    vertex: int | None
    edge: int | None
    message: str


class EmptyDisc(NamedTuple):
    """A disc that overlaps no circle, and the circles that it touches."""

    x: float
    y: float
    r: float
    circles: Indices


class ClearestPath(NamedTuple):
    """A path that stays as far from all circles as any path between its ends can.

    `clearance` is the smallest distance from a circle along the path; it is negative if every path enters a circle.
    `edges` are the edges of the diagram that it follows. `points` has shape (k, 2): a polyline within the tolerance of
    the path, from its start to its end.
    """

    clearance: float
    edges: Indices
    points: Floats


class Diagram:
    """The Voronoi diagram of n circles, by indices. Make one with `compute`, `read` or `update`.

    A point belongs to the circle with the smallest distance minus radius. Arrays are read-only views of the diagram's
    own memory. The index -1 means "none": an end at infinity.

    Attributes
    ----------
    ids : ndarray of int32, shape (n,)
        The id of each circle. Ids stay the same in `update`; without updates they are 0 to n - 1.
    crs : pyproj.CRS or None
        The coordinate reference system of the GeoDataFrame that the circles come from.
    """

    def __init__(
        self, core: _core.Diagram, ids: Indices | None = None, editor: _Editor | None = None, crs: Any = None
    ) -> None:
        self._core = core
        self.crs = crs
        self._finder: _core.Finder | None = None
        self._editor = editor
        if ids is None:
            ids = np.arange(len(core.circles), dtype=np.int32)
            ids.flags.writeable = False
        self.ids = ids

    @property
    def circles(self) -> Floats:
        """The circles of the input, shape (n, 3): x, y, r."""
        return self._core.circles

    @property
    def vertices(self) -> Floats:
        """The Voronoi vertices, shape (v, 3): x, y and radius of the disc that touches the three circles of the vertex.

        A vertex that touches more than three circles appears as several vertices, joined by edges of length zero.
        """
        return self._core.vertices

    @property
    def vertex_circles(self) -> Indices:
        """The three circles of each vertex, counter-clockwise, shape (v, 3)."""
        return self._core.vertex_circles

    @property
    def edges(self) -> Indices:
        """The edges, shape (e, 4): left circle, right circle, start vertex, end vertex."""
        return self._core.edges

    @property
    def hidden(self) -> Indices:
        """The circles without a cell, each with a circle that contains it, shape (h, 2)."""
        return self._core.hidden

    @property
    def hull(self) -> Indices:
        """The circles on the convex hull, counter-clockwise. A circle recurs if the hull touches it more than once."""
        return self._core.hull

    @property
    def next_side(self) -> Indices:
        """The next side around the cell of each side, shape (2 e,). Sides 2 k and 2 k + 1 are edge k from left and right."""
        return self._core.next_side

    @property
    def first_side(self) -> Indices:
        """The smallest side of each cell, shape (n,)."""
        return self._core.first_side

    @property
    def metric(self) -> str:
        """The distance that defines the cells: "circles", "centers" or "power"."""
        return self._core.metric

    @property
    def weights(self) -> bool:
        """Whether the third numbers of circles are weights, which may be negative."""
        return self._core.weights

    @property
    def certificate(self) -> Certificate:
        """The certificate that came with the diagram."""
        return Certificate(*self._core.certificate)

    @property
    def certified(self) -> bool:
        """Whether the diagram is proven to be right."""
        return self.certificate.certified

    @property
    def stats(self) -> dict[str, Any]:
        """How the diagram was made: the construction (`way`), `counts`, and `seconds` of each stage."""
        return self._core.stats

    def __len__(self) -> int:
        return len(self._core.circles)

    def __repr__(self) -> str:
        counts = f"{len(self)} circles, {len(self.hidden)} hidden, {len(self.vertices)} vertices, {len(self.edges)} edges"
        return f"<Diagram of {counts}, {'certified' if self.certified else 'not certified'}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.to_bytes("json"), self.ids, self.crs)

    def _clip(self, bounds: Any, region: Any) -> _core.Region | None:
        return region_of(bounds, region, self.crs)

    def _repr_html_(self) -> str:
        return _figure.html(self)

    def certify(self) -> Certificate:
        """Judge the diagram once more. Linear time.

        Returns
        -------
        Certificate
        """
        return Certificate(*self._core.certify())

    def export_box(self, *, max_distance: float | None = None) -> tuple[float, float, float, float]:
        """Return the box to which polygons, files and plots are clipped without `bounds` and `region`.

        It is the bounding box of the circles, each grown by `max_distance`, with a margin of a twentieth of its size.

        Returns
        -------
        tuple of four float
            Least x and y, largest x and y.

        Examples
        --------
        >>> cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]]).export_box()
        (-2.65, -2.65, 11.65, 10.15)
        """
        return _core.export_box(self._core, _distance(max_distance))

    def clipped_cells(
        self, *, bounds: Any = None, region: Any = None, max_distance: float | None = None
    ) -> npt.NDArray[np.bool_]:
        """Return whether each cell is clipped, so that `polygons` has at most a part of it.

        Takes the same parameters as `areas`. By default cells are clipped to `export_box`.

        Returns
        -------
        ndarray of bool, shape (n,)
            False for hidden circles, and for cells that lie outside.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 1], [4, 0, 1], [0, 4, 1], [-4, 0, 1], [0, -4, 1]])
        >>> diagram.clipped_cells().tolist()
        [False, True, True, True, True]
        """
        return _core.clipped_cells(self._core, self._clip(bounds, region), _distance(max_distance))

    def areas(self, *, bounds: Any = None, region: Any = None, max_distance: float | None = None) -> Floats:
        """Return the area of each cell.

        Parameters
        ----------
        bounds : four numbers, optional
            Clip the cells to this box: least x and y, largest x and y.
        region : optional
            Clip the cells to this region: see `Region`.
        max_distance : float, optional
            Cut each cell at this distance from its circle: at this length of the tangents to the circle, the root of
            the power, in a power diagram.

        Returns
        -------
        ndarray of float64, shape (n,)
            In square units of the input. Hidden circles have 0. Without limits, unbounded cells have infinity. In a
            region without `max_distance`, the areas sum to that of the region.

        Raises
        ------
        CircleVoronoiError
            The limits are not valid.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.areas(bounds=(-5, -5, 15, 15)).round(2).tolist()
        [113.88, 97.69, 188.43]
        """
        return _core.areas(self._core, self._clip(bounds, region), _distance(max_distance))

    def centroids(self, *, bounds: Any = None, region: Any = None, max_distance: float | None = None) -> Floats:
        """Return the center of mass of each cell.

        Takes the same parameters as `areas`.

        Returns
        -------
        ndarray of float64, shape (n, 2)
            NaN for unbounded cells without limits, and where there is no cell.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.centroids(bounds=(-5, -5, 15, 15)).round(1).tolist()
        [[-0.3, 0.6], [10.7, 0.3], [5.2, 10.1]]
        """
        return _core.centroids(self._core, self._clip(bounds, region), _distance(max_distance))

    def perimeters(self, *, bounds: Any = None, region: Any = None, max_distance: float | None = None) -> Floats:
        """Return the length of the outline of each cell, holes included.

        Takes the same parameters as `areas`.

        Returns
        -------
        ndarray of float64, shape (n,)
            In units of the input. Hidden circles have 0. Without limits, unbounded cells have infinity.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.perimeters(max_distance=1).round(2).tolist()
        [18.85, 12.57, 15.71]
        """
        return _core.perimeters(self._core, self._clip(bounds, region), _distance(max_distance))

    def polygons(
        self,
        *,
        tolerance: float | None = None,
        bounds: Any = None,
        region: Any = None,
        max_distance: float | None = None,
    ) -> list[Cell]:
        """Return the cells as polygons. Neighbors share their points to the bit.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance between a polygon and the true curves, in units of the input. By default a
            hundred-thousandth of the size of the box or region.
        bounds, region, max_distance : optional
            See `areas`. By default cells are clipped to `export_box`. `clipped_cells` tells which ones are.

        Returns
        -------
        list of length n
            With shapely installed a Polygon, a MultiPolygon if the region cuts the cell apart, or None if there is no
            cell. Without shapely a list of polygons, each a list of rings, each an array of shape (k, 2). The first
            ring is the outer one, counter-clockwise; the others are holes.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> cells = diagram.polygons(bounds=(-5, -5, 15, 15))
        >>> [round(cell.area, 1) for cell in cells]
        [113.9, 97.7, 188.4]
        """
        arrays = _core.polygons(
            self._core,
            self._clip(bounds, region),
            _distance(max_distance),
            None if tolerance is None else positive(tolerance, "tolerance"),
        )
        return shapes_of(nested(*arrays))

    def neighbors(
        self, circle: int, *, bounds: Any = None, region: Any = None, max_distance: float | None = None
    ) -> Indices:
        """Return the circles whose cells share an edge with a cell, counter-clockwise, each once.

        Parameters
        ----------
        circle : int
        bounds, region, max_distance : optional
            See `areas`. With limits, only circles count that share a part of an edge inside them. For all circles at
            once, `neighbor_pairs` is faster.

        Returns
        -------
        ndarray of int32

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.neighbors(0).tolist()
        [2, 1]
        """
        i = index(circle, len(self), "circle")
        clip, distance = self._clip(bounds, region), _distance(max_distance)
        if clip is not None or distance is not None:
            return _core.neighbors_inside(self._core, i, clip, distance)
        found = self._core.neighbors(i)
        _, first = np.unique(found, return_index=True)
        return found[np.sort(first)]

    def neighbor_pairs(
        self, *, bounds: Any = None, region: Any = None, max_distance: float | None = None
    ) -> Indices:
        """Return the pairs of circles whose cells share an edge, as an array of shape (k, 2).

        Each pair occurs once, with the smaller index first, in increasing order. Takes the same limits as `neighbors`.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.neighbor_pairs().tolist()
        [[0, 1], [0, 2], [1, 2]]
        """
        clip, distance = self._clip(bounds, region), _distance(max_distance)
        if clip is None and distance is None:
            return self._core.neighbor_pairs()
        return _core.pairs_inside(self._core, clip, distance)

    def find(self, points: Any) -> Indices:
        """Return the circle nearest to each point: the cell that contains it.

        Parameters
        ----------
        points : array_like, shape (m, 2)

        Returns
        -------
        ndarray of int32, shape (m,)
            -1 if there are no circles.

        Raises
        ------
        CircleVoronoiError
            A point is not finite; the message names its row.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> diagram.find([[1, 1], [9, 0], [5, 6]]).tolist()
        [0, 1, 2]
        """
        if self._finder is None:
            self._finder = _core.Finder(self._core)
        return self._finder.find(finite_points(points, "points"))

    def largest_empty_disc(self, *, bounds: Any = None, region: Any = None, inside: bool = False) -> EmptyDisc | None:
        """Return the largest disc that overlaps no circle.

        Parameters
        ----------
        bounds, region : optional
            The center lies in this box or region. By default it lies in the convex hull of the circles.
        inside : bool
            Whether the whole disc lies in the box or region.

        Returns
        -------
        EmptyDisc or None
            None if there are no circles. The radius is negative if circles cover the region.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> disc = diagram.largest_empty_disc()
        >>> round(disc.r, 3), disc.circles.tolist()
        (4.075, [0, 1, 2])
        """
        clip = self._clip(bounds, region)
        if inside and clip is None:
            raise CircleVoronoiError("inside needs bounds or region.", "badOption")
        found = _core.largest_empty_disc(self._core, clip, inside)
        return None if found is None else EmptyDisc(*found)

    def clearest_path(
        self, start: Any, end: Any, *, bounds: Any = None, region: Any = None, tolerance: float | None = None
    ) -> ClearestPath | None:
        """Return a path between two points that stays as far from all circles as any path can.

        Parameters
        ----------
        start, end : array_like, shape (2,)
        bounds, region : optional
            The path stays inside this box or region. It may run along the boundary, which counts as no obstacle.
        tolerance : float, optional
            The largest distance of `points` from the true curves. By default a hundred-thousandth of the size of the
            circles' bounding box.

        Returns
        -------
        ClearestPath or None
            None if the ends lie in different parts of the region.

        Raises
        ------
        CircleVoronoiError
            There are no circles, or an end lies outside the region.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> path = diagram.clearest_path([5, -3], [9, 7])
        >>> round(path.clearance, 3), path.edges.tolist()
        (2.623, [2, 1])
        """
        distance = None if tolerance is None else positive(tolerance, "tolerance")
        found = _core.clearest_path(
            self._core, point(start, "start"), point(end, "end"), self._clip(bounds, region), distance
        )
        return None if found is None else ClearestPath(*found)

    def update(self, *, remove: Any = (), replace: Mapping[int, Any] | None = None, insert: Any = ()) -> Diagram:
        """Return the certified diagram after some edits. All edits are made, or none.

        The edits themselves take microseconds each, the arrays of the new diagram take linear time. This diagram does
        not change. Only the newest diagram of a series can be updated.

        Parameters
        ----------
        remove : array_like of int
            The ids of circles to remove.
        replace : mapping of int to (x, y, r), optional
            New circles for ids.
        insert : array_like, shape (k, 3)
            New circles. They get the next ids, in their order.

        Returns
        -------
        Diagram
            Its `ids` name the circle of each row.

        Raises
        ------
        CircleVoronoiError
            An id is unknown, or a circle is not valid. `edit` is the index of the edit to blame.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
        >>> newest = diagram.update(remove=[1], replace={0: (1, 0, 2)}, insert=[[9, 9, 1]])
        >>> newest.ids.tolist()
        [0, 2, 3]
        """
        if self.metric != "circles":
            raise CircleVoronoiError(f"A diagram of the metric {self.metric} cannot be updated.", "badInput")
        editor = self._editor if self._editor is not None else _Editor(self)
        changes = {} if replace is None else dict(mapping(replace, "replace"))
        edits = (
            indices(remove, "remove"),
            indices(list(changes), "the ids of replace"),
            matrix(list(changes.values()), _XYR, "replace"),
            matrix(insert, _XYR, "insert"),
        )
        # Edits release the GIL, and an editor serves one thread at a time.
        with editor.lock:
            if editor.newest is not self._core:
                raise CircleVoronoiError(
                    "Another update was made from this diagram. Update the newest one.", "badInput"
                )
            result = editor.apply(*edits)
        result.crs = self.crs
        self._editor = editor
        return result

    def to_bytes(
        self,
        format: str,
        *,
        bounds: Any = None,
        region: Any = None,
        max_distance: float | None = None,
        tolerance: float | None = None,
        digits: int | None = None,
        attributes: Any = None,
    ) -> bytes:
        """Return the diagram as the text of a file, as the program ``circle-voronoi compute`` writes it.

        Parameters
        ----------
        format : {"json", "csv", "cells", "svg", "geojson", "geojsonl", "wkt", "obj"}
        bounds, region, max_distance, tolerance : optional
            See `polygons`. The formats json and csv take none of them.
        digits : int, optional
            The largest number of digits after the decimal point.
        attributes : DataFrame with n rows, or sequence of n mappings, optional
            More members for the circles of json, columns of cells, or properties for the features of GeoJSON. In svg,
            names are tooltips. NaN and other missing values become null, and times become ISO 8601 texts. A geometry
            column is left out.

        Returns
        -------
        bytes
            UTF-8.

        Examples
        --------
        >>> diagram = cv.compute([[0, 0, 1], [10, 0, 1]])
        >>> print(diagram.to_bytes("wkt", bounds=(-5, -5, 15, 5)).decode().splitlines()[0])
        POLYGON ((5 5, -5 5, -5 -5, 5 -5, 5 5))
        """
        choice(format, FORMATS, "format")
        limits = {"bounds": bounds, "region": region, "max_distance": max_distance, "tolerance": tolerance}
        for name, value in limits.items():
            if format in _UNCLIPPED and value is not None:
                raise CircleVoronoiError(f"The format {format} takes no {name}.", "badOption")
        if attributes is not None and format not in _ATTRIBUTED:
            raise CircleVoronoiError(f"The format {format} takes no attributes.", "badOption")
        if bounds is not None and region is not None:
            raise CircleVoronoiError("Give either bounds or region, not both.", "badOption")
        if is_frame(attributes):
            attributes = records_of(attributes)
        rows = [] if attributes is None else items_of(attributes, "attributes")
        if attributes is not None and len(rows) != len(self):
            raise CircleVoronoiError(f"attributes has {len(rows)} items; expected {len(self)}.")
        return _core.write_diagram(
            self._core,
            format,
            None if bounds is None else box(bounds, "bounds"),
            self._clip(None, region),
            _distance(max_distance),
            None if tolerance is None else positive(tolerance, "tolerance"),
            None if digits is None else whole(digits, 0, 2**31 - 1, "digits"),
            [_members(one, row) for row, one in enumerate(rows)],
        )

    def write(self, path: str | PathLike[str], *, format: str | None = None, **options: Any) -> None:
        """Write the diagram to a file, which is replaced only when the text is complete.

        Parameters
        ----------
        path : str or path
        format : str, optional
            A format of `to_bytes`. By default the extension of the file.
        **options
            The other parameters of `to_bytes`.

        Examples
        --------
        >>> cv.compute([[0, 0, 2], [10, 0, 1]]).write("cells.geojson", bounds=(-5, -5, 15, 5))
        """
        target = Path(path)
        text = self.to_bytes(target.suffix[1:].lower() if format is None else format, **options)
        part = target.with_name(f".{target.name}.part")
        try:
            part.write_bytes(text)
            part.replace(target)
        finally:
            part.unlink(missing_ok=True)

    def plot(self, ax: Any = None, *, bounds: Any = None, region: Any = None, **style: Any) -> Any:
        """Draw circles and edges with matplotlib.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            By default a new one.
        bounds, region : optional
            The part to draw: see `areas`.
        **style
            Properties of the edges, such as ``color`` and ``linewidth``.

        Returns
        -------
        matplotlib.axes.Axes

        Examples
        --------
        >>> ax = cv.compute([[0, 0, 2], [10, 0, 1]]).plot(bounds=(-5, -5, 15, 5), color="black")
        >>> ax.figure.savefig("diagram.pdf")
        """
        return _plot.plot(self, ax, bounds, region, style)


class _Editor:
    """An editor, and the newest diagram that it made."""

    def __init__(self, diagram: Diagram) -> None:
        self._core = _core.Editor(diagram.circles, diagram.weights)
        self.newest: _core.Diagram | None = diagram._core
        self.lock = Lock()

    def apply(self, removed: Indices, replaced: Indices, replacements: Floats, inserted: Floats) -> Diagram:
        self._core.apply(removed, replaced, replacements, inserted)
        # Ctrl-C may end the snapshot: then no diagram shows what the editor holds.
        self.newest = None
        newest = self._core.snapshot()
        self.newest = newest
        return Diagram(newest, self._core.ids(), self)


class AreaFit(NamedTuple):
    """The result of `fit_areas`.

    `weights` has the weight of each point, the least one 0. `diagram` is the certified diagram of the points with
    these weights. `areas` are the areas of its cells inside the region, and `error` is the largest relative
    error of an area. `steps` is the number of Newton steps. `tolerance` is the error that was allowed: the option's, or
    more where the last bits of coordinates and weights allow no less.
"""

    weights: Floats
    diagram: Diagram
    areas: Floats
    error: float
    steps: int
    tolerance: float


def compute(
    circles: Any = None,
    y: Any = None,
    r: Any = None,
    *,
    x: Any = None,
    metric: str = "circles",
    weights: bool = False,
    method: str = "auto",
    candidates: str = "dynamic",
    samples: int | None = None,
    resample: bool = False,
    threads: int = 1,
) -> Diagram:
    """Compute the Voronoi diagram of circles.

    The circles may be disjoint, intersecting, tangent, nested, equal, or points, in any position. The same input gives
    the same bits on every platform and with any number of threads. Ctrl-C cancels.

    Parameters
    ----------
    circles : array_like, shape (n, 3), or (n, 2) with `r`, or shape (n,) with `y` and `r`, or a table
        Rows of x, y, r; or points with `r` apart; or x alone. A DataFrame has columns that `x`, `y` and `r` name, by
        default these letters. A GeoDataFrame has points as geometry, and its radii are the column `r`.
    x, y, r : array_like, shape (n,), or a number for `r`; for tables a name of a column
        Without `circles`, the columns of the circles: ``compute(x=x, y=y, r=r)``.
    metric : {"circles", "centers", "power"}
        The distance of a point p from a circle with the center c: |p - c| - r, |p - c|, or |p - c|^2 - r^2, which
        gives the power (Laguerre) diagram.
    weights : bool
        Whether `r` holds weights, which may be negative: the distance is |p - c| - r, or |p - c|^2 - r for "power".
    method : {"auto", "touching-disc", "flip"}
        With "auto" the result is certified, or there is an error.
    candidates, samples, resample
        For "touching-disc": which pairs of circles are tried ("dynamic", "uniform", "all-pairs"), the number of
        samples, and whether to take more samples where the diagram is not certified.
    threads : int
        The number of threads that may work at the same time; 0 means one for each hardware thread.

    Returns
    -------
    Diagram

    Raises
    ------
    CircleVoronoiError
        A number is missing, not finite, too large, or a radius is negative. The message names the row.

    Warns
    -----
    UserWarning
        More than a quarter of the circles are hidden inside others, perhaps because radii have another unit than
        coordinates.

    Examples
    --------
    >>> cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
    <Diagram of 3 circles, 0 hidden, 1 vertices, 3 edges, certified>
    >>> cv.compute(x=[0, 10, 5], y=[0, 0, 8], r=0).vertices.round(3).tolist()
    [[5.0, 2.438, 5.562]]
    """
    core = _core.compute(
        circles_from(circles, x, y, r),
        choice(metric, METRICS, "metric"),
        bool(weights),
        choice(method, METHODS, "method"),
        choice(candidates, CANDIDATES, "candidates"),
        None if samples is None else whole(samples, 0, 1000, "samples"),
        bool(resample),
        whole(threads, 0, 1024, "threads"),
    )
    if core.hidden_warning:
        warnings.warn(core.hidden_warning, stacklevel=2)
    return Diagram(core, crs=getattr(circles, "crs", None) if is_frame(circles) else None)


def fit_areas(
    points: Any,
    areas: Any,
    region: Any,
    *,
    metric: str = "circles",
    shares: bool = False,
    tolerance: float = 1e-9,
    max_steps: int = 500,
    relax: int = 0,
    weights: Any = 0.0,
) -> AreaFit:
    """Find weights for which the cell of each point has a given area inside a region.

    Parameters
    ----------
    points : array_like, shape (n, 2)
    areas : array_like, shape (n,), or "equal"
        Positive areas that sum to that of the region.
    region
        See `Region`.
    metric : {"circles", "power"}
        The distance of a point p from a site c: |p - c| less the weight, or |p - c|^2 less the weight, for cells with
        straight borders.
    shares : bool
        Whether `areas` are shares: they are multiplied so that they sum to the area of the region.
    tolerance : float
        The largest relative error of an area. A larger one remains only where the last bits of coordinates and weights
        allow no less; the result has the tolerance that was allowed.
    max_steps : int
        The largest number of Newton steps.
    relax : int
        How often all points move to the centers of mass of their cells, which makes cells rounder.
    weights : array_like, shape (n,)
        The weights to start from.

    Returns
    -------
    AreaFit

    Raises
    ------
    CircleVoronoiError
        An area is not positive, the areas do not fit the region, two points are equal, or the fit does not converge.

    Examples
    --------
    >>> square = [[(0, 0), (4, 0), (4, 4), (0, 4)]]
    >>> fit = cv.fit_areas([[1, 1], [3, 1], [2, 3]], [1, 1, 2], square, shares=True)
    >>> fit.areas.round(6).tolist()
    [4.0, 4.0, 8.0]
    """
    clip = region_of(None, region)
    if clip is None:
        raise CircleVoronoiError("fit_areas needs a region.", "badOption")
    options = fit_options(areas, metric, shares, tolerance, max_steps, relax)
    found = _core.fit_areas(*fit_arguments(points, areas, weights), clip, options)
    return AreaFit(found[0], Diagram(found[1]), *found[2:])


def fit_arguments(points: Any, areas: Any, weights: Any) -> tuple[Floats, Floats]:
    """Return the sites with the weights to start from, and the areas."""
    sites = finite_points(points, "points")
    if isinstance(areas, str):
        choice(areas, ("equal",), "areas")
        areas = np.ones(len(sites))
    return np.column_stack([sites, column(weights, len(sites), "weights")]), column(areas, len(sites), "areas")


def fit_options(
    areas: Any, metric: str, shares: bool, tolerance: float, max_steps: int, relax: int
) -> tuple[str, bool, float, int, int]:
    """Return the options of a fit. Equal areas are shares."""
    return (
        choice(metric, FIT_METRICS, "metric"),
        bool(shares) or isinstance(areas, str),
        positive(tolerance, "tolerance"),
        whole(max_steps, 1, 2**31 - 1, "max_steps"),
        whole(relax, 0, 2**31 - 1, "relax"),
    )


def read(
    path: str | PathLike[str],
    *,
    x: str | None = None,
    y: str | None = None,
    radius: str | None = None,
    weights: bool = False,
    points: bool = False,
    skip_invalid: bool = False,
) -> Diagram | Floats:
    """Read circles or a diagram from a file of any format that the program reads.

    Parameters
    ----------
    path : str or path
        A table (CSV), JSON, GeoJSON points, or a diagram in the project's JSON format.
    x, y, radius : str, optional
        The columns, properties or members with the numbers of a circle. Columns are also called #1, #2 and so on. By
        default their usual names: lon, easting, rad and so on.
    weights : bool
        Whether radii may be negative.
    points : bool
        Whether all radii are 0, so that no column is needed for them.
    skip_invalid : bool
        Whether rows and features that are no circles are skipped. A warning tells their number.

    Returns
    -------
    Diagram or ndarray of float64, shape (n, 3)
        A diagram is judged again: see `Diagram.certified`.

    Raises
    ------
    CircleVoronoiError
        The text is not valid; the message names the line.

    Examples
    --------
    >>> with open("shops.csv", "w") as file:
    ...     _ = file.write("name,east,north,pull\\nCenter,2,1.5,0.4\\nNorth,2.5,3.6,0\\n")
    >>> cv.read("shops.csv", x="east", y="north", radius="pull")
    array([[2. , 1.5, 0.4],
           [2.5, 3.6, 0. ]])
    """
    columns = _columns(x, y, radius, weights, points, skip_invalid)
    text = Path(path).read_bytes()
    if _core.holds_diagram(text):
        if any(columns):
            raise CircleVoronoiError(f"{path} holds a diagram, which takes no options about columns.", "badOption")
        return Diagram(_core.read_diagram(text, str(path)))
    circles, reasons = _core.read_circles(text, str(path), columns)
    if reasons:
        count = len(circles) + len(reasons)
        warnings.warn(f"{len(reasons)} of {count} rows were skipped; the first: {reasons[0]}", stacklevel=2)
    return circles


def read_attributes(
    path: str | PathLike[str],
    *,
    x: str | None = None,
    y: str | None = None,
    radius: str | None = None,
    weights: bool = False,
    points: bool = False,
    skip_invalid: bool = False,
) -> list[dict[str, Any]]:
    """Read what a file says about each circle beyond x, y and r, for `Diagram.to_bytes`.

    Parameters
    ----------
    path : str or path
        A file of circles.
    x, y, radius, weights, points, skip_invalid
        See `read`. With the same options, there is an entry for each circle that `read` returns.

    Returns
    -------
    list of dict, one for each circle

    Examples
    --------
    >>> with open("shops.csv", "w") as file:
    ...     _ = file.write("name,x,y,r\\nCenter,2,1.5,0.4\\nNorth,2.5,3.6,0\\n")
    >>> cv.read_attributes("shops.csv")
    [{'name': 'Center'}, {'name': 'North'}]
    """
    columns = _columns(x, y, radius, weights, points, skip_invalid)
    members = _core.read_attributes(Path(path).read_bytes(), str(path), columns)
    try:
        return [json.loads("{" + text + "}") for text in members]
    except RecursionError as error:
        raise CircleVoronoiError(f"{path}: the attributes of a circle are nested too deep.") from error


def _columns(
    x: str | None, y: str | None, radius: str | None, weights: bool, points: bool, skip_invalid: bool
) -> tuple[str, str, str, bool, bool, bool]:
    for name, value in (("x", x), ("y", y), ("radius", radius)):
        if value is not None and not isinstance(value, str):
            raise CircleVoronoiError(f"{name} must be the name of a column (got {value!r}).", "badOption")
    if points and (radius is not None or weights):
        raise CircleVoronoiError("Points have no radii; give neither radius nor weights.", "badOption")
    return x or "", y or "", radius or "", bool(weights), bool(points), bool(skip_invalid)


def circles_from(circles: Any, x: Any, y: Any, r: Any) -> Floats:
    """Return the circles of the arguments of `compute`."""
    return circles_of(circles, x, y, r) if is_frame(circles) else rows_from(circles, x, y, r, _XYR, "compute")


def _members(attributes: Any, row: int) -> str:
    """Return the attributes of a circle as members of a JSON object."""
    try:
        return json_object(mapping(attributes, f"Row {row} of attributes"))[1:-1]
    except (TypeError, ValueError, RecursionError) as error:
        if isinstance(error, CircleVoronoiError):
            raise
        raise CircleVoronoiError(f"Row {row} of attributes is no JSON: {error}.", circle=row) from error


def _distance(value: Any) -> float | None:
    return optional_number(value, "max_distance")


def _unpickled(text: bytes, ids: Indices, crs: Any = None) -> Diagram:
    return Diagram(_core.read_diagram(text, "pickle"), ids, crs=crs)
