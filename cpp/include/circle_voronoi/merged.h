// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A diagram with vertices of any degree: vertices joined by edges of length near zero are one (paper, section 8).
struct MergedDiagram {
  /// For each merged vertex its centre and signed radius: those of its member of smallest index.
  std::vector<Vertex> vertices;
  /// The circles of merged vertex v, counter-clockwise around it from the smallest index, are
  /// circles[firstCircle[v]] up to before circles[firstCircle[v + 1]]. A circle recurs if its cell meets the vertex
  /// more than once.
  std::vector<std::int32_t> firstCircle;
  std::vector<CircleIndex> circles;
  /// The edges that remain, in the order of the diagram, between merged vertices.
  std::vector<Edge> edges;
  /// For each vertex of the diagram its merged vertex.
  std::vector<VertexIndex> mergedVertex;
};

/// Merges the vertices of a certified diagram whose edges are not longer than `nearZero`, in the units of the input.
/// A negative `nearZero`, the default, stands for a small multiple of the rounding error of each vertex. The circles
/// around each merged vertex do not depend on the order of the input, up to their names, as long as no edge is about as
/// long as `nearZero`.
///
/// Precondition: `diagram` is certified.
MergedDiagram mergeVertices(const Diagram& diagram, double nearZero = -1);

}  // namespace circle_voronoi
