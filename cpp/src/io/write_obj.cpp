// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"
#include "circle_voronoi/export.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

/// Points, and then the element that joins them, which counts all points of the file from 1.
void writeElement(Writer& out, std::string_view element, const std::vector<Point>& points, std::int64_t& count) {
  for (const Point& p : points) out << "v " << p.x << " " << p.y << " 0\n";
  out << element;
  for (std::size_t i = 0; i < points.size(); ++i) out << " " << ++count;
  out << "\n";
}

/// A closed line.
void writeLoop(Writer& out, const std::vector<Point>& points, std::int64_t& count) {
  const std::int64_t first = count + 1;
  for (const Point& p : points) out << "v " << p.x << " " << p.y << " 0\n";
  out << "l";
  for (std::size_t i = 0; i < points.size(); ++i) out << " " << ++count;
  out << " " << first << "\n";
}

}  // namespace

Result<void> writeObj(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    const CellPolygons polygons(frame);
    std::int64_t count = 0;
    const auto& [minX, minY, maxX, maxY] = frame.box;
    out << "# Voronoi diagram of circles\n# cut to the box " << minX << " " << minY << " " << maxX << " " << maxY
        << "\no edges\n";
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
      for (const auto& line : polygons.polylines(e)) writeElement(out, "l", line, count);
    }
    out << "o cells\n";
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
      out << "g circle" << i << "\n";
      for (const auto& rings : polygons.polygons(i)) {
        writeElement(out, "f", rings.front(), count);
        // A face has no holes: lines show them.
        for (std::size_t k = 1; k < rings.size(); ++k) writeLoop(out, rings[k], count);
      }
    }
  });
}

}  // namespace circle_voronoi
