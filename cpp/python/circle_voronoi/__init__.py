# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams of circles, exact and certified.

    import circle_voronoi as cv

    diagram = cv.compute([[0, 0, 2], [10, 0, 1], [5, 8, 1.5]])
    diagram.areas(bounds=(-5, -5, 15, 15))

The package is a thin layer over the C++ library circle-voronoi. It needs only NumPy. It uses shapely, geopandas and matplotlib if
they are installed.
"""

from . import _core

# Before NumPy, which does not work in subinterpreters either.
if _core.in_subinterpreter():
    raise ImportError("circle_voronoi cannot be imported in a subinterpreter.")

from ._diagram import (
    AreaFit,
    Certificate,
    ClearestPath,
    Diagram,
    EmptyDisc,
    compute,
    fit_areas,
    read,
    read_attributes,
)
from ._errors import CircleVoronoiError
from ._frames import to_geodataframe
from ._periodic import Contacts, PeriodicAreaFit, PeriodicDiagram, compute_periodic, fit_areas_periodic
from ._regions import Region
from ._sphere import EARTH_RADIUS, FarthestPlace, SphereDiagram, compute_sphere
from ._treemap import treemap

__version__ = _core.__version__

__all__ = [
    "AreaFit",
    "Certificate",
    "CircleVoronoiError",
    "ClearestPath",
    "Contacts",
    "Diagram",
    "EARTH_RADIUS",
    "EmptyDisc",
    "FarthestPlace",
    "PeriodicAreaFit",
    "PeriodicDiagram",
    "Region",
    "SphereDiagram",
    "compute",
    "compute_periodic",
    "compute_sphere",
    "fit_areas",
    "fit_areas_periodic",
    "read",
    "read_attributes",
    "to_geodataframe",
    "treemap",
]
