// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "attribute_columns.h"
#include "attribute_writer.h"
#include "circle_voronoi/table.h"
#include "geojson_feature.h"
#include "guarded.h"
#include "json_reader.h"
#include "members.h"
#include "polygons_of_row.h"
#include "valid_polygons.h"
#include "writer.h"
#include "xml_text.h"

namespace circle_voronoi {
namespace {

std::size_t rowsOf(std::span<const Column> columns) { return columns.empty() ? 0 : columns[0].values.size(); }

void checkTable(std::span<const Column> columns, const ClippedPolygons* polygons = nullptr) {
  const auto refuse = [](std::string message) { throw ThrownError{{ErrorCode::badInput, kNone, std::move(message)}}; };
  const std::size_t rows = rowsOf(columns);
  if (polygons != nullptr && polygons->polygonOffsets.size() != rows + 1) {
    refuse("There are not as many cells as rows.");
  }
  for (const Column& column : columns) {
    if (column.values.size() != rows) refuse("The column " + column.name + " has another number of rows.");
    if (!std::ranges::all_of(column.values, isJsonLine)) refuse("A value of " + column.name + " is not JSON.");
  }
}

void writeRowMembers(Writer& out, std::span<const Column> columns, std::size_t row) {
  writeJoined(out, columns, ",",
              [&](const Column& column) { out << jsonString(column.name) << ":" << column.values[row]; });
}

void writeTableFeatures(Writer& out, std::span<const Column> columns, const ClippedPolygons& polygons,
                        std::string_view separator) {
  for (std::size_t row = 0; row < rowsOf(columns); ++row) {
    if (row > 0) out << separator;
    writeFeatureStart(out, nullptr, row);
    writeRowMembers(out, columns, row);
    out << R"(},"geometry":)";
    writeGeometry(out, polygonsOfRow(polygons, row));
    out << "}";
  }
}

/// "region: North, people: 5": the values of a row that it has.
std::string titleOf(std::span<const Column> columns, std::size_t row) {
  std::string title;
  for (const Column& column : columns) {
    const std::string& value = column.values[row];
    if (value == "null") continue;
    title += (title.empty() ? "" : ", ") + column.name + ": ";
    title += value.starts_with('"') ? std::string(JsonReader(value).string()) : value;
  }
  return title;
}

void writeCellPath(Writer& out, const std::vector<std::vector<PointRing>>& polygons) {
  for (const auto& rings : polygons) {
    for (const PointRing& ring : rings) {
      out << "M";
      writeJoined(out, ring, "L", [&](const Point& p) { out << p.x << " " << p.y; });
      out << "Z";
    }
  }
}

}  // namespace

Result<void> writeTableCsv(std::ostream& stream, std::span<const Column> columns) {
  return guarded([&]() -> Result<void> {
    checkTable(columns);
    return unguardedWriting(stream, [&](Writer& out) {
      const auto writeLine = [&](auto field) {
        writeJoined(out, columns, ",", [&](const Column& column) { out << field(column); });
        out << "\n";
      };
      writeLine([](const Column& column) { return csvText(column.name); });
      for (std::size_t row = 0; row < rowsOf(columns); ++row) {
        writeLine([row](const Column& column) { return csvField(column.values[row]); });
      }
    });
  });
}

Result<void> writeTableJson(std::ostream& stream, std::span<const Column> columns, const ClippedPolygons& polygons) {
  return guarded([&]() -> Result<void> {
    checkTable(columns, &polygons);
    return unguardedWriting(stream, [&](Writer& out) {
      out << "[";
      for (std::size_t row = 0; row < rowsOf(columns); ++row) {
        out << (row > 0 ? ",\n{" : "\n{");
        writeRowMembers(out, columns, row);
        out << R"(,"polygons":)";
        writeMultiPolygon(out, polygonsOfRow(polygons, row));
        out << "}";
      }
      out << "\n]\n";
    });
  });
}

Result<void> writeTableGeoJson(std::ostream& stream, std::span<const Column> columns, const ClippedPolygons& polygons) {
  return guarded([&]() -> Result<void> {
    checkTable(columns, &polygons);
    return unguardedWriting(stream, [&](Writer& out) {
      writeCollectionStart(out, nullptr);
      out << "\n";
      writeTableFeatures(out, columns, polygons, ",\n");
      out << "\n]}\n";
    });
  });
}

Result<void> writeTableGeoJsonLines(std::ostream& stream, std::span<const Column> columns,
                                    const ClippedPolygons& polygons) {
  return guarded([&]() -> Result<void> {
    checkTable(columns, &polygons);
    return unguardedWriting(stream, [&](Writer& out) {
      writeTableFeatures(out, columns, polygons, "\n");
      if (rowsOf(columns) > 0) out << "\n";
    });
  });
}

Result<void> writeTableSvg(std::ostream& stream, std::span<const Column> columns, const ClippedPolygons& polygons,
                           std::span<const int> levels, const Box& box) {
  return guarded([&]() -> Result<void> {
    checkTable(columns, &polygons);
    if (levels.size() != rowsOf(columns)) {
      return errorWith(ErrorCode::badInput, "There are not as many levels as rows.");
    }
    return unguardedWriting(stream, [&](Writer& out) {
      constexpr double kPixels = 1000;
      constexpr double kWider = 1.5;
      const double width = box.maxX - box.minX;
      const double height = box.maxY - box.minY;
      const double unit = std::max(width, height) / kPixels;
      out << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << width / unit << R"(" height=")" << height / unit
          << R"(" viewBox=")" << box.minX << " " << -box.maxY << " " << width << " " << height
          << "\" class=\"circle-voronoi\" role=\"img\">\n<title>Treemap</title>\n"
             "<g transform=\"scale(1,-1)\" stroke=\"#1f4e79\" stroke-linejoin=\"round\">\n";
      const int deepest = levels.empty() ? 0 : *std::ranges::max_element(levels);
      for (int level = deepest; level > 0; --level) {
        out << "<g class=\"level-" << std::int32_t{level} << R"(" fill=")" << (level == deepest ? "#f6f4ee" : "none")
            << R"(" stroke-width=")" << (1 + kWider * (deepest - level)) * unit << "\">\n";
        for (std::size_t row = 0; row < levels.size(); ++row) {
          if (levels[row] != level) continue;
          const auto cell = polygonsOfRow(polygons, row);
          if (cell.empty()) continue;
          out << "<path d=\"";
          writeCellPath(out, cell);
          out << "\"><title>" << xmlText(titleOf(columns, row)) << "</title></path>\n";
        }
        out << "</g>\n";
      }
      out << "</g>\n</svg>\n";
    });
  });
}

}  // namespace circle_voronoi
