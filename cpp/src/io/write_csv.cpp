// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "circle_voronoi/export.h"
#include "digits.h"
#include "writer.h"

namespace circle_voronoi {

Result<void> writeDiagramCsv(std::ostream& stream, const Diagram& diagram, std::optional<int> digits) {
  if (auto checked = checkDigits(digits); !checked) return checked;
  if (auto checked = checkVertices(diagram); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    const DecimalGrid grid(digits);
    out << "type,index,x,y,r,circle1,circle2,circle3,start,end\n";
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
      const auto& [x, y, radius] = diagram.vertices[v];
      const auto& [i, j, k] = diagram.vertexCircles[v];
      out << "vertex," << static_cast<std::int64_t>(v) << "," << grid.round(x) << "," << grid.round(y) << ","
          << grid.round(radius) << "," << i << "," << j << "," << k << ",,\n";
    }
    for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
      const auto& [left, right, start, end] = diagram.edges[e];
      out << "edge," << static_cast<std::int64_t>(e) << ",,,," << left << "," << right << ",," << start << "," << end
          << "\n";
    }
  });
}

}  // namespace circle_voronoi
