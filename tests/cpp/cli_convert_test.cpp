// SPDX-License-Identifier: GPL-3.0-or-later
// circle-voronoi convert: circles and diagrams in other formats.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"
#include "cli.h"
#include "fixtures.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

class CliConvert : public test::Cli {
 protected:
  const std::string fixture_ = test::pathOfFixture("waka");

  std::string computed() const {
    textOf("compute " + fixture_ + " -o " + path("diagram.json"));
    return path("diagram.json");
  }
};

TEST_F(CliConvert, ADiagramHasTheDigitsThatAreAskedFor) {
  const std::string file = write("circles.csv", "0.123456,0,1\n6,0.5,1\n0,8,1.25\n3,3,0.1\n");
  ASSERT_EQ(run("compute " + file + " -o " + path("diagram.json")).status, 0);
  for (const std::string format : {"json", "csv", "wkt", "geojson", "geojsonl", "svg", "obj"}) {
    const std::string options = " --digits 2 --format " + format;
    const auto [status, out, err] = run("convert " + path("diagram.json") + options);
    ASSERT_EQ(status, 0) << err;
    EXPECT_LT(out.size(), run("convert " + path("diagram.json") + " --format " + format).out.size());
    // But for its times and counts.
    if (format != "json") {
      EXPECT_EQ(run("compute " + file + options).out, out);
    }
  }
  const std::string rounded = run("convert " + path("diagram.json") + " --digits 2").out;
  EXPECT_NE(rounded.find("{\"x\": 0.123456, \"y\": 0, \"r\": 1}"), std::string::npos) << "circles keep theirs";
  EXPECT_EQ(run("certify -", rounded).status, 1);
  EXPECT_EQ(run("certify -", run("convert " + path("diagram.json") + " --digits 14").out).status, 0);
  EXPECT_EQ(run("convert " + path("diagram.json") + " --digits 400").out, readFile(path("diagram.json")));
}

TEST_F(CliConvert, CirclesGoThroughEveryFormatToTheBit) {
  auto circles = generate(Family::logUniform, 50, 1);
  circles[7].x = -0.0;
  std::ostringstream csv;
  EXPECT_TRUE(writeCirclesCsv(csv, circles));
  std::string text = csv.str();
  for (const char* format : {"geojson", "json", "geojson", "csv", "json", "csv"}) {
    text = textOf("convert - --format " + std::string(format), text);
  }
  EXPECT_EQ(text, csv.str());
}

TEST_F(CliConvert, CirclesAreWhatTheFormatsPromise) {
  const std::string csv = "1,2,3\n-4.5,0.005,0\n";
  EXPECT_EQ(textOf("convert - --format csv", csv), "x,y,r\n1,2,3\n-4.5,0.005,0\n");
  EXPECT_EQ(Json::parse(textOf("convert -", csv)),
            Json::parse(R"([{"x": 1, "y": 2, "r": 3}, {"x": -4.5, "y": 0.005, "r": 0}])"));
  EXPECT_EQ(Json::parse(textOf("convert - --format geojson", csv)),
            Json::parse(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"r": 3}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
    {"type": "Feature", "properties": {"r": 0},
     "geometry": {"type": "Point", "coordinates": [-4.5, 0.005]}}]})"));
  for (const char* format : {"csv", "json", "geojson"}) {
    const std::string none = textOf("convert - --format " + std::string(format), "x,y,r\n");
    EXPECT_TRUE(readCircles(none, "none").value().empty()) << none;
  }
}

