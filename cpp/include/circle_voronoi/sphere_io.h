// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/attributes.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/sphere.h"

namespace circle_voronoi {

/// The precision of cells that are written, and what is written with them.
struct SphereExportOptions {
  /// The largest distance between the polygons and the true borders (SpherePolygonOptions).
  std::optional<double> tolerance = {};
  /// Cells are cut at this distance from their caps.
  std::optional<double> maxDistance = {};
  /// The largest number of digits that coordinates, areas and perimeters have after the decimal point, from 0. By
  /// default rounding of coordinates uses up at most a tenth of the tolerance, and other numbers have all their digits.
  std::optional<int> digits = {};
  /// Data of the caps beside their own (readCircleFile). It must outlive the call.
  const CircleAttributes* attributes = nullptr;
};

// Lengths and areas are in the unit of the diagram's radius and its square, and angles in degrees. A cap that is hidden
// has no cell. The index of a cap is called circle, as in files of diagrams of the plane.
//
// Errors: badOption if an option is out of range; badInput if attributes do not fit the caps; notWritten if the stream
// fails; tooManyCircles if memory runs out. If the stream throws, its exception passes through.

/// Writes the cells as GeoJSON (RFC 7946), with a feature for each cap. Its geometry is a Polygon, a MultiPolygon if
/// the antimeridian or the maximum distance cuts the cell apart, or null without a cell. The properties are circle, r,
/// area, neighbors, and for hidden caps hiddenBy, as in `writeGeoJson`. The area is that of the true cell, or of its
/// part within the maximum distance.
CIRCLE_VORONOI_API Result<void> writeSphereGeoJson(std::ostream& out, const SphereDiagram& diagram,
                                                   const SphereExportOptions& options = {});

/// Writes the features of `writeSphereGeoJson`, one a line, and nothing else.
CIRCLE_VORONOI_API Result<void> writeSphereGeoJsonLines(std::ostream& out, const SphereDiagram& diagram,
                                                        const SphereExportOptions& options = {});

/// Writes a table with a line for each cap and the columns longitude, latitude, r, area, perimeter, neighbors (indices
/// with spaces between them), hiddenBy, and those of the attributes. `readCircleFile` reads the caps back.
CIRCLE_VORONOI_API Result<void> writeSphereCsv(std::ostream& out, const SphereDiagram& diagram,
                                               const SphereExportOptions& options = {});

/// Writes the diagram as JSON: radius, rounding, caps, hidden, vertices and edges, with indices as in SphereDiagram,
/// and `weights` if radii are weights. All numbers read back to the same bits. Tolerance, maximum distance and digits
/// have no effect.
CIRCLE_VORONOI_API Result<void> writeSphereJson(std::ostream& out, const SphereDiagram& diagram,
                                                const SphereExportOptions& options = {});

}  // namespace circle_voronoi
