// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
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

Result<void> writeCellsCsv(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return writingIn(stream, diagram, options, [&](Writer& out, const ExportFrame& frame) {
    constexpr auto kOwn = std::to_array<std::string_view>({"circle", "area", "perimeter", "neighbors", "hiddenBy"});
    const CircleAttributes none;
    AttributeColumns columns(options.attributes != nullptr ? *options.attributes : none, kOwn);
    const auto [areas, perimeters] = measuresIn(frame);
    const std::vector<CircleIndex> hiders = hidersOf(diagram.hidden, diagram.circles.size());
    out << "circle,x,y,r,area,perimeter,neighbors,hiddenBy";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const Circle& c = diagram.circles[i];
      const Point center = frame.place ? frame.place({c.x, c.y}) : Point{c.x, c.y};
      out << static_cast<std::int64_t>(i) << "," << center.x << "," << center.y << "," << c.r << ",";
      writeCellColumns(out, frame.area(areas[i]), frame.area(perimeters[i]),
                       neighborsIn(frame, static_cast<std::int32_t>(i)), hiders[i]);
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
