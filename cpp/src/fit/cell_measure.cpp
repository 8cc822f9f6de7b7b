// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_measure.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/curve.h"
#include "clip_parts.h"
#include "guarded.h"
#include "spring.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// The spring of an edge between two circles, or an image of one, along a part of its curve.
Spring springOf(const Diagram& diagram, const Edge& edge, const EdgeCurve& arc) {
  const auto circle = [&](CircleIndex i) { return diagram.circles[static_cast<std::size_t>(i)]; };
  const double apart = length(between(circle(edge.left), circle(edge.right)));
  const double stiff = diagram.metric == Metric::power ? stiffnessOfPowers(arc, apart) : stiffness(arc);
  return {edge.left, edge.right, stiff, apart};
}

}  // namespace

CellMeasure measureCells(const Diagram& diagram, const Region& region) {
  CellMeasure result;
  const auto clipped = ClipParts::clip(diagram, region, {}, {}, [&](const Edge& edge, const EdgeCurve& arc) {
    result.springs.push_back(springOf(diagram, edge, arc));
  });
  if (!clipped) throw ThrownError{clipped.error()};
  result.areas = clipped->areas();
  return result;
}

CellMeasure measureCells(const PeriodicDiagram& periodic) {
  const Diagram& diagram = periodic.diagram;
  CellMeasure result;
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) result.areas.push_back(area(outline(diagram, i)));
  const auto given = [&](CircleIndex i) { return periodic.circleOf[static_cast<std::size_t>(i)]; };
  for (std::size_t k = 0; k < diagram.edges.size(); ++k) {
    const Edge& edge = diagram.edges[k];
    const CircleIndex i = std::min(edge.left, edge.right);
    const CircleIndex j = std::max(edge.left, edge.right);
    // A border with an image has a twin, seen from the other circle.
    const bool isCounted = j < periodic.circleCount || (i < periodic.circleCount && i < given(j));
    if (!isCounted) continue;
    Spring spring = springOf(diagram, edge, edgeCurve(diagram, static_cast<std::int32_t>(k)));
    spring.left = i;
    spring.right = given(j);
    result.springs.push_back(spring);
  }
  return result;
}

}  // namespace circle_voronoi
