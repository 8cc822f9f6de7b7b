// SPDX-License-Identifier: GPL-3.0-or-later
#include "geojson_feature.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "attribute_writer.h"
#include "circle_voronoi/point.h"
#include "members.h"

namespace circle_voronoi {
namespace {

void writePosition(Writer& out, Point p) { out << "[" << p.x << "," << p.y << "]"; }

void writePolygon(Writer& out, const std::vector<PointRing>& rings) {
  out << "[";
  writeJoined(out, rings, ",", [&](const PointRing& ring) {
    out << "[";
    for (const Point& p : ring) {
      writePosition(out, p);
      out << ",";
    }
    writePosition(out, ring.front());
    out << "]";
  });
  out << "]";
}

}  // namespace

void writeMultiPolygon(Writer& out, const std::vector<std::vector<PointRing>>& polygons) {
  out << "[";
  writeJoined(out, polygons, ",", [&](const auto& rings) { writePolygon(out, rings); });
  out << "]";
}

void writeGeometry(Writer& out, const std::vector<std::vector<PointRing>>& polygons) {
  if (polygons.empty()) {
    out << "null";
    return;
  }
  const bool isOne = polygons.size() == 1;
  out << R"({"type":")" << (isOne ? "Polygon" : "MultiPolygon") << R"(","coordinates":)";
  if (isOne) {
    writePolygon(out, polygons[0]);
  } else {
    writeMultiPolygon(out, polygons);
  }
  out << "}";
}

void writeAttributes(Writer& out, const CircleAttributes& attributes, std::size_t circle) {
  const std::string_view height = entryOf(attributes.heights, circle);
  const auto isOwn = [&](std::string_view name) {
    constexpr std::array<std::string_view, 8> kWritten = {"circle",    "r",        "area",   "clipped",
                                                          "neighbors", "hiddenBy", "shifts", "hiderShift"};
    return std::ranges::find(kWritten, name) != kWritten.end() || (!height.empty() && name == "z");
  };
  visitProperties(attributes, circle, isOwn, [&](std::string_view name, std::string_view value) {
    out << "," << jsonString(name) << ":" << value;
  });
  if (!height.empty()) out << R"(,"z":)" << height;
}

}  // namespace circle_voronoi
