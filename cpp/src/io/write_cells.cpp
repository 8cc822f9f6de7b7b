// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "attribute_columns.h"
#include "checks.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "export_frame.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

/// Writes a measure; `inf` for that of an unbounded cell.
void writeMeasure(Writer& out, const ExportFrame& frame, double value) {
  if (std::isinf(value)) {
    out << "inf";
  } else {
    out << frame.area(value);
  }
}

}  // namespace

Result<void> writeCellsCsv(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    constexpr auto kOwn = std::to_array<std::string_view>({"circle", "area", "perimeter", "neighbors", "hiddenBy"});
    const CircleAttributes none;
    AttributeColumns columns(options.attributes != nullptr ? *options.attributes : none, kOwn);
    const std::vector<double> areas = areasIn(frame);
    const std::vector<double> perimeters = perimetersIn(frame);
    std::vector<CircleIndex> hiders(diagram.circles.size(), kNone);
    for (const auto& [circle, by] : diagram.hidden) hiders[static_cast<std::size_t>(circle)] = by;
    out << "circle,x,y,r,area,perimeter,neighbors,hiddenBy";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const Circle& c = diagram.circles[i];
      const Point center = frame.place ? frame.place({c.x, c.y}) : Point{c.x, c.y};
      out << static_cast<std::int64_t>(i) << "," << center.x << "," << center.y << "," << c.r << ",";
      writeMeasure(out, frame, areas[i]);
      out << ",";
      writeMeasure(out, frame, perimeters[i]);
      out << ",";
      std::string_view space;
      for (const CircleIndex neighbor : neighborsIn(frame, static_cast<std::int32_t>(i))) {
        out << space << neighbor;
        space = " ";
      }
      out << ",";
      if (hiders[i] != kNone) out << hiders[i];
      columns.writeRow(out, i);
      out << "\n";
    }
  });
}

Result<void> writeFoundCsv(std::ostream& stream, std::span<const Circle> points, const CircleAttributes& attributes,
                           std::span<const Found> found, std::span<const std::string> ids) {
  if (found.size() != points.size()) {
    return errorWith(ErrorCode::badInput, "There are not as many results as points.");
  }
  if (auto checked = checkAttributes(attributes, points.size()); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    constexpr auto kOwn = std::to_array<std::string_view>({"circle", "circle_id", "distance"});
    AttributeColumns columns(attributes, kOwn);
    out << "x,y,circle," << (ids.empty() ? "" : "circle_id,") << "distance";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [circle, distance] = found[i];
      out << points[i].x << "," << points[i].y << ",";
      if (circle != kNone) out << circle;
      if (!ids.empty()) out << "," << (circle == kNone ? "" : csvField(ids[static_cast<std::size_t>(circle)]));
      out << ",";
      if (circle != kNone) out << distance;
      columns.writeRow(out, i);
      out << "\n";
    }
  });
}

}  // namespace circle_voronoi
