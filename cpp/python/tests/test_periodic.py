# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pandas
import pytest
from conftest import random_circles

import circle_voronoi as cv


def test_cells_fill_the_box_and_neighbors_are_mutual():
    a, b = (100, 0), (30, 90)
    periodic = cv.compute_periodic(random_circles(40, 1), a, b)
    assert len(periodic) == 40 and periodic.images.certified
    assert periodic.areas().sum() == pytest.approx(9000, rel=1e-12)
    borders = set()
    for i in range(40):
        for j, (s, t) in zip(*map(np.ndarray.tolist, periodic.neighbors(i))):
            borders.add((i, j, s, t))
    assert borders == {(j, i, -s, -t) for i, j, s, t in borders}


def test_power_cells_fill_the_box_and_have_given_areas():
    a, b = (100, 0), (30, 90)
    periodic = cv.compute_periodic(random_circles(40, 1), a, b, metric="power")
    assert periodic.images.metric == "power" and periodic.images.certified
    assert periodic.areas().sum() == pytest.approx(9000, rel=1e-12)
    fit = cv.fit_areas_periodic(random_circles(12, 2)[:, :2], "equal", a, b, metric="power")
    assert fit.periodic.areas() == pytest.approx(750, rel=1e-8)


def test_the_contact_table_agrees_with_the_neighbors():
    periodic = cv.compute_periodic(random_circles(30, 2), (100, 0), (0, 100))
    contacts = periodic.contacts()
    assert contacts.area == pytest.approx(periodic.areas(), rel=1e-12)
    for i in range(30):
        rows = contacts.circle == i
        circles, shifts = periodic.neighbors(i)
        assert {(j, *s) for j, s in zip(contacts.neighbor[rows].tolist(), contacts.shift[rows].tolist())} == {
            (j, *s) for j, s in zip(circles.tolist(), shifts.tolist())
        }
        assert contacts.length[rows].sum() == pytest.approx(periodic.perimeters()[i])
    images = periodic.circles[contacts.neighbor, :2] + contacts.shift @ periodic.periods
    distance = np.hypot(*(periodic.circles[contacts.circle, :2] - images).T)
    radii = periodic.circles[contacts.circle, 2] + periodic.circles[contacts.neighbor, 2]
    assert contacts.gap == pytest.approx(distance - radii, abs=1e-9)


def test_contacts_are_a_table():
    contacts = cv.compute_periodic(random_circles(30, 2), (100, 0), (0, 100)).contacts()
    table = contacts.to_dataframe()
    assert table.shape == (len(contacts.circle), 6)
    assert table[["shift_a", "shift_b"]].to_numpy().tolist() == contacts.shift.tolist()
    for name in ("circle", "neighbor", "length", "gap"):
        assert table[name].tolist() == getattr(contacts, name).tolist()


def test_points_and_tables_repeat_too():
    circles = random_circles(30, 4)
    box = ((100, 0), (0, 100))
    table = pandas.DataFrame(circles, columns=["east", "north", "size"])
    expected = cv.compute_periodic(circles, *box).images.vertices.tobytes()
    assert cv.compute_periodic(table, *box, x="east", y="north", r="size").images.vertices.tobytes() == expected
    assert cv.compute_periodic(circles[:, :2], *box, r=circles[:, 2]).images.vertices.tobytes() == expected


def test_find_wraps():
    periodic = cv.compute_periodic([[10, 10, 1], [60, 60, 2]], (100, 0), (0, 100))
    circles, shifts = periodic.find([[11, 9], [-39, 62], [1010, -990]])
    assert circles.tolist() == [0, 1, 0] and shifts.tolist() == [[0, 0], [-1, 0], [10, -10]]


def test_circles_come_first_among_their_images():
    given = random_circles(20, 3)
    periodic = cv.compute_periodic(given - [0, 0, 5], (100, 0), (30, 90), weights=True)
    plain = cv.compute_periodic(given, (100, 0), (30, 90), threads=2)
    assert plain.circles == pytest.approx(given, abs=1e-12)
    assert repr(plain) == "<PeriodicDiagram of 20 circles, periods (100.0, 0.0) and (30.0, 90.0)>"
    for measure in ("areas", "centroids", "perimeters"):
        values = getattr(plain, measure)()
        assert len(values) == 20
        assert values == pytest.approx(getattr(periodic, measure)(), rel=1e-9, nan_ok=True)
        assert values == pytest.approx(getattr(plain.images, measure)()[:20], nan_ok=True)
    assert plain.image_circles[:20].tolist() == list(range(20)) and not plain.image_shifts[:20].any()
    images = plain.circles[plain.image_circles, :2] + plain.image_shifts @ plain.periods
    assert images == pytest.approx(plain.images.circles[:, :2])
    cells = plain.polygons(tolerance=1e-4)
    assert [0 if cell is None else cell.area for cell in cells] == pytest.approx(plain.areas(), abs=0.05)
    fractions = plain.contacts().packing_fraction
    assert fractions.shape == (20,) and ((fractions >= 0) & (fractions <= 1)).all()
    with pytest.raises(cv.CircleVoronoiError):
        cv.compute_periodic(given - [0, 0, 5], (100, 0), (30, 90))


def test_one_circle_is_its_own_neighbor():
    periodic = cv.compute_periodic([[3, 4, 1]], (10, 0), (0, 10))
    circles, shifts = periodic.neighbors(0)
    assert set(circles.tolist()) == {0} and (1, 0) in map(tuple, shifts.tolist())
    assert periodic.areas() == pytest.approx([100])


@pytest.mark.parametrize("a, b", [((1, 0), (2, 0)), ((0, 0), (1, 1)), ((np.inf, 0), (0, 1)), ((1, 2, 3), (0, 1))])
def test_periods_that_span_no_box_are_one_error(a, b):
    with pytest.raises(cv.CircleVoronoiError):
        cv.compute_periodic([[0, 0, 1]], a, b)


@pytest.mark.parametrize("count", [1, 2, 3, 40])
def test_areas_in_a_box_are_those_of_its_periodic_diagram(count):
    points = np.random.default_rng(count).random((count, 2)) * 3
    areas = np.arange(1, count + 1)
    fit = cv.fit_areas_periodic(points, areas, [3, 0], [1, 2], shares=True)
    circles = np.column_stack([points, fit.weights])
    assert cv.compute_periodic(circles, [3, 0], [1, 2]).areas() == pytest.approx(6 * areas / areas.sum(), rel=1e-8)
    assert fit.periodic.areas() == pytest.approx(fit.areas)
    assert fit.weights.min() == 0 and fit.error < 1e-8
    equal = cv.fit_areas_periodic(points, "equal", [3, 0], [1, 2], relax=3)
    assert equal.areas == pytest.approx(6 / count, rel=1e-8)


@pytest.mark.parametrize(
    "points, areas, b, words",
    [
        ([[0, 0], [4, 2]], [3, 3], [1, 2], "the same position as an image of site 0"),
        ([[0, 0], [1, 1]], [3, 4], [1, 2], "the area of the box is 6"),
        ([[0, 0], [1, 1]], [3, 3], [6, 0], "parallel"),
        ([[0, 0], [1, 1]], [3], [1, 2], "expected 2"),
    ],
)
def test_areas_that_a_box_cannot_have_are_one_error(points, areas, b, words):
    with pytest.raises(cv.CircleVoronoiError, match=words):
        cv.fit_areas_periodic(points, areas, [3, 0], b)
