// SPDX-License-Identifier: GPL-3.0-or-later
#include "diagram_of.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "at.h"
#include "certificate_message.h"
#include "predicates.h"
#include "validate.h"

namespace circle_voronoi {

Diagram diagramOf(std::span<const Circle> circles, State state, Threads threads) {
  Sites& sites = state.sites;
  Construction& construction = state.construction;
  Diagram diagram;
  Topology topology;
  Links links;
  const Predicates predicates(sites.circles);
  // A diagram that is not certified may have triples without a disc, whose vertex may be anything.
  const auto vertexOf = [&](const Predicates::Triple& corners, const FaceDisc& disc) {
    return predicates.vertex(corners, disc).value_or(Vertex{});
  };
  if (construction.flawed) {
    const TopologyFlaw& found = construction.flawed->flaw;
    topology = std::move(construction.flawed->topology);
    diagram.certificate = {found.flaw, found.circle, found.vertex, found.edge, {}};
    const auto ofInput = [&](CircleIndex& circle) { circle = sites.indices[at(circle)]; };
    for (auto& triple : topology.vertexCircles) {
      const auto& [i, j, k] = triple;
      diagram.vertices.push_back(vertexOf({i, j, k}, {}));
      std::for_each(triple.begin(), triple.end(), ofInput);
      std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
    }
    for (Edge& edge : topology.edges) {
      ofInput(edge.left);
      ofInput(edge.right);
    }
    std::for_each(topology.hull.begin(), topology.hull.end(), ofInput);
    // No side has a next one.
    links.nextSide.resize(2 * topology.edges.size());
    links.vertexSides.resize(topology.vertexCircles.size());
    links.firstSide.resize(circles.size());
  } else {
    Dual& dual = construction.dual;
    Verdict& verdict = construction.verdict;
    const std::vector<FaceDisc>& discs = verdict.proof.discs;
    const std::vector<VertexIndex> vertices = verticesOf(dual, threads);
    const auto isVertex = [](VertexIndex vertex) { return vertex != kNone; };
    diagram.vertices.resize(static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(), isVertex)));
    threads.forEach(vertices.size(), [&](std::size_t face) {
      if (!isVertex(vertices[face])) return;
      diagram.vertices[at(vertices[face])] =
          vertexOf(cornersOf(dual, 3 * static_cast<int>(face)), discs.empty() ? FaceDisc{} : discs[face]);
    });
    // Frees memory before more is needed.
    verdict.proof = {};
    sites.circles = std::vector<Circle>();
    threads.forEach(dual.origin.size(), [&](std::size_t h) {
      if (int& corner = dual.origin[h]; corner != kPointAtInfinity) corner = sites.indices[at(corner)];
    });
    // The place of a flaw is known by its face and half-edge.
    const Dual flawed = verdict.isRight() ? Dual{} : dual;
    topology = topologyOf(std::move(dual), vertices, static_cast<int>(circles.size()), links, threads);
    if (sites.indices.size() == 1) topology.hull = {sites.indices[0]};
    diagram.certificate = certificateOf(verdict, flawed, topology);
  }
  construction = {};
  diagram.vertexCircles = std::move(topology.vertexCircles);
  diagram.edges = std::move(topology.edges);
  diagram.hull = std::move(topology.hull);
  diagram.links = std::move(links);
  diagram.hidden = std::move(sites.hidden);
  rotateHull(diagram.hull);
  if (diagram.certificate.circle != kNone) diagram.certificate.circle = sites.indices[at(diagram.certificate.circle)];
  diagram.certificate.message = messageOf(diagram.certificate, diagram);
  sites = {};
  diagram.circles.reserve(circles.size());
  for (const Circle& c : circles) diagram.circles.push_back(rounded(c));
  return diagram;
}

}  // namespace circle_voronoi
