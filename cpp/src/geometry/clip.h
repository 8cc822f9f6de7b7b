// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/curve.h"
#include "ring.h"

namespace circle_voronoi {

/// A part of a curve inside a region, and the sides of the region, or its circle (ring.h), that cut it off, on which
/// its ends lie then; kNone where it ends with the curve.
struct Part {
  EdgeCurve curve;
  std::int32_t cutFrom = kNone;
  std::int32_t cutTo = kNone;
};

/// The parts of a curve inside a region, in order: bounded.
std::vector<Part> partsInside(const EdgeCurve& curve, const ConvexPolygon& region);

/// The part of a curve whose points are up to a distance from the origin of its bisector, the centre of the smaller
/// circle: bounded, if there is one.
std::optional<Part> partNear(const EdgeCurve& curve, double reach);

/// Where a branch crosses the line through a point along a direction.
class LineCrossing {
 public:
  LineCrossing(const Bisector& bisector, Point p, Vector direction);

  /// The parameters, increasing: none, one or two.
  const std::vector<double>& parameters() const { return parameters_; }

  /// Whether the branch is to the right of the line between two parameters; ends at infinity are 0 and infinity.
  /// Precondition: it does not cross the line between them.
  bool isRight(double from, double to) const;

 private:
  double growth_;
  double half_;
  double decay_;
  std::vector<double> parameters_;
};

}  // namespace circle_voronoi
