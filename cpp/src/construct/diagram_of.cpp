// SPDX-License-Identifier: GPL-3.0-or-later
#include "diagram_of.h"

#include <algorithm>
#include <string>
#include <utility>

#include "certificate_message.h"
#include "three_touch_disc.h"

namespace circle_voronoi {

Error vertexBeyondDoubles(const std::array<CircleIndex, 3>& circles) {
  const auto& [i, j, k] = circles;
  return {ErrorCode::coordinateTooLarge, i,
          "The vertex of circles " + std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) +
              ", which nearly have a common tangent line, lies farther off than the largest number."};
}

Result<Diagram> diagramOf(std::span<const Circle> circles, Construction construction, Sites sites, double unit) {
  Diagram diagram;
  diagram.vertexCircles = std::move(construction.topology.vertexCircles);
  diagram.edges = std::move(construction.topology.edges);
  diagram.hull = std::move(construction.topology.hull);
  diagram.certificate = std::move(construction.certificate);
  diagram.hidden = std::move(sites.hidden);
  diagram.vertices.reserve(diagram.vertexCircles.size());
  for (auto& triple : diagram.vertexCircles) {
    // The smallest input index first, so that a vertex has the same bits however it was found.
    const auto isBefore = [&](std::int32_t a, std::int32_t b) { return sites.indices[a] < sites.indices[b]; };
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end(), isBefore), triple.end());
    const auto& [i, j, k] = triple;
    const auto vertex = vertexOf(sites.circles[i], sites.circles[j], sites.circles[k], unit);
    for (CircleIndex& circle : triple) circle = sites.indices[circle];
    // A diagram that is not certified may have triples without a disc, whose vertex may be anything.
    if (!vertex && diagram.certificate.certified()) return vertexBeyondDoubles(triple);
    diagram.vertices.push_back(vertex.value_or(Vertex{}));
  }
  for (Edge& edge : diagram.edges) {
    edge.left = sites.indices[edge.left];
    edge.right = sites.indices[edge.right];
  }
  for (CircleIndex& circle : diagram.hull) circle = sites.indices[circle];
  rotateHull(diagram.hull);
  if (diagram.certificate.circle != kNone) diagram.certificate.circle = sites.indices[diagram.certificate.circle];
  diagram.certificate.message = messageOf(diagram.certificate, diagram);
  sites = {};  // before more memory is needed
  diagram.circles.assign(circles.begin(), circles.end());
  linkSides(diagram);
  return diagram;
}

}  // namespace circle_voronoi
