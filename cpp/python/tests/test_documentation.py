# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs each Python block of the documentation, and the type checker."""

import doctest
import inspect
import json
import os
import re
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

import circle_voronoi as cv

LIST_BLOCKS = """
import { blocksRunBy } from './tests/readme/blocks.mjs'
console.log(JSON.stringify(blocksRunBy('cpp/python/tests/test_documentation.py')))
"""
BLOCKS = json.loads(
    subprocess.run(["node", "--input-type=module", "-e", LIST_BLOCKS], cwd=ROOT, capture_output=True, check=True).stdout
)


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block["headings"][-1])
def test_a_block_of_the_page_runs(block, tmp_path):
    code = block["code"]
    for name in ("bronzefilter", "spruces"):
        shutil.copy(ROOT / f"public/data/{name}.csv", tmp_path)
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, "MPLBACKEND": "Agg"}
    )
    assert run.returncode == 0, run.stderr
    printed = re.findall(r"^# prints (.*)$", code, re.MULTILINE)
    assert run.stdout.splitlines() == printed


def test_the_sources_pass_the_type_checker():
    run = subprocess.run(["mypy", "--cache-dir", ROOT / "build/mypy"], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


SHAPELY = "class Polygon: ...\nclass MultiPolygon: ...\n"
CELLS = """
import circle_voronoi as cv
reveal_type(cv.compute([]).polygons())
reveal_type(cv.compute_sphere([]).polygons())
reveal_type(cv.compute_periodic([], (1, 0), (0, 1)).polygons())
"""


def test_type_checkers_know_the_cells(tmp_path):
    (tmp_path / "shapely").mkdir()
    (tmp_path / "shapely/__init__.pyi").write_text("")
    (tmp_path / "shapely/geometry.pyi").write_text(SHAPELY)
    (tmp_path / "cells.py").write_text(CELLS)
    env = {**os.environ, "MYPYPATH": f"{tmp_path}:{ROOT / 'cpp/python'}"}
    run = subprocess.run(["mypy", "--cache-dir", tmp_path, "cells.py"], cwd=tmp_path, env=env, capture_output=True, text=True)
    found = re.findall(r"Revealed type is \"builtins.list\[(.*)\]\"", run.stdout)
    assert found == ["Union[shapely.geometry.Polygon, shapely.geometry.MultiPolygon, None]"] * 3, run.stdout


def test_every_public_name_has_a_docstring():
    for name in cv.__all__:
        item = getattr(cv, name)
        assert item.__doc__, name
        for member, value in vars(item).items() if inspect.isclass(item) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert value.__doc__, f"{name}.{member}"


@pytest.mark.parametrize("name", cv.__all__)
def test_the_examples_of_help_print_what_they_say(name, monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "Agg")
    item = getattr(cv, name)
    output = []
    runner = doctest.DocTestRunner()
    for test in doctest.DocTestFinder().find(item, name, module=False, globs={"cv": cv}):
        runner.run(test, out=output.append)
    assert "".join(output) == ""
    if inspect.isfunction(item):
        assert runner.summarize(verbose=False).attempted > 0
