// SPDX-License-Identifier: GPL-3.0-or-later
#include "diagram_of.h"

#include <algorithm>
#include <string>
#include <utility>

#include "certificate_message.h"
#include "predicates.h"

namespace circle_voronoi {

Error vertexBeyondDoubles(const std::array<CircleIndex, 3>& circles) {
  const auto& [i, j, k] = circles;
  return {ErrorCode::coordinateTooLarge, i,
          "The vertex of circles " + std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) +
              ", which nearly have a common tangent line, lies farther off than the largest number."};
}

namespace {

using Triple = Predicates::Triple;

/// The place of the smallest input index among the circles of a vertex. With this one first, a vertex has the same bits
/// however it was found.
std::ptrdiff_t firstOf(const Triple& corners, const std::vector<int>& indices) {
  const auto isBefore = [&](int a, int b) { return indices[a] < indices[b]; };
  return std::min_element(corners.begin(), corners.end(), isBefore) - corners.begin();
}

template <class Item>
void beginAt(std::array<Item, 3>& items, std::ptrdiff_t first) {
  std::rotate(items.begin(), items.begin() + first, items.end());
}

}  // namespace

Result<Diagram> diagramOf(std::span<const Circle> circles, Construction construction, Sites sites, double unit,
                          Threads threads) {
  Diagram diagram;
  Topology topology;
  Links links;
  const Predicates predicates(sites.circles);
  // A diagram that is not certified may have triples without a disc, whose vertex may be anything.
  const auto vertexOf = [&](Triple corners, const FaceDisc& disc) {
    beginAt(corners, firstOf(corners, sites.indices));
    return predicates.vertex(corners, disc, unit);
  };
  if (construction.unfit) {
    const Misfit& misfit = construction.unfit->misfit;
    topology = std::move(construction.unfit->topology);
    diagram.certificate = {misfit.flaw, misfit.circle, misfit.vertex, misfit.edge, {}};
    for (const auto& [i, j, k] : topology.vertexCircles) {
      diagram.vertices.push_back(vertexOf({i, j, k}, {}).value_or(Vertex{}));
    }
  } else {
    const Dual& dual = construction.dual;
    Verdict& verdict = construction.verdict;
    const std::vector<FaceDisc>& discs = verdict.proof.discs;
    const std::vector<VertexIndex> vertices = verticesOf(dual, threads);
    const auto isVertex = [](VertexIndex vertex) { return vertex != kNone; };
    diagram.vertices.resize(static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(), isVertex)));
    const std::size_t beyond = threads.firstWhere(vertices.size(), [&](std::size_t face) {
      if (!isVertex(vertices[face])) return false;
      const auto vertex =
          vertexOf(cornersOf(dual, 3 * static_cast<int>(face)), discs.empty() ? FaceDisc{} : discs[face]);
      diagram.vertices[vertices[face]] = vertex.value_or(Vertex{});
      return !vertex && verdict.isRight();
    });
    if (beyond < vertices.size()) {
      Triple corners = cornersOf(dual, 3 * static_cast<int>(beyond));
      beginAt(corners, firstOf(corners, sites.indices));
      const auto& [i, j, k] = corners;
      return vertexBeyondDoubles({sites.indices[i], sites.indices[j], sites.indices[k]});
    }
    verdict.proof = {};  // which frees memory before more is needed
    topology = topologyOf(dual, static_cast<int>(sites.circles.size()), &links, threads);
    diagram.certificate = certificateOf(verdict, dual, topology);
  }
  construction = {};
  diagram.vertexCircles = std::move(topology.vertexCircles);
  diagram.edges = std::move(topology.edges);
  diagram.hull = std::move(topology.hull);
  diagram.hidden = std::move(sites.hidden);
  // Where the topology does not fit, no side has a next one.
  diagram.links.nextSide = std::move(links.nextSide);
  diagram.links.nextSide.resize(2 * diagram.edges.size());
  diagram.links.vertexSides = std::move(links.vertexSides);
  diagram.links.vertexSides.resize(diagram.vertexCircles.size());
  diagram.links.firstSide.resize(circles.size());
  threads.forEach(links.firstSide.size(),
                  [&](std::size_t site) { diagram.links.firstSide[sites.indices[site]] = links.firstSide[site]; });
  threads.forEach(diagram.vertexCircles.size(), [&](std::size_t vertex) {
    auto& triple = diagram.vertexCircles[vertex];
    const auto first = firstOf({triple[0], triple[1], triple[2]}, sites.indices);
    beginAt(triple, first);
    beginAt(diagram.links.vertexSides[vertex], first);
    for (CircleIndex& circle : triple) circle = sites.indices[circle];
  });
  threads.forEach(diagram.edges.size(), [&](std::size_t i) {
    Edge& edge = diagram.edges[i];
    edge.left = sites.indices[edge.left];
    edge.right = sites.indices[edge.right];
  });
  for (CircleIndex& circle : diagram.hull) circle = sites.indices[circle];
  rotateHull(diagram.hull);
  if (diagram.certificate.circle != kNone) diagram.certificate.circle = sites.indices[diagram.certificate.circle];
  diagram.certificate.message = messageOf(diagram.certificate, diagram);
  sites = {};
  diagram.circles.assign(circles.begin(), circles.end());
  return diagram;
}

}  // namespace circle_voronoi
