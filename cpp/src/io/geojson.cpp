// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

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

/// The coordinates of a geometry, as far as a circle needs them: a position, or the first of several.
struct Coordinates {
  double x = 0;
  double y = 0;
  std::string height;
  int numbers = 0;    ///< the numbers of the position, up to two
  int positions = 0;  ///< in a list of positions
  bool isList = false;
  bool isEmpty = true;
};

/// Reads the rest of a position that has been entered.
void readPosition(JsonReader& reader, std::string_view text, Coordinates& to) {
  for (int count = 0; reader.nextItem(); ++count) {
    to.isEmpty = false;
    const bool isNumber = reader.kind() == JsonKind::number;
    const std::size_t begin = reader.offset();
    if (count < 2 && isNumber && to.numbers == count) {
      (count == 0 ? to.x : to.y) = reader.number();
      ++to.numbers;
    } else {
      reader.skip();
      if (count == 2 && isNumber) to.height = text.substr(begin, reader.offset() - begin);
    }
  }
}

Coordinates readCoordinates(JsonReader& reader, std::string_view text) {
  Coordinates result;
  const auto before = reader.place();
  reader.enterArray();
  result.isList = reader.nextItem() && reader.kind() == JsonKind::array;
  reader.goTo(before);
  reader.enterArray();
  if (!result.isList) {
    readPosition(reader, text, result);
    return result;
  }
  for (; reader.nextItem(); ++result.positions) {
    result.isEmpty = false;
    if (result.positions == 0) {
      reader.enterArray();
      readPosition(reader, text, result);
    } else {
      reader.skip();
    }
  }
  return result;
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

/// Returns the reason why a geometry is not one point; empty if it is one.
std::string problemOf(const std::optional<Geometry>& geometry) {
  if (!geometry) return " has no geometry.";
  if (!geometry->type) return " has a geometry without a type.";
  const std::string& type = *geometry->type;
  if (type != "Point" && type != "MultiPoint") return " is a " + type + "; a circle needs a Point.";
  const auto& coordinates = geometry->coordinates;
  if (coordinates && coordinates->isEmpty) return " is an empty " + type + ".";
  if (type == "MultiPoint" && coordinates && coordinates->isList && coordinates->positions > 1) {
    return " is a MultiPoint of " + std::to_string(coordinates->positions) + " points; a circle needs one Point.";
  }
  const bool isPosition = coordinates && coordinates->isList == (type == "MultiPoint") && coordinates->numbers == 2;
  return isPosition ? "" : " is a " + type + " without two numbers as its coordinates.";
}

/// Reads the features of a collection.
class FeatureReader {
 public:
  FeatureReader(JsonReader& reader, std::string_view text, const ReadOptions& options, Keep keep)
      : reader_(reader), text_(text), names_(options), keep_(keep), items_(options, keep) {}

  ParsedFile read() {
    std::int64_t index = 0;
    items_.read(reader_, [&](ItemReader::Item& item) { readFeature(item, index++); });
    return items_.take();
  }

 private:
  void readFeature(ItemReader::Item& item, std::int64_t index) {
    std::optional<std::string> type;
    std::optional<Geometry> geometry;
    std::optional<CircleMembers> properties;
    const auto failAsNone = [&] { reader_.fail("an item of the list of features is no Feature."); };
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
      } else {
        reader_.skip();
      }
    }
    if (type != "Feature") failAsNone();
    if (names_.hasId() && properties) item.id = properties->id();
    const auto fail = [&](const std::string& problem) {
      const std::string id = item.id.empty() ? "" : " (id " + item.id + ")";
      reader_.fail("feature " + std::to_string(index) + id + problem);
    };
    if (const std::string problem = problemOf(geometry); !problem.empty()) fail(problem);
    const double* r = properties ? properties->number(ColumnNames::kRadius) : nullptr;
    if (r == nullptr && names_.isNeeded(ColumnNames::kRadius)) {
      fail(" has no number as its property " + names_.listOf(ColumnNames::kRadius) + ".");
    }
    item.circle = {geometry->coordinates->x, geometry->coordinates->y, r == nullptr ? 0 : *r};
    item.height = geometry->coordinates->height;
    if (properties) item.properties = properties->others();
  }

  JsonReader& reader_;
  std::string_view text_;
  ColumnNames names_;
  Keep keep_;
  ItemReader items_;
};

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
  std::optional<std::string> type;
  std::optional<ParsedFile> circles;
  MemberList others;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "type") {
      readType(reader, type);
    } else if (*key == "features") {
      readLast(reader, circles, JsonKind::array, [&] { return FeatureReader(reader, text, options, keep).read(); });
    } else if (*key == "bbox") {
      reader.skip();  // of points; the output may have another one
    } else {
      std::string member(*key);
      others.emplace_back(std::move(member), rawValue(reader, text));
    }
  }
  reader.finish();
  if (type != "FeatureCollection") {
    return errorAt(name, text, 0, "expected an array of circles or a GeoJSON FeatureCollection.");
  }
  if (!circles) return errorAt(name, text, 0, "a FeatureCollection has no list of features.");
  if (keep == Keep::attributes) circles->attributes.collection = membersOf(others);
  return *std::move(circles);
} catch (const ReadError& failure) {
  return errorAt(name, text, failure);
}

}  // namespace circle_voronoi
