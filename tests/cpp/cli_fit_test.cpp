// SPDX-License-Identifier: GPL-3.0-or-later
// The command fit: areas from a column, in a region.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "cli.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

constexpr const char* kSites = "x,y,r,name,people,square meters\n1,1,0,north,3,6\n3,2,0,south,1,2\n2,3,0,west,4,8\n";
constexpr const char* kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4))";

class CliFit : public test::Cli {
 protected:
  const std::string sites_ = write("sites.csv", kSites);
  const std::string region_ = " --region " + write("region.wkt", kSquare);

  std::string textOf(const std::string& arguments, const std::string& input = "") const {
    return Cli::textOf("fit " + arguments, input);
  }

  void fails(const std::string& arguments, const std::string& message, int status = 2) const {
    expectFailure(run("fit " + arguments + " --format json"), status, message);
  }

  /// Whether the cells of a diagram as GeoJSON have the areas 6, 2 and 8.
  static void expectAreas(const std::string& geojson) {
    const std::vector<double> expected = {6, 2, 8};
    const Json features = Json::parse(geojson)["features"];
    ASSERT_EQ(features.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(features[i]["properties"]["area"].get<double>(), expected[i], 1e-8) << "cell " << i;
    }
  }
};

TEST_F(CliFit, TakesSharesOrAreasFromAColumn) {
  const std::string shares = textOf(sites_ + " --areas people --shares --format geojson" + region_);
  expectAreas(shares);
  EXPECT_EQ(Json::parse(shares)["features"][1]["properties"]["name"], "south");
  expectAreas(textOf(sites_ + " --areas 'square meters' --format geojson" + region_));
  // Standard input, and a file whose ending names the format, give the same result.
  EXPECT_EQ(textOf("- --areas people --shares --format geojson" + region_, kSites), shares);
  const std::string file = path("fitted.geojson");
  EXPECT_EQ(textOf(sites_ + " --areas people --shares -o " + file + region_), "");
  EXPECT_EQ(readFile(file), shares);
}

TEST_F(CliFit, SaysWhereLastBitsAllowNoBetterAreas) {
  const std::string square = " --region " + write("unit.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1))");
  const std::string sliver = write("sliver.csv", "x,y,r,a\n0.3,0.4,0,1\n0.3001,0.4,0,1e-7\n");
  const auto coarse = run("fit " + sliver + " --areas a --shares --format json" + square);
  EXPECT_EQ(coarse.status, 0);
  EXPECT_TRUE(std::regex_search(coarse.err, std::regex("largest relative error of an area is [0-9.]+e-0[34], as")))
      << coarse.err;
  // Far from the origin, differences of coordinates are exact.
  const std::string far = write("far.csv", "x,y,r,a\n5000000.2,5000000.1,0,3\n5000000.7,5000000.6,0,1\n");
  const std::string there =
      write("far.wkt", "POLYGON ((5000000 5000000, 5000001 5000000, 5000001 5000001, 5000000 5000001))");
  const auto fine = run("fit " + far + " --areas a --shares --format json --region " + there);
  EXPECT_EQ(fine.status, 0);
  EXPECT_EQ(fine.err, "");
}

TEST_F(CliFit, TakesPointsWithoutARadiusAndAreasFromProperties) {
  const std::string options = " --areas people --shares --format geojson" + region_;
  expectAreas(textOf(write("points.csv", "people,y,x\n3,1,1\n1,2,3\n4,3,2\n") + options));
  expectAreas(
      textOf(write("points.json", R"([{"x":1,"y":1,"people":3},{"x":3,"y":2,"people":1},{"x":2,"y":3,"people":4}])") +
             options));
  expectAreas(textOf(write("points.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","geometry":{"type":"Point","coordinates":[1,1]},"properties":{"people":3}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[3,2]},"properties":{"people":1}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[2,3]},"properties":{"people":4}}]})") +
                     options));
  fails(write("no-y.csv", "people,x\n3,1\n") + " --areas people" + region_,
        "no-y.csv:1: no column is called y, cy, lat, latitude or northing, only people, x; name one by --y.");
  // Only a fit takes them.
  expectFailure(run("compute " + write("points.csv", "people,y,x\n3,1,1\n") + " --format json"), 2,
                "points.csv:1: no column is called r, rad or radius, only people, y, x; name one by --radius.");
}

TEST_F(CliFit, WritesADiagramWithTheWeightsAsRadiiWhichIsWhereTheNextFitBegins) {
  const std::string options = " --areas people --shares" + region_;
  const Json first = Json::parse(textOf(sites_ + options + " --format json"));
  std::vector<double> weights;
  for (const Json& circle : first["circles"]) weights.push_back(circle["r"].get<double>());
  EXPECT_EQ(*std::ranges::min_element(weights), 0);
  EXPECT_TRUE(first["stats"]["certificate"]["certified"].get<bool>());
  // With no step to take, the weights are those given: at most one step would not do from the radii of the sites.
  std::string sites = "x,y,r,people\n";
  const std::vector<std::string> rest = {"3", "1", "4"};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Json& circle = first["circles"][i];
    sites += circle["x"].dump() + "," + circle["y"].dump() + "," + circle["r"].dump() + "," + rest[i] + "\n";
  }
  const std::string again = write("again.csv", sites);
  const Json second = Json::parse(textOf(again + options + " --max-steps 1 --format json"));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (const char* number : {"x", "y", "r"}) EXPECT_EQ(second["circles"][i][number], first["circles"][i][number]);
  }
  fails(sites_ + options + " --max-steps 1", "sites.csv: The fit stopped after 1 step: the largest relative error", 1);
  // A coarse fit takes fewer steps.
  textOf(sites_ + options + " --max-steps 4 --area-tolerance 0.1 --format json");
  fails(sites_ + options + " --max-steps 4", "The fit stopped after 4 steps", 1);
}

