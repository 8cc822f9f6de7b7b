// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <tuple>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/tile.h"
#include "circle_voronoi_families/families.h"
#include "far_apart.h"
#include "fixtures.h"
#include "lines.h"
#include "regions.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

template <class Write>
std::string textOf(Write write, const std::vector<Circle>& circles, const ExportOptions& options = {}) {
  std::ostringstream out;
  EXPECT_TRUE(write(out, compute(circles).value(), options));
  return out.str();
}

using test::linesOf;

std::size_t countOf(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

using Ring = std::vector<std::array<double, 2>>;

std::vector<Ring> ringsOf(const Json& geometry) {
  if (geometry.is_null()) return {};
  std::vector<Ring> rings;
  if (geometry["type"] == "Polygon") {
    for (const auto& ring : geometry["coordinates"]) rings.push_back(ring);
  } else {
    for (const auto& polygon : geometry["coordinates"]) {
      for (const auto& ring : polygon) rings.push_back(ring);
    }
  }
  return rings;
}

TEST(Export, GeoJsonPolygonsHaveTheAreasAndShareTheirPoints) {
  for (const Family family : {Family::logUniform, Family::twoHuge, Family::hidden, Family::grid, Family::chaos}) {
    SCOPED_TRACE(familyName(family));
    const auto circles = generate(family, 80, 3);
    const Box box = exportBox(circles);
    const double whole = (box.maxX - box.minX) * (box.maxY - box.minY);
    const Region region = test::regionOf(box);
    const Diagram diagram = compute(circles).value();
    const Json file = Json::parse(textOf(writeGeoJson, circles));
    EXPECT_EQ(file["type"], "FeatureCollection");
    ASSERT_EQ(file["features"].size(), circles.size());
    using Step = std::pair<std::array<double, 2>, std::array<double, 2>>;
    std::map<Step, int> steps;
    double sum = 0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Json& feature = file["features"][i];
      EXPECT_EQ(feature["properties"]["circle"], i);
      EXPECT_EQ(feature["properties"]["r"], circles[i].r);
      EXPECT_EQ(feature["properties"].contains("hiddenBy"), feature["properties"]["neighbors"].empty());
      double polygons = 0;
      for (const Ring& ring : ringsOf(feature["geometry"])) {
        EXPECT_EQ(ring.front(), ring.back());
        EXPECT_GE(ring.size(), 4U);
        polygons += test::areaOf(ring);
        for (std::size_t k = 1; k < ring.size(); ++k) ++steps[{ring[k - 1], ring[k]}];
      }
      EXPECT_NEAR(polygons, area(outline(diagram, static_cast<std::int32_t>(i), region)), 1e-3 * whole);
      sum += polygons;
    }
    EXPECT_NEAR(sum / whole, 1, 1e-9);
    for (const auto& [step, count] : steps) {
      const auto& [p, q] = step;
      EXPECT_EQ(count, 1);
      const bool isOnBox = (p[0] == q[0] && (p[0] == box.minX || p[0] == box.maxX)) ||
                           (p[1] == q[1] && (p[1] == box.minY || p[1] == box.maxY));
      EXPECT_TRUE(isOnBox || steps.contains({q, p})) << p[0] << ' ' << p[1];
    }
  }
}

double turn(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// Whether no two sides of a closed ring cross, and none of its points recurs.
bool isSimple(const Ring& ring) {
  for (std::size_t i = 1; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      const auto& [p, q, r, s] = std::tie(ring[i - 1], ring[i], ring[j - 1], ring[j]);
      if (q == s || (turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0)) return false;
    }
  }
  return true;
}

Json cellsOf(const std::vector<Circle>& circles, const ExportOptions& options) {
  return Json::parse(textOf(writeGeoJson, circles, options));
}

/// Expects that polygons are simple and counter-clockwise.
void expectSimple(const Json& collection) {
  for (const Json& feature : collection["features"]) {
    for (const Ring& ring : ringsOf(feature["geometry"])) {
      EXPECT_GT(test::areaOf(ring), 0);
      EXPECT_TRUE(isSimple(ring)) << feature;
    }
  }
}

