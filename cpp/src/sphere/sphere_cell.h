// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/sphere.h"
#include "place.h"

namespace circle_voronoi::sphere {

/// A side of a cell as seen from its center.
struct CellSide {
  SideIndex side = {};
  Border border;
  double amplitude = 0;
  double bearing = 0;  ///< of the other cap, counter-clockwise from the east
  /// The bearings of the ends, less that of the other cap. `from` is from -pi to pi; `to` is mostly larger, by up to a
  /// full turn, and smaller by rounding at most.
  double from = 0;
  double to = 0;

  /// The cotangent of the angle to the border at a bearing, less that of the other cap.
  [[nodiscard]] double cotangentAt(double angle) const { return amplitude * sineCosine(angle).cosine + border.offset; }
};

/// A part of the outline of a cell: of one of its sides, or of the circle at the maximum distance beyond this side.
struct CellPart {
  double from = 0;  ///< bearings as in CellSide
  double to = 0;
  bool isOnCircle = false;
};

/// Returns the sides of a cell, counter-clockwise; none if the cell is the whole sphere or there is none.
std::vector<CellSide> sidesOf(const SphereDiagram& diagram, const Places& places, CircleIndex cap);

/// Returns the parts of a side within an angle from the center, whose cotangent is given, and those of the circle
/// beyond it, in order.
std::vector<CellPart> partsOf(const CellSide& side, std::optional<double> cotangent);

/// The reach of a cell: the angle to which a maximum distance cuts it.
struct Reach {
  std::optional<double> angle;  ///< nothing if it cuts nothing; not positive if it cuts all
  std::optional<double> cotangent() const {
    if (!angle) return std::nullopt;
    const SineCosine arc = sineCosine(*angle);
    return arc.cosine / arc.sine;
  }
};

Reach reachOf(const SphereDiagram& diagram, CircleIndex cap, std::optional<double> maxDistance);

}  // namespace circle_voronoi::sphere
