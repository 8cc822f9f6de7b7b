// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/io.h"
#include "guarded.h"
#include "json_reader.h"
#include "text.h"
#include "wkb.h"
#include "wkt_reader.h"

namespace circle_voronoi {
namespace {

/// The polygons of all geometries of a text.
struct Polygons {
  std::vector<Point> points;
  std::vector<std::int32_t> ringOffsets = {0};
  std::vector<std::int32_t> polygonOffsets = {0};

  struct Size {
    std::size_t points, rings, polygons;
  };
  Size size() const { return {points.size(), ringOffsets.size(), polygonOffsets.size()}; }
  /// Removes the polygons that were read since the lists had this size.
  void shrinkTo(const Size& before) {
    points.resize(before.points);
    ringOffsets.resize(before.rings);
    polygonOffsets.resize(before.polygons);
  }

  void endRing() { ringOffsets.push_back(static_cast<std::int32_t>(points.size())); }
  void endPolygon() { polygonOffsets.push_back(static_cast<std::int32_t>(ringOffsets.size()) - 1); }
};

constexpr int kPositionHeight = 0;
constexpr int kPolygonHeight = 2;
constexpr int kMultiPolygonHeight = 3;

/// Reads coordinates, and returns how many levels of arrays are above the positions. Returns nothing for an empty
/// array.
std::optional<int> readCoordinates(JsonReader& reader, Polygons& polygons, int depth = 0) {
  reader.enterArray();
  std::optional<int> height;
  Point position;
  int count = 0;
  bool hasEmpty = false;
  for (; reader.nextItem(); ++count) {
    if (reader.kind() == JsonKind::number && (count == 0 || height == kPositionHeight)) {
      height = kPositionHeight;
      const double number = reader.number();
      if (count == 0) position.x = number;
      if (count == 1) position.y = number;
      continue;
    }
    if (height == kPositionHeight && count >= 2) {
      reader.skip();
      continue;
    }
    if (reader.kind() != JsonKind::array || depth > kMultiPolygonHeight) {
      reader.fail("the coordinates are not those of a Polygon or a MultiPolygon.");
    }
    const std::optional<int> below = readCoordinates(reader, polygons, depth + 1);
    if (below && height && *height != *below + 1) {
      reader.fail("the coordinates are not those of a Polygon or a MultiPolygon.");
    }
    if (below) height = *below + 1;
    hasEmpty |= !below;
  }
  // Polygons of a MultiPolygon may be empty.
  if (hasEmpty && height && *height <= 1) reader.fail("a position has fewer than two numbers.");
  if (hasEmpty && height == kPolygonHeight) reader.fail("a ring of the polygon is empty.");
  if (height == kPositionHeight) {
    if (count < 2) reader.fail("a position has fewer than two numbers.");
    polygons.points.push_back(position);
  }
  if (height == 1) polygons.endRing();
  if (height == kPolygonHeight) polygons.endPolygon();
  return height;
}

/// Members of objects in GeoJSON that have coordinates.
constexpr auto kKeysOfPolygons = std::to_array<std::string_view>({"coordinates", "geometry", "features", "geometries"});

void readGeoJsonObject(JsonReader& reader, Polygons& polygons, int depth = 0);

void readObjects(JsonReader& reader, Polygons& polygons, int depth) {
  reader.enterArray();
  while (reader.nextItem()) {
    if (reader.kind() != JsonKind::object) reader.fail("an item of the collection is no object.");
    readGeoJsonObject(reader, polygons, depth);
  }
}

/// Reads a geometry, a Feature or a collection.
void readGeoJsonObject(JsonReader& reader, Polygons& polygons, int depth) {
  if (depth == kMostNested) {
    reader.fail("geometries and collections are nested more than " + std::to_string(kMostNested) + " deep.");
  }
  std::string type;
  std::optional<int> height;
  bool hasCoordinates = false;
  const Polygons::Size before = polygons.size();
  std::string last;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    // The last value of a key that is given twice counts, as in all of JSON.
    if (*key == last) polygons.shrinkTo(before);
    if (std::ranges::find(kKeysOfPolygons, *key) != kKeysOfPolygons.end()) last = *key;
    const JsonKind kind = reader.kind();
    if (*key == "type" && kind == JsonKind::string) {
      type = reader.string();
    } else if (*key == "coordinates" && kind == JsonKind::array) {
      height = readCoordinates(reader, polygons);
      hasCoordinates = true;
    } else if (*key == "geometry" && kind == JsonKind::object) {
      readGeoJsonObject(reader, polygons, depth + 1);
    } else if ((*key == "features" || *key == "geometries") && kind == JsonKind::array) {
      readObjects(reader, polygons, depth + 1);
    } else {
      reader.skip();
    }
  }
  const bool isCollection = type == "Feature" || type == "FeatureCollection" || type == "GeometryCollection";
  if (isCollection && !hasCoordinates) return;
  const bool isPolygon = type == "Polygon" && height.value_or(kPolygonHeight) == kPolygonHeight;
  const bool isMultiPolygon = type == "MultiPolygon" && height.value_or(kMultiPolygonHeight) == kMultiPolygonHeight;
  if (hasCoordinates && (isPolygon || isMultiPolygon)) return;
  if (type.empty()) reader.fail("an object has no type, so it is not GeoJSON.");
  if (type == "Polygon" || type == "MultiPolygon") reader.fail("the coordinates are not those of a " + type + ".");
  reader.fail("a " + type + " has no area; a region is a Polygon or a MultiPolygon.");
}

/// Reads the polygons of well-known text: POLYGON, MULTIPOLYGON or a GEOMETRYCOLLECTION of these.
class WktPolygonReader {
 public:
  explicit WktPolygonReader(std::string_view text) : reader_(text) {}

