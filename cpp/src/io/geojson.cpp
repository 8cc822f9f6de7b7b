// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "json_reading.h"
#include "text.h"

namespace circle_voronoi {
namespace {

/// Of an item of the list `features` of the outermost object; a feature may hold others among its properties.
constexpr int kFeatureDepth = 2;

bool hasType(const Json& value, std::string_view type) {
  if (!value.is_object()) return false;
  const auto found = value.find("type");
  return found != value.end() && *found == type;
}

/// Reads the circle of a feature, or says what is wrong with it.
std::optional<std::string> readFeature(const Json& feature, Circle& circle) {
  const Json geometry = at(feature, "geometry");
  if (!hasType(geometry, "Point")) return "the geometry of a feature is not a Point.";
  const Json coordinates = at(geometry, "coordinates");
  if (!coordinates.is_array() || coordinates.size() < 2 || !coordinates[0].is_number() || !coordinates[1].is_number()) {
    return "a Point has no two numbers as its coordinates.";
  }
  const Json properties = at(feature, "properties");
  Json radius = at(properties, "radius");
  if (radius.is_null()) radius = at(properties, "r");
  if (!radius.is_number()) return "a feature has no number as its property radius.";
  circle = {numberOf(coordinates[0]), numberOf(coordinates[1]), numberOf(radius)};
  return std::nullopt;
}

}  // namespace

Result<NumberedCircles> readGeoJson(std::string_view text, std::string_view name) {
  JsonPosition position(text);
  NumberedCircles result;
  std::optional<Error> error;
  // Features are dropped as soon as they are read, so that memory holds one at a time.
  const auto take = [&](int depth, Json::parse_event_t event, const Json& value) {
    const bool isFeature =
        depth == kFeatureDepth && event == Json::parse_event_t::object_end && hasType(value, "Feature");
    if (!isFeature) return true;
    Circle circle;
    const auto problem = readFeature(value, circle);
    if (problem && !error) error = errorAt(name, position.line(), *problem);
    result.circles.push_back(circle);
    result.lines.push_back(position.line());
    return false;
  };
  try {
    const Json root =
        Json::parse(JsonIterator(text.data(), position), JsonIterator(text.data() + text.size(), position), take);
    if (!hasType(root, "FeatureCollection")) {
      return errorAt(name, 1, "expected an array of circles or a GeoJSON FeatureCollection.");
    }
  } catch (const Json::exception& exception) {
    return errorAt(name, position.line(), reasonOf(exception));
  }
  if (error) return *std::move(error);
  return result;
}

}  // namespace circle_voronoi
