// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/tile.h"
#include "circle_voronoi_families/families.h"
#include "text.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

Circles read(std::string_view text) {
  const auto circles = readCircles(text, "test");
  EXPECT_TRUE(circles) << circles.error().message;
  return circles ? circles.value() : Circles{};
}

std::string errorOf(std::string_view text) {
  const auto circles = readCircles(text, "test");
  return circles ? "" : circles.error().message;
}

const Circles kTwo = {{1, 2, 3}, {-4.5, 5e-3, 0}};

TEST(ReadCsv, ColumnsAreFoundByNumber) {
  const auto readBy = [](std::string_view text, const ReadOptions& options) {
    const auto file = readCircleFile(text, "test", options);
    EXPECT_TRUE(file) << file.error().message;
    return file ? *file : CircleFile{};
  };
  const ReadOptions options = {.x = "#2", .y = "#3", .radius = "#4", .id = "#1"};
  const CircleFile plain = readBy("a;1;2;3;01\nb;-4,5;5e-3;0\n", options);
  EXPECT_EQ(plain.circles, kTwo);
  EXPECT_EQ(plain.attributes.properties,
            (std::vector<std::string>{R"("column 1":"a","column 5":"01")", R"("column 1":"b","column 5":null)"}));
  EXPECT_EQ(plain.attributes.ids, (std::vector<std::string>{R"("a")", R"("b")"}));
  const CircleFile headed = readBy("a;b;b;;01\na;1;2;3;7\nb;-4,5;5e-3;0;\n", options);
  EXPECT_EQ(headed.circles, kTwo);
  EXPECT_EQ(headed.attributes.properties, (std::vector<std::string>{R"("a":"a","01":7)", R"("a":"b","01":null)"}));
  EXPECT_EQ(headed.attributes.ids, plain.attributes.ids);
  EXPECT_EQ(readBy("1,2,3,a\n-4.5,5e-3,0,b\n", {.x = "#1", .y = "#2", .radius = "#3", .id = "#4"}).attributes.ids,
            plain.attributes.ids)
      << "the last column";
  EXPECT_EQ(readBy("n,x,y,#2\n0,1,2,3\n0,-4.5,5e-3,0\n", {.radius = "#2"}).circles, kTwo) << "a name comes first";
  EXPECT_EQ(readBy("n,x,y,size\n0,1,2,3\n0,-4.5,5e-3,0\n", {.radius = "#4"}).circles, kTwo);
  EXPECT_EQ(readBy("1,2,3\n-4.5,5e-3,0\n", {.x = "#1", .y = "#2", .radius = "#3"}).circles, kTwo);
}

TEST(ReadCsv, NamedColumnsMustExist) {
  const std::vector<std::pair<ReadOptions, std::string>> missing = {
      {{.x = "#1", .y = "#2", .radius = "#4"}, "#4"},
      {{.y = "lat"}, "lat"},
      {{.id = "n"}, "n"},
      {{.x = "#1", .y = "#2", .radius = "#3", .id = "n"}, "n"}};
  for (const auto& [options, name] : missing) {
    const auto circles = readCircles("1,2,3\n", "test", options);
    ASSERT_FALSE(circles) << name;
    EXPECT_NE(circles.error().message.find("called " + name), std::string::npos) << circles.error().message;
  }
  EXPECT_FALSE(readCircles("1,2,3\n", "test", {.x = "#1", .y = "#2"}));
  EXPECT_FALSE(readCircles("[[1,2,3]]", "test", {.id = "n"}));
}

TEST(ReadCsv, PointsNeedNoRadius) {
  const std::vector<Circle> points = {{1, 2, 0}, {-4.5, 5e-3, 0}};
  for (const std::string text : {"1,2\n-4.5,5e-3\n", "1 2 7\n-4.5 5e-3 8\n", "1;2\n-4,5;0,005\n",
                                 "x,y\n1,2\n-4.5,5e-3\n", "[[1,2],[-4.5,5e-3]]"}) {
    const auto read = readCircles(text, "test", {.radii = Radii::none});
    ASSERT_TRUE(read) << text << read.error().message;
    EXPECT_EQ(*read, points) << text;
  }
  EXPECT_EQ(readCircles("1,2\n3,4\n", "test", {.radii = Radii::optional}).value().size(), 2U);
  EXPECT_EQ(readCircles("1,2,3\n", "test", {.radii = Radii::optional}).value()[0].r, 3);
  EXPECT_TRUE(readCircles("1,2\n3\n", "test", {.radii = Radii::none}).error().message.starts_with("test:2: "));
}

