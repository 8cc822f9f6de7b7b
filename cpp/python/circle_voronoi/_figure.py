# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures in notebooks."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._diagram import Diagram

# Larger diagrams are pictures: a notebook keeps the circles of each output.
MAX_LIVE_CIRCLES = 2000
# The custom element in one file. It is part of packages that were built after `npm run build:lib`.
_ELEMENT = Path(__file__).with_name("element.js")


def html(diagram: Diagram) -> str:
    """Return a live figure, or a picture if there are many circles, negative radii, or no element in this package."""
    if len(diagram) == 0:
        return f"<p>{escape(repr(diagram))}</p>"
    if len(diagram) > MAX_LIVE_CIRCLES or diagram.circles[:, 2].min() < 0 or not _ELEMENT.exists():
        return f'<div style="max-width: 40rem">{diagram.to_bytes("svg").decode()}</div>'
    circles = json.dumps(diagram.circles.tolist())
    # "</script" inside the script would end it.
    script = _ELEMENT.read_text(encoding="utf-8").replace("</script", "<\\/script")
    name = escape(f"Voronoi diagram of {len(diagram)} circles", quote=True)
    return (
        f'<circle-voronoi circles="{circles}" alt="{name}" controls style="width: 100%; max-width: 40rem"></circle-voronoi>'
        f'<script type="module">{script}</script>'
    )
