// SPDX-License-Identifier: GPL-3.0-or-later
// --region of compute, convert and edit, and attributes that go through to GeoJSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "circle_voronoi/io.h"
#include "cli.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

constexpr const char* kCircles =
    "x,y,r,name,population\n0,0,1,\"A, \"\"the first\"\"\",12\n4,0,0.5,B,\n9,9,0,far,1e3\n";
constexpr const char* kRegion =
    R"({"type":"Feature","properties":null,"geometry":{"type":"MultiPolygon","coordinates":[
[[[-1,-1],[5,-1],[5,1],[-1,1],[-1,-1]],[[0.5,0.5],[1,0.5],[1,0.75]]],[[[5,2,7],[6,2,7],[6,3,7]]]]}})";

class CliRegion : public test::Cli {
 protected:
  const std::string circles_ = write("circles.csv", kCircles);
  const std::string region_ = write("region.geojson", kRegion);

  void fails(const std::string& arguments, const std::string& message) const {
    expectFailure(run(arguments), 2, message);
  }
};

TEST_F(CliRegion, ComputeConvertAndEditClip) {
  const std::string options = " --region " + region_ + " --format geojson";
  const std::string computed = textOf("compute " + circles_ + options);
  const Json features = Json::parse(computed)["features"];
  ASSERT_EQ(features.size(), 3U);
  double sum = 0;
  for (const Json& feature : features) sum += feature["properties"]["area"].get<double>();
  EXPECT_NEAR(sum, 12 - 0.0625 + 0.5, 1e-12);
  EXPECT_EQ(features[0]["geometry"]["type"], "Polygon");
  EXPECT_EQ(features[0]["geometry"]["coordinates"].size(), 2U);
  EXPECT_EQ(features[1]["geometry"]["type"], "MultiPolygon");
  EXPECT_TRUE(features[2]["geometry"].is_null());
  EXPECT_EQ(features[2]["properties"]["circle"], 2);

  textOf("compute " + circles_ + " -o " + path("diagram.json"));
  const std::string script = write("script.csv", "remove,2\ninsert,9,9,0\n");
  for (const std::string format : {"geojsonl", "wkt", "obj", "svg"}) {
    const std::string wanted = " --region " + region_ + " --format " + format;
    const std::string text = textOf("convert " + path("diagram.json") + wanted);
    EXPECT_FALSE(text.empty());
    const std::string edited = textOf("edit " + circles_ + " --script " + script + wanted);
    // Edges and neighbors may come in another order, and curves may be straightened from their other end.
    EXPECT_EQ(std::ranges::count(edited, '\n'), std::ranges::count(text, '\n'));
    EXPECT_NEAR(static_cast<double>(edited.size()), static_cast<double>(text.size()),
                0.1 * static_cast<double>(text.size()));
  }
  EXPECT_NE(textOf("compute " + circles_ + " --region " + region_ + " --format wkt").find("\nPOLYGON EMPTY\n"),
            std::string::npos);
  // The same region as well-known text.
  const std::string wkt =
      write("region.wkt",
            "SRID=4326;multipolygon z (((-1 -1 0, 5 -1 0, 5 1 0, -1 1 0, -1 -1 0), (0.5 0.5 0, 1 0.5 0, 1 0.75 "
            "0)),\n ((5 2 0, 6 2 0, 6 3 0)))\n");
  EXPECT_EQ(textOf("compute " + circles_ + " --region " + wkt + " --format geojson"), computed);
}

TEST_F(CliRegion, DigitsAreThoseOfTheCellsAndNotOfTheRegion) {
  const std::string region = write("bay.wkt", "POLYGON ((-1.0625 -1, 5 -1, 5 1.0625, -1.0625 1.0625))");
  const std::string rounded = textOf("compute " + circles_ + " --format wkt --digits 1 --region " + region);
  EXPECT_NE(rounded.find("-1.0625 1.0625"), std::string::npos) << rounded;
  EXPECT_NE(rounded.find("5 1.0625"), std::string::npos) << rounded;
}

