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
  Dual& dual = state.dual;
  Verdict& verdict = state.verdict;
  Diagram diagram;
  const Predicates predicates(sites.circles);
  const std::vector<FaceDisc>& discs = verdict.proof.discs;
  const std::vector<VertexIndex> vertices = verticesOf(dual, threads);
  const auto isVertex = [](VertexIndex vertex) { return vertex != kNone; };
  diagram.vertices.resize(static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(), isVertex)));
  threads.forEach(vertices.size(), [&](std::size_t face) {
    if (!isVertex(vertices[face])) return;
    // A diagram that is not certified may have triples without a disc, whose vertex may be anything.
    diagram.vertices[at(vertices[face])] =
        predicates.vertex(cornersOf(dual, 3 * static_cast<int>(face)), discs.empty() ? FaceDisc{} : discs[face])
            .value_or(Vertex{});
  });
  // Frees memory before more is needed.
  verdict.proof = {};
  sites.circles = std::vector<Circle>();
  threads.forEach(dual.origin.size(), [&](std::size_t h) {
    if (int& corner = dual.origin[h]; corner != kPointAtInfinity) corner = sites.indices[at(corner)];
  });
  // The place of a flaw is known by its face and half-edge.
  const Dual flawed = verdict.isRight() ? Dual{} : dual;
  Topology topology = topologyOf(std::move(dual), vertices, static_cast<int>(circles.size()), diagram.links, threads);
  if (sites.indices.size() == 1) topology.hull = {sites.indices[0]};
  diagram.certificate = certificateOf(verdict, flawed, topology);
  if (diagram.certificate.circle != kNone) diagram.certificate.circle = sites.indices[at(diagram.certificate.circle)];
  takeTopology(diagram, std::move(topology));
  diagram.hidden = std::move(sites.hidden);
  diagram.certificate.message = messageOf(diagram.certificate, diagram);
  state = {};
  diagram.circles.reserve(circles.size());
  for (const Circle& c : circles) diagram.circles.push_back(rounded(c));
  return diagram;
}

}  // namespace circle_voronoi
