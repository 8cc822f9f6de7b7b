// SPDX-License-Identifier: GPL-3.0-or-later
// The command treemap: a table in, the cells of a hierarchy out.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

constexpr const char* kPeople =
    "land,people,town\nNorth,3,Ash\nNorth,2,Birch\nSouth,1,Ash\n\"No, man\",0,\"01\"\nNorth,1,Ash\nSouth,4,Cedar\n";
constexpr const char* kStrip = "POLYGON ((0 0, 11 0, 11 1, 0 1))";

class CliTreemap : public test::Cli {
 protected:
  const std::string people_ = write("people.csv", kPeople);
  const std::string region_ = " --region " + write("region.wkt", kStrip);
  const std::string options_ = " --path land,town --values people" + region_;

  std::string textOf(const std::string& arguments, const std::string& input = "") const {
    return Cli::textOf("treemap " + arguments, input);
  }

  Json featuresOf(const std::string& arguments, const std::string& input = "") const {
    return Json::parse(textOf(arguments + " --format geojson", input))["features"];
  }

  void fails(const std::string& arguments, const std::string& message, int status = 2) const {
    expectFailure(run("treemap " + arguments), status, message);
  }

  /// The area of a closed ring.
  static double areaOf(const Json& ring) {
    double area = 0;
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      area += ring[k][0].get<double>() * ring[k + 1][1].get<double>() -
              ring[k + 1][0].get<double>() * ring[k][1].get<double>();
    }
    return area / 2;
  }

  /// Checks that the cells are those of the table.
  static void expectPeople(const Json& features) {
    struct Row {
      Json land, town;
      double people;
      int level;
    };
    const std::vector<Row> expected = {{"North", nullptr, 6, 1}, {"South", nullptr, 5, 1}, {"No, man", nullptr, 0, 1},
                                       {"North", "Ash", 4, 2},   {"North", "Birch", 2, 2}, {"South", "Ash", 1, 2},
                                       {"No, man", "01", 0, 2},  {"South", "Cedar", 4, 2}};
    ASSERT_EQ(features.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Json& properties = features[i]["properties"];
      EXPECT_EQ(properties["land"], expected[i].land) << i;
      EXPECT_EQ(properties["town"], expected[i].town) << i;
      EXPECT_EQ(properties["people"], expected[i].people) << i;
      EXPECT_EQ(properties["level"], expected[i].level) << i;
      EXPECT_NEAR(properties["area"].get<double>(), expected[i].people, 1e-7) << i;
      const Json& geometry = features[i]["geometry"];
      EXPECT_EQ(geometry.is_null(), expected[i].people == 0) << i;
      EXPECT_EQ(properties["x"].is_null(), expected[i].people == 0) << i;
      if (geometry.is_null()) continue;
      EXPECT_EQ(geometry["type"], "Polygon");
      EXPECT_NEAR(areaOf(geometry["coordinates"][0]), expected[i].people, 1e-7) << i;
    }
  }
};

TEST_F(CliTreemap, GivesEachPathItsShareAndAddsRowsOfOnePath) {
  expectPeople(featuresOf(people_ + options_));
  expectPeople(featuresOf("-" + options_, kPeople));
  // Curved borders are more than a line.
  const Json curved = featuresOf(people_ + options_ + " --metric circles");
  const Json straight = featuresOf(people_ + options_);
  EXPECT_EQ(curved[0], straight[0]);
  EXPECT_NEAR(curved[3]["properties"]["area"].get<double>(), 4, 1e-7);
  EXPECT_GT(curved[3]["geometry"]["coordinates"][0].size(), straight[3]["geometry"]["coordinates"][0].size());
  // Without a region the cells fill the unit square.
  double sum = 0;
  for (const Json& feature : featuresOf(people_ + " --path land --values PEOPLE")) {
    sum += feature["properties"]["area"].get<double>();
  }
  EXPECT_NEAR(sum, 1, 1e-8);
}

