# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges clips in JSON lines (tests/cpp/print_clips.cpp) with GEOS: each polygon is valid, polygons do not overlap, and
their union is the region. Prints each fault and how many clips of each family there were."""
import json
import sys
from collections import Counter

from shapely.geometry import Polygon
from shapely.ops import unary_union
from shapely.validation import explain_validity

# Allowance for rounding, relative to the square of the extent.
ROUNDING = 1e-11

clips = Counter()
faults = 0


def fault_of(clip):
    region = unary_union([Polygon(rings[0], rings[1:]) for rings in clip["region"]])
    west, south, east, north = region.bounds
    rounding = ROUNDING * max(east - west, north - south) ** 2
    polygons = [(i, Polygon(rings[0], rings[1:])) for i, cell in enumerate(clip["cells"]) for rings in cell]
    for i, polygon in polygons:
        if not polygon.is_valid:
            return f"cell {i}: {explain_validity(polygon)}"
    if abs(sum(polygon.area for _, polygon in polygons) - region.area) > rounding:
        return "polygons overlap or leave gaps"
    if unary_union([polygon for _, polygon in polygons]).symmetric_difference(region).area > rounding:
        return "the union is not the region"
    return None


for line in sys.stdin:
    its = json.loads(line)
    clips[its["family"]] += 1
    fault = fault_of(its)
    if fault:
        faults += 1
        print(f"{its['family']}, clip {its['clip']}: {fault}")
print(dict(clips))
sys.exit(1 if faults or not clips else 0)
