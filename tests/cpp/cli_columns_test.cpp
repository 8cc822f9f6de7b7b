// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of circles, skipped rows, and messages on standard error, in every command.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

// The neighbors in sites-outside-box.csv whose cells touch inside the box, according to a grid of 1500 by 1500 points.
constexpr const char* kInside = "[[], [3, 4], [], [1, 4, 7], [1, 3, 5, 7, 8], [4, 8], [], [3, 4, 8], [4, 5, 7]]";

constexpr const char* kShops =
    "\xEF\xBB\xBFname;northing;easting;umsatz\r\n\"Z\xC3\xBCrich; Nord\";47,4;8,55;0,2\r\nBern;46,95;7,45;0,1\r\n"
    "Basel;47,55;7,6;0,05\r\n";

class CliColumns : public test::Cli {
 protected:
  const std::string shops_ = write("shops.csv", kShops);
  const std::string region_ = write("region.wkt", "POLYGON ((7 46, 9 46, 9 48, 7 48))");
  const std::string none_ = write("none.csv", "# no edits\n");

  Json cellsOf(const std::string& arguments) const {
    return Json::parse(textOf(arguments + " --format geojson"))["features"];
  }
};

TEST_F(CliColumns, AreNamedInEveryCommandThatReadsCircles) {
  for (const std::string& command :
       std::vector<std::string>{"compute " + shops_, "edit " + shops_ + " --script " + none_,
                                "fit " + shops_ + " --areas umsatz --shares --region " + region_}) {
    const bool isFit = command.starts_with("fit");
    const Json cells = cellsOf(command + " --id name" + (isFit ? "" : " --radius Umsatz"));
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells[0]["id"], "Z\xC3\xBCrich; Nord") << command;
    EXPECT_EQ(cells[1]["properties"]["name"], "Bern");
    EXPECT_EQ(cells[2]["properties"][isFit ? "umsatz" : "r"], 0.05);
  }
  EXPECT_EQ(textOf("convert " + shops_ + " --radius umsatz --x northing --y easting --format csv"),
            "x,y,r,name\n47.4,8.55,0.2,Z\xC3\xBCrich; Nord\n46.95,7.45,0.1,Bern\n47.55,7.6,0.05,Basel\n");
  EXPECT_EQ(textOf("convert " + shops_ + " --points --format csv").substr(0, 20), "x,y,r,name,umsatz\n8.");
  const std::string ids = write("ids.csv", "code;x;y;size\n7;0;0;1\n9;3;0;1\n");
  textOf("tile " + ids + " --radius size --id code --size 10 --halo 1 -o " + path("tiles"));
  EXPECT_EQ(readFile(path("tiles/x0y0.csv")), "id,x,y,r,done\n7,0,0,1,0\n9,3,0,1,0\n");
  const std::string known = " --format csv --max-radius 0 --known=-inf,-inf,inf,inf --radius size --id code";
  EXPECT_NE(textOf("compute " + ids + known).find("edge,,,,7,9"), std::string::npos);
  expectFailure(
      run("compute " + shops_), 2,
      shops_ + ":1: no column is called r, rad or radius, only name, northing, easting, umsatz; name one by --radius.");
}

TEST_F(CliColumns, AreQuotedAsTheyAre) {
  for (const std::string name : {"the option r", "Set `dissolve` to merge them.", "`shares` tolerance relax"}) {
    const std::string file = write(name, "\"x\",\"y\",\"" + name + "\"\n1,2,no\n");
    const std::string quoted = "'" + file + "'";
    expectFailure(
        run("compute " + quoted), 2,
        file + ":1: no column is called r, rad or radius, only x, y, " + name + "; make all radii 0 by --points.");
    expectFailure(run("compute " + quoted + " --radius '" + name + "'"), 2,
                  file + ":2: " + name + " is not a number: \"no\".");
    expectFailure(run("fit " + quoted + " --lattice 1,0,0,1 --areas '" + name + "'"), 2,
                  file + ": circle 0 has no number \"" + name + "\".");
  }
}

TEST_F(CliColumns, WeightsMayHaveAColumn) {
  const std::string file = write("weights.csv", "x,y,r,w\n0,0,1,-1\n5,0,1,2\n");
  const std::string expected =
      textOf("convert " + write("plain.csv", "x,y,r,old\n0,0,-1,1\n5,0,2,1\n") + " --weights --format json");
  EXPECT_EQ(Json::parse(textOf("convert --weights w " + file))[1]["r"], 2);
  EXPECT_EQ(textOf("convert --weights=w " + file), textOf("convert " + file + " --weights w"));
  EXPECT_EQ(textOf("convert --weights " + file), textOf("convert " + file + " --weights")) << "the file, not a column";
  EXPECT_EQ(textOf("convert --weights --radius w " + file), textOf("convert --weights w " + file));
  EXPECT_EQ(Json::parse(textOf("compute --weights w " + file))["weights"], true);
  expectFailure(run("convert --weights w --radius r " + file), 2, "--weights w takes no --radius.");
  expectFailure(run("convert --weights --points " + file), 2, "--weights takes no --points.");
  expectFailure(run("convert --points --radius r " + file), 2, "excludes --points");
  expectFailure(run("convert --weights"), 2, "FILE is required");
  expectFailure(run("compute"), 2, "FILE is required");
}

TEST_F(CliColumns, OptionsAboutThemAreNotForDiagrams) {
  textOf("compute " + shops_ + " --points -o " + path("diagram.json"));
  for (const std::string option :
       {"--x a", "--y a", "--radius a", "--points", "--id a", "--skip-invalid", "--weights"}) {
    const std::string name = option.substr(0, option.find(' '));
    const std::string message = ": " + name + " is for circles alone; a diagram's file says what its circles are.";
    expectFailure(run("convert " + path("diagram.json") + " " + option), 2, message);
    expectFailure(run("edit " + path("diagram.json") + " --script " + none_ + " " + option), 2, message);
  }
}

