# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pytest
from conftest import random_circles

import circle_voronoi as cv


def test_an_updated_diagram_is_that_of_its_circles():
    first = cv.compute(random_circles(100, 1))
    second = first.update(remove=[3, 50], replace={7: (1, 2, 3)}, insert=[[50, 50, 2], [20, 30, 0]])
    third = second.update(remove=[100], insert=[[50, 51, 2]])
    assert third.certified and len(first) == 100
    assert third.ids.tolist() == [i for i in range(103) if i not in (3, 50, 100)]
    expected = cv.compute(third.circles)
    assert np.array_equal(np.sort(third.vertices, axis=0), np.sort(expected.vertices, axis=0))
    assert third.circles[third.ids.tolist().index(7)].tolist() == [1, 2, 3]


def test_a_bad_edit_changes_nothing_and_is_named():
    diagram = cv.compute(random_circles(10, 2))
    with pytest.raises(cv.CircleVoronoiError) as caught:
        diagram.update(remove=[1], replace={5: (0, 0, 1)}, insert=[[0, 0, -1]])
    assert caught.value.edit == 2
    with pytest.raises(cv.CircleVoronoiError) as caught:
        diagram.update(remove=[10])
    assert (caught.value.code, caught.value.circle) == ("unknownCircle", 10)
    assert diagram.update(insert=[[200, 0, 1]]).ids.tolist() == list(range(11))


def test_only_the_newest_diagram_can_be_updated():
    first = cv.compute(random_circles(10, 3))
    second = first.update(remove=[1])
    with pytest.raises(cv.CircleVoronoiError, match="newest"):
        first.update(remove=[2])
    assert len(second.update(remove=[2])) == 8


def test_after_an_update_that_was_interrupted_the_old_diagram_cannot_be_updated(monkeypatch):
    first = cv.compute(random_circles(10, 4))
    second = first.update(remove=[1])

    class Interrupted:
        def __init__(self, core):
            self.apply, self.ids = core.apply, core.ids

        def snapshot(self):
            raise KeyboardInterrupt

    monkeypatch.setattr(second._editor, "_core", Interrupted(second._editor._core))
    with pytest.raises(KeyboardInterrupt):
        second.update(remove=[2])
    with pytest.raises(cv.CircleVoronoiError, match="newest"):
        second.update(remove=[3])