TEST(ReadCircles, OtherEncodingsAreNamed) {
  using namespace std::string_view_literals;
  const std::string expected = "test:1: the text is UTF-16; save it as UTF-8.";
  EXPECT_EQ(errorOf("\xFF\xFE"
                    "1\0,\0002\0,\0003\0"sv),
            expected);
  EXPECT_EQ(errorOf("\xFE\xFF\0001"sv), expected);
  EXPECT_EQ(errorOf("1\0,\0002\0"sv), expected);
  EXPECT_EQ(errorOf("\0[\0]"sv), expected);
  const auto region = readRegion("\xFF\xFEP\0"sv, "test");
  ASSERT_FALSE(region);
  EXPECT_EQ(region.error().message, expected);
  EXPECT_EQ(readRegion(" \n", "test").error().message, "test:1: the text is empty.");
  const auto diagram = readDiagram("\xFF\xFE{\0}\0"sv, "test");
  ASSERT_FALSE(diagram);
  EXPECT_EQ(diagram.error().message, expected);
}

TEST(ErrorAt, CountsALineEndOfTwoCharactersOnceWhereverThePlaceIs) {
  const std::string text = "a\r\nb\rc\nd";
  const std::vector<int> lines = {1, 1, 1, 2, 2, 3, 3, 4, 4};
  for (std::size_t offset = 0; offset <= text.size(); ++offset) {
    EXPECT_EQ(errorAt("test", text, offset, "bad").message, "test:" + std::to_string(lines[offset]) + ": bad")
        << offset;
  }
}

TEST(ReadJson, NamesTheLineThatIsWrong) {
  const std::string begin = R"({"type": "FeatureCollection", "features": [)";
  const std::string point =
      R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]}, "properties": )";
  for (const std::string& text :
       std::vector<std::string>{"[[1,2,3],\n[1,2]]", "[[1,2,3],\n[1,2,", "[{\"x\":1,\n\"y\":null,\"r\":1}]",
                                "[[1,2,3]]\n]", begin + "\n" + point + "{}}]}",
                                begin + "\n" + point + R"({"r": -1}}]})", begin + "\n7]}", "{\"type\":\n]"}) {
    EXPECT_TRUE(errorOf(text).starts_with("test:2: ")) << errorOf(text) << " in " << text;
  }
}

/// Whether another parser accepts an error as a JSON string, which must be UTF-8.
testing::AssertionResult isUtf8(const std::string& error) {
  try {
    (void)nlohmann::json(error).dump();
    return testing::AssertionSuccess();
  } catch (const nlohmann::json::exception& problem) {
    return testing::AssertionFailure() << problem.what();
  }
}

TEST(ReadCircles, ErrorsAreUtf8WhateverBytesTheTextHas) {
  std::ostringstream diagram;
  EXPECT_TRUE(writeJson(diagram, compute(Circles{{0, 0, 1}, {6, 0, 1}, {0, 8, 1}}).value()));
  const std::string collection = "{\"type\":\"FeatureCollection\",\"features\":[]}";
  for (const std::string& good :
       {std::string("[[1,2,3],{\"x\":1,\"y\":2,\"r\":3}]"), collection, std::string("x,y,r\n1,2,3\n"), diagram.str()}) {
    for (std::size_t i = 0; i < good.size(); ++i) {
      for (const char byte : {'\xFF', '\x80', '\xC3', '\xE2'}) {
        std::string bad = good;
        bad[i] = byte;
        EXPECT_TRUE(isUtf8(errorOf(bad))) << bad;
        const auto read = readDiagram(bad, "test");
        EXPECT_TRUE(read || isUtf8(read.error().message)) << bad;
      }
    }
  }
  EXPECT_EQ(errorOf("[[1,2,3]\xF0\x9F]"), "test:1: bad JSON: expected , or ], not \"?\".");
  EXPECT_EQ(errorOf("[[1,2,3]\xC3\xA9]"), "test:1: bad JSON: expected , or ], not \"\xC3\xA9\".");
  EXPECT_EQ(errorOf("1,2,a\xE2\x82z\xC2\x9B\n"), "test:1: r is not a number: \"a??z?\".");
  EXPECT_TRUE(isUtf8(errorOf("1,2,x" + std::string(1000, '\xC3') + "\n")));
  EXPECT_LT(errorOf("1,2," + std::string(1000, 'x') + "\n").size(), 350U);
  std::string accents;
  for (int i = 0; i < 500; ++i) accents += "\xC3\xA9";
  for (const char* before : {"", "x"}) EXPECT_TRUE(isUtf8(errorOf("1,2," + (before + accents) + "\n"))) << "cut";
}

TEST(ReadCircles, RejectsTheCirclesThatComputeWouldReject) {
  const auto negative = readCircles("x,y,r\n1,2,3\n1,2,-3\n", "test");
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.error().code, ErrorCode::negativeRadius);
  EXPECT_EQ(negative.error().circle, 1);
  EXPECT_EQ(readCircles("1,inf,3\n", "test").error().code, ErrorCode::nonFinite);
  EXPECT_EQ(readCircles("[[1e200,0,0]]", "test").error().code, ErrorCode::coordinateTooLarge);
}

