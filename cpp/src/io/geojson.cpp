// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "circle_members.h"
#include "column_names.h"
#include "items.h"
#include "json_reader.h"
#include "text.h"

namespace circle_voronoi {
namespace {

/// Reads the value of a key. A value of another kind is skipped and counts as none. If a key is given twice, the last
/// value counts, as in all of JSON.
template <class Value, class Read>
void readLast(JsonReader& reader, std::optional<Value>& value, JsonKind kind, Read read) {
  value.reset();
  if (reader.kind() == kind) {
    value = read();
  } else {
    reader.skip();
  }
}

void readType(JsonReader& reader, std::optional<std::string>& type) {
  readLast(reader, type, JsonKind::string, [&] { return std::string(reader.string()); });
}

struct Position {
  Point point;
  std::string height;  ///< the third number; empty if there is none
  int numbers = 0;     ///< up to two
};

/// The coordinates of a geometry, as far as circles need them: a position, or a list of positions.
struct Coordinates {
  Position first;
  std::vector<Position> others;
  bool isList = false;
  bool isEmpty = true;
};

/// Reads the rest of a position that has been entered.
Position readPosition(JsonReader& reader, std::string_view text, bool& isEmpty) {
  Position to;
  for (int count = 0; reader.nextItem(); ++count) {
    isEmpty = false;
    const bool isNumber = reader.kind() == JsonKind::number;
    const std::size_t begin = reader.offset();
    if (count < 2 && isNumber && to.numbers == count) {
      (count == 0 ? to.point.x : to.point.y) = reader.number();
      ++to.numbers;
    } else {
      reader.skip();
      if (count == 2 && isNumber) to.height = text.substr(begin, reader.offset() - begin);
    }
  }
  return to;
}

Coordinates readCoordinates(JsonReader& reader, std::string_view text) {
  Coordinates result;
  const auto before = reader.place();
  reader.enterArray();
  result.isList = reader.nextItem() && reader.kind() == JsonKind::array;
  reader.goTo(before);
  reader.enterArray();
  if (!result.isList) {
    result.first = readPosition(reader, text, result.isEmpty);
    return result;
  }
  for (bool isFirst = true; reader.nextItem(); isFirst = false) {
    result.isEmpty = false;
    Position position;
    if (reader.kind() == JsonKind::array) {
      reader.enterArray();
      position = readPosition(reader, text, result.isEmpty);
    } else {
      reader.skip();
    }
    if (isFirst) {
      result.first = std::move(position);
    } else {
      result.others.push_back(std::move(position));
    }
  }
  return result;
}

bool isGeometry(std::string_view type) {
  constexpr auto kTypes = std::to_array<std::string_view>(
      {"Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"});
  return std::ranges::find(kTypes, type) != kTypes.end();
}

struct Geometry {
  std::optional<std::string> type;
  std::optional<Coordinates> coordinates;
};

Geometry readGeometry(JsonReader& reader, std::string_view text) {
  Geometry geometry;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, geometry.type);
    } else if (*key == "coordinates") {
      readLast(reader, geometry.coordinates, JsonKind::array, [&] { return readCoordinates(reader, text); });
    } else {
      reader.skip();
    }
  }
  return geometry;
}

/// Returns the reason why a geometry is not points; empty if it is.
std::string problemOf(const std::optional<Geometry>& geometry) {
  if (!geometry) return " has no geometry.";
  if (!geometry->type) return " has a geometry without a type.";
  const std::string& type = *geometry->type;
  if (type != "Point" && type != "MultiPoint") return " is a " + type + "; a circle needs a Point.";
  const auto& coordinates = geometry->coordinates;
  if (coordinates && coordinates->isEmpty) return " is an empty " + type + ".";
  const auto isRight = [](const Position& position) { return position.numbers == 2; };
  const bool arePositions = coordinates && coordinates->isList == (type == "MultiPoint") &&
                            isRight(coordinates->first) && std::ranges::all_of(coordinates->others, isRight);
  return arePositions ? "" : " is a " + type + " without two numbers as its coordinates.";
}

/// Reads features: those of a collection, or a text of features and geometries.
class FeatureReader {
 public:
  FeatureReader(JsonReader& reader, std::string_view text, const ReadOptions& options, Keep keep)
      : reader_(reader), text_(text), names_(options), keep_(keep), items_(options, keep) {}

  ParsedFile readCollection() {
    std::int64_t index = 0;
    items_.read(reader_, [&](ItemReader::Item& item) { readFeature(item, index++, false); });
    return items_.take();
  }

  ParsedFile readLines() {
    for (std::int64_t index = 0; reader_.hasMore(); ++index) {
      items_.readOne(reader_, index, [&](ItemReader::Item& item) { readFeature(item, index, true); });
    }
    return items_.take();
  }

