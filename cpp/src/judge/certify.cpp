// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/certify.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "certificate_message.h"
#include "guarded.h"
#include "judge.h"
#include "prefetch.h"
#include "topology.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// The visible circles of a diagram, if its list of hidden ones is right.
struct Visible {
  std::vector<Circle> circles;
  std::vector<CircleIndex> indices;  ///< of each its index in the input
  std::vector<std::int32_t> sites;   ///< of each input circle its place in `circles`, kNone if hidden
};

/// Returns a certificate with the part of a diagram whose sides are linked wrongly, or without a flaw if there is none.
/// `right` has the correct links, indexed by visible circles.
Certificate judgeSides(const Diagram& diagram, const Links& right, const Visible& visible) {
  std::vector<SideIndex> firstSide(visible.sites.size());
  for (std::size_t i = 0; i < firstSide.size(); ++i) {
    if (visible.sites[i] != kNone) firstSide[i] = right.firstSide[visible.sites[i]];
  }
  if (diagram.links.nextSide.size() != right.nextSide.size() ||
      diagram.links.vertexSides.size() != right.vertexSides.size() ||
      diagram.links.firstSide.size() != firstSide.size()) {
    return {Flaw::adjacency, 0, kNone, kNone, {}};
  }
  const auto firstDifference = [](const auto& a, const auto& b) {
    const auto [found, other] = std::mismatch(a.begin(), a.end(), b.begin());
    return found == a.end() ? kNone : static_cast<std::int32_t>(found - a.begin());
  };
  if (const SideIndex side = firstDifference(diagram.links.nextSide, right.nextSide); side != kNone) {
    return {Flaw::adjacency, diagram.circleOf(side), kNone, kNone, {}};
  }
  if (const VertexIndex vertex = firstDifference(diagram.links.vertexSides, right.vertexSides); vertex != kNone) {
    return {Flaw::adjacency, kNone, vertex, kNone, {}};
  }
  const CircleIndex circle = firstDifference(diagram.links.firstSide, firstSide);
  return {circle == kNone ? Flaw::none : Flaw::adjacency, circle, kNone, kNone, {}};
}

std::variant<Visible, Certificate> visibleCircles(std::span<const Circle> circles, const Diagram& diagram) {
  if (const Verdict verdict = judgeHidden(circles, diagram.hidden); !verdict.isRight()) {
    return Certificate{verdict.flaw, verdict.circle, kNone, kNone, {}};
  }
  Visible visible;
  visible.sites.assign(circles.size(), 0);
  for (const HiddenCircle& hidden : diagram.hidden) visible.sites[hidden.circle] = kNone;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    if (visible.sites[i] == kNone) continue;
    visible.sites[i] = static_cast<std::int32_t>(visible.circles.size());
    visible.circles.push_back(circles[i]);
    visible.indices.push_back(i);
  }
  return visible;
}

/// Returns the topology in terms of visible circles. An index of no visible circle becomes kNone, which no topology
/// accepts.
Topology visibleTopology(const Diagram& diagram, const std::vector<std::int32_t>& sites) {
  const auto site = [&](std::int32_t i) {
    return i >= 0 && static_cast<std::size_t>(i) < sites.size() ? sites[i] : kNone;
  };
  Topology topology{diagram.vertexCircles, diagram.edges, diagram.hull};
  for (auto& triple : topology.vertexCircles) {
    for (CircleIndex& i : triple) i = site(i);
  }
  for (Edge& edge : topology.edges) {
    edge.left = site(edge.left);
    edge.right = site(edge.right);
  }
  for (CircleIndex& i : topology.hull) i = site(i);
  return topology;
}