void expectPolygonsOfAllVisible(const Json& collection) {
  for (const Json& feature : collection["features"]) {
    EXPECT_EQ(feature["geometry"].is_null(), feature["properties"].contains("hiddenBy")) << feature;
  }
}

/// Whether cells of a family are no larger than the rounding that coordinates are allowed, or narrower than that of
/// their vertices. Such cells have no simple polygon.
bool haveNarrowCells(Family family) {
  return family == Family::twoClusters || family == Family::nestedTangent || family == Family::twoCommonPoints ||
         family == Family::barelyOut;
}

TEST(Export, EveryVisibleCircleHasASimplePolygonHoweverLargeTheTolerance) {
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family) || haveNarrowCells(family.family)) continue;
    const auto circles = generate(family.family, 100, 4);
    const double size = exportBox(circles).maxX - exportBox(circles).minX;
    for (const double tolerance : {1e-5, 0.1, 10.0}) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(tolerance));
      const Json collection = cellsOf(circles, {.tolerance = tolerance * size});
      EXPECT_EQ(collection["features"].size(), circles.size());
      expectSimple(collection);
      expectPolygonsOfAllVisible(collection);
    }
  }
}

/// The number of digits after the decimal point of a number.
std::size_t placesOf(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}

std::vector<std::string> numbersOf(const std::string& text) {
  const std::regex number("-?[0-9.]+(e[-+][0-9]+)?");
  return {std::sregex_token_iterator(text.begin(), text.end(), number), {}};
}

/// The share of the numbers in a text that have no more places after the decimal point.
double shareWithin(std::size_t places, const std::string& text) {
  const auto numbers = numbersOf(text);
  const auto isWithin = [&](const std::string& number) { return placesOf(number) <= places; };
  return static_cast<double>(std::ranges::count_if(numbers, isWithin)) / static_cast<double>(numbers.size());
}

TEST(Export, CoordinatesHaveTheDigitsOfTheTolerance) {
  const auto circles = generate(Family::uniform, 400, 2);
  for (const auto& [tolerance, places] : {std::pair(0.1, 2U), std::pair(0.05, 3U), std::pair(1e-3, 4U)}) {
    ExportOptions options;
    options.tolerance = tolerance;
    EXPECT_GT(shareWithin(places, textOf(writeWkt, circles, options)), 0.85) << "but for the box and short edges";
    const std::string svg = textOf(writeSvg, circles, options);
    const std::string cells =
        svg.substr(svg.find("<g class=\"cells\""), svg.find("<g class=\"dual\"") - svg.find("<g class=\"cells\""));
    EXPECT_EQ(shareWithin(places, cells), 1);
    EXPECT_NE(cells.find('.'), std::string::npos);
  }
}

TEST(Export, CoordinatesHaveNoMoreThanTheDigitsThatAreAskedFor) {
  const auto circles = generate(Family::uniform, 400, 2);
  for (const auto& [digits, least] : {std::pair(1, 0.7), std::pair(2, 0.95), std::pair(5, 1.0)}) {
    ExportOptions options;
    options.digits = digits;
    options.maxDistance = digits == 5 ? std::optional(0.4) : std::nullopt;
    for (const std::string& text : {textOf(writeWkt, circles, options), textOf(writeObj, circles, options)}) {
      EXPECT_GE(shareWithin(static_cast<std::size_t>(digits), text), least) << "but for short edges";
    }
    const Json file = Json::parse(textOf(writeGeoJson, circles, options));
    for (const Json& feature : file["features"]) {
      EXPECT_LE(placesOf(feature["properties"]["area"].dump()), static_cast<std::size_t>(digits));
    }
  }
  std::ostringstream out;
  EXPECT_TRUE(writeDiagramCsv(out, compute(circles).value(), 3));
  EXPECT_EQ(shareWithin(3, out.str()), 1);
}