 private:
  void readFeature(ItemReader::Item& item, std::int64_t index, bool mayBeGeometry) {
    std::optional<std::string> type;
    std::optional<Geometry> geometry;
    std::optional<CircleMembers> properties;
    std::optional<Coordinates> own;
    const auto failAsNone = [&] {
      reader_.fail(mayBeGeometry ? "expected a Feature, a Point or a MultiPoint."
                                 : "an item of the list of features is no Feature.");
    };
    if (reader_.kind() != JsonKind::object) {
      reader_.skip();  // so that the error points to the end of the value
      failAsNone();
    }
    reader_.enterObject();
    while (const auto key = reader_.nextKey()) {
      if (*key == "type") {
        readType(reader_, type);
      } else if (*key == "geometry") {
        readLast(reader_, geometry, JsonKind::object, [&] { return readGeometry(reader_, text_); });
      } else if (*key == "properties") {
        readLast(reader_, properties, JsonKind::object, [&] {
          CircleMembers members(names_, ColumnNames::kRadius, keep_);
          members.read(reader_, text_);
          return members;
        });
      } else if (*key == "id") {
        const std::string value = rawValue(reader_, text_);
        item.id = isIdValue(value) ? value : "";
      } else if (*key == "coordinates") {
        readLast(reader_, own, JsonKind::array, [&] { return readCoordinates(reader_, text_); });
      } else {
        reader_.skip();
      }
    }
    if (mayBeGeometry && type && isGeometry(*type)) {
      geometry = {*type, std::move(own)};
      type = "Feature";
    }
    if (type != "Feature") failAsNone();
    if (names_.hasId() && properties) item.id = properties->id();
    const auto failure = [&](const std::string& problem) {
      const std::string id = item.id.empty() ? "" : " (id " + item.id + ")";
      return reader_.failure("feature " + std::to_string(index) + id + problem);
    };
    if (const std::string problem = problemOf(geometry); !problem.empty()) throw failure(problem);
    const double* r = properties ? properties->number(ColumnNames::kRadius) : nullptr;
    if (r == nullptr && names_.isNeeded(ColumnNames::kRadius)) {
      throw names_.withoutRadius(failure(" has no number as its property " + names_.listOf(ColumnNames::kRadius)));
    }
    auto& [first, others, isList, isEmpty] = *geometry->coordinates;
    item.circle = {first.point.x, first.point.y, r == nullptr ? 0 : *r};
    item.height = std::move(first.height);
    for (Position& position : others) item.others.emplace_back(position.point, std::move(position.height));
    if (properties) item.properties = properties->others();
  }

  JsonReader& reader_;
  std::string_view text_;
  ColumnNames names_;
  Keep keep_;
  ItemReader items_;
};

/// Returns whether a text is not a collection, but a Feature or a geometry, or several of these.
bool isLines(JsonReader reader) {
  std::optional<std::string> type;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "features") return false;
    if (*key == "type") {
      readType(reader, type);
    } else {
      reader.skip();
    }
  }
  return type && (*type == "Feature" || isGeometry(*type));
}

}  // namespace

Result<ParsedFile> readGeoJson(std::string_view text, std::string_view name, const ReadOptions& options,
                               Keep keep) try {
  for (const auto& [option, column] : {std::pair("x", &options.x), std::pair("y", &options.y)}) {
    if (column->empty()) continue;
    Error error =
        errorAt(name, text, 0, std::string("GeoJSON takes no column as ") + option + "; a Point has its coordinates.");
    error.code = ErrorCode::badOption;
    return error;
  }
  JsonReader reader(text);
  (void)reader.hasMore();
  if (isLines(reader)) return FeatureReader(reader, text, options, keep).readLines();
  std::optional<std::string> type;
  std::optional<ParsedFile> circles;
  MemberList others;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, type);
    } else if (*key == "features") {
      readLast(reader, circles, JsonKind::array,
               [&] { return FeatureReader(reader, text, options, keep).readCollection(); });
    } else if (*key == "bbox") {
      reader.skip();  // of points; the output may have another one
    } else {
      std::string member(*key);
      others.emplace_back(std::move(member), rawValue(reader, text));
    }
  }
  reader.finish();
  if (type != "FeatureCollection") {
    return errorAt(name, text, 0, "expected an array of circles, or a GeoJSON FeatureCollection or Feature.");
  }
  if (!circles) return errorAt(name, text, 0, "a FeatureCollection has no list of features.");
  if (keep == Keep::attributes) circles->attributes.collection = membersOf(others);
  return *std::move(circles);
} catch (const ReadError& failure) {
  return errorAt(name, text, failure);
}

}  // namespace circle_voronoi
