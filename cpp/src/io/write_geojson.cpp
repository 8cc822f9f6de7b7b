// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"
#include "circle_voronoi/export.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

void writePoint(Writer& out, Point p) { out << "[" << p.x << "," << p.y << "]"; }

void writeRing(Writer& out, const std::vector<Point>& ring) {
  out << "[[";
  for (const Point& p : ring) {
    writePoint(out, p);
    out << ",";
  }
  writePoint(out, ring.front());
  out << "]]";
}

void writeGeometry(Writer& out, const std::vector<std::vector<Point>>& rings) {
  if (rings.empty()) {
    out << "null";
    return;
  }
  const bool isOne = rings.size() == 1;
  out << R"({"type":")" << (isOne ? "Polygon" : "MultiPolygon") << R"(","coordinates":)" << (isOne ? "" : "[");
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (i > 0) out << ",";
    writeRing(out, rings[i]);
  }
  out << (isOne ? "}" : "]}");
}

}  // namespace

void writeGeoJson(std::ostream& stream, std::span<const Circle> circles, const Diagram& diagram,
                  const ExportOptions& options) {
  Writer out(stream);
  const ExportFrame frame(circles, diagram, options);
  const CellPolygons polygons(frame);
  std::vector<std::int32_t> hiders(circles.size(), kNone);
  for (const auto& [circle, by] : diagram.hidden) hiders[static_cast<std::size_t>(circle)] = by;
  out << R"({"type":"FeatureCollection","features":[)";
  polygons.visit([&](std::int32_t i) {
    out << (i == 0 ? "\n" : ",\n") << R"({"type":"Feature","properties":{"circle":)" << i << R"(,"radius":)"
        << circles[static_cast<std::size_t>(i)].r << R"(,"area":)" << polygons.area(i) << R"(,"neighbors":[)";
    std::string_view separator;
    for (const std::int32_t side : frame.cells.sides(i)) {
      out << separator << frame.cells.neighborOf(side);
      separator = ",";
    }
    out << "]";
    if (const std::int32_t hider = hiders[static_cast<std::size_t>(i)]; hider != kNone) {
      out << R"(,"hiddenBy":)" << hider;
    }
    out << R"(},"geometry":)";
    writeGeometry(out, polygons.rings(i));
    out << "}";
  });
  out << "\n]}\n";
}

}  // namespace circle_voronoi
