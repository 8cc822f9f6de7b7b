// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "checks.h"
#include "circle_voronoi/tile.h"
#include "tile_row.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

/// The circle of a vertex at an end of an edge that is not beside the edge; kNone at infinity.
std::int32_t thirdCircle(const Diagram& diagram, std::int32_t vertex, const Edge& edge) {
  if (vertex == kNone) return kNone;
  const auto& triple = diagram.vertexCircles[static_cast<std::size_t>(vertex)];
  return *std::ranges::find_if(triple, [&](std::int32_t i) { return i != edge.left && i != edge.right; });
}

}  // namespace

Result<void> writePartsCsv(std::ostream& stream, const Diagram& diagram, const Selection& selection) {
  if (auto checked = checkSelection(selection, diagram.circles.size()); !checked) return checked;
  if (auto checked = checkVertices(diagram); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    out << "type,x,y,r,circle1,circle2,circle3,circle4\n";
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
      auto triple = diagram.vertexCircles[v];
      std::rotate(triple.begin(), std::ranges::min_element(triple), triple.end());
      if (!selection.contains(triple[0])) continue;
      const auto& [x, y, radius] = diagram.vertices[v];
      out << "vertex," << x << "," << y << "," << radius;
      for (const std::int32_t i : triple) out << "," << selection.id(i);
      out << ",\n";
    }
    for (const Edge& edge : diagram.edges) {
      Edge e = edge;
      if (e.left > e.right) e = {edge.right, edge.left, edge.end, edge.start};
      if (!selection.contains(e.left)) continue;
      out << "edge,,,," << selection.id(e.left) << "," << selection.id(e.right) << ","
          << selection.id(thirdCircle(diagram, e.start, e)) << "," << selection.id(thirdCircle(diagram, e.end, e))
          << "\n";
    }
    for (const auto& [circle, by] : diagram.hidden) {
      if (selection.contains(circle)) out << "hidden,,,," << selection.id(circle) << "," << selection.id(by) << ",,\n";
    }
  });
}

Result<void> writeTile(std::ostream& stream, const Tile& tile, std::span<const std::uint8_t> isChosen) {
  const std::size_t count = tile.circles.size();
  if (tile.ids.size() != count || tile.done.size() != count || isChosen.size() != count) {
    return errorWith(ErrorCode::badInput, "The tile's lists do not have as many entries as there are circles.");
  }
  return writing(stream, [&](Writer& out) {
    out << kTileHeader;
    for (std::size_t i = 0; i < tile.circles.size(); ++i) {
      if (isChosen[i] != 0) writeTileRow(tile, i, [&](auto part) { out << part; });
    }
  });
}

}  // namespace circle_voronoi
