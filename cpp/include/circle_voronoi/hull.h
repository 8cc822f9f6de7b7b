// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// An arc of a circle on the convex hull, counter-clockwise from `start` to `end`. A point (radius 0) has an arc too:
/// it turns, but has no length.
struct HullArc {
  CircleIndex circle = {};
  double r = 0;  ///< of its circle, grown as below
  Point start;
  Point end;
  double angle = 0;  ///< from 0 to 2 pi
};

/// The convex hull of circles: arcs, each joined to the next by the tangent segment from its end to the next start, the
/// last to the first. The angles add up to 2 pi.
struct Hull {
  std::vector<HullArc> arcs;
  double length = 0;
  double area = 0;
};

/// By how much circles grow that have a hull: 0, unless weights on the hull are negative, then by the amount that makes
/// the least of them a point. All circles grow alike, so that the diagram, and which circles are on the hull, stay.
double hullGrowth(const Diagram& diagram);

/// The hull of the circles of a certified diagram, grown by hullGrowth, in the order of `diagram.hull`. That of a
/// single circle is the circle: one arc of 2 pi. For Metric::centers and Metric::power it is the hull of the centres.
/// Angles, lengths and areas use std::atan2 and std::sin, whose last bit may differ between platforms; points do not.
Hull convexHull(const Diagram& diagram);

}  // namespace circle_voronoi
