# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

from decimal import Decimal
from typing import NamedTuple

import numpy as np
import pytest

import circle_voronoi as cv

CIRCLES = np.array([[0, 0, 2], [10, 0, 1], [5, 8, 1.5], [4, 3, 0]])


@pytest.mark.parametrize(
    "same",
    [
        CIRCLES.tolist(),
        [tuple(row) for row in CIRCLES],
        tuple(map(tuple, CIRCLES)),
        (row for row in CIRCLES),
        np.asfortranarray(CIRCLES),
        np.repeat(CIRCLES, 2, axis=0)[::2],
        CIRCLES.astype(np.float32),
        CIRCLES.astype(np.longdouble),
        CIRCLES.astype(object),
        [[Decimal(float(number)) for number in row] for row in CIRCLES],
        np.ma.array(CIRCLES, mask=False),
    ],
    ids=lambda same: type(same).__name__,
)
def test_any_array_of_numbers_gives_the_same_bits(same):
    assert cv.compute(same).vertices.tobytes() == cv.compute(CIRCLES).vertices.tobytes()


def test_read_only_input_is_neither_changed_nor_kept():
    circles = CIRCLES.copy()
    circles.flags.writeable = False
    diagram = cv.compute(circles)
    assert not np.shares_memory(diagram.circles, circles)


def test_columns_and_points_with_radii_give_the_same_bits():
    expected = cv.compute(CIRCLES).vertices.tobytes()
    x, y, r = CIRCLES.T
    assert cv.compute(x, y, r).vertices.tobytes() == expected
    assert cv.compute(x=x, y=y, r=r).vertices.tobytes() == expected
    assert cv.compute(CIRCLES[:, :2], r=r).vertices.tobytes() == expected
    assert cv.compute(CIRCLES[:, :2], r=0).circles[:, 2].tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("none", [[], np.empty((0, 3)), np.empty(0)])
def test_no_circles_have_an_empty_diagram(none):
    diagram = cv.compute(none)
    assert len(diagram) == 0 and diagram.certified
    assert diagram.vertices.shape == (0, 3) and diagram.edges.shape == (0, 4)
    assert diagram.find([[1, 2]]).tolist() == [-1]
    assert diagram.areas().shape == (0,)
    assert diagram.polygons() == []


class Kind:
    """The right value of a kind of arguments, and the wrong ones with the code and the row that each error names."""

    def __init__(self, right, *wrong):
        self.right = right
        self.wrong = [case if isinstance(case, Wrong) else Wrong(case) for case in wrong]


class Wrong(NamedTuple):
    value: object
    code: str = "badInput"
    row: int | None = None


def options(*values):
    return [Wrong(value, "badOption") for value in values]


