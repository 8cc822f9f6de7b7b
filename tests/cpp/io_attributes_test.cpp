// SPDX-License-Identifier: GPL-3.0-or-later
// Data of files about circles beyond x, y and r, and the columns, properties and members that hold it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/periodic_diagram.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;
using Circles = std::vector<Circle>;
using Strings = std::vector<std::string>;

CircleFile fileOf(std::string_view text, const ReadOptions& options = {}) {
  const auto file = readCircleFile(text, "test", options);
  EXPECT_TRUE(file) << file.error().message << "\n" << text;
  return file ? file.value() : CircleFile{};
}

std::string fileErrorOf(std::string_view text, const ReadOptions& options = {}) {
  const auto file = readCircleFile(text, "test", options);
  return file ? "" : file.error().message;
}

/// The values of a column of a table with that column alone, in JSON.
Strings valuesOfColumn(const std::string& rows, char separator = ',') {
  std::string text = "x,y,r,c\n";
  for (const std::string& line : test::linesOf(rows)) text += "0,0,0," + line + "\n";
  if (separator != ',') {
    for (char& c : text) c = c == ',' ? ';' : c == '|' ? ',' : c;
  }
  Strings values;
  for (const std::string& members : fileOf(text).attributes.properties) values.push_back(members.substr(4));
  return values;
}

TEST(ReadCircleFile, AColumnHasOneType) {
  EXPECT_EQ(valuesOfColumn("01001\n1003\n06037"), (Strings{R"("01001")", R"("1003")", R"("06037")"})) << "zeros stay";
  EXPECT_EQ(valuesOfColumn("1\n2\n3.5"), (Strings{"1", "2", "3.5"}));
  EXPECT_EQ(valuesOfColumn("1\nx"), (Strings{R"("1")", R"("x")"}));
  EXPECT_EQ(valuesOfColumn("12345678901234567890\n1.50\n-0\n1e5"),
            (Strings{"12345678901234567890", "1.50", "-0", "1e5"}))
      << "as they are written";
  EXPECT_EQ(valuesOfColumn("1\n\nNA\nNaN\nnull\n2"), (Strings{"1", "null", "null", "null", "null", "2"}))
      << "missing numbers";
  EXPECT_EQ(valuesOfColumn("NA\nDE"), (Strings{R"("NA")", R"("DE")"})) << "Namibia";
  EXPECT_EQ(valuesOfColumn("true\nfalse"), (Strings{"true", "false"}));
  EXPECT_EQ(valuesOfColumn("true\n1"), (Strings{R"("true")", R"("1")"}));
  EXPECT_EQ(valuesOfColumn("\"1\"\n2"), (Strings{R"("1")", R"("2")"})) << "quoted: text";
  EXPECT_EQ(valuesOfColumn("\"\"\nx"), (Strings{R"("")", R"("x")"}));
  EXPECT_EQ(valuesOfColumn("\"[1, 2]\"\n\"{\"\"a\"\": 1}\""), (Strings{"[1, 2]", R"({"a": 1})"}));
  EXPECT_EQ(valuesOfColumn("[1]\nx"), (Strings{R"("[1]")", R"("x")"}));
  EXPECT_EQ(valuesOfColumn("1e999\n1"), (Strings{R"("1e999")", R"("1")"})) << "no double";
  for (const char* text : {"+5", ".5", "5.", "0x5", "1_000", "00", "-01", "1 "}) {
    const bool isTrimmed = std::string(text) == "1 ";
    EXPECT_EQ(valuesOfColumn(text), (Strings{isTrimmed ? "1" : "\"" + std::string(text) + "\""}));
  }
}

TEST(ReadCircleFile, NumbersOfAColumnHaveTheDecimalMarkOfTheTable) {
  EXPECT_EQ(fileOf("x;y;r;c\n0,5;0;0;1,25\n1;0;0;7\n").attributes.properties, (Strings{R"("c":1.25)", R"("c":7)"}));
  EXPECT_EQ(fileOf("x;y;r;c\n0,5;0;0;1.25\n").attributes.properties, Strings{R"("c":"1.25")"});
  EXPECT_EQ(fileOf("x;y;r;c\n0.5;0;0;1,25\n").attributes.properties, Strings{R"("c":"1,25")"}) << "perhaps a list";
  EXPECT_EQ(fileOf("x;y;r;c\n0;0;0;1,25\n").attributes.properties, Strings{R"("c":1.25)"});
  EXPECT_EQ(fileOf("x,y,r,c\n\"0,5\",0,0,7\n").attributes.properties, Strings{R"("c":7)"});
}

