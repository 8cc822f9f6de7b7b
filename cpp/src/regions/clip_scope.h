// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "at.h"
#include "chosen.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// The cells that are clipped, with their edges and vertices: all of a diagram, or a few.
struct ClipScope {
  ClipScope(const Diagram& diagram, const std::optional<std::span<const CircleIndex>>& circles)
      : cells(diagram.circles.size()), edges(diagram.edges.size()), vertices(diagram.vertices.size()) {
    if (!circles) return;
    cells = Chosen(std::vector<std::int32_t>(circles->begin(), circles->end()));
    std::vector<std::int32_t> itsEdges;
    std::vector<std::int32_t> itsVertices;
    for (std::size_t row = 0; row < cells.size(); ++row) {
      for (const SideIndex side : diagram.sides(cells[row])) {
        itsEdges.push_back(Diagram::edgeOf(side));
        for (const VertexIndex vertex : {diagram.originOf(side), diagram.targetOf(side)}) {
          if (vertex != kNone) itsVertices.push_back(vertex);
        }
      }
    }
    edges = Chosen(std::move(itsEdges));
    vertices = Chosen(std::move(itsVertices));
  }

  bool isAll() const { return cells.isAll(); }

  Chosen cells;
  Chosen edges;
  Chosen vertices;
};

}  // namespace circle_voronoi
