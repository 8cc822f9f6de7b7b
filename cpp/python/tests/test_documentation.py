# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs each Python block of the documentation, and the type checker."""

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
    run = subprocess.run(["mypy", "--cache-dir", ROOT / "build/mypy"], cwd=ROOT / "cpp/python", capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


def test_every_public_name_has_a_docstring():
    for name in cv.__all__:
        item = getattr(cv, name)
        assert item.__doc__, name
        for member, value in vars(item).items() if inspect.isclass(item) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert value.__doc__, f"{name}.{member}"