TEST(ReadRegion, TakesWellKnownTextOfAnyDimension) {
  for (const std::string text :
       {"POLYGON ((0 0, 4 0, 4 4, 0 4))", "POLYGON Z ((0 0 1, 4 0 1, 4 4 1, 0 4 1))",
        "POLYGON M((0 0 1, 4 0 1, 4 4 1, 0 4 1))", "SRID=4326;polygon zm ((0 0 1 2, 4 0 1 2, 4 4 1 2, 0 4 1 2))",
        " \n POLYGON(( 0 +0 ,4 0,4 4 , 0 4 ) ) ;\n", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4)));"}) {
    const auto region = readRegion(text, "test");
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_EQ(region->area(), 16) << text;
  }
}

TEST(ReadRegion, NamesThePlaceWhereWellKnownTextIsWrong) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"SRID=4326 POLYGON ((0 0, 4 0, 4 4))", "test:1: expected ; after SRID."},
           {"LINESTRING (0 0, 4 0)", "test:1: expected GeoJSON, POLYGON or MULTIPOLYGON."},
           {R"({"type":"Point","coordinates":[0,0]})",
            "test:1: a Point has no area; a region is a Polygon or a MultiPolygon."},
           {"\nMULTIPOLYGON Z EMPTY", "test:2: the region is empty."},
           {"POLYGON B ((0 0, 4 0, 4 4))", "test:1: expected an opening parenthesis."},
           {"POLYGON\n(0 0, 4 0, 4 4)", "test:2: expected an opening parenthesis."},
           {"POLYGON ((0 0,\n4 b, 4 4))", "test:2: expected a number."},
           {"POLYGON ((0 0, 4 0, 4", "test:1: expected a number."},
           {"POLYGON ((0 0, 4 0, 4 4)", "test:1: expected a comma or a closing parenthesis."},
           {"POLYGON ((0 0, 4 0, 4 4)))", "test:1: expected nothing after the geometry."},
           {"POLYGON ((0 0, 4 0, 4 4));\n;", "test:2: expected nothing after the geometry."}}) {
    const auto region = readRegion(text, "test");
    ASSERT_FALSE(region) << text;
    EXPECT_EQ(region.error().message, message) << text;
  }
}

TEST(ReadRegion, OfAMemberThatIsGivenTwiceTheLastValueCounts) {
  const std::string ring = "[[[0, 0], [4, 0], [4, 4], [0, 4]]]";
  const auto region = readRegion(
      R"({"type": "Polygon", "coordinates": [[[9, 9], [8, 9], [8, 8]]], "coordinates": )" + ring + "}", "test");
  ASSERT_TRUE(region) << region.error().message;
  EXPECT_EQ(region->area(), 16);
}

TEST(ReadRegion, TakesEachGeoJsonObjectWithPolygons) {
  const std::string polygon = R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]})";
  const std::string polygons =
      R"({"coordinates": [[[[5, 0], [7, 0], [7, 2]]], [[[5, 3], [6, 3], [6, 4]]]], "type": "MultiPolygon"})";
  const auto feature = [](const std::string& geometry) {
    return R"({"type": "Feature", "geometry": )" + geometry + "}";
  };
  const std::vector<std::pair<std::string, double>> areas = {
      {polygon, 16},
      {polygons, 2.5},
      {feature(polygon), 16},
      {R"({"type": "Polygon", "coordinates": [[[0, 0, null], [4, 0, "a", 7], [4, 4, 1], [0, 4]]]})", 16},
      {R"({"type": "GeometryCollection", "geometries": [)" + polygon + ", " + polygons + "]}", 18.5},
      {R"({"type": "FeatureCollection", "features": [)" + feature(polygon) + ", " + feature(polygons) + "]}", 18.5},
      {feature(R"({"type": "GeometryCollection", "geometries": [)" + polygon + "]}"), 16}};
  for (const auto& [text, area] : areas) {
    const auto region = readRegion(text, "test");
    ASSERT_TRUE(region) << region.error().message << " " << text;
    EXPECT_EQ(region->area(), area) << text;
  }
}