TEST(ReadCircleFile, TextIsKeptAsItIs) {
  EXPECT_EQ(fileOf("x,y,r,note\n1,2,3,[1] {a}\n").attributes.properties, Strings{R"("note":"[1] {a}")"});
  EXPECT_EQ(fileOf("x,y,r,note\n1,2,3,\"a\"\"\"\"b\"\n").attributes.properties, Strings{R"("note":"a\"\"b")"});
  EXPECT_EQ(fileOf("x,y,r,note\n1,2,3,\"a\nb\"\n").attributes.properties, Strings{R"("note":"a\u000ab")"});
  EXPECT_EQ(fileErrorOf("x,y,r,note\n1,2,3,caf\xE9\n"),
            "test:2: the text is not UTF-8, perhaps Windows-1252; save it as UTF-8.");
}

TEST(NumbersIn, TakesAColumnWhoseNameIsOneOfTheOutputOrThatIsQuoted) {
  const auto numbers = numbersIn(fileOf("x,y,r,area\n1,2,3,\"4.5\"\n").attributes, "Area");
  ASSERT_TRUE(numbers) << numbers.error().message;
  EXPECT_EQ(*numbers, std::vector<double>{4.5});
  EXPECT_EQ(numbersIn(fileOf("x,y,r,area\n1,2,3,\n").attributes, "area").error().message,
            "circle 0 has no number \"area\".");
  EXPECT_EQ(numbersIn({}, "area").error().message, "there is no column or property \"area\".");
}

TEST(ReadCircleFile, ColumnsAreThoseThatTheUserNames) {
  const Circles circles = {{8.55, 47.4, 1200}};
  const std::string table = "name;lat;lon;umsatz;r\nZ;47,4;8,55;1200;7\n";
  EXPECT_EQ(fileOf(table, {.radius = "Umsatz"}).circles, circles);
  EXPECT_EQ(fileOf(table, {.radius = "umsatz"}).attributes.properties, (Strings{R"("name":"Z","r":7)"}));
  EXPECT_EQ(fileOf(table, {.x = "lat", .y = "lon"}).circles, (Circles{{47.4, 8.55, 7}}));
  EXPECT_EQ(fileOf(table, {.radii = Radii::none}).circles, (Circles{{8.55, 47.4, 0}}));
  EXPECT_EQ(fileOf("lat,lon\n1,2\n", {.radii = Radii::optional}).circles, (Circles{{2, 1, 0}}));
  EXPECT_EQ(fileErrorOf(table, {.radius = "sales"}),
            "test:1: no column is called sales, only name, lat, lon, umsatz, r; name one by the option radius.");
  EXPECT_EQ(fileErrorOf(table, {.id = "code"}), "test:1: no column is called code, only name, lat, lon, umsatz, r.");
  EXPECT_EQ(fileOf("x,y,lon,lat,r\n1,2,3,4,5\n", {.x = "lon", .y = "lat"}).circles, (Circles{{3, 4, 5}}));

  const std::string objects = R"([{"lat": 1, "LON": 2, "Radius": 3, "size": 4, "id": 9}])";
  EXPECT_EQ(fileOf(objects).circles, (Circles{{2, 1, 3}})) << "the same names as in tables";
  EXPECT_EQ(fileOf(objects).attributes.properties, Strings{R"("size":4,"id":9)"});
  EXPECT_EQ(fileOf(objects, {.radius = "size"}).circles, (Circles{{2, 1, 4}}));
  EXPECT_EQ(fileErrorOf(objects, {.radius = "sales"}), "test:1: a circle has no sales.");
  const std::string points = R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties":
    {"RADIUS": 3, "size": 4, "code": "A"}, "geometry": {"type": "Point", "coordinates": [1, 2]}}]})";
  EXPECT_EQ(fileOf(points).circles, (Circles{{1, 2, 3}}));
  EXPECT_EQ(fileOf(points, {.radius = "size"}).circles, (Circles{{1, 2, 4}}));
  EXPECT_EQ(fileOf(points, {.id = "code"}).attributes.ids, Strings{R"("A")"});
  EXPECT_EQ(fileErrorOf(points, {.x = "lon"}), "test:1: GeoJSON takes no column as x; a Point has its coordinates.");
  EXPECT_EQ(fileOf("x,y,r\n1,2,-3\n", {.weights = true}).circles, (Circles{{1, 2, -3}}));
}

