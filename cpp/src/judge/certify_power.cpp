// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify_power.h"

#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include "certificate_message.h"
#include "guarded.h"
#include "judge_power.h"
#include "radical_center.h"
#include "validate.h"
#include "vectors.h"
#include "visible.h"

namespace circle_voronoi {
namespace {

/// Returns whether a vertex is the radical center up to rounding: to 40 bits of its distance from a point, and its
/// power to 40 bits of the terms of this power.
bool isInPlace(const Vertex& vertex, const Vertex& right, const WeightedPoint& point) {
  if (vertex == right) return true;
  if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.r)) return false;
  constexpr double kSlack = 0x1p-40;
  const double reach = length({right.x - point.p.x, right.y - point.p.y});
  const double size = reach + std::abs(right.x) + std::abs(right.y);
  const auto powerOf = [](const Vertex& v) { return v.r * std::abs(v.r); };
  return std::abs(vertex.x - right.x) <= kSlack * size && std::abs(vertex.y - right.y) <= kSlack * size &&
         std::abs(powerOf(vertex) - powerOf(right)) <= kSlack * (size * size + std::abs(point.weight.value));
}

Certificate judgePowerDiagram(const std::vector<Circle>& circles, const Diagram& diagram) {
  std::vector<std::uint8_t> isHidden(circles.size(), 0);
  if (const auto wrong = markHidden(diagram.hidden, isHidden)) {
    return {Flaw::badIndex, *wrong, kNone, kNone, {}};
  }
  const Visible visible(circles, diagram.hidden);
  const Topology topology = visibleTopology(diagram, visible.sites);
  if (visible.circles.size() < 2 && topology.hull.size() != visible.circles.size()) {
    return {Flaw::eulerCount, kNone, kNone, kNone, {}};
  }
  Links links;
  const auto found = dualOf(topology, static_cast<int>(visible.circles.size()), &links);
  if (const auto* wrong = std::get_if<TopologyFlaw>(&found)) return certificateOf(*wrong, visible);
  const Dual& dual = std::get<Dual>(found);
  std::vector<WeightedPoint> sites;
  sites.reserve(visible.circles.size());
  for (const Circle& c : visible.circles) sites.push_back(weightedPoint(c, diagram.weights));
  Certificate certificate = certificateOf(judgePower(sites, dual), dual, topology);
  if (!certificate.certified()) return certificate;
  std::vector<HiddenPoint> hidden;
  for (const auto& [circle, by] : diagram.hidden) {
    hidden.push_back({weightedPoint(circles[static_cast<std::size_t>(circle)], diagram.weights),
                      visible.sites[static_cast<std::size_t>(by)]});
  }
  if (const Verdict verdict = judgeHiddenPoints(sites, dual, hidden); !verdict.isRight()) {
    return {verdict.flaw, diagram.hidden[static_cast<std::size_t>(verdict.circle)].circle, kNone, kNone, {}};
  }
  for (std::size_t v = 0; v < topology.vertexCircles.size(); ++v) {
    const auto& [i, j, k] = topology.vertexCircles[v];
    const auto site = [&](CircleIndex index) { return sites[static_cast<std::size_t>(index)]; };
    if (v < diagram.vertices.size() &&
        isInPlace(diagram.vertices[v], radicalCenter(site(i), site(j), site(k)), site(i))) {
      continue;
    }
    return {Flaw::vertexMisplaced, kNone, static_cast<std::int32_t>(v), kNone, {}};
  }
  if (diagram.vertices.size() != topology.vertexCircles.size()) return {Flaw::vertexMisplaced, kNone, 0, kNone, {}};
  return judgeSides(diagram, links, visible);
}

}  // namespace

Result<Certificate> certifyPower(const Diagram& diagram) {
  return guarded([&]() -> Result<Certificate> {
    const auto circles = validate(diagram.circles, diagram.weights, Metric::power);
    if (!circles) return circles.error();
    Certificate certificate = judgePowerDiagram(circles.value(), diagram);
    certificate.message = messageOf(certificate, diagram);
    return certificate;
  });
}

}  // namespace circle_voronoi
