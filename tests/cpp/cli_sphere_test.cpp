// SPDX-License-Identifier: GPL-3.0-or-later
// --sphere of compute, and what the program says of degrees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/sphere.h"
#include "cli.h"
#include "elementary.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

constexpr double kEarthArea = 4 * kPi * kEarthRadius * kEarthRadius;

class CliSphere : public test::Cli {
 protected:
  const std::string cities_ = write("cities.csv",
                                    "city,lon,lat,r\nJuneau,-134.42,58.3,40\nPetersburg,30.31,59.94,20\n"
                                    "Melbourne,144.96,-37.81,0\nSouth,0,-90,5\nSuburb,30.4,59.94,1\n");
  const std::vector<Cap> caps_ = {
      {-134.42, 58.3, 40}, {30.31, 59.94, 20}, {144.96, -37.81, 0}, {0, -90, 5}, {30.4, 59.94, 1}};
};

/// The polygons of a GeoJSON geometry without the points that close rings.
std::vector<std::vector<std::vector<Point>>> polygonsIn(const Json& geometry) {
  std::vector<std::vector<std::vector<Point>>> polygons;
  const Json all = geometry["type"] == "Polygon" ? Json::array({geometry["coordinates"]}) : geometry["coordinates"];
  for (const Json& polygon : all) {
    polygons.emplace_back();
    for (const Json& ring : polygon) {
      EXPECT_EQ(ring.front(), ring.back());
      polygons.back().emplace_back();
      for (std::size_t k = 0; k + 1 < ring.size(); ++k) polygons.back().back().push_back({ring[k][0], ring[k][1]});
    }
  }
  return polygons;
}

TEST_F(CliSphere, GeoJsonHasAValidPolygonForEachCell) {
  for (const std::string format : {"geojson", "geojsonl"}) {
    const std::string text = textOf("compute " + cities_ + " --sphere --format " + format);
    std::vector<Json> features;
    if (format == "geojson") {
      const Json collection = Json::parse(text);
      for (const Json& feature : collection["features"]) features.push_back(feature);
    } else {
      for (const std::string& line : test::linesOf(text)) features.push_back(Json::parse(line));
    }
    const auto diagram = computeSphere(caps_);
    ASSERT_TRUE(diagram);
    ASSERT_EQ(features.size(), caps_.size());
    double sum = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      const Json& properties = features[i]["properties"];
      EXPECT_EQ(properties["circle"], i);
      EXPECT_EQ(properties["r"], caps_[i].r);
      EXPECT_EQ(properties["neighbors"].size(), neighbors(*diagram, static_cast<std::int32_t>(i)).size());
      sum += properties["area"].get<double>();
      if (i == 4) {
        EXPECT_TRUE(features[i]["geometry"].is_null());
        EXPECT_EQ(properties["hiddenBy"], 1);
      } else {
        const auto valid = Region::fromPolygons(polygonsIn(features[i]["geometry"]));
        EXPECT_TRUE(valid) << valid.error().message;
      }
    }
    EXPECT_EQ(features[0]["properties"]["city"], "Juneau");
    EXPECT_NEAR(sum / kEarthArea, 1, 1e-12);
  }
}

TEST_F(CliSphere, CsvReadsBackWithNamesAndAreas) {
  const std::string text = textOf("compute " + cities_ + " --sphere --format csv");
  const auto file = readCircleFile(text, "cells");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->circles.size(), caps_.size());
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    EXPECT_EQ(file->circles[i], (Circle{caps_[i].longitude, caps_[i].latitude, caps_[i].r}));
  }
  const auto areas = numbersIn(file->attributes, "area");
  ASSERT_TRUE(areas);
  double sum = 0;
  for (const double area : *areas) sum += area;
  EXPECT_NEAR(sum / kEarthArea, 1, 1e-12);
  EXPECT_NE(file->attributes.properties[0].find("Juneau"), std::string::npos);
}