TEST_F(CliTreemap, ReadsTheSameFromEachFormat) {
  const std::string semicolons =
      write("semicolons.csv",
            "land;people;town\nNorth;3,0;Ash\nNorth;2,0;Birch\nSouth;1,0;Ash\nNo, man;0,0;01\nNorth;1,0;Ash\n"
            "South;4,0;Cedar\n");
  const std::string objects = write("objects.json", R"([{"town":"Ash","land":"N\u006frth","people":3},
{"town":"Birch","land":"North","people":2},{"town":"Ash","land":"South","people":1},
{"town":"01","land":"No, man","people":0},{"town":"Ash","land":"North","people":1},
{"people":4,"land":"South","town":"Cedar"}])");
  Json collection = {{"type", "FeatureCollection"}, {"features", Json::array()}};
  for (const Json& properties : Json::parse(readFile(objects))) {
    collection["features"].push_back({{"type", "Feature"}, {"geometry", nullptr}, {"properties", properties}});
  }
  expectPeople(featuresOf(semicolons + options_));
  expectPeople(featuresOf(objects + options_));
  expectPeople(featuresOf(write("features.geojson", collection.dump()) + options_));
}

TEST_F(CliTreemap, WritesTheSameInEachFormat) {
  const Json features = featuresOf(people_ + options_);
  const Json objects = Json::parse(textOf(people_ + options_));
  for (std::size_t i = 0; i < features.size(); ++i) {
    Json object = objects.at(i);
    const Json polygons = object["polygons"];
    object.erase("polygons");
    EXPECT_EQ(object, features[i]["properties"]);
    const Json& geometry = features[i]["geometry"];
    EXPECT_EQ(polygons, geometry.is_null() ? Json::array() : Json::array({geometry["coordinates"]}));
  }
  std::istringstream rows(textOf(people_ + options_ + " --format geojsonl"));
  for (const Json& feature : features) {
    std::string row;
    ASSERT_TRUE(std::getline(rows, row));
    EXPECT_EQ(Json::parse(row), feature);
  }
  const std::string csv = textOf(people_ + options_ + " --format csv");
  EXPECT_EQ(csv.rfind("land,town,people,level,area,x,y,weight\nNorth,,6,1,", 0), 0U) << csv;
  EXPECT_NE(csv.find("\n\"No, man\",01,0,2,0,,,\n"), std::string::npos) << csv;
  const std::string file = path("people.svg");
  EXPECT_EQ(textOf(people_ + options_ + " -o " + file), "");
  const std::string svg = readFile(file);
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_NE(svg.find("viewBox=\"0 -1 11 1\""), std::string::npos);
  EXPECT_LT(svg.find("<title>land: South, town: Cedar, people: 4</title>"), svg.find("class=\"level-1\""));
  EXPECT_GT(svg.find("<title>land: South, people: 5</title>"), svg.find("class=\"level-1\""));
  EXPECT_NE(textOf(write("tag.csv", "land,n\n\"<a & b>\",1\n") + " --path land --values n --format svg")
                .find("<title>land: &lt;a &amp; b>, n: 1<"),
            std::string::npos);
}

TEST_F(CliTreemap, LeavesSitesWhereAnEarlierOutputHasThem) {
  const std::string changed = write("changed.csv", std::string(kPeople) + "South,1,Dill\n");
  const auto placesOf = [&](const std::string& arguments) {
    std::map<std::string, Json> places;
    for (const Json& feature : featuresOf(arguments)) {
      const Json& properties = feature["properties"];
      places[properties["land"].dump() + properties["town"].dump()] = {properties["x"], properties["y"]};
    }
    return places;
  };
  const auto first = placesOf(people_ + options_);
  for (const char* format : {"csv", "json", "geojson"}) {
    const std::string previous = path(std::string("previous.") + format);
    textOf(people_ + options_ + " -o " + previous);
    EXPECT_EQ(placesOf(people_ + options_ + " --previous " + previous), first) << format;
    const auto later = placesOf(changed + options_ + " --previous " + previous);
    for (const char* same : {"\"North\"null", "\"South\"null", "\"North\"\"Ash\"", "\"North\"\"Birch\""}) {
      EXPECT_EQ(later.at(same), first.at(same)) << format << same;
    }
    EXPECT_NE(later.at("\"South\"\"Ash\""), first.at("\"South\"\"Ash\"")) << "a sibling is new";
  }
}