TEST(Export, PolygonsFillTheBoxAndAreSimpleHoweverFewTheDigits) {
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family) || haveNarrowCells(family.family)) continue;
    const auto circles = generate(family.family, 60, 5);
    const Box all = exportBox(circles);
    const Box inner = {all.minX + (all.maxX - all.minX) / 3, all.minY, all.maxX, all.maxY - (all.maxY - all.minY) / 5};
    for (const int digits : {0, 1, 3, 6}) {
      for (const Box& box : {all, inner}) {
        SCOPED_TRACE(std::string(family.name) + " " + std::to_string(digits));
        double sum = 0;
        const Json file = cellsOf(circles, {.bounds = box, .digits = digits});
        expectSimple(file);
        for (const Json& feature : file["features"]) {
          for (const Ring& ring : ringsOf(feature["geometry"])) {
            for (const auto& [x, y] : ring) {
              EXPECT_TRUE(box.minX <= x && x <= box.maxX && box.minY <= y && y <= box.maxY) << x << ' ' << y;
            }
            sum += test::areaOf(ring);
          }
        }
        EXPECT_NEAR(sum / ((box.maxX - box.minX) * (box.maxY - box.minY)), 1, 1e-9);
      }
    }
  }
}

TEST(Export, CellsCutAtAMaximumDistanceAreSimpleHoweverFewTheDigits) {
  for (const Family family : {Family::uniform, Family::logUniform, Family::twoHuge, Family::hidden, Family::chaos}) {
    const auto circles = generate(family, 60, 5);
    const double size = exportBox(circles).maxX - exportBox(circles).minX;
    for (const double share : {0.3, 0.05, 1e-3, 1e-6}) {
      for (const int digits : {0, 1, 3, 6}) {
        SCOPED_TRACE(std::string(familyName(family)) + " " + std::to_string(share) + " " + std::to_string(digits));
        const Json file = cellsOf(circles, {.maxDistance = share * size, .digits = digits});
        expectSimple(file);
        expectPolygonsOfAllVisible(file);
      }
    }
  }
}

// Boxes that meet vertices, and cells whose centers lie outside the box, or near their cutoff: their boundary need not
// turn around the center.
TEST(Export, CellsThatTheBoxCutsAreSimpleHoweverFewTheDigits) {
  expectSimple(cellsOf(generate(Family::hexagonal, 300, 1), {.bounds = Box{3, 3, 9, 8}}));
  expectSimple(
      cellsOf(generate(Family::mixed, 100, 40), {.bounds = Box{-0.6054, -2.236, 14.481, 17.294}, .digits = 0}));
  expectSimple(cellsOf(generate(Family::clustered, 100, 397), {.digits = 0}));
  expectSimple(cellsOf(generate(Family::hexagonal, 30, 290),
                       {.bounds = Box{1.36958, 0.53586, 7.06341, 3.484755}, .maxDistance = 0.63523, .digits = 0}));
}

TEST(Export, LargeAndTinyDrawingsAreRoundedLikewise) {
  for (const double scale : {1e-9, 1e-6, 1e9, 1e25}) {
    auto circles = generate(Family::mixed, 60, 5);
    for (Circle& c : circles) c = {c.x * scale, c.y * scale, c.r * scale};
    const Box box = exportBox(circles);
    std::size_t rounded = 0;
    std::size_t all = 0;
    for (const std::string& line : linesOf(textOf(writeWkt, circles))) {
      for (const std::string& number : numbersOf(line)) {
        const double value = std::stod(number);
        EXPECT_TRUE(value >= std::min(box.minX, box.minY) && value <= std::max(box.maxX, box.maxY)) << number;
        ++all;
        rounded += number.ends_with("0000") ? 1 : 0;
      }
    }
    if (scale == 1e9) {
      EXPECT_GT(static_cast<double>(rounded), 0.6 * static_cast<double>(all));
    }
  }
}

TEST(Export, RoundedPointsKeepTheTolerance) {
  for (const Family family : {Family::logUniform, Family::intersecting, Family::twoHuge}) {
    const auto circles = generate(family, 60, 7);
    ExportOptions options;
    const Box box = exportBox(circles);
    options.tolerance = 0.01 * (box.maxX - box.minX);
    const Json file = Json::parse(textOf(writeGeoJson, circles, options));
    const Diagram diagram = compute(circles).value();
    for (std::size_t i = 0; i < circles.size(); ++i) {
      for (const Ring& ring : ringsOf(file["features"][i]["geometry"])) {
        for (const auto& [x, y] : ring) {
          const auto own = distanceFrom(diagram, static_cast<std::int32_t>(i), {x, y});
          for (const std::int32_t neighbor : neighbors(diagram, static_cast<std::int32_t>(i))) {
            // Each distance changes by no more than the point moves.
            EXPECT_LE(own - distanceFrom(diagram, neighbor, {x, y}), 2 * *options.tolerance)
                << familyName(family) << ' ' << i;
          }
        }
      }
    }
  }
}