// Computed, verified, converted and cut: each with --weights, or because the file says it.
TEST_F(CliConvert, WeightsAreOfAnySign) {
  const std::string csv = "x,y,r\n0,0,-3\n6,0,-1\n3,7,-2\n6.5,0,-2\n";
  const std::string plain = "x,y,r\n0,0,0\n6,0,2\n3,7,1\n6.5,0,1\n";
  const std::string problem = "standard input:2: Circle 0 has a negative radius.";
  for (const char* command : {"compute -", "convert -", "tile - --size 1 --halo 1 -o tiles"}) {
    expectFailure(run(command, csv), 2, problem);
  }
  textOf("compute - --weights -o " + path("weights.json"), csv);
  EXPECT_EQ(textOf("certify " + path("weights.json")), "certified: 4 circles, 1 of them hidden; 1 vertices, 3 edges\n");
  EXPECT_EQ(textOf("convert --circles --format csv " + path("weights.json")), csv);
  EXPECT_EQ(textOf("convert --weights --format csv -", csv), csv);
  for (const char* format : {"wkt", "obj"}) {
    const std::string box = " --bounds=-9,-9,20,20 --format " + std::string(format);
    EXPECT_EQ(textOf("convert " + path("weights.json") + box), textOf("compute -" + box, plain));
    EXPECT_EQ(textOf("compute --weights -" + box, csv), textOf("compute -" + box, plain));
  }
  expectFailure(run("convert --weights " + path("weights.json")), 2,
                path("weights.json") + ": --weights is for circles alone; a diagram's file says what its circles are.");

  textOf("tile --weights - --size 10 --halo 20 -o " + path("tiles"), csv);
  const std::string known = " --format csv --max-radius 0 --core=0,0,10,10 --known=-inf,-inf,inf,inf ";
  expectFailure(run("compute " + path("tiles/x0y0.csv") + known), 2,
                path("tiles/x0y0.csv") + ":2: Circle 0 has a negative radius.");
  EXPECT_NE(textOf("compute --weights " + path("tiles/x0y0.csv") + known).find("hidden,,,,3,1"), std::string::npos);
}

TEST_F(CliConvert, CellsAreCutAtAMaximumDistance) {
  const std::string circles = "0,0,1\n4,0,1\n";
  const std::string cut = textOf("compute - --format wkt --max-distance 1 --tolerance 1 --bounds=-9,-9,1,9", circles);
  EXPECT_EQ(cut,
            "POLYGON ((1 -1.7320508075688772, 1 1.7320508075688772, 0 2, -2 0, 0 -2, 1 -1.7320508075688772))\n"
            "POLYGON EMPTY\n");
  textOf("compute - -o " + path("diagram.json"), circles);
  for (const char* format : {"svg", "geojson", "geojsonl", "wkt", "obj"}) {
    const std::string options = " --max-distance 1.5 --format " + std::string(format);
    const std::string text = textOf("compute -" + options, circles);
    EXPECT_EQ(textOf("convert " + path("diagram.json") + options), text);
    EXPECT_NE(textOf("compute - --format " + std::string(format), circles), text);
  }
  expectFailure(run("compute - --max-distance 1", circles), 2,
                "--max-distance needs --format cells, svg, geojson, geojsonl, wkt or obj.");
  expectFailure(run("compute - --format svg --max-distance=inf", circles), 2,
                "--max-distance: expected a number up to 1.2e30 (2^100).");
}

TEST_F(CliConvert, TheNameOfTheOutputTellsTheFormat) {
  for (const char* name : {"circles.csv", "circles.geojson", "circles.json", "circles"}) {
    EXPECT_EQ(textOf("convert " + fixture_ + " -o " + path(name)), "");
  }
  EXPECT_EQ(readFile(path("circles.csv")), textOf("convert --format csv " + fixture_));
  EXPECT_EQ(readFile(path("circles.geojson")), textOf("convert --format geojson " + fixture_));
  EXPECT_EQ(readFile(path("circles.json")), textOf("convert " + fixture_));
  EXPECT_EQ(readFile(path("circles")), readFile(path("circles.json")));
  textOf("convert " + fixture_ + " --format csv -o " + path("other.json"));
  EXPECT_EQ(readFile(path("other.json")), readFile(path("circles.csv"))) << "what the user says comes first";
}