NAN, INF = np.nan, np.inf
TEXT_AS_Y = [[0, 0, 1], [4, "0", 1]]
MASKED = np.ma.array(CIRCLES, mask=[[0] * 3, [0] * 3, [0, 1, 0], [0] * 3])
CROSSED = [[0, 0], [1, 1], [1, 0], [0, 1]]
NO_INDICES = ["x", [1, 2], {}, 1j, None, True, 1.0, -1, 4, NAN]
KINDS = {
    "rows": Kind(
        CIRCLES,
        *("circles", None, CIRCLES[:, :2], CIRCLES[0], CIRCLES[None], 5),
        *(Wrong(bad, row=1) for bad in ([[0, 0, 1], [4, 0]], [[0, 0, 1], [4, 0, 1, 2]], TEXT_AS_Y)),
        *(Wrong(np.array([[0, 0, 1], [4, None, 1]], dtype=object), row=1), Wrong(MASKED, row=2)),
        *(Wrong([[0, 0, 1], [0, sign * (2**53 + 1), 1]], row=1) for sign in (1, -1)),
        Wrong(np.array([[0, 0, 1], [4, 0, 1j]]), row=0),
        Wrong(np.array([["2020-01-01"] * 3], "datetime64[D]"), row=0),
        *(Wrong([[0, 0, 1], [0, bad, 1]], "nonFinite", 1) for bad in (NAN, INF)),
        Wrong([[0, 0, 1], [4, 0, -1]], "negativeRadius", 1),
        Wrong([[0, 0, 1], [1e29, 0, 1]], "coordinateTooLarge", 1),
    ),
    "points": Kind(
        [[0, 1], [3, 4]],
        *([1, 2], None, 5, "x", [[0, 1, 2]]),
        *(Wrong([[0, 1], [0, bad]], "nonFinite", 1) for bad in (NAN, INF)),
    ),
    "index": Kind(0, *NO_INDICES),
    "point": Kind((1, 1), *([1], 5, None, "xy", [1, 2, 3]), Wrong((0, NAN), "nonFinite"), Wrong((0, INF), "nonFinite")),
    "period a": Kind((9, 0), *([1], None, "xy"), Wrong((9, INF), "nonFinite"), *options((0, 0), (0, 18))),
    "period b": Kind((0, 9), *([1], None, "xy"), Wrong((0, NAN), "nonFinite"), *options((18, 0))),
    "ids": Kind((), [-1], [0.5], [2**31], "x", None, [[1]], [True]),
    "new circles": Kind((), [[0, 1]], "x", None, Wrong([[0, 0, 1], [0, "0", 1]], row=1)),
    "replacements": Kind({}, 5, [1], {-1: (0, 0, 1)}, {0: (0, 1)}, {"0": (0, 0, 1)}),
    "first column": Kind(CIRCLES[:, 0], CIRCLES, "x", None),
    "column": Kind(CIRCLES[:, 2], CIRCLES[:3, 2], CIRCLES, "x"),
    "areas": Kind("equal", [1], [], None, [[1]], *options("x")),
    "starting weights": Kind(0, [1, 2, 3], "x", None),
    "region": Kind(None, 7, *options(CROSSED, [[0, 0], [0, 0], [0, 0]])),
    "needed region": Kind(CIRCLES[:3, :2], 7, *options(None, CROSSED)),
    "bounds": Kind(None, *options((0, 0, 1), 5, "x", (0, 0, 1, "1"), (0, 0, 0, 1), (0, 0, NAN, 1))),
    "distance": Kind(None, *options([1], "x", 1j, NAN)),
    "finite distance": Kind(None, *options([1], "x", 1j, NAN, INF)),
    "tolerance": Kind(0.1, *options([1], "x", 1j, 0, -1, NAN, INF)),
    "unused": Kind(None, *options(1, "x", (0, 0, 9, 9), CIRCLES[:3, :2], [{}] * 4)),
    "metric": Kind("circles", *options("euclidean", 5, None)),
    "metric of a fit": Kind("circles", *options("centers", 5, None)),
    "method": Kind("auto", *options("fast", 5, None)),
    "candidates": Kind("dynamic", *options("some", 5, None)),
    "format": Kind("geojson", *options("pdf", 5, None)),
    "samples": Kind(3, *options("x", -1, 1001, 0.5, True)),
    "threads": Kind(1, *options("x", None, -1, 1025, 0.5, True)),
    "digits": Kind(3, *options("x", -1, 2**31, 0.5, True)),
    "steps": Kind(500, *options("x", None, 0, -1, 0.5, True)),
    "times": Kind(0, *options("x", None, -1, 0.5, True)),
    "attributes": Kind(None, [{}], 5, "abcd", [5] * 4, Wrong([{}, {"a": {1}}, {}, {}], row=1)),
}
KINDS["caps"] = Kind(
    CIRCLES,
    *KINDS["rows"].wrong[:-1],  # any number is a longitude
    Wrong([[0, 0, 1], [0, 91, 0]], "coordinateTooLarge", 1),
    Wrong([[0, 0, 20_020], [0, 0, 1]], "coordinateTooLarge", 0),
)
KINDS["places"] = Kind(*([KINDS["points"].right] + KINDS["points"].wrong), Wrong([[0, 1], [0, -91]], row=1))
LIMITS = {"bounds": "bounds", "region": "region", "max_distance": "distance"}
WITHIN = {"bounds": "bounds", "region": "region", "tolerance": "tolerance"}
FIT = {"metric": "metric of a fit", "tolerance": "tolerance", "max_steps": "steps", "relax": "times", "weights": "starting weights"}
COMPUTE = {"metric": "metric", "method": "method", "candidates": "candidates", "samples": "samples", "threads": "threads"}


