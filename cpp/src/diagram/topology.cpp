// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "at.h"
#include "branchless.h"

namespace circle_voronoi {
namespace {

/// Numbers the items for which a condition holds, in their order, and calls number(item, its number) for each. Returns
/// their count.
template <class Condition, class Number>
std::int32_t numbered(std::size_t items, Threads threads, Condition condition, Number number) {
  std::vector<std::int32_t> first(threads.rangesOf(items) + 1, 0);
  if (first.size() > 2) {
    threads.forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t range) {
      for (std::size_t i = begin; i < end; ++i) first[range + 1] += condition(i) ? 1 : 0;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
  }
  threads.forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t range) {
    std::int32_t next = first[range];
    std::array<std::size_t, 256> chosen;
    for (std::size_t from = begin; from < end; from += chosen.size()) {
      const std::size_t count = select(from, std::min(from + chosen.size(), end), chosen, condition);
      for (std::size_t k = 0; k < count; ++k) number(chosen[k], next++);
    }
    if (first.size() == 2) first[1] = next;
  });
  return first.back();
}

/// Sets the links of a face, except the first sides of circles. `sideOf` gives the side of a half-edge between circles:
/// that of its origin, along the border with its target. The side of the other half differs in the last bit.
///
/// The side of half-edge h ends at the vertex that is the face of h, and the next one around the same circle begins
/// there: it lies one half-edge on, counter-clockwise around the origin, or two where that one goes to infinity.
///
/// The sides of a vertex begin with that of the corner `first`, from 0 to 2. This function uses only the
/// twins of edges to infinity.
template <class SideOf>
void linkFace(int face, VertexIndex vertex, const Dual& dual, SideOf sideOf, Links& links, std::size_t first = 0) {
  const int h = 3 * face;
  if (vertex != kNone) {
    const std::array<SideIndex, 3> own = {sideOf(h), sideOf(h + 1), sideOf(h + 2)};
    const std::array<SideIndex, 3> sides = {own[2] ^ 1, own[0] ^ 1, own[1] ^ 1};
    links.vertexSides[at(vertex)] = startingAt(sides, first);
    for (int k = 0; k < 3; ++k) links.nextSide[at(own[at(k)])] = sides[at(k)];
  } else {
    const int between = h + (dual.origin[at(h)] == kPointAtInfinity       ? 1
                             : dual.origin[at(h + 1)] == kPointAtInfinity ? 2
                                                                          : 0);
    links.nextSide[at(sideOf(between))] = sideOf(Dual::previous(dual.around(between))) ^ 1;
  }
}

void linkFirstSides(std::span<const Edge> edges, Links& links) {
  // The loop runs backwards, so that the first side of a circle is set last.
  auto side = static_cast<std::int32_t>(2 * edges.size());
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) {
    links.firstSide[at(edge->right)] = --side;
    links.firstSide[at(edge->left)] = --side;
  }
}

Links emptyLinks(std::size_t edges, std::size_t vertices, int circleCount) {
  Links links;
  links.nextSide.resize(2 * edges);
  links.vertexSides.resize(vertices);
  links.firstSide.resize(static_cast<std::size_t>(circleCount));
  return links;
}

class DualBuilder {
 public:
  DualBuilder(const Topology& topology, int circleCount)
      : topology_(topology), circleCount_(circleCount), vertexCount_(static_cast<int>(topology.vertexCircles.size())) {}

  std::variant<Dual, TopologyFlaw> build(Links* links) {
    if (const auto flaw = addVertices()) return *flaw;
    if (const auto flaw = addHull()) return *flaw;
    dual_.twin.assign(dual_.origin.size(), kNone);
    sideOf_.resize(dual_.origin.size());
    linkHull();
    for (int edge = 0; edge < static_cast<int>(topology_.edges.size()); ++edge) {
      if (const auto flaw = link(edge)) return *flaw;
    }
    const auto open = std::find(dual_.twin.begin(), dual_.twin.end(), kNone);
    if (open != dual_.twin.end()) {
      const int face = static_cast<int>(open - dual_.twin.begin()) / 3;
      return TopologyFlaw{Flaw::adjacency, kNone, face < vertexCount_ ? face : kNone};
    }
    if (links != nullptr) {
      *links = emptyLinks(topology_.edges.size(), topology_.vertexCircles.size(), circleCount_);
      for (int face = 0; face < dual_.faceCount(); ++face) {
        linkFace(
            face, face < vertexCount_ ? VertexIndex(face) : VertexIndex(), dual_, [&](int h) { return sideOf_[at(h)]; },
            *links);
      }
      linkFirstSides(topology_.edges, *links);
    }
    return std::move(dual_);
  }

