// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate_message.h"

#include <algorithm>

#include "at.h"

namespace circle_voronoi {
namespace {

std::string vertexName(std::int32_t vertex, const Diagram& diagram) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= diagram.vertexCircles.size()) return "A vertex at infinity";
  const auto& [i, j, k] = diagram.vertexCircles[at(vertex)];
  return "Vertex " + std::to_string(vertex) + " (circles " + std::to_string(i) + ", " + std::to_string(j) + ", " +
         std::to_string(k) + ")";
}

std::string edgeName(std::int32_t edge, const Diagram& diagram) {
  const Edge& e = diagram.edges[at(edge)];
  return "Edge " + std::to_string(edge) + " (circles " + std::to_string(e.left) + ", " + std::to_string(e.right) + ")";
}

/// Returns the name of the edge, circle or vertex that a certificate refers to.
std::string subject(const Certificate& certificate, const Diagram& diagram) {
  if (certificate.edge != kNone) return edgeName(certificate.edge, diagram);
  if (certificate.circle != kNone) return "Circle " + std::to_string(certificate.circle);
  return vertexName(certificate.vertex, diagram);
}

}  // namespace

Certificate certificateOf(const Verdict& verdict, const Dual& dual, const Topology& topology) {
  const auto vertexOf = [&](int face) {
    if (!dual.isFinite(face)) return kNone;
    std::int32_t vertex = 0;
    for (int before = 0; before < face; ++before) vertex += dual.isFinite(before) ? 1 : 0;
    return vertex;
  };
  Certificate certificate;
  certificate.flaw = verdict.flaw;
  certificate.circle = verdict.circle;
  if (verdict.face != kNone) certificate.vertex = vertexOf(verdict.face);
  if (verdict.halfEdge != kNone) {
    const int h = verdict.halfEdge;
    const int t = dual.twin[at(h)];
    const Edge forth = {dual.origin[at(h)], dual.origin[at(t)], vertexOf(t / 3), vertexOf(h / 3)};
    const Edge back = {forth.right, forth.left, forth.end, forth.start};
    const auto found = std::find_if(topology.edges.begin(), topology.edges.end(),
                                    [&](const Edge& edge) { return edge == forth || edge == back; });
    if (found != topology.edges.end()) certificate.edge = static_cast<std::int32_t>(found - topology.edges.begin());
  }
  return certificate;
}

std::string messageOf(const Certificate& certificate, const Diagram& diagram) {
  const auto about = [&] { return subject(certificate, diagram); };
  switch (certificate.flaw) {
    case Flaw::none:
      return "";
    case Flaw::notJudged:
      return "The diagram was not judged.";
    case Flaw::badIndex:
      return about() + " has an index that is out of range, repeated or of a hidden circle.";
    case Flaw::hiddenWithoutHider:
      return about() + " is listed as hidden by a circle that does not hide it.";
    case Flaw::adjacency:
      return about() + " does not fit together with the edges, vertices and hull around it.";
    case Flaw::eulerCount:
      return "The numbers of vertices and hull circles do not fit the number of visible circles.";
    case Flaw::vertexWithoutDisc:
      return about() + " has no disc that touches its circles in this order.";
    case Flaw::vertexMisplaced:
      return about() + " is not the center of the disc that touches its circles.";
    case Flaw::edgeOutOfOrder:
      return about() + " has its ends in the wrong order along the bisector.";
    case Flaw::cellNotClosed:
      return about() + " has a cell that does not go around it exactly once.";
    case Flaw::hullNotClosed:
      return "The hull does not turn exactly once.";
  }
  return "";
}

}  // namespace circle_voronoi
