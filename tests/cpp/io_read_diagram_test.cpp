// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi {
namespace {

std::string written(const Diagram& diagram) {
  std::ostringstream text;
  EXPECT_TRUE(writeJson(text, diagram));
  return text.str();
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(ReadDiagram, ReadsBackWhatWasWrittenToTheBit) {
  for (const FamilyInfo& family : families()) {
    auto circles = generate(family.family, 40, 1);
    circles[3].x = -0.0;
    circles[5].y = 0x1p62;
    const Diagram diagram = compute(circles).value();
    const auto file = readDiagram(written(diagram), "file");
    ASSERT_TRUE(file.ok()) << file.error().message;
    ASSERT_EQ(file.value().circles.size(), circles.size());
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Circle& c = file.value().circles[i];
      EXPECT_EQ(bits(c.x), bits(circles[i].x));
      EXPECT_EQ(bits(c.y), bits(circles[i].y));
      EXPECT_EQ(bits(c.r), bits(circles[i].r));
    }
    const Diagram& read = file.value();
    EXPECT_EQ(read.vertices, diagram.vertices);
    EXPECT_EQ(read.vertexCircles, diagram.vertexCircles);
    EXPECT_EQ(read.edges, diagram.edges);
    EXPECT_EQ(read.hidden, diagram.hidden);
    EXPECT_EQ(read.hull, diagram.hull);
    EXPECT_EQ(read.links.nextSide, diagram.links.nextSide);
    EXPECT_EQ(read.links.vertexSides, diagram.links.vertexSides);
    EXPECT_EQ(read.links.firstSide, diagram.links.firstSide);
    EXPECT_TRUE(certify(read).value().certified());
  }
}

TEST(ReadDiagram, ReadsTheMetric) {
  const auto circles = generate(Family::intersecting, 30, 2);
  for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
    const Diagram diagram = compute(circles, {.metric = metric}).value();
    const auto read = readDiagram(written(diagram), "file");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read.value().metric, metric);
    EXPECT_EQ(read.value().links.nextSide, diagram.links.nextSide);
  }
}

TEST(ReadDiagram, ReadsNoCircles) {
  const auto file = readDiagram(written(compute({}).value()), "file");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_TRUE(file.value().circles.empty());
}

TEST(ReadDiagram, SkipsOtherKeys) {
  const auto file = readDiagram(R"({"note": {"a": [1, {"circles": []}]}, "format": "circle-voronoi", "version": 1,
      "circles": [{"x": 1, "color": "red", "y": 2, "size": [1, 2], "r": 3}],
      "hidden": [], "vertices": [], "edges": [], "hull": [0], "stats": null})",
                                "file");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file.value().circles, (std::vector<Circle>{{1, 2, 3}}));
}

TEST(ReadDiagram, SkipsAttributesOfAnotherKind) {
  const auto file = readDiagramFile(R"({"format": "circle-voronoi", "version": 1, "collection": [1],
      "circles": [{"x": 1, "y": 2, "r": 3, "id": true, "z": "high", "properties": 7}],
      "hidden": [], "vertices": [], "edges": [], "hull": [0]})",
                                    "file");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_TRUE(file->attributes.empty());
}

TEST(ReadDiagram, OfAMemberThatIsGivenTwiceTheLastValueCounts) {
  const auto file = readDiagramFile(R"({"format": "circle-voronoi", "version": 1, "version": 1, "weights": true,
      "collection": {"crs": 7}, "circles": [{"x": 7, "y": 7, "r": -7, "id": "a"}, {"x": 7, "y": 7, "r": 7}],
      "circles": [{"x": 8, "x": 1, "y": 2, "r": 3}], "weights": false,
      "hidden": [{"circle": 0, "by": 0}], "hidden": [], "vertices": [], "edges": [], "hull": [0, 1], "hull": [0]})",
                                    "file");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file->diagram.circles, (std::vector<Circle>{{1, 2, 3}}));
  EXPECT_FALSE(file->diagram.weights);
  EXPECT_TRUE(file->diagram.hidden.empty());
  EXPECT_EQ(file->diagram.hull.size(), 1U);
  EXPECT_TRUE(file->attributes.ids.empty());
  EXPECT_EQ(file->attributes.collection, "\"crs\":7");
}