TEST_F(CliFit, MovesSitesToTheCentersOfTheirCells) {
  const std::string options = sites_ + " --areas people --shares" + region_;
  expectAreas(textOf(options + " --relax 30 --format geojson"));
  // Sites that are at the centers of their cells stay.
  const auto placesAfter = [&](const std::string& relax) {
    std::vector<double> places;
    const Json diagram = Json::parse(textOf(options + " --format json --relax " + relax));
    for (const Json& circle : diagram["circles"]) {
      places.push_back(circle["x"].get<double>());
      places.push_back(circle["y"].get<double>());
    }
    return places;
  };
  const std::vector<double> start = placesAfter("0");
  EXPECT_EQ(start, (std::vector<double>{1, 1, 3, 2, 2, 3}));
  const std::vector<double> places = placesAfter("60");
  const std::vector<double> more = placesAfter("61");
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(more[i], places[i], 0.01) << i;
    EXPECT_GT(std::abs(places[i] - start[i]), 0.01) << i;
  }
  fails(options + " --relax -1", "--relax must not be negative (got -1).");
}

TEST_F(CliFit, TakesWeightsBelowZeroToStartFrom) {
  const std::string sites = write("weights.csv", "x,y,r,people\n1,1,-1,3\n3,2,-1.5,1\n2,3,-1,4\n");
  expectAreas(textOf(sites + " --weights --areas people --shares --format geojson" + region_));
  fails(sites + " --areas people --shares" + region_, "weights.csv:2: Circle 0 has a negative radius.");
}

TEST_F(CliFit, RefusesInvalidAreasAndOptions) {
  fails(sites_ + " --areas people --shares", "fit needs --region or --lattice.");
  fails(sites_ + " --shares" + region_, "--areas is required");
  fails(sites_ + " --areas people" + region_,
        "sites.csv: The areas sum to 8, but the area of the region is 16. Set --shares to scale them.");
  fails(sites_ + " --areas persons --shares" + region_, "sites.csv: circle 0 has no number \"persons\".");
  fails(sites_ + " --areas name --shares" + region_, "sites.csv: circle 0 has no number \"name\".");
  const std::string options = " --areas people --shares";
  fails(sites_ + options + region_ + " --area-tolerance 2", "--area-tolerance must be above 0 and below 1 (got 2).");
  fails(sites_ + options + region_ + " --max-steps 0", "--max-steps must be 1 or more (got 0).");
  fails(sites_ + options + region_ + " -o " + path("region.wkt"), "region.wkt would be overwritten");
  EXPECT_EQ(readFile(path("region.wkt")), kSquare);
}

TEST_F(CliFit, DividesABoxWhoseOppositeSidesAreGluedTogether) {
  const std::string options = sites_ + " --areas people --shares --lattice ";
  expectAreas(textOf(options + "4,0,1,4 --format geojson"));
  const Json diagram = Json::parse(textOf(options + "4,0,1,4 --format json"));
  EXPECT_EQ(diagram["lattice"].size(), 2U);
  EXPECT_GT(diagram["images"].size(), 0U);
  EXPECT_EQ(textOf(options + "4,0,1,4 --format csv").rfind("circle,neighbor,", 0), 0U);
  EXPECT_EQ(textOf(options + "4,0,1,4 --format svg").rfind("<svg", 0), 0U);
  fails(options + "4,0,8,0", "sites.csv: The periods must not be zero or parallel");
  fails(options + "4,0,8", "--lattice");
  fails(options + "4,0,1,4" + region_, "--lattice takes no --region: cells are written whole.");
  expectFailure(run("fit " + options + "4,0,1,4 --max-distance 1 --format svg"), 2, "--max-distance");
  fails(sites_ + " --areas people --lattice 4,0,1,4",
        "sites.csv: The areas sum to 8, but the area of the box is 16. Set --shares to scale them.");
}

TEST_F(CliFit, ShowsItsProgress) {
  const auto [status, out, err] =
      run("fit " + sites_ + " --areas people --shares --progress always -o " + path("out.json") + region_);
  EXPECT_EQ(status, 0);
  for (const char* stage : {"read", "fit", "write"}) {
    EXPECT_TRUE(std::regex_search(err, std::regex(std::string(stage) + ", \\d+ s"))) << stage << " in " << err;
  }
  // Shares that grow to the whole.
  std::vector<int> parts;
  const std::regex part("fit (\\d+) %");
  for (auto found = std::sregex_iterator(err.begin(), err.end(), part); found != std::sregex_iterator(); ++found) {
    parts.push_back(std::stoi((*found)[1]));
  }
  ASSERT_GE(parts.size(), 2U) << err;
  EXPECT_GT(parts.front(), 0);
  EXPECT_LT(parts.front(), 100);
  EXPECT_EQ(parts.back(), 100);
  EXPECT_TRUE(std::ranges::is_sorted(parts)) << err;
}

}  // namespace
}  // namespace circle_voronoi
