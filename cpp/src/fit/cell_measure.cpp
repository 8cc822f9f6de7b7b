// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_measure.h"

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/curve.h"
#include "guarded.h"
#include "spring.h"

namespace circle_voronoi {

CellMeasure measureCells(const Diagram& diagram, const Region& region) {
  const Result<ClippedDiagram> clipped = ClippedDiagram::from(diagram, region);
  if (!clipped) throw Refusal{clipped.error()};
  CellMeasure result;
  result.areas = clipped->areas();
  const ClippedEdges edges = clipped->edges();
  EdgeIndex last = kNone;
  EdgeCurve arc;
  for (std::size_t k = 0; k < edges.edge.size(); ++k) {
    if (edges.edge[k] != last) arc.bisector = edgeCurve(diagram, edges.edge[k]).bisector;
    last = edges.edge[k];
    arc.from = edges.from[k];
    arc.to = edges.to[k];
    const Edge& edge = diagram.edges[static_cast<std::size_t>(last)];
    result.springs.push_back({edge.left, edge.right, stiffness(arc)});
  }
  return result;
}

}  // namespace circle_voronoi