TEST_F(CliColumns, InvalidRowsAreSkippedAndCounted) {
  const std::string file = write("missing.csv", "id,x,y,r\n1,1,1,0\n2,,,0\n3,3,1,0\n4,NaN,NaN,0\n5,2,3,0\n");
  const std::string said =
      "circle-voronoi: 2 of 5 were skipped; the first: " + file + ":3: x is empty (circle 1, id 2).\n";
  EXPECT_EQ(textOf("convert --skip-invalid --format csv " + file, "", said), "x,y,r,id\n1,1,0,1\n3,1,0,3\n2,3,0,5\n");
  EXPECT_EQ(Json::parse(textOf("compute --skip-invalid " + file, "", said))["circles"][2]["properties"]["id"], 5);
  textOf("edit --skip-invalid " + file + " --script " + none_, "", said);
  textOf("fit --skip-invalid " + file + " --areas id --shares --region " +
             write("box.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4))"),
         "", said);
  textOf("convert --skip-invalid -", "1,2,3\n1,2,x\n4,5,6\n",
         "circle-voronoi: 1 of 3 was skipped; the first: standard input:2: r is not a number: \"x\".\n");
  expectFailure(run("compute " + file), 2, file + ":3: x is empty (circle 1, id 2).");
  expectFailure(run("compute --skip-invalid --known=0,0,9,9 --max-radius 0 --format csv " + file), 2,
                "--known takes no --skip-invalid.");
}

TEST_F(CliColumns, ManyHiddenCirclesCauseAHint) {
  const std::string file =
      write("degrees.csv", "lon,lat,radius\n149.149,-35.315,500\n149.3,-35.5,800\n149.0,-35.2,300\n");
  const auto [status, out, err] = run("compute " + file + " --format wkt");
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(err.find("circle-voronoi: 2 of 3 circles are hidden inside others and have no cell. Perhaps ") !=
              err.npos)
      << err;
  EXPECT_NE(err.find("--project"), std::string::npos);
  // By other metrics, circles without a cell are usual.
  const std::string crowd = write("crowd.csv", "-2,0,9\n2,0,9\n0,2,9\n0,-2,9\n0,0,1\n0.1,0,1\n0,0.1,1\n");
  EXPECT_NE(run("compute " + crowd + " --format wkt").err, "");
  textOf("compute " + crowd + " --metric power --format wkt");
  textOf("compute " + write("quarter.csv", "0,0,9\n1,1,1\n20,0,1\n0,20,1\n") + " --format wkt");
}

TEST_F(CliColumns, LostMembersOfACollectionCauseAWarning) {
  const std::string file = write("points.geojson", R"({"type":"FeatureCollection","crs":{"a":"b"},"features":[
{"type":"Feature","id":"A","properties":{"r":1},"geometry":{"type":"Point","coordinates":[1,2,3]}}]})");
  const auto said = [](const std::string& format) {
    return "circle-voronoi: The format " + format + " has no place for the members of the collection, such as crs.\n";
  };
  for (const std::string format : {"csv", "json"}) textOf("convert " + file + " --format " + format, "", said(format));
  textOf("compute " + file + " --format geojsonl", "", said("geojsonl"));
  EXPECT_EQ(Json::parse(textOf("convert " + file + " --format geojson"))["crs"]["a"], "b");
  EXPECT_EQ(Json::parse(textOf("compute " + file + " --format geojson"))["crs"]["a"], "b");
  EXPECT_EQ(Json::parse(textOf("compute " + file))["collection"]["crs"]["a"], "b");
}

TEST_F(CliColumns, NeighborsInClippedFilesAreThoseInside) {
  const std::string sites = CIRCLE_VORONOI_FILES "/brought/sites-outside-box.csv";
  const auto neighborsOf = [&](const std::string& options) {
    Json neighbors;
    for (const Json& cell : cellsOf("compute " + sites + options)) {
      Json list = cell["properties"]["neighbors"];
      std::sort(list.begin(), list.end());
      neighbors.push_back(list);
      EXPECT_TRUE(options.empty() || !cell["geometry"].is_null() || list.empty());
    }
    return neighbors;
  };
  const Json all = neighborsOf("");
  const Json boxed = neighborsOf(" --bounds 2048,2048,4096,4096");
  EXPECT_NE(boxed, all);
  EXPECT_EQ(neighborsOf(" --region " + write("box.wkt", "POLYGON ((2048 2048, 4096 2048, 4096 4096, 2048 4096))")),
            boxed);
  EXPECT_EQ(boxed, Json::parse(kInside));
  EXPECT_NE(neighborsOf(" --max-distance 500"), all);
}

TEST_F(CliColumns, AttributesStayWithTheirCirclesWhenTheseAreEdited) {
  const std::string file = write("circles.csv", "id,x,y,r,z,note\nA,0,0,1,5,a\nB,6,0,1,6,b\nC,0,8,1,7,c\n");
  const std::string script = write("script.csv", "remove,0\nreplace,2,0,9,2\ninsert,9,9,1\n");
  const Json circles = Json::parse(textOf("edit " + file + " --script " + script))["circles"];
  EXPECT_EQ(circles, Json::parse(R"([
    {"x": 6, "y": 0, "r": 1, "z": 6, "id": "B", "properties": {"id": "B", "z": 6, "note": "b"}},
    {"x": 0, "y": 9, "r": 2, "z": 7, "id": "C", "properties": {"id": "C", "z": 7, "note": "c"}},
    {"x": 9, "y": 9, "r": 1}])"));
}

}  // namespace
}  // namespace circle_voronoi