TEST(Export, AreasAreThoseOfTheCells) {
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    const auto circles = generate(family.family, 60, 2);
    const Diagram diagram = compute(circles).value();
    const Region box = test::regionOf(exportBox(circles));
    // The areas of narrow cells are tiny compared with the triangles whose areas are summed.
    const double rounding = 1e-15 * box.area();
    const Json file = Json::parse(textOf(writeGeoJson, circles, {.bounds = exportBox(circles)}));
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const double expected = area(outline(diagram, static_cast<std::int32_t>(i), box));
      EXPECT_NEAR(file["features"][i]["properties"]["area"], expected, 1e-9 * std::abs(expected) + rounding)
          << family.name << ' ' << i;
    }
  }
}

TEST(Export, WithoutLimitsAreasAreThoseOfWholeCellsAndPolygonsAreClippedToTheDefaultBox) {
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    const auto circles = generate(family.family, 60, 2);
    const Diagram diagram = compute(circles).value();
    const Box box = exportBox(circles);
    const Region region = test::regionOf(box);
    const Json file = Json::parse(textOf(writeGeoJson, circles));
    const Json clipped = Json::parse(textOf(writeGeoJson, circles, {.bounds = box}));
    EXPECT_EQ(file["bbox"], (Json{box.minX, box.minY, box.maxX, box.maxY}));
    for (std::size_t i = 0; i < circles.size(); ++i) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(i));
      const auto circle = static_cast<std::int32_t>(i);
      const Json& feature = file["features"][i];
      EXPECT_EQ(feature["geometry"], clipped["features"][i]["geometry"]);
      const Json& properties = feature["properties"];
      const bool isPlane = diagram.hasCell(circle) && diagram.sides(circle).empty();
      const bool isUnbounded = isPlane || std::ranges::any_of(diagram.sides(circle), [&](SideIndex side) {
                                 return diagram.originOf(side) == kNone;
                               });
      EXPECT_EQ(properties["area"].is_null(), isUnbounded);
      if (!properties["area"].is_null()) {
        EXPECT_EQ(properties["area"], area(outline(diagram, circle)));
      }
      // The border of a clipped cell has a piece that belongs to no side of the cell.
      bool isCut = false;
      for (const auto& loop : outline(diagram, circle, region)) {
        isCut = isCut || std::ranges::any_of(loop, [](const OutlinePiece& piece) { return piece.side == kNone; });
      }
      EXPECT_EQ(properties.value("clipped", false), isCut);
      EXPECT_EQ(clipped["features"][i]["properties"].value("clipped", false), isCut);
    }
  }
}

TEST(Export, SvgHasTheNamesOfCirclesAsTitles) {
  // The last circle is hidden, and the one before it is a point.
  const std::vector<Circle> circles = {{0, 0, 2}, {9, 0, 1}, {0, 9, 0}, {0.5, 0, 1}};
  CircleAttributes attributes;
  attributes.properties = {R"("label":"a","Name":"A & <B>")", R"("pop":7)", R"("title":"C","name":null)",
                           R"("name":4)"};
  const std::string svg = textOf(writeSvg, circles, {.attributes = &attributes});
  EXPECT_EQ(countOf(svg, "<title>A &amp; &lt;B></title></path>"), 1U) << svg;
  EXPECT_EQ(countOf(svg, "<title>A &amp; &lt;B></title></circle>"), 1U);
  EXPECT_EQ(countOf(svg, "<title>C</title></path>"), 2U) << "cell and point";
  EXPECT_EQ(countOf(svg, "<title>4</title></circle>"), 1U);
  EXPECT_EQ(countOf(svg, "<title>"), 1 + 2 + 2 + 1U) << "one for the drawing";
  EXPECT_EQ(countOf(textOf(writeSvg, circles), "<title>"), 1U);
  const auto periodic = computePeriodic(circles, {{20, 0}, {0, 20}}).value();
  std::ostringstream out;
  EXPECT_TRUE(writePeriodicSvg(out, periodic, {.attributes = &attributes}));
  EXPECT_EQ(countOf(out.str(), "<title>C</title>"), 2U);
}