 private:
  bool isCircle(int i) const { return i >= 0 && i < circleCount_; }

  std::optional<TopologyFlaw> addVertices() {
    dual_.origin.reserve(3 * (topology_.vertexCircles.size() + topology_.hull.size()));
    for (int vertex = 0; vertex < vertexCount_; ++vertex) {
      const auto& [i, j, k] = topology_.vertexCircles[at(vertex)];
      if (!isCircle(i) || !isCircle(j) || !isCircle(k) || i == j || j == k || k == i) {
        return TopologyFlaw{Flaw::badIndex, kNone, vertex};
      }
      dual_.origin.insert(dual_.origin.end(), {i, j, k});
    }
    return std::nullopt;
  }

  /// The hull goes counter-clockwise, so the face at infinity lies to the left of each of its steps reversed.
  std::optional<TopologyFlaw> addHull() {
    const auto& hull = topology_.hull;
    for (const int i : hull) {
      if (!isCircle(i)) return TopologyFlaw{Flaw::badIndex, i};
    }
    if (hull.size() < 2) return std::nullopt;
    for (std::size_t step = 0; step < hull.size(); ++step) {
      const int i = hull[step];
      const int j = hull[(step + 1) % hull.size()];
      if (i == j) return TopologyFlaw{Flaw::badIndex, i};
      const auto face = static_cast<int>(dual_.origin.size() / 3);
      if (!hullFaces_.emplace(key(j, i), face).second) return TopologyFlaw{Flaw::adjacency, i};
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
      dual_.twin[at(h)] = t;
      dual_.twin[at(t)] = h;
    }
  }

  /// The half-edge left -> right bounds the face of the end of an edge, right -> left that of its start.
  std::optional<TopologyFlaw> link(int index) {
    const Edge& edge = topology_.edges[at(index)];
    if (!isCircle(edge.left) || !isCircle(edge.right) || edge.left == edge.right)
      return TopologyFlaw{Flaw::badIndex, kNone, kNone, index};
    const int h = halfEdge(edge.left, edge.right, edge.end);
    const int t = halfEdge(edge.right, edge.left, edge.start);
    if (h == kNone || t == kNone || h == t || dual_.twin[at(h)] != kNone || dual_.twin[at(t)] != kNone) {
      return TopologyFlaw{Flaw::adjacency, kNone, kNone, index};
    }
    dual_.twin[at(h)] = t;
    dual_.twin[at(t)] = h;
    sideOf_[at(h)] = 2 * index;
    sideOf_[at(t)] = 2 * index + 1;
    return std::nullopt;
  }

