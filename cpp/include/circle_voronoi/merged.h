// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// A diagram with vertices of any degree: vertices joined by edges of length near zero are merged (paper, section 8).
struct MergedDiagram {
  /// The center and signed radius of each merged vertex, taken from its member with the smallest index.
  std::vector<Vertex> vertices;
  /// The circles around merged vertex v are circles[firstCircle[v]] to circles[firstCircle[v + 1] - 1].
  std::vector<std::int32_t> firstCircle;
  /// The circles around each merged vertex, counter-clockwise from the smallest index. A circle recurs if its cell
  /// meets the vertex more than once.
  std::vector<CircleIndex> circles;
  /// The remaining edges, between merged vertices, in the order of the diagram.
  std::vector<Edge> edges;
  /// For each vertex of the diagram its merged vertex.
  std::vector<VertexIndex> mergedVertex;
};

/// Merges the vertices of a certified diagram whose edges are not longer than `nearZero`, in the units of the input. By
/// default the limit is a small multiple of the rounding error of each vertex.
///
/// The circles around each merged vertex do not depend on the order of the input, as long as no edge is about as long
/// as `nearZero`.
///
/// Precondition: the diagram is certified.
[[nodiscard]] CIRCLE_VORONOI_API MergedDiagram mergeVertices(const Diagram& diagram,
                                                             std::optional<double> nearZero = {});

}  // namespace circle_voronoi
