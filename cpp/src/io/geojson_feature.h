// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "circle_voronoi/attributes.h"
#include "valid_polygons.h"
#include "writer.h"

namespace circle_voronoi {

/// Writes the coordinates of a MultiPolygon. Rings are written closed.
void writeMultiPolygon(Writer& out, const std::vector<std::vector<PointRing>>& polygons);

/// Writes a Polygon, a MultiPolygon, or null without polygons. Rings are written closed.
void writeGeometry(Writer& out, const std::vector<std::vector<PointRing>>& polygons);

/// Writes the attributes of a circle from its file, after the properties that `writeGeoJson` writes.
void writeAttributes(Writer& out, const CircleAttributes& attributes, std::size_t circle);

}  // namespace circle_voronoi
