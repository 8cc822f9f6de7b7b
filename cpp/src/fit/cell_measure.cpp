// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_measure.h"

#include "circle_voronoi/clipped_diagram.h"
#include "guarded.h"
#include "spring.h"

namespace circle_voronoi {

CellMeasure measureCells(const Diagram& diagram, const Region& region) {
  CellMeasure result;
  const auto clipped = ClippedDiagram::visitingArcs(diagram, region, [&](const Edge& edge, const EdgeCurve& arc) {
    result.springs.push_back({edge.left, edge.right, stiffness(arc)});
  });
  if (!clipped) throw Refusal{clipped.error()};
  result.areas = clipped->areas();
  return result;
}

}  // namespace circle_voronoi