def of(name):
    """A call of a method of a diagram."""
    return lambda *args, **more: getattr(cv.compute(CIRCLES), name)(*args, **more)


def to_bytes(format):
    """A call of `to_bytes` with a format."""
    return lambda **more: cv.compute(CIRCLES).to_bytes(format, **more)


def sphere(name):
    return lambda *args, **more: getattr(cv.compute_sphere(CIRCLES), name)(*args, **more)


def periodic(name):
    return lambda *args, **more: getattr(cv.compute_periodic(CIRCLES, (9, 0), (0, 9)), name)(*args, **more)


# Each function with the kinds of its arguments and of its options.
FUNCTIONS = [
    (cv.compute, ["rows"], COMPUTE),
    (lambda r: cv.compute(CIRCLES[:, :2], r=r), ["column"], {}),
    (lambda y, r: cv.compute(CIRCLES[:, 0], y, r), ["column", "column"], {}),
    (lambda x, y: cv.compute(x=x, y=y, r=0), ["first column", "column"], {}),
    (cv.compute_periodic, ["rows", "period a", "period b"], {"metric": "metric", "threads": "threads"}),
    (cv.fit_areas, ["points", "areas", "needed region"], FIT),
    (cv.fit_areas_periodic, ["points", "areas", "period a", "period b"], FIT),
    *((of(name), [], LIMITS) for name in ("areas", "centroids", "perimeters", "neighbor_pairs")),
    (of("neighbors"), ["index"], LIMITS),
    (of("polygons"), [], {**LIMITS, "tolerance": "tolerance"}),
    (of("find"), ["points"], {}),
    (of("largest_empty_disc"), [], {"bounds": "bounds", "region": "region"}),
    (of("clearest_path"), ["point", "point"], WITHIN),
    (of("update"), [], {"remove": "ids", "replace": "replacements", "insert": "new circles"}),
    (of("to_bytes"), ["format"], {**LIMITS, "tolerance": "tolerance", "digits": "digits", "attributes": "attributes"}),
    *((to_bytes(name), [], dict.fromkeys((*LIMITS, "tolerance"), "unused")) for name in ("json", "csv")),
    *((to_bytes(name), [], {"attributes": "unused"}) for name in ("csv", "wkt", "obj")),
    (periodic("neighbors"), ["index"], {}),
    (periodic("find"), ["points"], {}),
    (periodic("polygons"), [], {"tolerance": "tolerance"}),
    (cv.compute_sphere, ["caps"], {"radius": "tolerance", "threads": "threads", "lon": "unused"}),
    (lambda r: cv.compute_sphere(CIRCLES[:, :2], r=r), ["column"], {}),
    (lambda lat, r: cv.compute_sphere(CIRCLES[:, 0], lat, r), ["column", "column"], {}),
    (sphere("neighbors"), ["index"], {}),
    (sphere("find"), ["places"], {}),
    *((sphere(name), [], {"max_distance": "finite distance"}) for name in ("areas", "perimeters")),
    (sphere("polygons"), [], {"tolerance": "tolerance", "max_distance": "finite distance"}),
]


@pytest.mark.parametrize("call, kinds, options", FUNCTIONS)
def test_each_wrong_argument_is_an_error_with_its_code_and_row(call, kinds, options):
    right = [KINDS[kind].right for kind in kinds]
    call(*right)
    calls = []
    for k, kind in enumerate(kinds):
        calls += [(wrong, [*right[:k], wrong.value, *right[k + 1 :]], {}) for wrong in KINDS[kind].wrong]
    calls += [(wrong, right, {name: wrong.value}) for name, kind in options.items() for wrong in KINDS[kind].wrong]
    if "bounds" in options:
        calls.append((Wrong("both", "badOption"), right, {"bounds": (0, 0, 1, 1), "region": CIRCLES[:3, :2]}))
    problems = []
    for wrong, args, more in calls:
        try:
            problem = f"no error but {call(*args, **more)!r}"
        except cv.CircleVoronoiError as error:
            problem = None if (error.code, error.circle) == wrong[1:] else f"{error.code} {error.circle} {error}"
        if problem is not None:
            problems.append((wrong, list(more), problem))
    assert problems == []
    with pytest.raises(TypeError):
        call(*right, foo=1)


