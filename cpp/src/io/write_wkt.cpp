// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"
#include "circle_voronoi/export.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

void writeCoordinates(Writer& out, Point p) { out << p.x << " " << p.y; }

void writeWktPolygon(Writer& out, const CellPolygons::Polygon& rings) {
  out << "(";
  writeJoined(out, rings, ", ", [&](const CellPolygons::Ring& ring) {
    out << "(";
    for (const Point& p : ring) {
      writeCoordinates(out, p);
      out << ", ";
    }
    writeCoordinates(out, ring.front());
    out << ")";
  });
  out << ")";
}

}  // namespace

Result<void> writeWkt(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    const CellPolygons polygons(frame);
    polygons.visit([&](std::int32_t i) {
      const auto its = mapped(frame, polygons.polygons(i));
      if (its.empty()) {
        out << "POLYGON EMPTY\n";
        return;
      }
      out << (its.size() == 1 ? "POLYGON " : "MULTIPOLYGON (");
      writeJoined(out, its, ", ", [&](const auto& rings) { writeWktPolygon(out, rings); });
      out << (its.size() == 1 ? "\n" : ")\n");
    });
  });
}

}  // namespace circle_voronoi