TEST(ReadRegion, RefusesPositionsOfOneNumberAndListsOfOtherDepth) {
  for (const auto& [coordinates, message] : std::vector<std::pair<std::string, std::string>>{
           {"[[[0, 0], [4], [4, 4]]]", "test:1: a position has fewer than two numbers."},
           {"[[[], [4, 0], [4, 4]]]", "test:1: a position has fewer than two numbers."},
           {"[[[0, []], [4, 0], [4, 4]]]", "test:1: a position has fewer than two numbers."},
           {"[[], [[0, 0], [4, 0], [4, 4]]]", "test:1: a ring of the polygon is empty."},
           {"[[[0, 0], [4, 0], [[4, 4]]]]", "test:1: the coordinates are not those of a Polygon or a MultiPolygon."},
           {"[[[0, 0], [4, 0], 4]]", "test:1: the coordinates are not those of a Polygon or a MultiPolygon."},
           {"[[[[[[0, 0]]]]]]", "test:1: the coordinates are not those of a Polygon or a MultiPolygon."},
           {"[]", "test: The region has no ring."},
           {"[[0, 0], [4, 0], [4, 4]]", "test:1: the coordinates are not those of a Polygon."}}) {
    const auto region = readRegion(R"({"type": "Polygon", "coordinates": )" + coordinates + "}", "test");
    ASSERT_FALSE(region) << coordinates;
    EXPECT_EQ(region.error().message, message) << coordinates;
  }
}

TEST(WriteCsv, ReadsBackToTheSameBits) {
  for (const FamilyInfo& family : families()) {
    const auto circles = generate(family.family, 50, 3);
    std::ostringstream text;
    EXPECT_TRUE(writeCirclesCsv(text, circles));
    EXPECT_EQ(read(text.str()), circles) << family.name;
  }
}

nlohmann::json numbersOf(const auto& indices) {
  auto numbers = nlohmann::json::array();
  for (const std::int32_t index : indices) numbers.push_back(index);
  return numbers;
}

TEST(WriteJson, HoldsTheDiagramToTheBit) {
  const auto circles = generate(Family::hidden, 60, 1);
  const Diagram diagram = compute(circles).value();
  std::ostringstream text;
  EXPECT_TRUE(writeJson(text, diagram));
  const auto json = nlohmann::json::parse(text.str());

  EXPECT_EQ(json.at("format"), "circle-voronoi");
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_EQ(read(json.at("circles").dump()), circles);
  ASSERT_EQ(json.at("hidden").size(), diagram.hidden.size());
  for (std::size_t i = 0; i < diagram.hidden.size(); ++i) {
    EXPECT_EQ(json["hidden"][i]["circle"], std::int32_t{diagram.hidden[i].circle});
    EXPECT_EQ(json["hidden"][i]["by"], std::int32_t{diagram.hidden[i].by});
  }
  ASSERT_EQ(json.at("vertices").size(), diagram.vertices.size());
  for (std::size_t i = 0; i < diagram.vertices.size(); ++i) {
    const auto& vertex = json["vertices"][i];
    EXPECT_EQ(vertex["x"].get<double>(), diagram.vertices[i].x);
    EXPECT_EQ(vertex["y"].get<double>(), diagram.vertices[i].y);
    EXPECT_EQ(vertex["r"].get<double>(), diagram.vertices[i].r);
    EXPECT_EQ(vertex["circles"], numbersOf(diagram.vertexCircles[i]));
  }
  ASSERT_EQ(json.at("edges").size(), diagram.edges.size());
  for (std::size_t i = 0; i < diagram.edges.size(); ++i) {
    const Edge& edge = diagram.edges[i];
    EXPECT_EQ(json["edges"][i]["circles"], numbersOf(std::array{edge.left, edge.right}));
    EXPECT_EQ(json["edges"][i]["vertices"], numbersOf(std::array{edge.start, edge.end}));
  }
  EXPECT_EQ(json.at("hull"), numbersOf(diagram.hull));
  EXPECT_EQ(json.at("stats").at("counts").at("circles"), 60);
  EXPECT_EQ(json.at("stats").at("seconds").at("total").get<double>(), diagram.stats.seconds.total);
  EXPECT_EQ(json.at("stats").at("certificate").at("certified"), true);
}

TEST(WriteJson, TheStatsAloneAreTheSame) {
  const auto circles = generate(Family::uniform, 5, 1);
  const Diagram diagram = compute(circles).value();
  std::ostringstream all;
  std::ostringstream stats;
  EXPECT_TRUE(writeJson(all, diagram));
  EXPECT_TRUE(writeStatsJson(stats, diagram));
  EXPECT_EQ(nlohmann::json::parse(all.str()).at("stats"), nlohmann::json::parse(stats.str()));
}

TEST(WriteJson, OfNoCirclesIsValid) {
  std::ostringstream text;
  EXPECT_TRUE(writeJson(text, compute({}).value()));
  const auto json = nlohmann::json::parse(text.str());
  EXPECT_EQ(json.at("circles").size(), 0U);
  EXPECT_EQ(json.at("vertices").size(), 0U);
}

}  // namespace
}  // namespace circle_voronoi
