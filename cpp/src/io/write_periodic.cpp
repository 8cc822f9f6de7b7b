// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "checks.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/periodic_queries.h"
#include "diagram_json.h"
#include "digits.h"
#include "periodic_options.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

constexpr double kPeriodicTolerance = 1e-5;  // as in export_frame.cpp

void writeImage(Writer& out, const CircleImage& image) {
  out << "{\"circle\": " << image.circle << ", \"shift\": [" << image.shift[0] << ", " << image.shift[1] << "]}";
}

}  // namespace

Box boxOf(const Lattice& lattice) {
  const auto& [a, b] = lattice;
  const auto range = [](double u, double v) { return std::minmax({0.0, u, v, u + v}); };
  const auto [minX, maxX] = range(a.x, b.x);
  const auto [minY, maxY] = range(a.y, b.y);
  return {minX, minY, maxX, maxY};
}

Result<ExportOptions> periodicOptions(const PeriodicDiagram& periodic, const ExportOptions& options) {
  if (options.bounds || options.region != nullptr || options.maxDistance) {
    return Error{ErrorCode::badOption, kNone, "The cells of a periodic diagram are written whole."};
  }
  if (options.attributes != nullptr) {
    const auto checked = checkAttributes(*options.attributes, static_cast<std::size_t>(periodic.circleCount));
    if (!checked) return checked.error();
  }
  const Diagram& diagram = periodic.diagram;
  Box box = exportBox(diagram.circles);
  for (const Edge& edge : diagram.edges) {
    if (edge.left >= periodic.circleCount && edge.right >= periodic.circleCount) continue;
    for (const VertexIndex vertex : {edge.start, edge.end}) {
      const Vertex& v = diagram.vertices[static_cast<std::size_t>(vertex)];
      box = {std::min(box.minX, v.x), std::min(box.minY, v.y), std::max(box.maxX, v.x), std::max(box.maxY, v.y)};
    }
  }
  // Each point of a cell is nearer to its center than the sum of the periods.
  const Box own = boxOf(periodic.lattice);
  const double margin = (own.maxX - own.minX) + (own.maxY - own.minY);
  ExportOptions result = options;
  result.bounds = Box{box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin};
  result.attributes = nullptr;
  if (!result.tolerance) result.tolerance = kPeriodicTolerance * std::max(own.maxX - own.minX, own.maxY - own.minY);
  return result;
}

CircleAttributes imageAttributes(const PeriodicDiagram& periodic, const CircleAttributes* attributes) {
  if (attributes == nullptr) return {};
  CircleAttributes result = *attributes;
  for (auto* list : {&result.properties, &result.ids, &result.heights}) {
    if (!list->empty()) list->resize(periodic.circleOf.size());
  }
  return result;
}

Result<void> writePeriodicJson(std::ostream& stream, const PeriodicDiagram& periodic, std::optional<int> digits,
                               const CircleAttributes& attributes) {
  const auto known = checkAttributes(attributes, static_cast<std::size_t>(periodic.circleCount));
  if (!known) return known.error();
  if (auto checked = checkDigits(digits); !checked) return checked;
  if (auto checked = checkVertices(periodic.diagram); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    const Vector a = periodic.lattice.a;
    const Vector b = periodic.lattice.b;
    writeDiagram(out, periodic.diagram, digits, imageAttributes(periodic, &attributes), [&] {
      out << "\"lattice\": [[" << a.x << ", " << a.y << "], [" << b.x << ", " << b.y << "]],\n \"images\": ";
      writeLines(out, periodic.circleOf.size(), [&](std::size_t i) {
        writeImage(out, {periodic.circleOf[i], periodic.shiftOf[i]});
      });
      out << ",\n \"neighbors\": ";
      writeLines(out, static_cast<std::size_t>(periodic.circleCount), [&](std::size_t i) {
        out << "[";
        writeJoined(out, neighbors(periodic, static_cast<std::int32_t>(i)), ", ",
                    [&](const CircleImage& image) { writeImage(out, image); });
        out << "]";
      });
      out << ",\n ";
    });
  });
}

Result<void> writeContactsCsv(std::ostream& stream, const PeriodicDiagram& periodic, std::optional<int> digits) {
  if (auto checked = checkDigits(digits); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    const DecimalGrid grid(digits);
    const ContactTable table = contactTable(periodic);
    out << "circle,neighbor,shift_a,shift_b,length,gap,area,packing_fraction\n";
    for (const Contact& contact : table.contacts) {
      const auto i = static_cast<std::size_t>(contact.circle);
      const auto& [neighbor, shift] = contact.neighbor;
      out << contact.circle << "," << neighbor << "," << shift[0] << "," << shift[1] << ","
          << grid.round(contact.length) << "," << grid.round(contact.gap) << "," << grid.round(table.areas[i]) << ",";
      if (!std::isnan(table.packingFractions[i])) out << grid.round(table.packingFractions[i]);
      out << "\n";
    }
  });
}

}  // namespace circle_voronoi
