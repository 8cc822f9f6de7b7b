// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "circle_voronoi/export.h"
#include "export_frame.h"
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
  std::map<std::int32_t, std::int32_t> hiders;
  for (const HiddenCircle& hidden : diagram.hidden) hiders[hidden.circle] = hidden.by;
  out << R"({"type":"FeatureCollection","features":[)";
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    out << (i == 0 ? "\n" : ",\n") << R"({"type":"Feature","properties":{"circle":)" << i << R"(,"radius":)"
        << circles[static_cast<std::size_t>(i)].r << R"(,"area":)" << area(outline(frame.cells, i, frame.box))
        << R"(,"neighbors":[)";
    std::string_view separator;
    for (const std::int32_t neighbor : frame.cells.neighbors(i)) {
      out << separator << neighbor;
      separator = ",";
    }
    out << "]";
    if (const auto hider = hiders.find(i); hider != hiders.end()) out << R"(,"hiddenBy":)" << hider->second;
    out << R"(},"geometry":)";
    writeGeometry(out, ringsOf(frame, i));
    out << "}";
  }
  out << "\n]}\n";
}

}  // namespace circle_voronoi