/// Two circles, one of which has the hull's longer arc.
const std::vector<Circle> kLargeArc = {{0, 0, 5}, {6.2, 0, 1}};

TEST(Export, SvgTakesTheLargeArcWhereTheHullTurnsByMoreThanHalf) {
  const std::string svg = textOf(writeSvg, kLargeArc);
  const std::string hull = svg.substr(svg.find("<g class=\"hull\""));
  EXPECT_EQ(countOf(hull, "A5 5 0 1 1 "), 1U) << hull;
  EXPECT_EQ(countOf(hull, "A1 1 0 0 1 "), 1U) << hull;
  EXPECT_NE(textOf(writeSvg, {{0, 0, 1}, {9, 0, 1}}).find("<path d=\"M0 1A1 1 0 0 1 0 -1L9 -1A1 1 0 0 1 9 1Z\"/>"),
            std::string::npos);
  const std::string alone = textOf(writeSvg, {{2, 3, 1}});
  EXPECT_NE(alone.find("<circle cx=\"2\" cy=\"3\" r=\"1\"/>"), std::string::npos) << alone;
  const std::string equal = textOf(writeSvg, {{0, 0, 1}, {9, 0, 1}, {4, 6, 1}});
  EXPECT_EQ(countOf(equal, "A1 1 0 0 1 "), 3U) << equal;
  EXPECT_EQ(countOf(equal, " 0 1 1 "), 0U) << equal;
}

TEST(Export, SvgFollowsTheSidesOfCells) {
  // One circle in the middle, with four edges, and four around it. All edges are straight if all radii are equal.
  for (const double r : {1.0, 2.0}) {
    const std::string svg = textOf(writeSvg, {{0, 0, r}, {10, 0, 1}, {0, 10, 1}, {-10, 0, 1}, {0, -10, 1}});
    const std::size_t begin = svg.find("<path data-circle=\"0\" d=\"");
    const std::string cell = svg.substr(begin, svg.find("/>", begin) - begin);
    const std::size_t group = svg.find("<g class=\"edges\"");
    const std::string edges = svg.substr(group, svg.find("</g>", group) - group);
    EXPECT_EQ(countOf(cell, "M"), 1U) << cell;
    EXPECT_EQ(countOf(edges, "d=\"M"), 8U) << edges;
    if (r == 1) {
      EXPECT_EQ(countOf(cell, "L"), 4U) << cell;
      EXPECT_EQ(countOf(edges, "L"), 8U) << edges;
      for (const char* corner : {"L5 5", "L-5 5", "L-5 -5", "L5 -5"}) EXPECT_EQ(countOf(cell, corner), 1U) << cell;
    } else {
      EXPECT_GE(countOf(cell, "C"), 4U) << cell;
      EXPECT_EQ(countOf(edges, "C"), countOf(cell, "C")) << edges;
    }
  }
}

TEST(Export, GeoJsonOfACellInTwoPartsIsAMultiPolygon) {
  ExportOptions options;
  options.bounds = Box{6.5, -20, 7, 20};
  const Json file = Json::parse(textOf(writeGeoJson, kLargeArc, options));
  const Json& geometry = file["features"][0]["geometry"];
  EXPECT_EQ(geometry["type"], "MultiPolygon");
  ASSERT_EQ(geometry["coordinates"].size(), 2U);
  for (const Json& polygon : geometry["coordinates"]) {
    ASSERT_EQ(polygon.size(), 1U) << "one ring";
    EXPECT_GE(polygon[0].size(), 4U);
    for (const Json& point : polygon[0]) EXPECT_EQ(point.size(), 2U);
  }
  const Json& whole = file["features"][1]["geometry"];
  EXPECT_EQ(whole["type"], "Polygon");
  ASSERT_EQ(whole["coordinates"].size(), 1U);
  EXPECT_EQ(whole["coordinates"][0][0].size(), 2U);
}

