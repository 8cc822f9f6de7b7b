// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/merged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "at.h"
#include "disjoint_sets.h"
#include "near_vertices.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Returns 2^-40 of the numbers from which a vertex was computed. This is 2^13 times the unit roundoff, which allows
/// for the condition of three-touch discs of circles that can be drawn, and it is far too small to be seen.
double roundingError(const Diagram& diagram, VertexIndex v) {
  const Vertex& vertex = diagram.vertices[at(v)];
  double size = std::abs(vertex.x) + std::abs(vertex.y) + std::abs(vertex.r);
  for (const CircleIndex i : diagram.vertexCircles[at(v)]) {
    const Circle& c = diagram.circles[at(i)];
    size = std::max(size, std::abs(c.x) + std::abs(c.y) + std::abs(c.r));
  }
  return 0x1p-40 * size;
}

/// Whether an edge between vertices is of length near zero.
bool isShortEdge(const Diagram& diagram, const Edge& edge, std::optional<double> nearZero) {
  if (edge.start == kNone || edge.end == kNone) return false;
  const Vertex& s = diagram.vertices[at(edge.start)];
  const Vertex& t = diagram.vertices[at(edge.end)];
  const double limit = nearZero ? *nearZero : roundingError(diagram, edge.start) + roundingError(diagram, edge.end);
  return !(lengthOf({t.x - s.x, t.y - s.y}) > limit);
}

}  // namespace

std::vector<std::int32_t> firstVerticesHere(const Diagram& diagram, const Chosen& edges, const Chosen& vertices) {
  DisjointSets sets(vertices.size());
  for (std::size_t row = 0; row < edges.size(); ++row) {
    const Edge& edge = diagram.edges[at(edges[row])];
    if (isShortEdge(diagram, edge, std::nullopt)) sets.join(vertices.rowOf(edge.start), vertices.rowOf(edge.end));
  }
  return std::move(sets).representatives();
}

std::vector<std::int32_t> firstVerticesHere(const Diagram& diagram) {
  return firstVerticesHere(diagram, Chosen(diagram.edges.size()), Chosen(diagram.vertices.size()));
}

MergedDiagram mergeVertices(const Diagram& diagram, std::optional<double> nearZero) {
  const std::size_t count = diagram.vertices.size();
  DisjointSets sets(count);
  std::vector<bool> isShort(diagram.edges.size(), false);
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Edge& edge = diagram.edges[e];
    if (!isShortEdge(diagram, edge, nearZero)) continue;
    isShort[e] = true;
    sets.join(edge.start, edge.end);
  }

  MergedDiagram merged;
  merged.mergedVertex.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const std::int32_t root = sets.find(static_cast<std::int32_t>(v));
    if (root == static_cast<std::int32_t>(v)) {
      merged.mergedVertex[v] = static_cast<std::int32_t>(merged.vertices.size());
      merged.vertices.push_back(diagram.vertices[v]);
    } else {
      merged.mergedVertex[v] = merged.mergedVertex[at(root)];
    }
  }

  // Clockwise around a merged vertex: beyond a long side that leaves it lies a cell, of which the next long side leaves
  // it too.
  std::vector<bool> isMet(2 * diagram.edges.size(), false);
  std::vector<std::vector<CircleIndex>> around(merged.vertices.size());
  for (std::size_t v = 0; v < count; ++v) {
    auto& list = around[at(merged.mergedVertex[v])];
    for (const SideIndex start : diagram.links.vertexSides[v]) {
      for (SideIndex side = start; !isShort[at(Diagram::edgeOf(side))] && !isMet[at(side)];) {
        isMet[at(side)] = true;
        list.push_back(diagram.circleOf(side));
        side = Diagram::twin(side);
        do side = diagram.links.nextSide[at(side)];
        while (isShort[at(Diagram::edgeOf(side))]);
      }
    }
  }
  merged.firstCircle.push_back(0);
  for (auto& list : around) {
    std::reverse(list.begin(), list.end());
    std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
    merged.circles.insert(merged.circles.end(), list.begin(), list.end());
    merged.firstCircle.push_back(static_cast<std::int32_t>(merged.circles.size()));
  }
  const auto mergedEnd = [&](VertexIndex vertex) { return vertex == kNone ? vertex : merged.mergedVertex[at(vertex)]; };
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Edge& edge = diagram.edges[e];
    if (!isShort[e]) merged.edges.push_back({edge.left, edge.right, mergedEnd(edge.start), mergedEnd(edge.end)});
  }
  return merged;
}

}  // namespace circle_voronoi