TEST_F(CliConvert, ADiagramBecomesWhatComputeWrites) {
  const std::string diagram = computed();
  for (const char* format : {"csv", "svg", "geojson", "wkt", "obj"}) {
    const std::string options = " --format " + std::string(format);
    EXPECT_EQ(textOf("convert " + diagram + options), textOf("compute " + fixture_ + options)) << format;
  }
  const std::string box = " --format wkt --bounds 0,0,5,5 --tolerance 0.1";
  EXPECT_EQ(textOf("convert " + diagram + box), textOf("compute " + fixture_ + box));
  EXPECT_EQ(textOf("convert - --format svg", readFile(diagram)), textOf("convert " + diagram + " --format svg"));
}

TEST_F(CliConvert, ADiagramKeepsItsStats) {
  const std::string diagram = path("diagram.json");
  for (const std::string method : {"auto", "touching-disc --candidates uniform"}) {
    textOf("compute " + fixture_ + " --method " + method + " -o " + diagram);
    EXPECT_EQ(textOf("convert " + diagram), readFile(diagram));
    EXPECT_EQ(Json::parse(textOf("convert --format stats " + diagram)), Json::parse(readFile(diagram)).at("stats"));
  }
  EXPECT_EQ(Json::parse(readFile(diagram)).at("stats").at("candidates"), "uniform");
}

TEST_F(CliConvert, StatsThatFitNothingAreLeftOut) {
  Json json = Json::parse(readFile(computed()));
  json["stats"] =
      Json::parse(R"({"method": "\"quoted\"", "way": 7, "counts": [1], "seconds": {"triangulate": "long", "total": 2},
                                  "certificate": {"certified": false, "message": "wrong"}})");
  const Json stats = Json::parse(textOf("convert - --format stats", json.dump()));
  EXPECT_EQ(stats.at("method"), "");
  EXPECT_EQ(stats.at("way"), "");
  EXPECT_EQ(stats.at("counts").at("circles"), 0);
  EXPECT_EQ(stats.at("seconds").at("triangulate"), 0);
  EXPECT_EQ(stats.at("seconds").at("total"), 2);
  EXPECT_EQ(stats.at("certificate").at("certified"), true) << "judged, not believed";
  json["stats"] = Json::parse(
      R"({"counts": {"circles": "many", "hidden": -1, "flips": 2.5, "events": null, "samples": 3}, "candidates": 1})");
  const Json counts = Json::parse(textOf("convert - --format stats", json.dump())).at("counts");
  for (const char* name : {"circles", "hidden", "flips", "events"}) EXPECT_EQ(counts.at(name), 0) << name;
  EXPECT_EQ(counts.at("samples"), 3);
  json.erase("stats");
  EXPECT_EQ(Json::parse(textOf("convert -", json.dump())).at("stats").at("certificate").at("certified"), true);
}

TEST_F(CliConvert, TakesTheCirclesOfADiagram) {
  EXPECT_EQ(textOf("convert --circles --format csv " + computed()), textOf("convert --format csv " + fixture_));
}

TEST_F(CliConvert, RefusesImpossibleConversions) {
  expectFailure(run("convert --format svg " + fixture_), 2, "Circles alone cannot be written as svg");
  expectFailure(run("convert --circles --format svg " + computed()), 2, "Circles alone cannot be written as svg");
  expectFailure(run("convert " + path("absent.csv")), 1, "absent.csv");

  Json moved = Json::parse(readFile(computed()));
  moved["vertices"][7]["x"] = moved["vertices"][7]["x"].get<double>() + 0.001;
  const std::string wrong = write("wrong.json", moved.dump());
  expectFailure(run("convert --format svg " + wrong), 1, "wrong.json: The diagram is not certified: Vertex 7");
  EXPECT_EQ(Json::parse(textOf("convert --format stats " + wrong)).at("certificate").at("vertex"), 7);
}

}  // namespace
}  // namespace circle_voronoi
