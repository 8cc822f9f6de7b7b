// SPDX-License-Identifier: GPL-3.0-or-later
#include "perturbed_circle.h"

#include "in_circle.h"
#include "vectors.h"

namespace circle_voronoi {

bool isInPerturbedCircle(Point a, Point b, Point c, Point d) {
  if (const int side = inCircle(a, b, c, d); side != 0) return side > 0;
  // The last point decides, because it is lifted most. If it is d, d is outside. If it is a corner, d is inside if it
  // lies on the corner's side of the other two, and only then. No three of four points on a circle are collinear.
  const Point& last = isBefore(a, b) ? b : a;
  const Point& lastOfCorners = isBefore(last, c) ? c : last;
  if (isBefore(lastOfCorners, d)) return false;
  if (&lastOfCorners == &a) return orientation(d, b, c) > 0;
  if (&lastOfCorners == &b) return orientation(a, d, c) > 0;
  return orientation(a, b, d) > 0;
}

}  // namespace circle_voronoi