TEST(ReadCircleFile, ErrorsNameTheColumnAndTheId) {
  EXPECT_EQ(fileErrorOf("id,lon,lat,r\n1,1,1,0\nb 7,,,0\n"), "test:3: lon is empty (circle 1, id b 7).");
  EXPECT_EQ(fileErrorOf("lon,lat,r\n1,NaN,0\n"), "test:2: lat is not a finite number: \"NaN\".");
  EXPECT_EQ(readCircleFile("lon,lat,r\n1,NaN,0\n", "test").error().code, ErrorCode::nonFinite);
  EXPECT_EQ(readCircleFile("lon,lat,r\n1,1,1\n1,,0\n", "test").error().circle, 1);
  EXPECT_EQ(fileErrorOf("Code,x,y,r\nA,1,1,x\n", {.id = "code"}),
            "test:2: r is not a number: \"x\" (circle 0, Code A).");
}

std::string circleFeature(const std::string& geometry, const std::string& more = "") {
  return R"({"type": "Feature", "properties": {"r": 1}, )" + more + R"("geometry": )" + geometry + "}";
}

std::string circleCollection(const std::string& features, const std::string& more = "") {
  return R"({"type": "FeatureCollection", )" + more + R"("features": [)" + features + "]}";
}

TEST(ReadGeoJson, TheThirdCoordinateIsTheHeight) {
  for (const auto& [coordinates, heights] : std::vector<std::pair<std::string, Strings>>{
           {"[1, 2]", {}}, {"[1, 2, 7.50]", {"7.50"}}, {"[1, 2, 7, 8]", {"7"}}, {"[1, 2, null, 8]", {}}}) {
    const CircleFile file =
        fileOf(circleCollection(circleFeature(R"({"type": "Point", "coordinates": )" + coordinates + "}")));
    EXPECT_EQ(file.circles, (Circles{{1, 2, 1}}));
    EXPECT_EQ(file.attributes.heights, heights) << coordinates;
  }
}

TEST(ReadGeoJson, AMultiPointOfOnePointIsAPoint) {
  EXPECT_EQ(fileOf(circleCollection(circleFeature(R"({"type": "MultiPoint", "coordinates": [[1, 2, 7]]})"))).circles,
            (Circles{{1, 2, 1}}));
  EXPECT_EQ(fileOf(circleCollection(circleFeature(R"({"coordinates": [[1, 2, 7]], "type": "MultiPoint"})")))
                .attributes.heights,
            Strings{"7"});
}