TEST_F(CliSphere, JsonHasTheDiagramToTheBit) {
  const Json json = Json::parse(textOf("compute " + cities_ + " --sphere"));
  const auto diagram = computeSphere(caps_);
  ASSERT_TRUE(diagram);
  EXPECT_EQ(json["radius"], kEarthRadius);
  ASSERT_EQ(json["vertices"].size(), diagram->vertices.size());
  for (std::size_t v = 0; v < diagram->vertices.size(); ++v) {
    EXPECT_EQ(json["vertices"][v]["longitude"], diagram->vertices[v].longitude);
    EXPECT_EQ(json["vertices"][v]["latitude"], diagram->vertices[v].latitude);
    EXPECT_EQ(json["vertices"][v]["distance"], diagram->vertices[v].distance);
  }
  EXPECT_EQ(json["edges"].size(), diagram->edges.size());
  EXPECT_EQ(json["hidden"], (Json::array({{{"cap", 4}, {"by", 1}}})));
  EXPECT_EQ(json["caps"][0]["properties"]["city"], "Juneau");
}

TEST_F(CliSphere, AUnitIsThatOfRadiiAndAreas) {
  const std::string meters = write("meters.csv", "lon,lat,r\n0,0,40000\n90,10,0\n");
  const std::string kilometers = write("kilometers.csv", "lon,lat,r\n0,0,40\n90,10,0\n");
  const auto areaOf = [&](const std::string& arguments) {
    const Json first = Json::parse(test::linesOf(textOf("compute " + arguments + " --format geojsonl --sphere"))[0]);
    return first["properties"]["area"].get<double>();
  };
  EXPECT_NEAR(areaOf(meters + " --unit m") / areaOf(kilometers) / 1e6, 1, 1e-14);
  const double cut = areaOf(kilometers + " --max-distance 60");
  const double sine = std::sin(50 / kEarthRadius);
  EXPECT_NEAR(cut / (4 * kPi * kEarthRadius * kEarthRadius * sine * sine), 1, 1e-13);
}

TEST_F(CliSphere, ATableHasCellsCutAtADistance) {
  const std::string two = write("two.csv", "lon,lat,r\n0,0,40\n90,10,0\n");
  const auto file =
      readCircleFile(textOf("compute " + two + " --sphere --max-distance 60 --digits 3 --format csv"), "cells");
  ASSERT_TRUE(file) << file.error().message;
  const double sine = std::sin(50 / kEarthRadius);
  const auto areas = numbersIn(file->attributes, "area");
  const auto perimeters = numbersIn(file->attributes, "perimeter");
  ASSERT_TRUE(areas && perimeters);
  EXPECT_NEAR(areas->at(0), 4 * kPi * kEarthRadius * kEarthRadius * sine * sine, 0.001);
  EXPECT_NEAR(perimeters->at(0), 2 * kPi * kEarthRadius * std::sin(100 / kEarthRadius), 0.001);
}

TEST_F(CliSphere, OneCapHasTheWholeSphere) {
  const std::string one = write("one.csv", "lat;lon\n10,5;20,25\n");
  const Json json = Json::parse(textOf("compute " + one + " --sphere --points --format geojson"));
  EXPECT_EQ(json["features"][0]["geometry"]["coordinates"],
            (Json{{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}, {-180, -90}}}));
}

TEST_F(CliSphere, OptionsOfThePlaneAreRefused) {
  for (const std::string option :
       {"--bounds 0,0,1,1 --format geojson", "--project local", "--lattice 1,0,0,1", "--method flip", "--known 0,0,1,1",
        "--format svg", "--format stats", "--max-distance 9 --format json", "--digits 3 --format json",
        "--tolerance 1 --format csv", "--tolerance 1 --format json"}) {
    const auto outcome = run("compute " + cities_ + " --sphere " + option);
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_TRUE(outcome.out.empty());
  }
  EXPECT_EQ(run("compute " + cities_ + " --unit m").status, 2);
}

TEST_F(CliSphere, AnErrorNamesTheCap) {
  const std::string beyond = write("beyond.csv", "lon,lat,r\n0,0,1\n0,91,0\n");
  const auto outcome = run("compute " + beyond + " --sphere");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("Cap 1"), std::string::npos) << outcome.err;
}