/// Returns whether a vertex is where the disc of its circles i, j, k is, up to rounding. Our own vertices are so to the
/// bit. Vertices from other programs may be rounded differently: they must touch all three circles to 40 bits, and lie
/// near our disc rather than near the disc that touches the same circles clockwise.
bool isInPlace(const Vertex& vertex, const std::optional<Vertex>& disc, const Circle& i, const Circle& j,
               const Circle& k) {
  if (!disc) return false;
  if (vertex == *disc) return true;
  if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.r)) return false;
  // Discs reach up to 2^876 (three_touch_disc.h), and a given vertex to the largest double: squares must not overflow.
  const double largest = std::max({std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.r)});
  const double shrink = largest < 0x1p400 ? 1 : 0x1p-560;
  const Vertex given = {vertex.x * shrink, vertex.y * shrink, vertex.r * shrink};
  const Vertex right = {disc->x * shrink, disc->y * shrink, disc->r * shrink};
  double reach = 0;
  for (const Circle* circle : {&i, &j, &k}) {
    const Circle c = {circle->x * shrink, circle->y * shrink, circle->r * shrink};
    const double distance = length({given.x - c.x, given.y - c.y});
    const double size = std::abs(given.x) + std::abs(given.y) + std::abs(c.x) + std::abs(c.y) + std::abs(c.r);
    if (!(std::abs(distance - (c.r + given.r)) <= 0x1p-40 * (size + distance))) return false;
    reach = std::max(reach, distance);
  }
  return length({given.x - right.x, given.y - right.y}) <= 0x1p-10 * reach;
}

/// Returns the first misplaced vertex, or kNone.
std::int32_t misplacedVertex(const Diagram& diagram, const Topology& topology, std::span<const Circle> circles,
                             const Predicates& predicates, const std::vector<FaceDisc>& discs) {
  if (diagram.vertices.size() != diagram.vertexCircles.size()) return 0;
  for (std::size_t vertex = 0; vertex < diagram.vertices.size(); ++vertex) {
    if (diagram.vertices.size() - vertex > kPrefetchAhead) {
      for (const std::int32_t i : topology.vertexCircles[vertex + kPrefetchAhead]) prefetch(circles, i);
    }
    auto triple = topology.vertexCircles[vertex];
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
    const auto& [i, j, k] = triple;
    const auto disc = predicates.vertex({i, j, k}, discs[vertex]);
    if (!isInPlace(diagram.vertices[vertex], disc, circles[i], circles[j], circles[k])) {
      return static_cast<std::int32_t>(vertex);
    }
  }
  return kNone;
}

Certificate judgeDiagram(std::span<const Circle> circles, const Diagram& diagram) {
  auto found = visibleCircles(circles, diagram);
  if (const auto* certificate = std::get_if<Certificate>(&found)) return *certificate;
  const auto& visible = std::get<Visible>(found);
  const auto count = static_cast<int>(visible.circles.size());
  const Topology topology = visibleTopology(diagram, visible.sites);
  if (count < 2 && topology.hull.size() != visible.circles.size()) return {Flaw::eulerCount, kNone, kNone, kNone, {}};
  Links links;
  auto dual = dualOf(topology, count, &links);
  if (const auto* wrong = std::get_if<TopologyFlaw>(&dual)) {
    return {wrong->flaw,
            wrong->circle == kNone ? CircleIndex() : visible.indices[wrong->circle],
            wrong->vertex,
            wrong->edge,
            {}};
  }
  Predicates predicates(visible.circles);
  const Verdict verdict = judge(visible.circles, std::get<Dual>(dual), predicates);
  Certificate certificate = certificateOf(verdict, std::get<Dual>(dual), topology);
  if (certificate.circle != kNone) certificate.circle = visible.indices[certificate.circle];
  if (certificate.certified()) {
    certificate.vertex = misplacedVertex(diagram, topology, visible.circles, predicates, verdict.proof.discs);
    if (certificate.vertex != kNone) certificate.flaw = Flaw::vertexMisplaced;
  }
  return certificate.certified() ? judgeSides(diagram, links, visible) : certificate;
}

}  // namespace

Result<Certificate> certify(const Diagram& diagram) {
  return guarded([&]() -> Result<Certificate> {
    if (diagram.metric == Metric::power) {
      return errorWith(ErrorCode::badOption, "There is no certificate for a power diagram.");
    }
    const auto circles = validate(diagram.circles, diagram.weights);
    if (!circles) return circles.error();
    Certificate certificate =
        judgeDiagram(diagram.metric == Metric::centers ? pointsOf(circles.value()) : circles.value(), diagram);
    certificate.message = messageOf(certificate, diagram);
    return certificate;
  });
}

}  // namespace circle_voronoi