// tests/files/readings.json has more geometries that are refused.
TEST(ReadGeoJson, OtherGeometriesAreRefusedByNameIndexAndId) {
  const std::string good = circleFeature(R"({"type": "Point", "coordinates": [1, 2]})") + ",";
  for (const auto& [geometry, name] :
       std::vector<std::pair<std::string, std::string>>{{"null", "geometry"},
                                                        {"7", "geometry"},
                                                        {R"({"coordinates": [1, 2]})", "type"},
                                                        {R"({"type": "Point"})", "Point"},
                                                        {R"({"type": "MultiPoint", "coordinates": []})", "MultiPoint"},
                                                        {R"({"type": "Polygon", "coordinates": []})", "Polygon"}}) {
    const auto file = readCircleFile(circleCollection(good + circleFeature(geometry, R"("id": "b\"7", )")), "test");
    ASSERT_FALSE(file) << geometry;
    EXPECT_EQ(file.error().circle, 1);
    EXPECT_TRUE(file.error().message.starts_with(R"(test:1: feature 1 (id "b\"7"))")) << file.error().message;
    EXPECT_NE(file.error().message.find(name), std::string::npos) << file.error().message;
  }
}

TEST(ReadCircleFile, InvalidRowsAreSkippedOnRequest) {
  const auto skippedOf = [](const CircleFile& file) {
    Strings reasons;
    for (const Error& error : file.skipped) reasons.push_back(std::to_string(error.circle) + " " + error.message);
    return reasons;
  };
  const auto table = fileOf("id,lon,lat,r\n1,1,1,1\n2,,,1\r\n\n3,NaN,1,1\n4,1,1,-1\n5,1e200,1,1\n6,2,2,x\n7,3,3,3\n",
                            {.skipInvalid = true});
  EXPECT_EQ(table.circles, (Circles{{1, 1, 1}, {3, 3, 3}}));
  EXPECT_EQ(table.attributes.properties, (Strings{R"("id":1)", R"("id":7)"}));
  EXPECT_EQ(skippedOf(table),
            (Strings{"1 test:3: lon is empty (circle 1, id 2).",
                     "2 test:5: lon is not a finite number: \"NaN\" (circle 2, id 3).",
                     "3 test:6: Circle 3 has a negative radius (circle 3, id 4).",
                     "4 test:7: Circle 4 has a coordinate or a radius beyond 7.9e28 (2^96) (circle 4, id 5).",
                     "5 test:8: r is not a number: \"x\" (circle 5, id 6)."}));
  const auto points =
      fileOf(circleCollection(circleFeature("null", R"("id": 7, )") + ",\n" +
                                  circleFeature(R"({"type": "Point", "coordinates": [1, 2]})") + ",\n7,\n" +
                                  circleFeature(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})"),
                              R"("crs": {"a": "b"}, )"),
             {.skipInvalid = true});
  EXPECT_EQ(points.circles, (Circles{{1, 2, 1}}));
  EXPECT_EQ(skippedOf(points), (Strings{"0 test:1: feature 0 (id 7) has no geometry.",
                                        "2 test:3: an item of the list of features is no Feature.",
                                        "3 test:4: feature 3 is a LineString; a circle needs a Point."}));
  const auto objects = fileOf(R"([{"x": 1, "y": 2, "r": 3}, {"x": null}, [1, 2], [4, 5, 6]])", {.skipInvalid = true});
  EXPECT_EQ(objects.circles, (Circles{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(objects.skipped.size(), 2U);
  // The type of a column is that of the rows that stay.
  EXPECT_EQ(fileOf("x,y,r,c\n1,1,1,5\n,,,total\n", {.skipInvalid = true}).attributes.properties, Strings{R"("c":5)"});
  EXPECT_EQ(fileErrorOf("x,y,r\n,,\n1,,\n", {.skipInvalid = true}),
            "test:3: y is empty; all others are invalid as well.");
  EXPECT_EQ(fileErrorOf("[[1,2,3],[1,2,]]", {.skipInvalid = true}).substr(0, 17), "test:1: bad JSON:");
}

const std::string kPoints =
    R"({"type": "FeatureCollection", "name": "stores", "crs": {"type": "name", "properties": {"name": "x"}},
"bbox": [0, 0, 1, 1], "features": [
{"type": "Feature", "id": "a1", "properties": {"ref": "0042", "text": "12", "addr": {"zip": "01730"}, "tags": ["a", "b"],
"big": 12345678901234567890, "n": null, "empty": "", "yes": true, "y": "attribute", "area": 3, "r": 0.25, "line": "a\nb,\"c\""},
"geometry": {"type": "Point", "coordinates": [149.149, -35.315, 578.2]}},
{"type": "Feature", "id": "a2", "properties": {"ref": "0043", "text": "13", "yes": false, "r": 0.5},
"geometry": {"type": "Point", "coordinates": [151, -35.5, 600]}}]})";

TEST(CircleAttributes, GoThroughEveryFormatOfCirclesAndBack) {
  const CircleFile file = fileOf(kPoints);
  ASSERT_EQ(file.attributes.ids, (Strings{R"("a1")", R"("a2")"}));
  ASSERT_EQ(file.attributes.heights, (Strings{"578.2", "600"}));
  for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    std::ostringstream there;
    ASSERT_TRUE(write(there, file.circles, file.attributes));
    const CircleFile middle = fileOf(there.str());
    EXPECT_EQ(middle.circles, file.circles);
    EXPECT_EQ(middle.attributes.ids, file.attributes.ids) << there.str();
    EXPECT_EQ(middle.attributes.heights, file.attributes.heights);
    std::ostringstream back;
    ASSERT_TRUE(writeCirclesGeoJson(back, middle.circles, middle.attributes));
    const Json features = Json::parse(back.str())["features"];
    const Json first = features[0]["properties"];
    EXPECT_EQ(first["ref"], "0042");
    EXPECT_EQ(first["text"], "12") << "a text of digits stays one";
    EXPECT_EQ(first["addr"]["zip"], "01730");
    EXPECT_EQ(first["tags"][1], "b");
    EXPECT_NE(back.str().find(R"("big":12345678901234567890)"), std::string::npos);
    EXPECT_TRUE(first["n"].is_null());
    EXPECT_EQ(first["empty"], "");
    EXPECT_EQ(first["yes"], true);
    EXPECT_EQ(first["line"], "a\nb,\"c\"");
    EXPECT_EQ(first.contains("y") ? first["y"] : first["input_y"], "attribute");
    EXPECT_EQ(first["area"], 3);
    EXPECT_EQ(features[0]["geometry"]["coordinates"][2], 578.2);
    EXPECT_EQ(features[1]["id"], "a2");
    // And again, without another name.
    std::ostringstream again;
    ASSERT_TRUE(write(again, middle.circles, middle.attributes));
    EXPECT_EQ(again.str(), there.str());
  }
}

TEST(CircleAttributes, GoThroughDiagramsInJsonAndToCells) {
  const CircleFile file = fileOf(kPoints);
  const Diagram diagram = compute(file.circles).value();
  std::ostringstream json;
  ASSERT_TRUE(writeDiagramFile(json, diagram, file.attributes));
  const auto back = readDiagramFile(json.str(), "test");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->attributes.properties, file.attributes.properties);
  EXPECT_EQ(back->attributes.ids, file.attributes.ids);
  EXPECT_EQ(back->attributes.heights, file.attributes.heights);
  EXPECT_EQ(back->attributes.collection, file.attributes.collection);
  EXPECT_EQ(readDiagram(json.str(), "test")->edges, diagram.edges) << "as by an older reader";
  std::ostringstream plain;
  ASSERT_TRUE(writeJson(plain, diagram));
  EXPECT_TRUE(readDiagramFile(plain.str(), "test")->attributes.empty());

  std::ostringstream cells;
  ASSERT_TRUE(writeGeoJson(cells, diagram, {.attributes = &back->attributes}));
  const Json written = Json::parse(cells.str());
  EXPECT_EQ(written["crs"]["properties"]["name"], "x");
  EXPECT_EQ(written["name"], "stores");
  const Box box = exportBox(diagram.circles);
  EXPECT_EQ(written["bbox"], Json({box.minX, box.minY, box.maxX, box.maxY})) << "cells are larger than the points";
  EXPECT_EQ(written["features"][0]["id"], "a1");
  EXPECT_EQ(written["features"][0]["properties"]["z"], 578.2);
  EXPECT_EQ(written["features"][0]["properties"]["input_area"], 3);
  EXPECT_EQ(written["features"][1]["properties"]["ref"], "0043");
  CircleAttributes few = file.attributes;
  few.ids.pop_back();
  EXPECT_EQ(writeDiagramFile(cells, diagram, few).error().code, ErrorCode::badInput);
  EXPECT_EQ(writeGeoJson(cells, diagram, {.attributes = &few}).error().code, ErrorCode::badInput);
  EXPECT_EQ(writeCirclesCsv(cells, file.circles, few).error().code, ErrorCode::badInput);
}