TEST_F(CliRegion, MaxDistanceAndRegionTogether) {
  const Json features = Json::parse(
      textOf("compute " + circles_ + " --region " + region_ + " --max-distance 0.25 --format geojson"))["features"];
  // The second disc is whole.
  EXPECT_NEAR(features[1]["properties"]["area"].get<double>(), 0.75 * 0.75 * 3.14159265358979, 1e-9);
  EXPECT_LT(features[0]["properties"]["area"].get<double>(), 1.25 * 1.25 * 3.14159265358979);
}

TEST_F(CliRegion, FinalCellsOfATileAreClippedAsInTheWholeDiagram) {
  const std::string circles = write("many.csv", textOf("generate uniform 300 --seed 3"));
  const std::string region = write("bay.wkt", "POLYGON((5 5, 25 6, 24 20, 15 12, 6 22, 5 5))");
  const std::string options = " --format geojsonl --region " + region;
  const std::string whole = "\n" + textOf("compute " + circles + options);
  const auto [status, part, err] = run("compute " + circles + " --known 0,0,30,30 --max-radius 1" + options);
  EXPECT_EQ(status, 3);
  EXPECT_NE(err.find("are not final"), std::string::npos) << err;
  int clipped = 0;
  for (const std::string& line : test::linesOf(part)) {
    EXPECT_NE(whole.find("\n" + line + "\n"), std::string::npos) << line;
    clipped += Json::parse(line)["geometry"].is_null() ? 0 : 1;
  }
  EXPECT_GT(clipped, 30);
}

TEST_F(CliRegion, AttributesGoThrough) {
  const Json features = Json::parse(textOf("compute " + circles_ + " --format geojson"))["features"];
  EXPECT_EQ(features[0]["properties"]["name"], "A, \"the first\"");
  EXPECT_EQ(features[0]["properties"]["population"], 12);
  EXPECT_TRUE(features[1]["properties"]["population"].is_null());
  EXPECT_EQ(features[2]["properties"]["population"], 1000);
  const std::string points = write("points.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","geometry":{"type":"Point","coordinates":[0,0]},"properties":{"r":1,"area":"wide","tags":{"a":
[1,2]}}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[3,0]},"properties":{"radius":1}}]})");
  const auto lines = test::linesOf(textOf("compute " + points + " --format geojsonl"));
  ASSERT_GE(lines.size(), 2U);
  const Json first = Json::parse(lines[0])["properties"];
  EXPECT_EQ(first["input_area"], "wide");
  EXPECT_TRUE(first["area"].is_null()) << "unbounded";
  EXPECT_EQ(first["tags"]["a"][1], 2);
  EXPECT_EQ(Json::parse(lines[1])["properties"].size(), 5U);
}

TEST_F(CliRegion, RefusesInvalidRegionsAndOptions) {
  const std::string compute = "compute " + circles_ + " --format wkt --region ";
  fails(compute + circles_, "circles.csv:1: ");
  fails(compute + write("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2))"), "bow.wkt: Side 0 of ring 0 of the region");
  const std::string spike = compute + write("spike.wkt", "POLYGON ((0 0, 4 0, 6 0, 4 0, 4 4, 0 4))");
  fails(spike, " Set --dissolve to repair it.");
  EXPECT_EQ(textOf(spike + " --dissolve"), textOf(compute + write("no-spike.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4))")));
  fails(compute + write("open.wkt", "POLYGON ((0 0, 1 0, 1 1)"), "open.wkt:1: ");
  fails(compute + write("none.json", R"({"type":"FeatureCollection","features":[]})"), "The region has no ring.");
  fails(compute + region_ + " --bounds 0,0,1,1", "--region takes no --bounds.");
  fails("compute " + circles_ + " --format csv --region " + region_, "--region needs --format cells, svg, geojson");
}

}  // namespace
}  // namespace circle_voronoi
