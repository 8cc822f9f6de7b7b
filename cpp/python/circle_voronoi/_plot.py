# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    from ._diagram import Diagram

# Curves deviate from the true hyperbolas by this share of the picture's size: less than a pixel on any paper.
_TOLERANCE = 1e-5


def plot(diagram: Diagram, ax: Any, bounds: Any, region: Any, style: dict[str, Any]) -> Any:
    """Draw circles and edges into axes, which are made if there are none."""
    try:
        from matplotlib import pyplot
        from matplotlib.collections import EllipseCollection
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path
    except ImportError:
        raise ImportError("plot needs matplotlib. Install it with your package manager or pip.") from None
    if ax is None:
        _, ax = pyplot.subplots()
    clip = diagram._clip(bounds, region) or _core.region_of_box(diagram.export_box())
    left, bottom, right, top = clip.bounds
    _, curves = _core.edge_curves(diagram._core, clip, _TOLERANCE * max(right - left, top - bottom))
    codes = np.tile([Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4], len(curves))
    edges = Path(curves.reshape(-1, 2), codes if len(codes) > 0 else None)
    ax.add_patch(PathPatch(edges, **{"fill": False, "edgecolor": "tab:blue", "linewidth": 1, **_patch_style(style)}))
    x, y, r = diagram.circles.T
    sizes = 2 * np.maximum(r, 0)
    ax.add_collection(
        EllipseCollection(
            sizes, sizes, np.zeros(len(r)), units="xy", offsets=np.column_stack([x, y]), transOffset=ax.transData,
            facecolor=(0.5, 0.5, 0.5, 0.2), edgecolor="dimgray",
        )
    )
    ax.plot(x[r <= 0], y[r <= 0], ".", color="dimgray", markersize=3)
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    ax.set_aspect("equal")
    return ax


def _patch_style(style: dict[str, Any]) -> dict[str, Any]:
    """Translate properties of a line to properties of a patch, whose `color` would fill it."""
    return {"edgecolor" if name in ("color", "c") else "linewidth" if name == "lw" else name: value for name, value in style.items()}