TEST(CircleAttributes, OfAPeriodicDiagramBelongToTheGivenCircles) {
  const auto periodic = computePeriodic(Circles{{0.2, 0.2, 0.1}, {0.7, 0.6, 0.1}}, {{1, 0}, {0, 1}});
  ASSERT_TRUE(periodic);
  ASSERT_GT(periodic->circleOf.size(), 2U);
  const auto written = [&](auto write, const Strings& properties) {
    std::ostringstream out;
    const CircleAttributes attributes = {.properties = properties};
    ExportOptions options;
    options.attributes = &attributes;
    const Result<void> result = write(out, options);
    return result ? out.str() : std::string(errorCodeName(result.error().code)) + ": " + result.error().message;
  };
  using Write = Result<void> (*)(std::ostream&, const PeriodicDiagram&, const ExportOptions&);
  for (const Write write : {writePeriodicGeoJson, writePeriodicGeoJsonLines, writePeriodicSvg}) {
    const auto writeOptions = [&](std::ostream& out, const ExportOptions& options) {
      return write(out, *periodic, options);
    };
    EXPECT_TRUE(written(writeOptions, {R"({"n":1})"}).starts_with("badInput: ")) << written(writeOptions, {"{}"});
    if (write == writePeriodicSvg) continue;
    EXPECT_NE(written(writeOptions, {R"("n":1)", R"("n":2)"}).find(R"("n":2)"), std::string::npos);
  }
  const auto writeJson = [&](std::ostream& out, const ExportOptions& options) {
    return writePeriodicJson(out, *periodic, {}, *options.attributes);
  };
  EXPECT_TRUE(written(writeJson, {"{}"}).starts_with("badInput: "));
}

