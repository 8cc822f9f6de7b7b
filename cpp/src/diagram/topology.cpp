// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace circle_voronoi {
namespace {

class DualBuilder {
 public:
  DualBuilder(const Topology& topology, int circleCount)
      : topology_(topology), circleCount_(circleCount), vertexCount_(static_cast<int>(topology.vertexCircles.size())) {}

  std::variant<Dual, Misfit> build() {
    if (const auto misfit = addVertices()) return *misfit;
    if (const auto misfit = addHull()) return *misfit;
    dual_.twin.assign(dual_.origin.size(), kNone);
    linkHull();
    for (int edge = 0; edge < static_cast<int>(topology_.edges.size()); ++edge) {
      if (const auto misfit = link(edge)) return *misfit;
    }
    const auto open = std::find(dual_.twin.begin(), dual_.twin.end(), kNone);
    if (open != dual_.twin.end()) {
      const int face = static_cast<int>(open - dual_.twin.begin()) / 3;
      return Misfit{Flaw::adjacency, kNone, face < vertexCount_ ? face : kNone};
    }
    return std::move(dual_);
  }

 private:
  bool isCircle(int i) const { return i >= 0 && i < circleCount_; }

  std::optional<Misfit> addVertices() {
    dual_.origin.reserve(3 * (topology_.vertexCircles.size() + topology_.hull.size()));
    for (int vertex = 0; vertex < vertexCount_; ++vertex) {
      const auto& [i, j, k] = topology_.vertexCircles[vertex];
      if (!isCircle(i) || !isCircle(j) || !isCircle(k) || i == j || j == k || k == i) {
        return Misfit{Flaw::badIndex, kNone, vertex};
      }
      dual_.origin.insert(dual_.origin.end(), {i, j, k});
    }
    return std::nullopt;
  }

  /// The hull goes counter-clockwise, so the face at infinity lies to the left of each of its steps reversed.
  std::optional<Misfit> addHull() {
    const auto& hull = topology_.hull;
    for (const int i : hull) {
      if (!isCircle(i)) return Misfit{Flaw::badIndex, i};
    }
    if (hull.size() < 2) return std::nullopt;
    for (std::size_t step = 0; step < hull.size(); ++step) {
      const int i = hull[step];
      const int j = hull[(step + 1) % hull.size()];
      if (i == j) return Misfit{Flaw::badIndex, i};
      const auto face = static_cast<int>(dual_.origin.size() / 3);
      if (!hullFaces_.emplace(key(j, i), face).second) return Misfit{Flaw::adjacency, i};
      dual_.origin.insert(dual_.origin.end(), {j, i, kPointAtInfinity});
    }
    return std::nullopt;
  }

  void linkHull() {
    const auto steps = static_cast<int>(hullFaces_.size());
    for (int step = 0; step < steps; ++step) {
      // (j, i, infinity) and the next (k, j, infinity) share the edge between j and infinity.
      const int h = 3 * (vertexCount_ + step) + 2;
      const int t = 3 * (vertexCount_ + (step + 1) % steps) + 1;
      dual_.twin[h] = t;
      dual_.twin[t] = h;
    }
  }

  /// The half-edge left -> right bounds the face of the end of an edge, right -> left that of its start.
  std::optional<Misfit> link(int index) {
    const Edge& edge = topology_.edges[index];
    if (!isCircle(edge.left) || !isCircle(edge.right) || edge.left == edge.right)
      return Misfit{Flaw::badIndex, kNone, kNone, index};
    const int h = halfEdge(edge.left, edge.right, edge.end);
    const int t = halfEdge(edge.right, edge.left, edge.start);
    if (h == kNone || t == kNone || h == t || dual_.twin[h] != kNone || dual_.twin[t] != kNone) {
      return Misfit{Flaw::adjacency, kNone, kNone, index};
    }
    dual_.twin[h] = t;
    dual_.twin[t] = h;
    return std::nullopt;
  }

  /// The half-edge i -> j of a vertex, or of the hull; kNone if there is none.
  int halfEdge(int i, int j, int vertex) const {
    if (vertex == kNone) {
      const auto found = hullFaces_.find(key(i, j));
      return found == hullFaces_.end() ? kNone : 3 * found->second;
    }
    if (vertex < 0 || vertex >= vertexCount_) return kNone;
    for (int h = 3 * vertex; h < 3 * vertex + 3; ++h) {
      if (dual_.origin[h] == i && dual_.target(h) == j) return h;
    }
    return kNone;
  }

  static std::uint64_t key(int i, int j) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32 | static_cast<std::uint32_t>(j);
  }

  const Topology& topology_;
  int circleCount_;
  int vertexCount_;
  std::unordered_map<std::uint64_t, int> hullFaces_;
  Dual dual_;
};

}  // namespace

Topology topologyOf(const Dual& dual, int circleCount) {
  Topology topology;
  std::vector<std::int32_t> vertexOf(dual.faceCount(), kNone);
  int atInfinity = kNone;
  topology.vertexCircles.reserve(dual.faceCount());
  topology.edges.reserve(dual.halfEdgeCount() / 2);
  for (int face = 0; face < dual.faceCount(); ++face) {
    if (dual.isFinite(face)) {
      vertexOf[face] = static_cast<std::int32_t>(topology.vertexCircles.size());
      topology.vertexCircles.push_back({dual.origin[3 * face], dual.origin[3 * face + 1], dual.origin[3 * face + 2]});
    } else {
      atInfinity = face;
    }
  }
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int t = dual.twin[h];
    if (h > t || dual.origin[h] == kPointAtInfinity || dual.origin[t] == kPointAtInfinity) continue;
    topology.edges.push_back({dual.origin[h], dual.origin[t], vertexOf[t / 3], vertexOf[h / 3]});
  }
  if (circleCount == 1) topology.hull.push_back(0);
  if (atInfinity == kNone) return topology;
  int start = 3 * atInfinity;
  while (dual.origin[start] != kPointAtInfinity) ++start;
  int h = start;
  do {
    topology.hull.push_back(dual.target(h));
    h = Dual::next(dual.twin[h]);
  } while (h != start);
  return topology;
}

void rotateHull(std::vector<CircleIndex>& hull) {
  const std::size_t size = hull.size();
  std::size_t start = 0;
  const auto step = [&](std::size_t i) { return std::pair(hull[i], hull[(i + 1) % size]); };
  for (std::size_t i = 1; i < size; ++i) {
    if (step(i) < step(start)) start = i;
  }
  std::rotate(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(start), hull.end());
}

std::variant<Dual, Misfit> dualOf(const Topology& topology, int circleCount) {
  return DualBuilder(topology, circleCount).build();
}

}  // namespace circle_voronoi