TEST(Export, WktHasALineForEachCircle) {
  const std::vector<Circle> circles = {{0, 0, 10}, {0, 10.6, 0.1}, {1, 1, 1}};
  ExportOptions options;
  options.bounds = Box{-8, 10.5, 8, 14};
  const auto lines = linesOf(textOf(writeWkt, circles, options));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("MULTIPOLYGON (((")) << lines[0];
  EXPECT_TRUE(lines[0].ends_with(")))")) << lines[0];
  EXPECT_EQ(countOf(lines[0], ")), (("), 1U) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("POLYGON ((")) << lines[1];
  EXPECT_EQ(lines[2], "POLYGON EMPTY");
}

TEST(Export, ObjElementsNameVerticesThatCameBefore) {
  const auto circles = generate(Family::mixed, 40, 1);
  int vertices = 0;
  int faces = 0;
  for (const std::string& line : linesOf(textOf(writeObj, circles))) {
    std::istringstream in(line);
    std::string kind;
    in >> kind;
    if (kind == "v") ++vertices;
    if (kind == "f") ++faces;
    if (kind != "l" && kind != "f") continue;
    for (int index = 0; in >> index;) EXPECT_TRUE(index >= 1 && index <= vertices);
  }
  EXPECT_EQ(faces, 40);
}

TEST(Export, CsvHasTheVerticesAndEdges) {
  const auto circles = generate(Family::mixed, 40, 1);
  const Diagram diagram = compute(circles).value();
  std::ostringstream out;
  EXPECT_TRUE(writeDiagramCsv(out, diagram));
  const auto lines = linesOf(out.str());
  EXPECT_EQ(lines.size(), 1 + diagram.vertices.size() + diagram.edges.size());
  for (const std::string& line : lines) EXPECT_EQ(std::ranges::count(line, ','), 9) << line;
}

TEST(Export, PartsHaveEdgesFromTheirFirstVertexToTheirLast) {
  const auto circles = generate(Family::mixed, 40, 1);
  const Diagram diagram = compute(circles).value();
  const auto thirdOf = [&](VertexIndex v, const Edge& edge) {
    if (v == kNone) return std::string("-1");
    for (const std::int32_t i : diagram.vertexCircles[static_cast<std::size_t>(v)])
      if (i != edge.left && i != edge.right) return std::to_string(i);
    return std::string();
  };
  std::vector<std::string> expected;
  for (Edge edge : diagram.edges) {
    if (edge.left > edge.right) edge = {edge.right, edge.left, edge.end, edge.start};
    expected.push_back("edge,,,," + std::to_string(edge.left) + "," + std::to_string(edge.right) + "," +
                       thirdOf(edge.start, edge) + "," + thirdOf(edge.end, edge));
  }
  std::ostringstream out;
  EXPECT_TRUE(writePartsCsv(out, diagram, {}));
  std::vector<std::string> actual = linesOf(out.str());
  std::erase_if(actual, [](const std::string& line) { return !line.starts_with("edge"); });
  EXPECT_EQ(actual, expected);
}

TEST(Export, AChosenPartIsThatOfTheLeastCircle) {
  const Diagram diagram = compute(generate(Family::mixed, 40, 1)).value();
  std::vector<std::uint8_t> isChosen(diagram.circles.size(), 0);
  for (std::size_t i = 0; i < isChosen.size(); i += 3) isChosen[i] = 1;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  for (const auto& triple : diagram.vertexCircles) {
    vertices += isChosen[static_cast<std::size_t>(std::int32_t{*std::ranges::min_element(triple)})];
  }
  for (const Edge& edge : diagram.edges) {
    edges += isChosen[static_cast<std::size_t>(std::min<std::int32_t>(edge.left, edge.right))];
  }
  std::ostringstream out;
  EXPECT_TRUE(writePartsCsv(out, diagram, {{}, isChosen}));
  const auto lines = linesOf(out.str());
  const auto count = [&](const char* type) {
    return static_cast<std::size_t>(
        std::ranges::count_if(lines, [&](const std::string& line) { return line.starts_with(type); }));
  };
  EXPECT_EQ(count("vertex,"), vertices);
  EXPECT_EQ(count("edge,"), edges);
}

