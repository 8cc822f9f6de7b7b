// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"
#include "checks.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/tile.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

void writePosition(Writer& out, Point p) { out << "[" << p.x << "," << p.y << "]"; }

void writePolygon(Writer& out, const CellPolygons::Polygon& rings) {
  std::string_view separator = "[[";
  for (const auto& ring : rings) {
    out << separator;
    for (const Point& p : ring) {
      writePosition(out, p);
      out << ",";
    }
    writePosition(out, ring.front());
    out << "]";
    separator = ",[";
  }
  out << "]";
}

void writeGeometry(Writer& out, const std::vector<CellPolygons::Polygon>& polygons) {
  if (polygons.empty()) {
    out << "null";
    return;
  }
  const bool isOne = polygons.size() == 1;
  out << R"({"type":")" << (isOne ? "Polygon" : "MultiPolygon") << R"(","coordinates":)" << (isOne ? "" : "[");
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (i > 0) out << ",";
    writePolygon(out, polygons[i]);
  }
  out << (isOne ? "}" : "]}");
}

/// Writes the cell of each chosen circle as a feature, with a separator between them; whether there is one.
bool writeFeatures(Writer& out, const ExportFrame& frame, const Selection& selection, std::string_view separator) {
  const Diagram& diagram = frame.diagram;
  const CellPolygons polygons(frame);
  std::vector<std::int32_t> hiders(diagram.circles.size(), kNone);
  for (const auto& [circle, by] : diagram.hidden) hiders[static_cast<std::size_t>(circle)] = by;
  std::string_view between;
  bool isAny = false;
  polygons.visit([&](std::int32_t i) {
    if (!selection.contains(i)) return;
    out << between << R"({"type":"Feature","properties":{"circle":)" << selection.id(i) << R"(,"r":)"
        << diagram.circles[static_cast<std::size_t>(i)].r << R"(,"area":)" << frame.area(polygons.area(i))
        << R"(,"neighbors":[)";
    std::string_view comma;
    for (const SideIndex side : diagram.sides(i)) {
      out << comma << selection.id(diagram.neighborOf(side));
      comma = ",";
    }
    out << "]";
    if (const std::int32_t hider = hiders[static_cast<std::size_t>(i)]; hider != kNone) {
      out << R"(,"hiddenBy":)" << selection.id(hider);
    }
    if (!frame.attributes.empty() && !frame.attributes[static_cast<std::size_t>(i)].empty()) {
      out << "," << frame.attributes[static_cast<std::size_t>(i)];
    }
    out << R"(},"geometry":)";
    writeGeometry(out, polygons.polygons(i));
    out << "}";
    between = separator;
    isAny = true;
  });
  return isAny;
}

}  // namespace

Result<void> writeGeoJson(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    out << R"({"type":"FeatureCollection","features":[)" << (diagram.circles.empty() ? "" : "\n");
    writeFeatures(out, frame, {}, ",\n");
    out << "\n]}\n";
  });
}

Result<void> writeGeoJsonLines(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writePartsGeoJsonLines(stream, diagram, {}, options);
}

Result<void> writePartsGeoJsonLines(std::ostream& stream, const Diagram& diagram, const Selection& selection,
                                    const ExportOptions& options) {
  if (auto checked = checkSelection(selection, diagram.circles.size()); !checked) return checked;
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    if (writeFeatures(out, frame, selection, "\n")) out << "\n";
  });
}

}  // namespace circle_voronoi