  Polygons read() {
    (void)reader_.srid();
    readGeometry(0);
    if (polygons_.points.empty()) reader_.fail("the region is empty.");
    reader_.finish();
    return std::move(polygons_);
  }

 private:
  void readGeometry(int depth) {
    if (depth == kMostNested)
      reader_.fail("collections are nested more than " + std::to_string(kMostNested) + " deep.");
    const auto [type, hasHeight, isEmpty] = reader_.head();
    const bool isPolygon = type == "POLYGON";
    if (!(isPolygon || type == "MULTIPOLYGON" || type == "GEOMETRYCOLLECTION")) {
      reader_.fail("expected GeoJSON, POLYGON or MULTIPOLYGON.");
    }
    if (isEmpty) return;
    if (isPolygon) {
      readPolygon();
    } else if (type == "MULTIPOLYGON") {
      reader_.readList([&] { readPolygon(); });
    } else {
      reader_.readList([&] { readGeometry(depth + 1); });
    }
  }

  /// Rings may be EMPTY, and so may the polygon.
  void readPolygon() {
    const Polygons::Size before = polygons_.size();
    bool isFirst = true;
    bool hasOuter = false;
    reader_.readList([&] {
      const std::size_t count = polygons_.points.size();
      reader_.readList([&] { readPosition(); });
      const bool isEmpty = polygons_.points.size() == count;
      if (isFirst) hasOuter = !isEmpty;
      if (!isFirst && !isEmpty && !hasOuter) reader_.fail("a polygon has a hole, but no outer ring.");
      isFirst = false;
      if (!isEmpty) polygons_.endRing();
    });
    if (polygons_.size().rings > before.rings) polygons_.endPolygon();
  }

  void readPosition() {
    Point p;
    p.x = reader_.number();
    p.y = reader_.number();
    while (reader_.hasNumber()) (void)reader_.number();
    polygons_.points.push_back(p);
  }

  WktReader reader_;
  Polygons polygons_;
};

/// Returns a text without the white space around it.
std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlank);
  return text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

/// Reads the polygons of well-known binary in hexadecimal digits. It is one line, so places in its text do not matter.
Polygons readHexPolygons(std::string_view hex) {
  const std::string text = wktOfHexWkb(hex);
  return WktPolygonReader(text).read();
}

Polygons readPolygons(std::string_view text) {
  if (isHexWkb(trimmed(text))) return readHexPolygons(trimmed(text));
  if (firstOf(text) != '{') return WktPolygonReader(text).read();
  Polygons polygons;
  JsonReader reader(text);
  while (reader.hasMore()) readGeoJsonObject(reader, polygons);
  return polygons;
}

}  // namespace

Result<Region> readRegion(std::string_view text, std::string_view name, const RegionOptions& options) {
  return guarded([&]() -> Result<Region> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    const std::string_view rest = content.value();
    try {
      const auto [points, ringOffsets, polygonOffsets] = readPolygons(rest);
      auto region = Region::fromArrays(points, ringOffsets, polygonOffsets, options);
      if (region) return region;
      Error error = withPrefix(region.error(), std::string(name) + ": ");
      // Other errors are about coordinates, or name the option themselves.
      if (!points.empty() && error.code == ErrorCode::badOption && error.option.name.empty() && !options.dissolve) {
        append(error, {" Set ", "`dissolve`", " to repair it.", "dissolve"});
      }
      return error;
    } catch (const ReadError& failure) {
      return errorAt(name, rest, failure.offset, failure.reason);
    }
  });
}

}  // namespace circle_voronoi
