// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// An arc of a circle on the convex hull, counter-clockwise from `start` to `end`. A point (radius 0) has an arc, too:
/// it has an angle, but no length.
struct HullArc {
  CircleIndex circle = {};
  double r = 0;  ///< the radius of the circle, grown by `hullGrowth`
  Point start;
  Point end;
  double angle = 0;  ///< from 0 to 2 pi
};

/// The convex hull of circles: arcs, each joined to the next by a tangent segment. The last one is joined to the first.
/// The angles add up to 2 pi.
struct Hull {
  std::vector<HullArc> arcs;
  double length = 0;
  double area = 0;
};

/// Returns the amount by which all circles grow before their hull is taken. It is 0 unless a circle on the hull has a
/// negative weight; then the smallest such circle grows to a point. All circles grow by the same amount, so the diagram
/// and the circles on the hull do not change.
[[nodiscard]] CIRCLE_VORONOI_API double hullGrowth(const Diagram& diagram);

/// Returns the convex hull of the circles of a certified diagram, grown by hullGrowth, in the order of `diagram.hull`.
/// The hull of a single circle is that circle: one arc of 2 pi. For Metric::centers and Metric::power it is the hull of
/// the centers.
///
/// Angles, lengths and areas use std::atan2 and std::sin, so their last bit may differ between platforms. The points
/// have the same bits everywhere.
[[nodiscard]] CIRCLE_VORONOI_API Hull convexHull(const Diagram& diagram);

}  // namespace circle_voronoi
