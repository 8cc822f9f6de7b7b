// SPDX-License-Identifier: GPL-3.0-or-later
// --lattice of compute.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "circle_voronoi/io.h"
#include "cli.h"
#include "lines.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

class CliPeriodic : public test::Cli {
 protected:
  const std::string circles_ = write("circles.csv", "x,y,r,name\n0.1,0.2,0.1,A\n0.6,0.7,0.2,B\n0.6,0.75,0.02,C\n");
};

TEST_F(CliPeriodic, GeoJsonHasWholeCellsAndShifts) {
  for (const std::string format : {"geojson", "geojsonl"}) {
    const std::string text = textOf("compute " + circles_ + " --lattice 1,0,0.25,1 --format " + format);
    std::vector<Json> features;
    if (format == "geojson") {
      const Json collection = Json::parse(text);
      for (const Json& feature : collection["features"]) features.push_back(feature);
    } else {
      for (const std::string& line : test::linesOf(text)) features.push_back(Json::parse(line));
    }
    ASSERT_EQ(features.size(), 3U);
    double sum = 0;
    using Contact = std::tuple<int, int, int, int>;
    std::map<Contact, int> contacts;
    for (int i = 0; i < 3; ++i) {
      const Json& properties = features[static_cast<std::size_t>(i)]["properties"];
      EXPECT_EQ(properties["circle"], i);
      sum += properties["area"].get<double>();
      ASSERT_EQ(properties["neighbors"].size(), properties["shifts"].size());
      for (std::size_t k = 0; k < properties["neighbors"].size(); ++k) {
        const Json& shift = properties["shifts"][k];
        ++contacts[{i, properties["neighbors"][k].get<int>(), shift[0].get<int>(), shift[1].get<int>()}];
      }
      const Json& geometry = features[static_cast<std::size_t>(i)]["geometry"];
      if (i == 2) {
        EXPECT_TRUE(geometry.is_null());
        EXPECT_EQ(properties["hiddenBy"], 1);
        EXPECT_EQ(properties["hiderShift"], (Json{0, 0}));
      } else {
        EXPECT_EQ(geometry["type"], "Polygon");
        EXPECT_NEAR(test::areaOf(geometry["coordinates"][0]), properties["area"].get<double>(), 1e-4);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_FALSE(contacts.empty());
    for (const auto& [contact, count] : contacts) {
      const auto& [i, j, k, l] = contact;
      EXPECT_EQ((contacts[{j, i, -k, -l}]), count);
    }
    EXPECT_EQ(features[0]["properties"]["name"], "A");
  }
}

TEST_F(CliPeriodic, CellsOfCirclesThatAreMovedLieAroundTheCirclesAsGiven) {
  const std::string far = write("far.csv", "0,0,0.1\n7.5,0.5,0.1\n0.5,-20.25,0.1\n");
  const Json features = Json::parse(textOf("compute " + far + " --lattice 1,0,0,1 --format geojson"))["features"];
  const std::vector<std::pair<double, double>> centers = {{0, 0}, {7.5, 0.5}, {0.5, -20.25}};
  for (std::size_t i = 0; i < 3; ++i) {
    double x = 0;
    double y = 0;
    const Json& ring = features[i]["geometry"]["coordinates"][0];
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      x += ring[k][0].get<double>() / static_cast<double>(ring.size() - 1);
      y += ring[k][1].get<double>() / static_cast<double>(ring.size() - 1);
    }
    EXPECT_LT(std::hypot(x - centers[i].first, y - centers[i].second), 0.5);
  }
  // From circle 0 to the image of circle 1 beside it.
  const Json& properties = features[0]["properties"];
  bool isFound = false;
  for (std::size_t k = 0; k < properties["neighbors"].size(); ++k) {
    if (properties["neighbors"][k] == 1) isFound = isFound || std::abs(properties["shifts"][k][0].get<int>() + 7) <= 1;
  }
  EXPECT_TRUE(isFound);
}

TEST_F(CliPeriodic, CsvIsTheTableOfContacts) {
  std::istringstream lines(textOf("compute " + circles_ + " --lattice 1,0,0.25,1 --format csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "circle,neighbor,shift_a,shift_b,length,gap,area,packing_fraction");
  std::map<int, double> areas;
  int count = 0;
  while (std::getline(lines, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream fields(line);
    int circle = 0;
    int neighbor = 0;
    int a = 0;
    int b = 0;
    double length = 0;
    double gap = 0;
    double area = 0;
    double fraction = 0;
    ASSERT_TRUE(fields >> circle >> neighbor >> a >> b >> length >> gap >> area >> fraction);
    const double dx = circle == neighbor ? 0 : circle == 0 ? 0.5 : -0.5;
    const double r = circle == neighbor ? 0.1 + 0.1 * circle : 0.15;
    EXPECT_NEAR(gap, std::hypot(dx + a + 0.25 * b, dx + b) - 2 * r, 1e-12);
    EXPECT_GE(length, 0);
    areas[circle] = area;
    const double own = circle == 0 ? 0.1 : 0.2;
    EXPECT_NEAR(fraction * area, 3.14159265358979 * own * own, 1e-12);
    ++count;
  }
  EXPECT_GE(count, 10);
  EXPECT_EQ(areas.size(), 2U);
  EXPECT_NEAR(areas[0] + areas[1], 1, 1e-12);
}

TEST_F(CliPeriodic, JsonIsADiagramWithShifts) {
  const std::string text = textOf("compute " + circles_ + " --lattice 1,0,0.25,1");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["lattice"], (Json{{1.0, 0.0}, {0.25, 1.0}}));
  ASSERT_EQ(json["images"].size(), json["circles"].size());
  for (std::size_t m = 0; m < json["images"].size(); ++m) {
    const Json& image = json["images"][m];
    const Json& given = json["circles"][image["circle"].get<std::size_t>()];
    const int a = image["shift"][0].get<int>();
    const int b = image["shift"][1].get<int>();
    if (m < 3) {
      EXPECT_EQ(image["circle"], m);
    }
    EXPECT_NEAR(json["circles"][m]["x"].get<double>(), given["x"].get<double>() + a + 0.25 * b, 1e-15);
    EXPECT_NEAR(json["circles"][m]["y"].get<double>(), given["y"].get<double>() + b, 1e-15);
  }
  ASSERT_EQ(json["neighbors"].size(), 3U);
  EXPECT_GE(json["neighbors"][0].size(), 3U);
  EXPECT_TRUE(json["neighbors"][2].empty());
  // Commands that read diagrams can read it, too.
  const std::string file = write("diagram.json", text);
  EXPECT_EQ(run("certify " + file).status, 0);
  EXPECT_TRUE(readDiagram(text, "text"));
}

TEST_F(CliPeriodic, TheDrawingShowsCellsThatCrossTheBoxOnBothSides) {
  const std::string svg = textOf("compute " + circles_ + " --lattice 1,0,0.25,1 --format svg");
  // Names that other drawings in the same page do not have.
  const std::string start = "<clipPath id=\"box";
  const std::size_t from = svg.find(start) + start.size();
  ASSERT_NE(svg.find(start), std::string::npos);
  const std::string id = svg.substr(from, svg.find('"', from) - from);
  EXPECT_GT(id.size(), 8U);
  const std::string other = textOf("compute " + circles_ + " --lattice 1,0,0.5,1 --format svg");
  EXPECT_EQ(other.find(id), std::string::npos);
  EXPECT_NE(svg.find("class=\"lattice\""), std::string::npos);
  for (const std::string group : {"cells", "circles", "edges"}) {
    EXPECT_NE(svg.find("<g class=\"" + group + "\" "), std::string::npos) << group;
  }
  // Circle 0 is drawn once, and used at its own place and as image beside its neighbors.
  const auto count = [&](const std::string& part) {
    int found = 0;
    for (std::size_t k = svg.find(part); k != std::string::npos; k = svg.find(part, k + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<circle data-circle=\"0\""), 1);
  EXPECT_EQ(count("<path data-circle=\"0\""), 1);
  for (const std::string place : {"x=\"0\" y=\"0\"", "x=\"1\" y=\"0\"", "x=\"0.25\" y=\"1\"", "x=\"-1\" y=\"0\""}) {
    EXPECT_EQ(count("<use href=\"#given" + id + "\" " + place + "/>"), 1) << place;
  }
  // Each border once: six for each visible circle, and each for two.
  EXPECT_EQ(count("<path data-edge="), 6);
}

TEST_F(CliPeriodic, TheDrawingHasAMarginWithTheCopiesThatReachIntoIt) {
  const auto drawingOf = [&](const std::string& circle) {
    return textOf("compute " + write("one.csv", circle) + " --lattice 1,0,0,1 --format svg");
  };
  const auto copiesIn = [](const std::string& svg) {
    const std::regex use("<use href=\"#given-[0-9]+\" x=\"([^\"]+)\" y=\"([^\"]+)\"/>");
    std::vector<std::pair<std::string, std::string>> places;
    for (std::sregex_iterator at(svg.begin(), svg.end(), use), end; at != end; ++at)
      places.emplace_back((*at)[1], (*at)[2]);
    return places;
  };
  const std::string svg = drawingOf("0.5,0.5,0\n");
  EXPECT_NE(svg.find("viewBox=\"-0.15 -1.15 1.2999999999999998 1.2999999999999998\""), std::string::npos);
  EXPECT_EQ(copiesIn(svg).size(), 9U);
  // The copy on the left ends in the margin, or before it. The radius is room for the borders between two vertices.
  EXPECT_EQ(copiesIn(drawingOf("0.4,0.5,0\n")).size(), 9U);
  EXPECT_EQ(copiesIn(drawingOf("0.3,0.5,0\n")).size(), 6U);
  EXPECT_EQ(copiesIn(drawingOf("0.3,0.5,0.9\n")).size(), 20U);
}

TEST_F(CliPeriodic, RefusesInvalidLatticesAndOptions) {
  const auto fails = [&](const std::string& arguments, const std::string& message) {
    expectFailure(run("compute " + circles_ + " " + arguments), 2, message);
  };
  fails("--lattice 1,0,1", "expected AX,AY,BX,BY, not 3 numbers.");
  fails("--lattice 1,0,1,nan", "BY is not a finite number");
  fails("--lattice 1,0,2,0", "The periods must not be zero or parallel");
  fails("--lattice 0,0,0,1", "The periods must not be zero or parallel");
  fails("--lattice 1,0,0,0.0001 --format svg", "The box is too narrow to be drawn.");
  fails("--lattice 1,0,0,1 --format wkt", "--lattice takes no --format wkt.");
  fails("--lattice 1,0,0,1 --format svg --bounds 0,0,1,1", "--lattice takes no --bounds");
  fails("--lattice 1,0,0,1 --format svg --max-distance 1",
        "--lattice takes no --max-distance: cells are written whole.");
  fails("--lattice 1,0,0,1 --format svg --tolerance 1 --max-distance 1", "--lattice takes no --max-distance");
  fails("--lattice 1,0,0,1 --trace t.jsonl", "--lattice takes no --trace.");
  fails("--lattice 1,0,0,1 --method flip", "--lattice needs --method auto.");
  fails("--lattice 1,0,0,1 --known 0,0,1,1 --max-radius 1 --format csv", "--lattice takes no --known.");
}

}  // namespace
}  // namespace circle_voronoi
