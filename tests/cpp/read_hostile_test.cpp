// SPDX-License-Identifier: GPL-3.0-or-later
// Regions that would cost a reader its stack. io_mutation_test.cpp has such circles and diagrams.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/tile.h"

namespace circle_voronoi {
namespace {

constexpr std::size_t kDepth = 200'000;

std::string nested(std::string_view begin, std::string_view middle, std::string_view end, std::size_t depth = kDepth) {
  std::string text;
  for (std::size_t k = 0; k < depth; ++k) text += begin;
  text += middle;
  for (std::size_t k = 0; k < depth; ++k) text += end;
  return text;
}

const std::string kPolygon = R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4]]]})";

TEST(ReadHostile, GeometriesNestedTooDeepAreOneError) {
  const std::vector<std::pair<std::string, std::string>> levels = {
      {R"({"geometry":)", "}"},
      {R"({"type":"Feature","geometry":)", "}"},
      {R"({"type":"GeometryCollection","geometries":[)", "]}"},
      {R"({"type":"FeatureCollection","features":[)", "]}"}};
  for (const auto& [begin, end] : levels) {
    for (const std::string& text : {nested(begin, kPolygon, end), nested(begin, "", "")}) {
      const auto region = readRegion(text, "text");
      ASSERT_FALSE(region);
      EXPECT_EQ(region.error().code, ErrorCode::badInput);
      EXPECT_EQ(region.error().message, "text:1: geometries and collections are nested more than 100 deep.");
    }
  }
  const auto region = readRegion(nested(R"({"type":"GeometryCollection","geometries":[)", kPolygon, "]}", 99), "text");
  ASSERT_TRUE(region) << region.error().message;
  EXPECT_EQ(region->area(), 8);
}

TEST(ReadHostile, NothingElseThatIsNestedTakesTheStack) {
  const std::string arrays = nested("[", "", "]");
  for (const std::string& text :
       {arrays, nested("[", "", ""), nested("(", "", ""), "POLYGON " + nested("(", "", ")"),
        "MULTIPOLYGON " + nested("(", "1 2", ")"), R"({"type":"Polygon","coordinates":)" + arrays + "}",
        R"({"type":"Polygon","a":)" + nested(R"({"a":)", "1", "}") + "," + kPolygon.substr(1),
        R"({"type":"FeatureCollection","features":)" + arrays + "}"}) {
    const auto region = readRegion(text, "text");
    EXPECT_TRUE(region || region.error().message.starts_with("text:")) << region.error().message;
  }
  if (const auto file = readCircleFile(R"([{"x":1,"y":1,"r":1,"a":)" + arrays + "}]", "text")) {
    (void)numbersIn(file->attributes, "a");
  }
}

}  // namespace
}  // namespace circle_voronoi
