// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "json_reader.h"
#include "text.h"

namespace circle_voronoi {
namespace {

/// The value of a key that may be given once; a value of another kind is skipped and counts as none.
template <class Value, class Read>
void readOnce(JsonReader& reader, std::optional<Value>& value, JsonKind kind, const std::string& key, Read read) {
  if (value) reader.fail(key + " is given twice.");
  if (reader.kind() == kind) {
    value = read();
  } else {
    reader.skip();
  }
}

void readType(JsonReader& reader, std::optional<std::string>& type) {
  readOnce(reader, type, JsonKind::string, "type", [&] { return std::string(reader.string()); });
}

struct Position {
  double x = 0;
  double y = 0;
};

/// Two numbers, and perhaps more values, such as a height.
Position readPosition(JsonReader& reader) {
  Position position;
  int count = 0;
  reader.enterArray();
  for (; reader.nextItem(); ++count) {
    if (count < 2 && reader.kind() != JsonKind::number) break;
    if (count < 2) {
      (count == 0 ? position.x : position.y) = reader.number();
    } else {
      reader.skip();
    }
  }
  if (count < 2) reader.fail("a Point has no two numbers as its coordinates.");
  return position;
}

struct Geometry {
  std::optional<std::string> type;
  std::optional<Position> position;
};

Geometry readGeometry(JsonReader& reader) {
  Geometry geometry;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, geometry.type);
    } else if (*key == "coordinates") {
      readOnce(reader, geometry.position, JsonKind::array, "coordinates", [&] { return readPosition(reader); });
    } else {
      reader.skip();
    }
  }
  return geometry;
}

struct Radius {
  std::optional<double> radius;
  std::optional<double> r;
};

Radius readProperties(JsonReader& reader) {
  Radius result;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "radius") {
      readOnce(reader, result.radius, JsonKind::number, "radius", [&] { return reader.number(); });
    } else if (*key == "r") {
      readOnce(reader, result.r, JsonKind::number, "r", [&] { return reader.number(); });
    } else {
      reader.skip();
    }
  }
  return result;
}

Circle readFeature(JsonReader& reader, bool points) {
  std::optional<std::string> type;
  std::optional<Geometry> geometry;
  std::optional<Radius> properties;
  if (reader.kind() != JsonKind::object) reader.fail("an item of the list of features is no Feature.");
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, type);
    } else if (*key == "geometry") {
      readOnce(reader, geometry, JsonKind::object, "geometry", [&] { return readGeometry(reader); });
    } else if (*key == "properties") {
      readOnce(reader, properties, JsonKind::object, "properties", [&] { return readProperties(reader); });
    } else {
      reader.skip();
    }
  }
  if (type != "Feature") reader.fail("an item of the list of features is no Feature.");
  if (!geometry || geometry->type != "Point") reader.fail("the geometry of a feature is not a Point.");
  if (!geometry->position) reader.fail("a Point has no two numbers as its coordinates.");
  const auto r = properties && properties->r ? properties->r : properties ? properties->radius : std::nullopt;
  if (!r && !points) reader.fail("a feature has no number as its property r or radius.");
  return {geometry->position->x, geometry->position->y, r.value_or(0)};
}

PlacedCircles readFeatures(JsonReader& reader, bool points) {
  PlacedCircles result;
  reader.enterArray();
  while (reader.nextItem()) {
    result.circles.push_back(readFeature(reader, points));
    result.offsets.push_back(reader.offset());
  }
  return result;
}

}  // namespace

Result<PlacedCircles> readGeoJson(std::string_view text, std::string_view name, bool points) try {
  JsonReader reader(text);
  std::optional<std::string> type;
  std::optional<PlacedCircles> circles;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, type);
    } else if (*key == "features") {
      readOnce(reader, circles, JsonKind::array, "features", [&] { return readFeatures(reader, points); });
    } else {
      reader.skip();
    }
  }
  reader.finish();
  if (type != "FeatureCollection") {
    return errorAt(name, text, 0, "expected an array of circles or a GeoJSON FeatureCollection.");
  }
  if (!circles) return errorAt(name, text, 0, "a FeatureCollection has no list of features.");
  return *std::move(circles);
} catch (const ReadFailure& failure) {
  return errorAt(name, text, failure.offset, failure.reason);
}

}  // namespace circle_voronoi
