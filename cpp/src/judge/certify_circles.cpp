// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify_circles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "at.h"
#include "certificate_message.h"
#include "guarded.h"
#include "judge.h"
#include "prefetch.h"
#include "topology.h"
#include "validate.h"
#include "visible.h"

namespace circle_voronoi {
namespace {

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
      for (const std::int32_t i : topology.vertexCircles[vertex + kPrefetchAhead]) prefetch(circles, at(i));
    }
    auto triple = topology.vertexCircles[vertex];
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
    const auto& [i, j, k] = triple;
    const auto disc = predicates.vertex({i, j, k}, discs[vertex]);
    if (!isInPlace(diagram.vertices[vertex], disc, circles[at(i)], circles[at(j)], circles[at(k)])) {
      return static_cast<std::int32_t>(vertex);
    }
  }
  return kNone;
}

Certificate judgeDiagram(std::span<const Circle> circles, const Diagram& diagram) {
  if (const Verdict verdict = judgeHidden(circles, diagram.hidden); !verdict.isRight()) {
    return {verdict.flaw, verdict.circle, kNone, kNone, {}};
  }
  const Visible visible(circles, diagram.hidden);
  const auto count = static_cast<int>(visible.circles.size());
  const Topology topology = visibleTopology(diagram, visible.sites);
  if (count < 2 && topology.hull.size() != visible.circles.size()) return {Flaw::eulerCount, kNone, kNone, kNone, {}};
  Links links;
  auto dual = dualOf(topology, count, &links);
  if (const auto* wrong = std::get_if<TopologyFlaw>(&dual)) return certificateOf(*wrong, visible);
  Predicates predicates(visible.circles);
  const Verdict verdict = judge(visible.circles, std::get<Dual>(dual), predicates);
  Certificate certificate = certificateOf(verdict, std::get<Dual>(dual), topology);
  if (certificate.circle != kNone) certificate.circle = visible.indices[at(certificate.circle)];
  if (certificate.certified()) {
    certificate.vertex = misplacedVertex(diagram, topology, visible.circles, predicates, verdict.proof.discs);
    if (certificate.vertex != kNone) certificate.flaw = Flaw::vertexMisplaced;
  }
  return certificate.certified() ? judgeSides(diagram, links, visible) : certificate;
}

}  // namespace

Result<Certificate> certifyCircles(const Diagram& diagram) {
  return guarded([&]() -> Result<Certificate> {
    if (diagram.metric == Metric::power) {
      return errorWith(ErrorCode::badOption, "A power diagram is judged elsewhere.");
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
