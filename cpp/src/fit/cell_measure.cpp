// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_measure.h"

#include "areas_and_arcs.h"
#include "circle_voronoi/clipped_diagram.h"
#include "guarded.h"
#include "spring.h"

namespace circle_voronoi {

CellMeasure measureCells(const Diagram& diagram, const Region& region) {
  const Result<ClippedDiagram> clipped = ClippedDiagram::from(diagram, region);
  if (!clipped) throw Refusal{clipped.error()};
  CellMeasure result;
  result.areas = areasAndArcs(*clipped, [&](const Edge& edge, const EdgeCurve& arc) {
    result.springs.push_back({edge.left, edge.right, stiffness(arc)});
  });
  return result;
}

}  // namespace circle_voronoi
