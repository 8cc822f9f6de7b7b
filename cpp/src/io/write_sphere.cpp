// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "attribute_columns.h"
#include "attribute_writer.h"
#include "checks.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/sphere_io.h"
#include "diagram_json.h"
#include "digits.h"
#include "elementary.h"
#include "export_frame.h"
#include "geojson_feature.h"
#include "valid_polygons.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

const CircleAttributes kNoAttributes;

const CircleAttributes& attributesOf(const SphereExportOptions& options) {
  return options.attributes != nullptr ? *options.attributes : kNoAttributes;
}

Result<void> check(const SphereDiagram& diagram, const SphereExportOptions& options) {
  if (auto checked = checkDigits(options.digits); !checked) return checked;
  if (!std::isfinite(options.maxDistance.value_or(0))) {
    return errorWith(ErrorCode::badOption, "The maximum distance must be a finite number.");
  }
  return checkAttributes(attributesOf(options), diagram.caps.size());
}

/// The polygons of a row, rounded. Polygons whose rings would cross by rounding keep all digits.
std::vector<std::vector<PointRing>> rowOf(const ClippedPolygons& all, std::size_t row, const DecimalGrid& grid) {
  const auto at = [](const auto& list, std::size_t i) { return static_cast<std::size_t>(list[i]); };
  std::vector<std::vector<PointRing>> polygons;
  for (std::size_t p = at(all.polygonOffsets, row); p < at(all.polygonOffsets, row + 1); ++p) {
    std::vector<PointLoop> exact;
    std::vector<PointLoop> rounded;
    for (std::size_t ring = at(all.ringOffsets, p); ring < at(all.ringOffsets, p + 1); ++ring) {
      const bool isHole = !exact.empty();
      exact.push_back({{}, isHole});
      rounded.push_back({{}, isHole});
      for (std::size_t k = at(all.pointOffsets, ring); k < at(all.pointOffsets, ring + 1); ++k) {
        const Point point = all.points[k];
        const Point on = {grid.round(point.x), grid.round(point.y)};
        exact.back().points.push_back(point);
        PointRing& points = rounded.back().points;
        if (points.empty() || points.back() != on) points.push_back(on);
      }
      PointRing& points = rounded.back().points;
      while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    }
    std::vector<std::vector<PointRing>> rings(1);
    for (const PointLoop& loop : rounded) rings[0].push_back(loop.points);
    const bool isValid = static_cast<bool>(Region::fromPolygons(rings));
    for (auto& polygon : isValid ? std::move(rings) : validPolygons(std::move(exact))) {
      polygons.push_back(std::move(polygon));
    }
  }
  return polygons;
}

Result<void> writeFeatures(std::ostream& stream, const SphereDiagram& diagram, const SphereExportOptions& options,
                           bool isCollection) {
  if (auto checked = check(diagram, options); !checked) return checked;
  const auto polygons = cellPolygons(diagram, {options.tolerance, options.maxDistance});
  if (!polygons) return polygons.error();
  const double tolerance = options.tolerance.value_or(kSphereTolerance * diagram.radius);
  const DecimalGrid grid = options.digits ? DecimalGrid(options.digits)
                                          : DecimalGrid(kRoundingShare * tolerance / (diagram.radius * kDegree));
  const DecimalGrid areaGrid(options.digits);
  return writing(stream, [&](Writer& out) {
    const std::vector<double> areas = circle_voronoi::areas(diagram, options.maxDistance);
    const std::vector<CircleIndex> hiders = hidersOf(diagram.hidden, diagram.caps.size());
    if (isCollection) {
      writeCollectionStart(out, options.attributes);
      out << (diagram.caps.empty() ? "" : "\n");
    }
    for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
      if (i > 0) out << (isCollection ? ",\n" : "\n");
      writeFeatureStart(out, options.attributes, i);
      out << R"("circle":)" << static_cast<std::int64_t>(i) << R"(,"r":)" << diagram.caps[i].r << R"(,"area":)"
          << areaGrid.round(areas[i]) << R"(,"neighbors":[)";
      writeJoined(out, neighbors(diagram, static_cast<std::int32_t>(i)), ",");
      out << "]";
      if (hiders[i] != kNone) out << R"(,"hiddenBy":)" << hiders[i];
      if (options.attributes != nullptr) writeAttributes(out, *options.attributes, i);
      out << R"(},"geometry":)";
      writeGeometry(out, rowOf(*polygons, i, grid));
      out << "}";
    }
    out << (isCollection ? "\n]}\n" : diagram.caps.empty() ? "" : "\n");
  });
}

}  // namespace

