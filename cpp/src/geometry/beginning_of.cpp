// SPDX-License-Identifier: GPL-3.0-or-later
#include "beginning_of.h"

#include <cmath>

#include "circle_voronoi/curve.h"
#include "scale.h"

namespace circle_voronoi {

Vector beginningOf(const Diagram& diagram, SideIndex side) {
  const Circle& c = diagram.circles[static_cast<std::size_t>(diagram.circleOf(side))];
  return beginningOf(diagram, side, {c.x, c.y});
}

Vector beginningOf(const Diagram& diagram, SideIndex side, Point from) {
  const VertexIndex origin = diagram.originOf(side);
  if (origin != kNone) {
    const Vertex& v = diagram.vertices[static_cast<std::size_t>(origin)];
    return {v.x - from.x, v.y - from.y};
  }
  // The limit of point(s) as s goes to 0.
  const Bisector bisector = sideCurve(diagram, side).bisector;
  const double a = std::abs(bisector.a);
  return {-a * bisector.along.x - bisector.b * bisector.across.x,
          -a * bisector.along.y - bisector.b * bisector.across.y};
}

bool isNoLater(Vector reference, Vector v, Vector w) {
  const auto isSecondHalf = [&](Vector u) {
    const double side = turn(reference, u);
    return side < 0 || (side == 0 && facing(reference, u) < 0);
  };
  if (isSecondHalf(v) != isSecondHalf(w)) return isSecondHalf(w);
  return turn(v, w) >= 0;
}

}  // namespace circle_voronoi
