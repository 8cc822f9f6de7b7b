// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/merged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "near_vertices.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Union-find over indices, the smallest index of a set standing for it.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::int32_t find(std::int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  /// Of each index the one that stands for its set.
  std::vector<std::int32_t> first() && {
    for (std::int32_t& parent : parent_) parent = parent_[parent];  // of a smaller index, and so done before
    return std::move(parent_);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// 2^-40 of the numbers that went into a vertex: some thousand times the unit roundoff, for the condition of
/// three-touch discs of circles that are drawn, and far below what can be seen.
double roundingError(const Vertex& vertex, const std::array<std::int32_t, 3>& triple, std::span<const Circle> circles) {
  double size = std::abs(vertex.x) + std::abs(vertex.y) + std::abs(vertex.radius);
  for (const std::int32_t i : triple) {
    size = std::max(size, std::abs(circles[i].x) + std::abs(circles[i].y) + circles[i].r);
  }
  return 0x1p-40 * size;
}

/// Whether an edge between vertices is of length near zero.
bool isShortEdge(const Edge& edge, std::span<const Circle> circles, const Diagram& diagram, double nearZero) {
  if (edge.start == kNone || edge.end == kNone) return false;
  const Vertex& s = diagram.vertices[edge.start];
  const Vertex& t = diagram.vertices[edge.end];
  const double limit = nearZero >= 0 ? nearZero
                                     : roundingError(s, diagram.vertexCircles[edge.start], circles) +
                                           roundingError(t, diagram.vertexCircles[edge.end], circles);
  return !(lengthOf({t.x - s.x, t.y - s.y}) > limit);
}

}  // namespace

std::vector<std::int32_t> firstVerticesHere(std::span<const Circle> circles, const Diagram& diagram) {
  constexpr double kByRounding = -1;
  Sets sets(diagram.vertices.size());
  for (const Edge& edge : diagram.edges) {
    if (isShortEdge(edge, circles, diagram, kByRounding)) sets.unite(edge.start, edge.end);
  }
  return std::move(sets).first();
}

MergedDiagram mergeVertices(std::span<const Circle> circles, const Diagram& diagram, double nearZero) {
  const std::size_t count = diagram.vertices.size();
  // Of each corner (vertex, circle) the edge that leaves the vertex with that circle on its right: walking such edges
  // from corner to corner goes around a merged vertex.
  std::vector<std::array<std::int32_t, 3>> edgeAt(count, {kNone, kNone, kNone});
  const auto cornerOf = [&](std::int32_t vertex, std::int32_t circle) {
    const auto& triple = diagram.vertexCircles[vertex];
    return static_cast<std::size_t>(std::find(triple.begin(), triple.end(), circle) - triple.begin());
  };
  Sets sets(count);
  std::vector<bool> isShort(diagram.edges.size(), false);
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Edge& edge = diagram.edges[e];
    const auto index = static_cast<std::int32_t>(e);
    if (edge.start != kNone) edgeAt[edge.start][cornerOf(edge.start, edge.right)] = index;
    if (edge.end != kNone) edgeAt[edge.end][cornerOf(edge.end, edge.left)] = index;
    if (!isShortEdge(edge, circles, diagram, nearZero)) continue;
    isShort[e] = true;
    sets.unite(edge.start, edge.end);
  }

  MergedDiagram merged;
  merged.mergedVertex.assign(count, kNone);
  for (std::size_t v = 0; v < count; ++v) {
    const std::int32_t root = sets.find(static_cast<std::int32_t>(v));
    if (root == static_cast<std::int32_t>(v)) {
      merged.mergedVertex[v] = static_cast<std::int32_t>(merged.vertices.size());
      merged.vertices.push_back(diagram.vertices[v]);
    } else {
      merged.mergedVertex[v] = merged.mergedVertex[root];
    }
  }

  // Around a merged vertex: of each member a corner whose leaving edge is long starts a walk; at a short edge the walk
  // goes on at the other end. Counter-clockwise, a circle is followed by the one across the edge that ends its corner.
  std::vector<std::array<bool, 3>> isMet(count, {false, false, false});
  std::vector<std::vector<std::int32_t>> around(merged.vertices.size());
  for (auto& list : around) list.reserve(3);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto vertex = static_cast<std::int32_t>(v);
      std::size_t corner = i;
      auto& list = around[merged.mergedVertex[v]];
      if (isMet[v][i] || isShort[edgeAt[v][i]]) continue;
      do {
        isMet[vertex][corner] = true;
        list.push_back(diagram.vertexCircles[vertex][corner]);
        // The next corner counter-clockwise, past short edges. Their corners belong to circles met already.
        corner = (corner + 1) % 3;
        while (isShort[edgeAt[vertex][corner]]) {
          const Edge& edge = diagram.edges[edgeAt[vertex][corner]];
          const std::int32_t circle = diagram.vertexCircles[vertex][corner];
          vertex = edge.start == vertex ? edge.end : edge.start;
          corner = cornerOf(vertex, circle);
        }
      } while (!isMet[vertex][corner]);
    }
  }
  merged.firstCircle.push_back(0);
  for (auto& list : around) {
    std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
    merged.circles.insert(merged.circles.end(), list.begin(), list.end());
    merged.firstCircle.push_back(static_cast<std::int32_t>(merged.circles.size()));
  }
  const auto mergedEnd = [&](std::int32_t vertex) { return vertex == kNone ? kNone : merged.mergedVertex[vertex]; };
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Edge& edge = diagram.edges[e];
    if (!isShort[e]) merged.edges.push_back({edge.left, edge.right, mergedEnd(edge.start), mergedEnd(edge.end)});
  }
  return merged;
}

}  // namespace circle_voronoi