def test_an_error_is_a_value_error_with_a_code_and_survives_pickling():
    import pickle

    with pytest.raises(ValueError) as caught:
        cv.compute([[0, 0, -1]])
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (str(copy), copy.code, copy.circle, copy.edit) == (str(caught.value), "negativeRadius", 0, None)
    with pytest.raises(ValueError) as caught:
        cv.compute(CIRCLES).update(remove=[1], insert=[[0, 0, -1]])
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (str(copy), copy.code, copy.edit) == (str(caught.value), "negativeRadius", 1)


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda d: cv.compute(CIRCLES, method="fast"), "method must be one of auto, touching-disc, flip (got 'fast')."),
        (lambda d: cv.compute(CIRCLES, threads=1025), "threads must be a whole number from 0 to 1024 (got 1025)."),
        (lambda d: cv.compute(CIRCLES, x="x"), "x names a column of a table"),
        (lambda d: cv.compute(), "circles must be an array of numbers (got None)."),
        (lambda d: cv.compute(x=[1, 2]), "x needs y, an array of the same length."),
        (lambda d: cv.compute(x=[1, 2], y=[1, 2], r=[1]), "r has 1 number; expected 2."),
        (lambda d: cv.compute_sphere(lon=[1, 2]), "lon needs lat, an array of the same length."),
        (lambda d: cv.compute(CIRCLES[:, :2], r=CIRCLES[:1, 2]), "r has 1 number; expected 4."),
        (lambda d: cv.compute([[0, 0, 1], [4, 0]]), "Row 1 of circles has 2 numbers; expected 3 (x, y, r)."),
        (lambda d: cv.compute(CIRCLES[0]), "circles has the shape (3,); expected (n, 3): x, y, r."),
        (lambda d: cv.compute([[0, 0, 1], [4, "0", 1]]), "Row 1: y is not a real number (got '0')."),
        (lambda d: cv.compute([[2**53 + 1, 0, 1]]), "Row 0: x is 9007199254740993, a whole number that is no double."),
        (lambda d: cv.compute(MASKED), "Row 2 of circles is masked."),
        (lambda d: cv.compute("circles"), "circles must be an array of numbers (got 'circles')."),
        (lambda d: d.neighbors(True), "circle must be a whole number (got True)."),
        (lambda d: d.neighbors(4), "circle must be from 0 to 3 (got 4)."),
        (lambda d: d.find([[0, 1], [0, -np.inf]]), "Row 1 of points is not finite: (0.0, -inf)."),
        (lambda d: d.polygons(tolerance=0), "tolerance must be a positive number (got 0)."),
        (lambda d: d.areas(bounds=(0, 0, 1)), "bounds must be four numbers: least x and y, largest x and y (got "),
        (lambda d: d.areas(max_distance="x"), "max_distance must be a number (got 'x')."),
        (lambda d: d.to_bytes("json", bounds=(0, 0, 1, 1)), "The format json takes no bounds."),
        (lambda d: d.to_bytes("obj", attributes=[{}] * 4), "The format obj takes no attributes."),
        (lambda d: d.areas(bounds=(0, 0, 1, 1), region=CROSSED), "Give either bounds or region, not both."),
        (lambda d: d.areas(region=7), "region must be"),
        (lambda d: d.areas(region="town.wkt"), "region is neither a file nor GeoJSON nor well-known text (got 'town.wkt')."),
        (lambda d: d.areas(region=CROSSED), "cross"),
        (lambda d: d.update(remove=[0.5]), "remove must be whole numbers from 0."),
        (lambda d: d.update(replace={-1: (0, 0, 1)}), "the ids of replace must be whole numbers from 0."),
        (lambda d: d.to_bytes("geojson", attributes=[{}]), "attributes has 1 items; expected 4."),
        (lambda d: d.clearest_path([0, 0], [1]), "end must be two finite numbers, x and y (got [1])."),
        (lambda d: d.largest_empty_disc(inside=True), "inside needs"),
        (lambda d: cv.fit_areas([[0, 0]], [1], None), "fit_areas needs a region."),
    ],
)
def test_a_sentence_says_what_is_wrong(call, sentence):
    with pytest.raises(cv.CircleVoronoiError) as caught:
        call(cv.compute(CIRCLES))
    assert sentence in str(caught.value)