TEST_F(CliTreemap, MovesSitesToTheCentersOfTheirCells) {
  const std::string letters = write("letters.csv", "name,n\na,1\nb,2\nc,3\nd,4\ne,5\n") + " --path name --values n";
  const std::string sites = path("sites.csv");
  textOf(letters + " --relax 0 -o " + sites);
  EXPECT_EQ(textOf(letters + " --previous " + sites + " --format csv"), readFile(sites));
  EXPECT_NE(textOf(letters + " --format csv"), readFile(sites));
  EXPECT_NE(textOf(letters + " --previous " + sites + " --relax 8 --format csv"), readFile(sites));
}

TEST_F(CliTreemap, NamesTheRowOfAnError) {
  const auto with = [&](const std::string& row) {
    return write("with.csv", std::string(kPeople) + row + "\n") + options_;
  };
  fails(with("North,-1,Elm"), "with.csv:8: row 6 has the number \"people\" below 0 (-1).");
  fails(with("North,,Elm"), "with.csv:8: row 6 has no number \"people\".");
  fails(with("North,inf,Elm"), "with.csv:8: row 6 has no number \"people\".");
  fails(with(",1,Elm"), "with.csv:8: row 6 has no \"land\".");
  fails(with("North,1"), "with.csv:8: row 6 has no \"town\".");
  fails(with("North,1,Elm,2"), "with.csv:8: there are 4 fields in 3 columns.");
  fails(write("row.json", "[{\"land\":1,\"town\":2,\"people\":3},\n5]") + options_,
        "row.json:2: expected an object, not a number.");
  fails(write("row.geojson", "{\"type\":\"Point\"}") + options_,
        "row.geojson:1: expected an array of objects or a GeoJSON FeatureCollection.");
  fails(write("zero.csv", "land,town,people\na,b,0\n") + options_, "zero.csv: All values are zero.");
  fails(write("none.csv", "land,town,people\n") + options_, "none.csv: There are no rows.");
  fails(people_ + " --path nation --values people",
        "people.csv:1: no column is called nation, only land, people, town.");
  fails(write("people.json", "[\n{\"land\":1},\n{\"town\":2,\"people\":3}]") + " --path town,nation --values people",
        "people.json:2: no member is called nation, only land.");
}

TEST_F(CliTreemap, RefusesOptionsThatDoNotGoTogether) {
  fails(people_ + " --values people", "--path is required");
  fails(people_ + " --path land", "--values is required");
  fails(people_ + " --path land,land --values people",
        "The output has another column called land; rename the column of the input.");
  fails(write("area.csv", "Area,n\na,1\n") + " --path Area --values n",
        "The output has another column called Area; rename the column of the input.");
  fails(write("polygons.csv", "polygons,n\na,1\n") + " --path polygons --values n",
        "The output has another column called polygons; rename the column of the input.");
  fails(people_ + options_ + " --area-tolerance 5e-324",
        "people.csv: The cell of the whole region cannot be divided: --area-tolerance must be above 0");
  fails(people_ + options_ + " -o " + path("cells.wkt"), "treemap needs --format json, csv, svg, geojson or geojsonl.");
  fails(people_ + options_ + " --metric centers", "--metric");
  fails(people_ + options_ + " --relax -1", "--relax");
  fails(people_ + options_ + " --area-tolerance 2", "--area-tolerance must be above 0 and below 1 (got 2).");
  fails(people_ + " --path land --values people --dissolve", "--dissolve needs --region.");
  fails(people_ + options_ + " -o " + people_, "people.csv would be overwritten");
  fails(people_ + options_ + " --previous " + people_, "people.csv:1: no column is called x, only land, people, town.");
}

TEST_F(CliTreemap, ShowsItsProgress) {
  const auto [status, out, err] = run("treemap " + people_ + options_ + " --progress always -o " + path("out.json"));
  EXPECT_EQ(status, 0);
  for (const char* stage : {"read", "treemap", "write"}) {
    EXPECT_TRUE(std::regex_search(err, std::regex(std::string(stage) + "[ ,]"))) << stage << " in " << err;
  }
}

}  // namespace
}  // namespace circle_voronoi