  /// Returns the half-edge i -> j of a vertex, or of the hull if `vertex` is kNone. Returns kNone if there is none.
  int halfEdge(int i, int j, int vertex) const {
    if (vertex == kNone) {
      const auto found = hullFaces_.find(key(i, j));
      return found == hullFaces_.end() ? kNone : 3 * found->second;
    }
    if (vertex < 0 || vertex >= vertexCount_) return kNone;
    for (int h = 3 * vertex; h < 3 * vertex + 3; ++h) {
      if (dual_.origin[at(h)] == i && dual_.target(h) == j) return h;
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
  std::vector<SideIndex> sideOf_;  ///< of each half-edge between circles
};

}  // namespace

std::vector<VertexIndex> verticesOf(const Dual& dual, Threads threads) {
  std::vector<VertexIndex> vertexOf(dual.origin.size() / 3);
  numbered(
      vertexOf.size(), threads, [&](std::size_t face) { return dual.isFinite(static_cast<int>(face)); },
      [&](std::size_t face, std::int32_t vertex) { vertexOf[face] = vertex; });
  return vertexOf;
}

Topology topologyOf(Dual dual, int circleCount) {
  const std::vector<VertexIndex> vertexOf = verticesOf(dual, Threads());
  Links links;
  return topologyOf(std::move(dual), vertexOf, circleCount, links, Threads());
}

Topology topologyOf(Dual dual, const std::vector<VertexIndex>& vertexOf, int circleCount, Links& links,
                    Threads threads) {
  const auto isVertex = [](VertexIndex vertex) { return vertex != kNone; };
  const auto vertexCount = static_cast<std::size_t>(std::count_if(vertexOf.begin(), vertexOf.end(), isVertex));
  // Each face at infinity follows an edge to there.
  const std::size_t edgeCount = dual.origin.size() / 2 - (vertexOf.size() - vertexCount);
  Topology topology;
  topology.edges.resize(edgeCount);
  topology.vertexCircles.resize(vertexCount);
  // The side of the first half of an edge takes the place of its twin, as the complement, which is negative.
  std::vector<int>& sideOrTwin = dual.twin;
  numbered(
      sideOrTwin.size(), threads,
      [&](std::size_t i) {
        const int t = sideOrTwin[i];
        const int isFirst = static_cast<int>(i) < t ? 1 : 0;
        const int startsAtCircle = dual.origin[i] != kPointAtInfinity ? 1 : 0;
        const int endsAtCircle = dual.origin[at(t)] != kPointAtInfinity ? 1 : 0;
        return (isFirst & startsAtCircle & endsAtCircle) != 0;
      },
      [&](std::size_t i, std::int32_t edge) {
        const int t = sideOrTwin[i];
        topology.edges[at(edge)] = {dual.origin[i], dual.origin[at(t)], vertexOf[at(t / 3)], vertexOf[i / 3]};
        sideOrTwin[i] = ~(2 * edge);
      });
  const auto sideOf = [&](int h) {
    const int t = sideOrTwin[at(h)];
    const int isSecond = t >= 0 ? 1 : 0;
    return SideIndex(~sideOrTwin[at(h + isSecond * (t - h))] + isSecond);
  };
  links = emptyLinks(edgeCount, vertexCount, circleCount);
  threads.forEach(vertexOf.size(), [&](std::size_t i) {
    const auto face = static_cast<int>(i);
    const auto corners = cornersOf(dual, 3 * face);
    // The smallest circle first, so that the triple does not depend on how the face was found.
    const std::size_t first = indexOfSmallest(corners);
    linkFace(face, vertexOf[i], dual, sideOf, links, first);
    if (!isVertex(vertexOf[i])) return;
    const auto [a, b, c] = startingAt(corners, first);
    topology.vertexCircles[at(vertexOf[i])] = {a, b, c};
  });
  linkFirstSides(topology.edges, links);
  const auto atInfinity =
      static_cast<int>(std::find_if_not(vertexOf.rbegin(), vertexOf.rend(), isVertex).base() - vertexOf.begin()) - 1;
  if (circleCount == 1) topology.hull.push_back(0);
  if (atInfinity < 0) return topology;
  int start = 3 * atInfinity;
  while (dual.origin[at(start)] != kPointAtInfinity) ++start;
  int h = start;
  do {
    topology.hull.push_back(dual.target(h));
    h = dual.aroundClockwise(h);
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

void takeTopology(Diagram& diagram, Topology topology) {
  diagram.vertexCircles = std::move(topology.vertexCircles);
  diagram.edges = std::move(topology.edges);
  diagram.hull = std::move(topology.hull);
  rotateHull(diagram.hull);
}

std::variant<Dual, TopologyFlaw> dualOf(const Topology& topology, int circleCount, Links* links) {
  return DualBuilder(topology, circleCount).build(links);
}

bool linkSides(Diagram& diagram) {
  const auto circleCount = static_cast<int>(diagram.circles.size());
  const Topology topology = {diagram.vertexCircles, diagram.edges, diagram.hull};
  Links links;
  const bool fits = diagram.vertices.size() == diagram.vertexCircles.size() &&
                    std::holds_alternative<Dual>(dualOf(topology, circleCount, &links));
  if (!fits) {
    links.nextSide.assign(2 * diagram.edges.size(), kNone);
    links.vertexSides.assign(diagram.vertexCircles.size(), {kNone, kNone, kNone});
    links.firstSide.assign(diagram.circles.size(), kNone);
  }
  diagram.links = std::move(links);
  return fits;
}

}  // namespace circle_voronoi