TEST(ReadDiagram, TimesOfMinusZeroComeBack) {
  std::string text = written(compute({}).value());
  const std::size_t at = text.find("\"seconds\": {");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string::npos, "\"seconds\": {\"certify\": -0e-06}}}");
  const auto file = readDiagram(text, "file");
  ASSERT_TRUE(file.ok()) << file.error().message;
  const auto again = readDiagram(written(file.value()), "file");
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(bits(file.value().stats.seconds.certify), bits(-0.0));
  EXPECT_EQ(bits(again.value().stats.seconds.certify), bits(-0.0));
}

/// A small file with one part of its text replaced.
std::string errorAfter(const std::string& part, const std::string& other) {
  std::string text = R"({"format": "circle-voronoi", "version": 1,
 "circles": [
  {"x": 0, "y": 0, "r": 5},
  {"x": 1, "y": 0, "r": 1}],
 "hidden": [{"circle": 1, "by": 0}],
 "vertices": [
  {"x": 0, "y": 0, "r": 1, "circles": [0, 1, 2]}],
 "edges": [
  {"circles": [0, 1], "vertices": [-1, 0]}],
 "hull": [0]})";
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return "the part is not there";
  text.replace(at, part.size(), other);
  const auto file = readDiagram(text, "file");
  return file ? "" : file.error().message;
}

TEST(ReadDiagram, ReportsTheErrorAndItsPlace) {
  EXPECT_EQ(errorAfter("5}", "5.5}"), "");
  EXPECT_EQ(errorAfter("\"circle-voronoi\"", "\"svg\""), "file:1: the format is \"svg\", not \"circle-voronoi\".");
  EXPECT_EQ(errorAfter("\"version\": 1", "\"version\": 2"),
            "file:1: the version is not 1, the only one that can be read.");
  EXPECT_EQ(errorAfter("\"version\": 1,", ""), "file:10: there is no version.");
  EXPECT_EQ(errorAfter("\"version\": 1,", "\"version\": 1, \"metric\": \"taxi\","),
            "file:1: there is no metric \"taxi\"; it is circles, centers or power.");
  EXPECT_EQ(errorAfter("\"version\": 1,", "\"version\": 1, \"metric\": 1,"),
            "file:1: expected a string for metric, not a number.");
  EXPECT_EQ(errorAfter("\"circle-voronoi\"", "null"), "file:1: expected a string for format, not null.");
  EXPECT_EQ(errorAfter("\"format\": \"circle-voronoi\",", ""),
            "file:10: there is no format; a diagram has \"format\": \"circle-voronoi\".");
  EXPECT_EQ(errorAfter("\"hull\": [0]", "\"hulls\": [0]"), "file:10: there is no list of hull.");
  EXPECT_EQ(errorAfter("\"r\": 5}", "\"r\": -5}"), "file:3: Circle 0 has a negative radius.");
  EXPECT_EQ(errorAfter(" \"hidden\": [", " \"circles\": [\n  {\"x\": 0, \"y\": 0, \"r\": -5}],\n \"hidden\": ["),
            "file:6: Circle 0 has a negative radius.");
  EXPECT_EQ(errorAfter("\"r\": 5}", "\"r\": null}"), "file:3: expected a number for r of circles[0], not null.");
  EXPECT_EQ(errorAfter("\"r\": 1}", "\"x\": 1}"), "file:4: circles[1] has no r.");
  EXPECT_EQ(errorAfter("\"r\": 1, ", ""), "file:7: vertices[0] has no r.");
  EXPECT_EQ(errorAfter("[0, 1, 2]", "[0, 1]"), "file:7: expected 3 numbers for circles of vertices[0].");
  EXPECT_EQ(errorAfter("[0, 1, 2]", "[0, 1, 2, 3]"), "file:7: expected 3 numbers for circles of vertices[0].");
  EXPECT_EQ(errorAfter("[0, 1, 2]", "[0, 1, 0.5]"), "file:7: circles of vertices[0] is no index.");
  EXPECT_EQ(errorAfter("[-1, 0]", "[-1, 3000000000]"), "file:9: vertices of edges[0] is no index.");
  EXPECT_EQ(errorAfter("\"hull\": [0]", "\"hull\": [[0]]"), "file:10: expected a number for hull[0], not an array.");
  EXPECT_EQ(errorAfter("\"hull\": [0]", "\"hull\": 0"), "file:10: expected an array for hull, not a number.");
  EXPECT_EQ(errorAfter("\"hull\": [0]}", "\"hull\": [0"),
            "file:10: bad JSON: expected , or ], not the end of the text.");
}

}  // namespace
}  // namespace circle_voronoi