Result<void> writeSphereGeoJson(std::ostream& stream, const SphereDiagram& diagram,
                                const SphereExportOptions& options) {
  return writeFeatures(stream, diagram, options, true);
}

Result<void> writeSphereGeoJsonLines(std::ostream& stream, const SphereDiagram& diagram,
                                     const SphereExportOptions& options) {
  return writeFeatures(stream, diagram, options, false);
}

Result<void> writeSphereCsv(std::ostream& stream, const SphereDiagram& diagram, const SphereExportOptions& options) {
  if (auto checked = check(diagram, options); !checked) return checked;
  return writing(stream, [&](Writer& out) {
    constexpr std::array<std::string_view, 4> kOwn = {"area", "perimeter", "neighbors", "hiddenBy"};
    AttributeColumns columns(attributesOf(options), kOwn);
    const std::vector<double> areas = circle_voronoi::areas(diagram, options.maxDistance);
    const std::vector<double> perimeters = circle_voronoi::perimeters(diagram, options.maxDistance);
    const std::vector<CircleIndex> hiders = hidersOf(diagram.hidden, diagram.caps.size());
    const DecimalGrid grid(options.digits);
    out << "longitude,latitude,r,area,perimeter,neighbors,hiddenBy";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
      const Cap& cap = diagram.caps[i];
      out << cap.longitude << "," << cap.latitude << "," << cap.r << ",";
      writeCellColumns(out, grid.round(areas[i]), grid.round(perimeters[i]),
                       neighbors(diagram, static_cast<std::int32_t>(i)), hiders[i]);
      columns.writeRow(out, i);
      out << "\n";
    }
  });
}

Result<void> writeSphereJson(std::ostream& stream, const SphereDiagram& diagram, const SphereExportOptions& options) {
  if (auto checked = check(diagram, options); !checked) return checked;
  const CircleAttributes& attributes = attributesOf(options);
  return writing(stream, [&](Writer& out) {
    out << "{\"format\": \"circle-voronoi-sphere\", \"version\": 1,\n \"radius\": " << diagram.radius
        << ", \"rounding\": " << diagram.rounding << ",\n ";
    if (diagram.weights) out << "\"weights\": true,\n ";
    if (!attributes.collection.empty()) out << "\"collection\": {" << attributes.collection << "},\n ";
    out << "\"caps\": ";
    writeLines(out, diagram.caps.size(), [&](std::size_t i) {
      const auto& [longitude, latitude, r] = diagram.caps[i];
      out << "{\"longitude\": " << longitude << ", \"latitude\": " << latitude << ", \"r\": " << r;
      writeAttributeMembers(out, attributes, i);
      out << "}";
    });
    out << ",\n \"hidden\": ";
    writeHidden(out, diagram.hidden, "cap");
    out << ",\n \"vertices\": ";
    writeLines(out, diagram.vertices.size(), [&](std::size_t i) {
      const auto& [longitude, latitude, distance] = diagram.vertices[i];
      const auto& [a, b, c] = diagram.vertexCaps[i];
      out << "{\"longitude\": " << longitude << ", \"latitude\": " << latitude << ", \"distance\": " << distance
          << ", \"caps\": [" << a << ", " << b << ", " << c << "]}";
    });
    out << ",\n \"edges\": ";
    writeEdges(out, diagram.edges, "caps");
    out << "}\n";
  });
}

}  // namespace circle_voronoi
