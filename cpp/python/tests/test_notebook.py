# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures in notebooks: the HTML that Jupyter shows for a diagram."""

import json
import re
import sys
from base64 import b64decode
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest
from conftest import random_circles

import circle_voronoi as cv
from circle_voronoi import _figure


@pytest.fixture(autouse=True)
def kernel(tmp_path, monkeypatch):
    """A new kernel, the notebook that it serves, and a package with the custom element."""
    element = tmp_path / "element.js"
    element.write_text("define('</script>')")
    monkeypatch.setattr(_figure, "_ELEMENT", element)
    monkeypatch.setattr(_figure, "_first_cell", None)
    monkeypatch.setattr(_figure, "_last_run", None)
    shell = SimpleNamespace(parent_header={}, execution_count=0)
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    return shell


def run(kernel, cell, figures=1):
    """The outputs of a cell."""
    kernel.execution_count += 1
    kernel.parent_header = {"metadata": {"cellId": cell} if cell is not None else {}}
    return [cv.compute(random_circles(10, 13))._repr_html_() for _ in range(figures)]


def scripts_of(outputs):
    return [output.count("<script") for output in outputs]


def picture_in(html):
    """The SVG of the image in some HTML."""
    return ElementTree.fromstring(b64decode(re.search(r'src="data:image/svg\+xml;base64,([^"]*)"', html)[1]))


def test_a_live_figure_holds_the_circles_and_a_picture(kernel):
    diagram = cv.compute(random_circles(10, 13))
    html = diagram._repr_html_()
    assert json.loads(re.search(r'circles="([^"]*)"', html)[1]) == diagram.circles.tolist()
    assert picture_in(re.search("<circle-voronoi[^>]*>(.*)</circle-voronoi>", html)[1]).tag.endswith("svg")
    assert html.endswith("</circle-voronoi><script type=\"module\">define('<\\/script>')</script>")


def test_other_figures_are_pictures(kernel):
    for diagram in (
        cv.compute(random_circles(2001, 14)),
        cv.compute([[0, 0, -1], [3, 0, 1]], weights=True),
    ):
        html = diagram._repr_html_()
        assert picture_in(html).tag.endswith("svg") and "<circle-voronoi" not in html and "<script" not in html
    assert "0 circles" in cv.compute([])._repr_html_()
    _figure._ELEMENT.unlink()
    assert run(kernel, "a")[0].startswith("<img ")


def test_a_notebook_has_one_script(kernel):
    outputs = [output for cell in "abc" for output in run(kernel, cell, figures=2)]
    assert scripts_of(outputs) == [1, 0, 0, 0, 0, 0]


def test_the_first_figure_keeps_the_script_when_its_cell_runs_again(kernel):
    assert scripts_of(run(kernel, "a", 2)) == scripts_of(run(kernel, "a", 2)) == [1, 0]
    assert scripts_of(run(kernel, "b")) == [0]
    assert scripts_of(run(kernel, "a")) == [1]


def test_notebooks_that_name_no_cells_have_one_script_for_each_kernel(kernel):
    assert scripts_of([run(kernel, None)[0] for _ in range(3)]) == [1, 0, 0]


def test_programs_without_a_notebook_have_one_script(kernel, monkeypatch):
    monkeypatch.delitem(sys.modules, "IPython")
    assert scripts_of([cv.compute([[0, 0, 1]])._repr_html_() for _ in range(3)]) == [1, 0, 0]
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: None))
    assert scripts_of([cv.compute([[0, 0, 1]])._repr_html_()]) == [0]