TEST(Export, SvgHasItsLayers) {
  const auto circles = test::readFixture("bronzefilter");
  const std::string svg = textOf(writeSvg, circles);
  for (const char* name : {"cells", "edges", "dual", "hull", "circles", "vertices"}) {
    EXPECT_EQ(countOf(svg, "<g class=\"" + std::string(name) + "\""), 1U);
  }
  // In a page with other drawings, no name is there twice, and no rule is for anything else.
  EXPECT_EQ(svg.find(" id="), std::string::npos);
  const std::string style = svg.substr(svg.find("<style>\n"), svg.find("</style>") - svg.find("<style>\n"));
  EXPECT_EQ(countOf(style, ".circle-voronoi "), countOf(style, "{") + countOf(style, ","));
  EXPECT_NE(svg.find("class=\"circle-voronoi\" role=\"img\">"), std::string::npos);
  EXPECT_EQ(countOf(svg, "<g"), countOf(svg, "</g>"));
  EXPECT_EQ(countOf(svg, " r=\"") - countOf(svg, "data-vertex"), circles.size());
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Export, OnlyCellsThatACommonDistanceLimitsHaveBorders) {
  const auto strokeOfCells = [](const ExportOptions& options) {
    const std::string svg = textOf(writeSvg, {{0, 0, 1}, {9, 0, 1}}, options);
    const std::size_t cells = svg.find("<g class=\"cells\"");
    const std::size_t stroke = svg.find("stroke=\"", cells) + 8;
    return svg.substr(stroke, svg.find('"', stroke) - stroke);
  };
  ExportOptions near;
  near.maxDistance = 2;
  EXPECT_EQ(strokeOfCells({}), "none");
  EXPECT_EQ(strokeOfCells(near), "#1f4e79");
}

TEST(Export, SvgTellsHiddenCirclesAndPoints) {
  const std::string svg = textOf(writeSvg, {{0, 0, 3}, {1, 1, 1}, {9, 2, 0}, {0, 1, 0}, {0, 8, 0.001}});
  EXPECT_NE(svg.find("<circle data-circle=\"0\" cx=\"0\" cy=\"0\" r=\"3\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<circle data-circle=\"1\" class=\"hidden\" cx=\"1\" cy=\"1\" r=\"1\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<path data-circle=\"2\" class=\"point\" d=\"M9 2h0\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<circle data-circle=\"4\" class=\"point\" cx=\"0\" cy=\"8\" r=\"0.001\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<path data-circle=\"3\" class=\"point hidden\" d=\"M0 1h0\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<desc>5 circles, 2 of them hidden; 1 vertices, 3 edges</desc>"), std::string::npos);
  const std::string corner = textOf(writeSvg, {{0, 0, 1}, {6, 0, 1}, {0, 8, 1}});
  EXPECT_EQ(countOf(corner, "<circle data-vertex=\"0\" cx=\"3\" cy=\"4\" r=\""), 1U) << corner;
}

TEST(Export, SvgOmitsPartsOutsideTheBox) {
  const std::vector<Circle> circles = {{0, 0, 1}, {9, 0, 1}, {0, 9, 1}, {30, 30, 1}, {39, 30, 1}};
  ExportOptions options;
  options.bounds = Box{-2, -2, 7, 7};
  const std::string svg = textOf(writeSvg, circles, options);
  EXPECT_EQ(countOf(svg, "<circle data-circle="), 1U);
  EXPECT_EQ(countOf(svg, "<line"), 3U) << "the triangle of the first three circles";
  for (const char* ends : {"0\" y1=\"0\" x2=\"9\" y2=\"0\"/>", "0\" y1=\"0\" x2=\"0\" y2=\"9\"/>"}) {
    EXPECT_EQ(countOf(svg, "<line x1=\"" + std::string(ends)), 1U) << svg;
  }
  for (const Circle& across : {Circle{-2.5, 3, 1}, Circle{7.5, 3, 1}, Circle{3, -2.5, 1}, Circle{3, 7.5, 1}}) {
    EXPECT_EQ(countOf(textOf(writeSvg, {across}, options), "<circle data-circle="), 1U) << across.x << " " << across.y;
  }
}

