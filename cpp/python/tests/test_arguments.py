# SPDX-License-Identifier: GPL-3.0-or-later
from decimal import Decimal

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


@pytest.mark.parametrize(
    "bad, row, words",
    [
        ([[0, 0, 1], [0, np.nan, 1]], 1, "not a finite number"),
        ([[0, 0, 1], [np.inf, 0, 1]], 1, "not a finite number"),
        ([[0, 0, 1], [4, 0, -1]], 1, "negative radius"),
        ([[0, 0, 1], [4, 0]], 1, "2 numbers"),
        ([[0, 0, 1], [4, 0, 1, 2]], 1, "4 numbers"),
        ([[0, 0, 1], [4, "0", 1]], 1, "y is not a real number"),
        (np.array([[0, 0, 1], [4, 0, 1j]]), 0, "not a real number"),
        (np.array([[0, 0, 1], [4, None, 1]], dtype=object), 1, "y is not a real number"),
        (np.ma.array(CIRCLES, mask=[[0] * 3, [0] * 3, [0, 1, 0], [0] * 3]), 2, "masked"),
        ([[0, 0, 1], [2**53 + 1, 0, 1]], 1, "x is 9007199254740993, a whole number that is no double"),
        ([[0, 0, 1], [0, -(2**53) - 1, 1]], 1, "y is -9007199254740993, a whole number that is no double"),
        (CIRCLES[:, :2], None, "shape (4, 2)"),
        (CIRCLES[0], None, "shape (3,)"),
        (CIRCLES[None], None, "shape (1, 4, 3)"),
        ("circles", None, "circles must be an array of numbers"),
        (None, None, "None"),
        (np.array([["2020-01-01"] * 3], dtype="datetime64[D]"), 0, "not a real number"),
    ],
)
def test_a_bad_row_is_one_error_that_names_it(bad, row, words):
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.compute(bad)
    assert caught.value.circle == row
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda d: cv.compute(CIRCLES, method="fast"), "method must be one of auto"),
        (lambda d: cv.compute(CIRCLES, threads=-1), "threads"),
        (lambda d: cv.compute(CIRCLES, threads=True), "threads"),
        (lambda d: cv.compute(CIRCLES, threads=1025), "threads must be a whole number from 0 to 1024 (got 1025)"),
        (lambda d: cv.compute(CIRCLES, candidates="some"), "candidates must be one of dynamic, uniform, all-pairs"),
        (lambda d: cv.compute(CIRCLES, samples=-1), "samples must be a whole number from 0 to 1000 (got -1)"),
        (lambda d: cv.compute(CIRCLES, samples=1001), "samples must be a whole number from 0 to 1000 (got 1001)"),
        (lambda d: cv.compute(CIRCLES, x="x"), "x names a column of a table"),
        (lambda d: cv.compute(CIRCLES[:, 0], CIRCLES[:, 1], CIRCLES[:1, 2]), "r has 1 number; expected 4"),
        (lambda d: cv.compute(CIRCLES[:, :2], r=CIRCLES[:3, 2]), "r has 3 numbers; expected 4"),
        (lambda d: d.neighbors(True), "circle must be a whole number (got True)"),
        (lambda d: d.find([[0, 1], [0, -np.inf]]), "Row 1 of points is not finite"),
        (lambda d: d.polygons(tolerance=np.inf), "tolerance must be a positive number"),
        (lambda d: d.polygons(tolerance=np.nan), "tolerance must be a positive number"),
        (lambda d: d.to_bytes("json", digits=-1), "digits must be a whole number from 0"),
        (lambda d: d.to_bytes("svg", tolerance=0), "tolerance must be a positive number"),
        (lambda d: d.to_bytes("svg", bounds=(0, 0, 1, 1), region=[[0, 0], [1, 0], [0, 1]]), "not both"),
        (lambda d: d.to_bytes("svg", bounds=(0, 0, 1)), "bounds must be four numbers"),
        (lambda d: d.clearest_path([0, np.nan], [1, 1]), "start must be two finite numbers"),
        (lambda d: d.clearest_path([0, 0], [1, 1], tolerance=-1), "tolerance must be a positive number"),
        (lambda d: d.update(remove=[-1]), "remove must be whole numbers from 0"),
        (lambda d: d.update(remove=[0.5]), "remove must be whole numbers from 0"),
        (lambda d: d.update(remove=[2**31]), "remove must be whole numbers from 0"),
        (lambda d: d.update(replace={-1: (0, 0, 1)}), "the ids of replace must be whole numbers from 0"),
        (lambda d: d.update(replace={0: (0, 1)}), "replace has the shape (1, 2)"),
        (lambda d: d.update(insert=[[0, 1]]), "insert has the shape (1, 2)"),
        (lambda d: cv.fit_areas([[0, 0]], [1], None), "fit_areas needs a region"),
        *(
            (lambda d, name=name, value=value: cv.fit_areas([[0, 0]], [1], CIRCLES[:3, :2], **{name: value}), name)
            for name, value in [("tolerance", 0), ("max_steps", 0), ("relax", -1), ("weights", [1, 2])]
        ),
        (lambda d: cv.compute_periodic(CIRCLES, (9, 0), (0, 9), threads=-1), "threads"),
        (lambda d: cv.compute_periodic(CIRCLES, (9, 0), (0, 9)).neighbors(4), "circle must be from 0 to 3 (got 4)"),
        (lambda d: cv.compute_periodic(CIRCLES, (9, 0), (0, 9)).find([[0, np.nan]]), "Row 0 of points is not finite"),
        (lambda d: cv.compute_periodic(CIRCLES, (9, np.inf), (0, 9)), "a must be two finite numbers"),
        (lambda d: cv.compute_periodic(CIRCLES, (9, 0), (0,)), "b must be two finite numbers"),
        (lambda d: cv.compute(CIRCLES[:, 0], CIRCLES[:2, 1], CIRCLES[:, 2]), "y has 2 numbers; expected 4"),
        (lambda d: d.neighbors(4), "circle must be from 0 to 3 (got 4)"),
        (lambda d: d.neighbors(-1), "circle must be from 0 to 3"),
        (lambda d: d.neighbors(1.0), "whole number"),
        (lambda d: d.find([[0, 1], [np.nan, 0]]), "Row 1 of points is not finite"),
        (lambda d: d.find([1, 2]), "shape (2,)"),
        (lambda d: d.areas(bounds=(0, 0, 1)), "bounds must be four numbers"),
        (lambda d: d.areas(bounds=(0, 0, 0, 1)), "box"),
        (lambda d: d.areas(bounds=(0, 0, 1, 1), region=[[0, 0], [1, 0], [0, 1]]), "not both"),
        (lambda d: d.areas(max_distance=np.nan), "distance"),
        (lambda d: d.polygons(tolerance=0), "tolerance must be a positive number"),
        (lambda d: d.polygons(region=[[0, 0], [1, 1], [1, 0], [0, 1]]), "cross"),
        (lambda d: d.polygons(region=7), "region must be"),
        (lambda d: d.to_bytes("pdf"), "format must be one of"),
        (lambda d: d.to_bytes("geojson", attributes=[{}]), "1 items; expected 4"),
        (lambda d: d.clearest_path([0, 0], [1]), "end must be two finite numbers"),
        (lambda d: d.largest_empty_disc(inside=True), "inside needs"),
    ],
)
def test_a_bad_argument_is_one_error(call, words):
    with pytest.raises(cv.CircleVoronoiError) as caught:
        call(cv.compute(CIRCLES))
    assert words in str(caught.value), str(caught.value)


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