TEST(CircleAttributes, IdsAndHeightsOfATableAreThoseOfFeatures) {
  const CircleFile file = fileOf("id,x,y,z,r\nA,0,0,1.50,1\nB,5,0,,1\n");
  std::ostringstream text;
  ASSERT_TRUE(writeCirclesGeoJson(text, file.circles, file.attributes));
  const Json features = Json::parse(text.str())["features"];
  EXPECT_EQ(features[0]["id"], "A");
  EXPECT_EQ(features[0]["properties"]["id"], "A");
  EXPECT_NE(text.str().find("[0,0,1.50]"), std::string::npos);
  EXPECT_EQ(features[1]["geometry"]["coordinates"].size(), 2U);
  std::ostringstream back;
  ASSERT_TRUE(writeCirclesCsv(back, fileOf(text.str()).circles, fileOf(text.str()).attributes));
  EXPECT_EQ(back.str(), "x,y,r,id,z\n0,0,1,A,1.50\n5,0,1,B,\n");
  // Other attributes with these names get other names.
  CircleAttributes others = file.attributes;
  others.properties = {R"("ID":7,"Z":8)", R"("ID":9)"};
  std::ostringstream both;
  ASSERT_TRUE(writeCirclesCsv(both, file.circles, others));
  EXPECT_EQ(both.str(), "x,y,r,id,z,input_ID,input_Z\n0,0,1,A,1.50,7,8\n5,0,1,B,,9,\n");
}

TEST(ReadCircleFile, ColumnsWithoutANameOrWithTheSameNameAreKept) {
  EXPECT_EQ(fileOf(",x,y,r,a,,a,a_2,,\n7,1,2,3,4,5,6,8,,\n9,1,2,3,,,,,\n").attributes.properties,
            (Strings{R"("column 1":7,"a":4,"column 6":5,"a_2":6,"a_2_2":8)",
                     R"("column 1":9,"a":null,"column 6":null,"a_2":null,"a_2_2":null)"}));
}

TEST(ReadCircleFile, ColumnsOfATableWithoutNamesAreKeptEvenIfTheyAreEmpty) {
  EXPECT_EQ(fileOf("1,2,3,\n4,5,6,\n", {.x = "#1", .y = "#2", .radius = "#3"}).attributes.properties,
            (Strings{R"("column 4":null)", R"("column 4":null)"}));
}

TEST(ReadCircleFile, AnIdThatNoCircleHasIsMissed) {
  EXPECT_EQ(fileErrorOf(R"([{"x":1,"y":2,"r":3,"code":null}])", {.id = "code"}),
            "test:1: no circle has a string or a number called code.");
  EXPECT_EQ(fileOf(R"([{"x":1,"y":2,"r":3,"code":"a"},{"x":1,"y":2,"r":3}])", {.id = "code"}).attributes.ids,
            (Strings{R"("a")", ""}));
  EXPECT_TRUE(fileOf("[]", {.id = "code"}).circles.empty());
}

TEST(ExportedBox, IsInFilesThatHaveAPlaceForIt) {
  const Diagram diagram = compute(std::vector<Circle>{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}).value();
  const auto bboxOf = [&](const ExportOptions& options) {
    std::ostringstream out;
    EXPECT_TRUE(writeGeoJson(out, diagram, options));
    return Json::parse(out.str()).value("bbox", Json());
  };
  EXPECT_EQ(bboxOf({.bounds = Box{-1, -2, 3.5, 4}}), Json({-1, -2, 3.5, 4}));
  const Region region = readRegion("POLYGON ((0 1, 5 1, 4 7))", "region").value();
  EXPECT_EQ(bboxOf({.region = &region}), Json({0, 1, 5, 7}));
  EXPECT_TRUE(bboxOf({.place = [](Point p) { return Point{p.y, p.x}; }}).is_null());
  std::ostringstream points;
  ASSERT_TRUE(writeCirclesGeoJson(points, diagram.circles));
  EXPECT_EQ(points.str().find("bbox"), std::string::npos);
  std::ostringstream obj;
  ASSERT_TRUE(writeObj(obj, diagram, {.bounds = Box{-1, -2, 3.5, 4}}));
  EXPECT_NE(obj.str().find("\n# cut to the box -1 -2 3.5 4\n"), std::string::npos);
}

}  // namespace
}  // namespace circle_voronoi
