// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "attribute_writer.h"
#include "cell_polygons.h"
#include "checks.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/periodic_queries.h"
#include "circle_voronoi/tile.h"
#include "geojson_feature.h"
#include "periodic_options.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

void writeShift(Writer& out, const Shift& shift) { out << "[" << shift[0] << "," << shift[1] << "]"; }

void writeShifts(Writer& out, const PeriodicDiagram& periodic, CircleIndex circle) {
  out << R"(,"shifts":[)";
  writeJoined(out, neighbors(periodic, circle), ",",
              [&](const CircleImage& neighbor) { writeShift(out, neighbor.shift); });
  out << "]";
}

std::vector<CellPolygons::Polygon> movedBack(std::vector<CellPolygons::Polygon> polygons,
                                             const PeriodicDiagram& periodic, CircleIndex circle) {
  const Vector move = offsetOf(periodic.lattice, periodic.shiftOf[static_cast<std::size_t>(circle)]);
  for (auto& polygon : polygons) {
    for (auto& ring : polygon) {
      for (Point& p : ring) p = {p.x - move.x, p.y - move.y};
    }
  }
  return polygons;
}

/// Writes the cell of each chosen circle as a feature, with a separator between them. Returns whether there is a
/// feature. In a periodic diagram neighbors have shifts, and cells lie where the circles were given.
bool writeFeatures(Writer& out, const ExportFrame& frame, const Selection& selection, std::string_view separator,
                   const PeriodicDiagram* periodic = nullptr) {
  const Diagram& diagram = frame.diagram;
  const CellPolygons polygons(frame);
  const std::vector<double> areas = areasIn(frame);
  const std::vector<CircleIndex> hiders = hidersOf(diagram.hidden, diagram.circles.size());
  std::string_view between;
  bool isAny = false;
  polygons.visit([&](std::int32_t i) {
    if (!selection.contains(i)) return;
    out << between;
    writeFeatureStart(out, frame.attributes, static_cast<std::size_t>(i));
    out << R"("circle":)" << selection.id(i) << R"(,"r":)" << diagram.circles[static_cast<std::size_t>(i)].r
        << R"(,"area":)";
    if (const double area = areas[static_cast<std::size_t>(i)]; std::isinf(area)) {
      out << "null";
    } else {
      out << frame.area(area);
    }
    if (frame.clipped.placeOf(i) == ClippedDiagram::Place::cut) out << R"(,"clipped":true)";
    out << R"(,"neighbors":[)";
    // Periodic diagrams have one for each shift.
    writeJoined(out, periodic == nullptr ? neighborsIn(frame, i) : neighbors(diagram, i), ",",
                [&](CircleIndex neighbor) { out << selection.id(neighbor); });
    out << "]";
    if (periodic != nullptr) writeShifts(out, *periodic, i);
    if (const CircleIndex hider = hiders[static_cast<std::size_t>(i)]; hider != kNone) {
      out << R"(,"hiddenBy":)" << selection.id(hider);
      if (periodic != nullptr) {
        out << R"(,"hiderShift":)";
        writeShift(out, periodic->imageFrom(i, hider).shift);
      }
    }
    if (frame.attributes != nullptr) writeAttributes(out, *frame.attributes, static_cast<std::size_t>(i));
    out << R"(},"geometry":)";
    if (periodic == nullptr) {
      writeGeometry(out, mapped(frame, polygons.polygons(i)));
    } else {
      writeGeometry(out, movedBack(polygons.polygons(i), *periodic, i));
    }
    out << "}";
    between = separator;
    isAny = true;
  });
  return isAny;
}

}  // namespace

Result<void> writeGeoJson(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    // A mapped box is no box, so there is no bbox.
    writeCollectionStart(out, options.attributes, frame.place ? nullptr : &frame.box);
    out << (diagram.circles.empty() ? "" : "\n");
    writeFeatures(out, frame, {}, ",\n");
    out << "\n]}\n";
  });
}

Result<void> writeGeoJsonLines(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writePartsGeoJsonLines(stream, diagram, {}, options);
}

namespace {

/// Writes the cells of the given circles.
Result<void> writePeriodic(std::ostream& stream, const PeriodicDiagram& periodic, const ExportOptions& options,
                           bool isCollection, std::string_view separator, std::string_view after) {
  return guarded([&]() -> Result<void> {
    const std::vector<std::int64_t> ids(periodic.circleOf.begin(), periodic.circleOf.end());
    std::vector<std::uint8_t> isChosen(ids.size());
    std::fill_n(isChosen.begin(), periodic.circleCount, std::uint8_t{1});
    auto own = periodicOptions(periodic, options);
    if (!own) return own.error();
    const CircleAttributes attributes = imageAttributes(periodic, options.attributes);
    own.value().attributes = &attributes;
    return unguardedWritingIn(stream, periodic.diagram, own.value(), [&](Writer& out, const ExportFrame& frame) {
      if (isCollection) {
        writeCollectionStart(out, &attributes);
        out << "\n";
      }
      writeFeatures(out, frame, {ids, isChosen}, separator, &periodic);
      out << after;
    });
  });
}

}  // namespace

Result<void> writePeriodicGeoJson(std::ostream& stream, const PeriodicDiagram& periodic, const ExportOptions& options) {
  return writePeriodic(stream, periodic, options, true, ",\n", "\n]}\n");
}

Result<void> writePeriodicGeoJsonLines(std::ostream& stream, const PeriodicDiagram& periodic,
                                       const ExportOptions& options) {
  return writePeriodic(stream, periodic, options, false, "\n", periodic.circleCount > 0 ? "\n" : "");
}

Result<void> writePartsGeoJsonLines(std::ostream& stream, const Diagram& diagram, const Selection& selection,
                                    const ExportOptions& options) {
  if (auto checked = checkSelection(selection, diagram.circles.size()); !checked) return checked;
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    if (writeFeatures(out, frame, selection, "\n")) out << "\n";
  });
}

}  // namespace circle_voronoi
