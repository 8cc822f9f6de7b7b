// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arc_measure.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// An arc of a circle, counter-clockwise from `start` to `end`, of a quarter turn at most. The ends and the radius
/// determine the center, which lies to the left of the chord.
struct CircleArc {
  Point start;
  Point end;
  double r = 0;
};

/// The arc that a piece of an outline is, if it is one.
inline CircleArc circleArc(const OutlinePiece& piece) { return {piece.curve.start, piece.curve.end, piece.r}; }

double arcLength(const CircleArc& arc);

/// The region between an arc and its chord, as that of an EdgeCurve.
Moments momentsOverChord(const CircleArc& arc, Point reference, double unit);

/// Returns at least two points that divide an arc evenly and form a polyline within `tolerance` of the arc. A tolerance
/// below 1e-9 of the radius counts as that. The library of files takes it from this one.
CIRCLE_VORONOI_API std::vector<Point> polyline(const CircleArc& arc, double tolerance);

}  // namespace circle_voronoi
