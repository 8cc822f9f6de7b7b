// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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

/// The area and the perimeter of a cell; nothing for an unbounded cell.
struct Measures {
  double area;
  double perimeter;
};

std::vector<std::optional<Measures>> measuresIn(const ExportFrame& frame) {
  const Diagram& diagram = frame.diagram;
  std::vector<std::optional<Measures>> result(diagram.circles.size());
  if (frame.isClipped) {
    const auto areas = frame.clipped.areas();
    const auto perimeters = frame.clipped.perimeters();
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {areas[i], perimeters[i]};
    return result;
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const CircleIndex circle = static_cast<std::int32_t>(i);
    const Outline whole = outline(diagram, circle);
    if (whole.empty() && diagram.hasCell(circle)) continue;
    result[i] = {area(whole), perimeter(whole)};
  }
  return result;
}

}  // namespace

Result<void> writeCellsCsv(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    constexpr auto kOwn = std::to_array<std::string_view>({"circle", "area", "perimeter", "neighbors", "hiddenBy"});
    const CircleAttributes none;
    AttributeColumns columns(options.attributes != nullptr ? *options.attributes : none, kOwn);
    const auto measures = measuresIn(frame);
    std::vector<CircleIndex> hiders(diagram.circles.size(), kNone);
    for (const auto& [circle, by] : diagram.hidden) hiders[static_cast<std::size_t>(circle)] = by;
    out << "circle,x,y,r,area,perimeter,neighbors,hiddenBy";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const Circle& c = diagram.circles[i];
      const Point center = frame.place ? frame.place({c.x, c.y}) : Point{c.x, c.y};
      out << static_cast<std::int64_t>(i) << "," << center.x << "," << center.y << "," << c.r << ",";
      if (measures[i]) {
        out << frame.area(measures[i]->area) << "," << frame.area(measures[i]->perimeter) << ",";
      } else {
        out << "inf,inf,";
      }
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