TEST_F(CliSphere, DegreesInAPlaneAreSaid) {
  const std::string objects = write("objects.json", R"([{"longitude": 1, "latitude": 2, "r": 0}])");
  const std::string plane = write("plane.csv", "x,y,r\n1,2,0\n");
  const std::string far = write("far.csv", "lon,lat,r\n1,2000,0\n");
  const auto saysSphere = [&](const std::string& arguments) {
    const auto outcome = run("compute " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err.find("--sphere") != std::string::npos;
  };
  EXPECT_TRUE(saysSphere(cities_));
  EXPECT_TRUE(saysSphere(objects));
  EXPECT_FALSE(saysSphere(plane));
  EXPECT_FALSE(saysSphere(far));
  EXPECT_FALSE(saysSphere(cities_ + " --sphere"));
}

TEST_F(CliSphere, AMapThatIsWrongForTheWorldIsSaid) {
  const auto outcome = run("compute " + cities_ + " --project mercator");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--sphere"), std::string::npos) << outcome.err;
  const std::string world = write("world.csv", "lon,lat\n-134.42,58.3\n30.31,59.94\n144.96,-10\n");
  EXPECT_NE(run("compute " + world + " --points --project mercator").err.find("--sphere"), std::string::npos);
  const std::string town = write("town.csv", "lon,lat\n8.5,50.1\n8.6,50.2\n8.7,50\n");
  for (const std::string map : {"mercator", "local", "equal-area"}) {
    EXPECT_EQ(run("compute " + town + " --points --project " + map).err, "") << map;
  }
}

TEST_F(CliSphere, APoleInACellOnAMapIsAnError) {
  const std::string stations =
      write("stations.csv", "station,lon,lat\nPole,0,-90\nVostok,106.84,-78.46\nTroll,2.53,-72\n");
  const std::string arguments = "compute " + stations + " --points --project local --format ";
  for (const std::string format : {"geojson", "geojsonl", "wkt"}) {
    const auto outcome = run(arguments + format);
    EXPECT_EQ(outcome.status, 2) << format;
    EXPECT_NE(outcome.err.find("--sphere"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run(arguments + "svg").status, 0);
  EXPECT_EQ(run(arguments + "geojson --max-distance 100000").status, 2);
  const std::string north = write("north.csv", "lon,lat\n0,75\n120,76\n-120,77\n");
  const std::string cells = "compute " + north + " --points --project equal-area --format geojson";
  EXPECT_EQ(run(cells).status, 2);
  EXPECT_EQ(run(cells + " --max-distance 100000").status, 0);
}

TEST_F(CliSphere, ABoxAcrossTheAntimeridianGoesOn) {
  const std::string fiji = write("fiji.csv", "lon,lat\n178.4,-18.1\n-179.9,-16.8\n179.3,-16.4\n");
  const std::string arguments = "compute " + fiji + " --points --project local --format geojson --bounds ";
  const auto refused = run(arguments + "177,-19,-178,-16");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("182"), std::string::npos) << refused.err;
  EXPECT_EQ(run(arguments + "177,-19,182,-16").status, 0);
}

TEST_F(CliSphere, AProjectedRegionIsDissolved) {
  const std::string towns = write("towns.csv", "lon,lat\n8.5,50.1\n8.6,50.2\n8.7,50\n");
  // Two overlapping squares, and two that share a side.
  const std::string region = write("counties.geojson", R"({"type": "MultiPolygon", "coordinates": [
    [[[8.4, 49.9], [8.6, 49.9], [8.6, 50.3], [8.4, 50.3]]], [[[8.55, 49.95], [8.8, 49.95], [8.8, 50.2], [8.55, 50.2]]],
    [[[8.8, 49.95], [8.9, 49.95], [8.9, 50.2], [8.8, 50.2]]]]})");
  const std::string arguments =
      "compute " + towns + " --points --format geojson --project equal-area --region " + region;
  EXPECT_EQ(run(arguments).status, 2);
  const Json dissolved = Json::parse(textOf(arguments + " --dissolve"));
  double sum = 0;
  for (const Json& feature : dissolved["features"]) sum += feature["properties"]["area"].get<double>();
  // 0.2 * 0.4 + 0.2 * 0.25 + 0.1 * 0.25 square degrees at 50 degrees, within the flattening.
  EXPECT_NEAR(sum / (0.155 * 111300.0 * 111300.0 * std::cos(50.1 * kDegree)), 1, 0.01);
}

}  // namespace
}  // namespace circle_voronoi