TEST(Export, SvgFiguresHaveTheirGroupsAndLayers) {
  const std::vector<Circle> circles = {{0, 0, 1}, {9, 0, 1}, {4, 6, 1}};
  const Diagram diagram = compute(circles).value();
  const auto figureOf = [&](const SvgFigure& figure) {
    std::ostringstream out;
    EXPECT_TRUE(writeSvgFigure(out, diagram, figure));
    return out.str();
  };
  EXPECT_EQ(figureOf({}), textOf(writeSvg, circles));

  SvgFigure figure;
  figure.frame.bounds = Box{-10, -10, 10, 10};
  figure.pixels = 200;
  figure.groups = {"edges"};
  figure.style = ".samples { stroke: red; }\n";
  figure.layers.push_back({.name = "samples", .points = {{1, 2}, {3, -4}}});
  figure.layers.push_back({.name = "discs", .discs = {{5, 6, 0.5}}});
  figure.layers.push_back({.name = "directed", .segments = {{{{0, 0}, {0, 5}}}}, .areArrows = true});
  figure.layers.push_back({.name = "arcs", .arcs = {segment({1, 1}, {2, 1})}});
  figure.layers.push_back({.name = "still", .segments = {{{{7, 7}, {7, 7}}}}, .areArrows = true});
  const std::string svg = figureOf(figure);
  EXPECT_NE(svg.find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\""), std::string::npos);
  EXPECT_NE(svg.find(".samples { stroke: red; }\n</style>"), std::string::npos);
  EXPECT_EQ(countOf(svg, "<g class="), 6U);
  EXPECT_EQ(svg.find("class=\"cells\""), std::string::npos);
  EXPECT_NE(svg.find("<g class=\"samples\">\n<path d=\"M1 2h0M3 -4h0\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<circle cx=\"5\" cy=\"6\" r=\"0.5\"/>"), std::string::npos);
  // Seven pixels of a tenth: a head of length 0.7 at the end.
  EXPECT_NE(svg.find("<path d=\"M0 0L0 5M-0.28 4.3L0 5L0.28 4.3\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"M1 1L2 1\"/>\n</g>"), std::string::npos) << "without points no path of points";
  EXPECT_NE(svg.find("<path d=\"M7 7L7 7\"/>\n</g>"), std::string::npos) << "an arrow without a direction has no head";
}

TEST(Export, LayersHaveTheDigitsThatAreAskedFor) {
  SvgFigure figure;
  figure.frame.digits = 1;
  figure.frame.bounds = Box{-10, -10, 10, 10};
  figure.groups = {};
  figure.layers = {{.name = "all",
                    .points = {{1.26, 2.04}},
                    .discs = {{5.26, 6.24, 0.46}},
                    .segments = {{{{0.04, 0.06}, {1.16, 5.99}}}},
                    .arcs = {segment({1.14, 1.16}, {2.06, 1.04})}}};
  std::ostringstream out;
  EXPECT_TRUE(writeSvgFigure(out, compute(std::vector<Circle>{{0, 0, 1}}).value(), figure));
  const std::string svg = out.str();
  for (const char* part :
       {"\"M1.3 2h0\"", "\"M0 0.1L1.2 6\"", "cx=\"5.3\" cy=\"6.2\" r=\"0.5\"", "\"M1.1 1.2L2.1 1\""}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part << " in " << svg;
  }
}

TEST(Export, NoCirclesGiveValidFiles) {
  EXPECT_TRUE(Json::parse(textOf(writeGeoJson, {}))["features"].empty());
  EXPECT_EQ(textOf(writeWkt, {}), "");
  EXPECT_NE(textOf(writeSvg, {}).find("</svg>"), std::string::npos);
  EXPECT_EQ(countOf(textOf(writeSvg, {}), "<path"), 0U);
}

}  // namespace
}  // namespace circle_voronoi
