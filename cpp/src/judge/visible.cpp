// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible.h"

#include <algorithm>
#include <cstddef>

#include "at.h"

namespace circle_voronoi {

Visible::Visible(std::span<const Circle> all, std::span<const HiddenCircle> hidden) {
  sites.assign(all.size(), 0);
  for (const HiddenCircle& h : hidden) sites[at(h.circle)] = kNone;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(all.size()); ++i) {
    if (sites[at(i)] == kNone) continue;
    sites[at(i)] = static_cast<std::int32_t>(circles.size());
    circles.push_back(all[at(i)]);
    indices.push_back(i);
  }
}

Topology visibleTopology(const Diagram& diagram, const std::vector<std::int32_t>& sites) {
  const auto site = [&](std::int32_t i) {
    return i >= 0 && static_cast<std::size_t>(i) < sites.size() ? sites[at(i)] : kNone;
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

Certificate certificateOf(const TopologyFlaw& wrong, const Visible& visible) {
  return {wrong.flaw,
          wrong.circle == kNone ? CircleIndex() : visible.indices[at(wrong.circle)],
          wrong.vertex,
          wrong.edge,
          {}};
}

Certificate judgeSides(const Diagram& diagram, const Links& right, const Visible& visible) {
  std::vector<SideIndex> firstSide(visible.sites.size());
  for (std::size_t i = 0; i < firstSide.size(); ++i) {
    if (visible.sites[i] != kNone) firstSide[i] = right.firstSide[at(visible.sites[i])];
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

}  // namespace circle_voronoi
