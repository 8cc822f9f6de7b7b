// SPDX-License-Identifier: GPL-3.0-or-later
#include "arc_within.h"
#include "circle_voronoi/cells.h"
#include "disc_loops.h"

namespace circle_voronoi {

Outline outlineWithin(const Diagram& diagram, CircleIndex circle, double maxDistance) {
  const DistanceSigns signs(diagram, maxDistance);
  if (!diagram.hasCell(circle) || !signs.hasDisc(circle)) return {};
  DiscLoops loops(signs, circle);
  const auto sides = diagram.sides(circle);
  const auto isInside = [&](VertexIndex vertex) { return vertex != kNone && signs.beyond(vertex).sign < 0; };
  bool begins = true;
  for (const SideIndex side : sides) {
    if (begins) loops.beginLoop(false, isInside(diagram.originOf(side)));
    begins = false;
    const Edge& edge = diagram.edges[static_cast<std::size_t>(Diagram::edgeOf(side))];
    const EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(side));
    addArcWithin(loops, signs, diagram, side, curve, {edge.start}, {edge.end});
  }
  if (!sides.empty()) loops.endLoop();
  return loops.finish(loops.isRimClear() && !loops.hasLoops() && signs.hasCenter(circle)).outline;
}

}  // namespace circle_voronoi
