# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures in notebooks."""

from __future__ import annotations

import json
import sys
from base64 import b64encode
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._diagram import Diagram

# Larger diagrams are pictures: a notebook keeps the circles of each output.
MAX_LIVE_CIRCLES = 2000
# The custom element in one file. It is part of packages that were built after `npm run build:lib`.
_ELEMENT = Path(__file__).with_name("element.js")

# The first cell that showed a figure, and the run of it that got the script. A script defines the element for all outputs
# of a notebook, so that one output holds it, also after its cell has run again.
_first_cell: Any = None
_last_run: Any = None


def html(diagram: Diagram) -> str:
    """Return a picture; for few circles inside a live figure, which takes its place where pages run scripts."""
    if len(diagram) == 0:
        return f"<p>{escape(repr(diagram))}</p>"
    name = escape(f"Voronoi diagram of {len(diagram)} circles", quote=True)
    # An image, because the styles of an SVG in a page are those of the whole page.
    source = b64encode(diagram.to_bytes("svg")).decode()
    picture = f'<img slot="poster" src="data:image/svg+xml;base64,{source}" alt="{name}" style="width: 100%; max-width: 40rem">'
    if len(diagram) > MAX_LIVE_CIRCLES or diagram.circles[:, 2].min() < 0 or not _ELEMENT.exists():
        return picture
    circles = json.dumps(diagram.circles.tolist())
    return (
        f'<circle-voronoi circles="{circles}" alt="{name}" controls style="width: 100%; max-width: 40rem">'
        f"{picture}</circle-voronoi>{_script() if _needs_script() else ''}"
    )


def _script() -> str:
    # "</script" inside the script would end it.
    text = _ELEMENT.read_text(encoding="utf-8").replace("</script", "<\\/script")
    return f'<script type="module">{text}</script>'


def _needs_script() -> bool:
    """Return whether this output is the first figure of its notebook."""
    global _first_cell, _last_run
    cell, run = _cell()
    if _last_run is not None and (cell is None or cell != _first_cell or run == _last_run):
        return False
    _first_cell, _last_run = cell, run
    return True


def _cell() -> tuple[Any, Any]:
    """Return the id of the current cell, if the notebook tells it, and the number of its run."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    header = getattr(shell, "parent_header", None) or {}
    return header.get("metadata", {}).get("cellId"), getattr(shell, "execution_count", 0)
