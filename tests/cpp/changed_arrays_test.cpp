// SPDX-License-Identifier: GPL-3.0-or-later
// Diagrams whose arrays a program has changed: what clips or writes them returns a result or an error, and reads
// nothing outside the arrays.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "check_arrays.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi_families/families.h"
#include "report.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

Region hallAround(const Diagram& diagram) {
  const Box box = exportBox(diagram.circles);
  const double width = box.maxX - box.minX;
  const double height = box.maxY - box.minY;
  const auto at = [&](double x, double y) { return Point{box.minX + x * width, box.minY + y * height}; };
  return test::regionFrom(
      {{at(0.1, 0.1), at(0.9, 0.2), at(0.8, 0.9), at(0.2, 0.8)}, {at(0.4, 0.4), at(0.6, 0.4), at(0.5, 0.6)}});
}

void useAll(const Diagram& diagram, const Region& region) {
  const std::vector<CircleIndex> some = {CircleIndex(0),
                                         CircleIndex(static_cast<std::int32_t>(diagram.circles.size()) - 1)};
  for (const bool isWhole : {true, false}) {
    const auto clipped =
        isWhole ? ClippedDiagram::from(diagram, region) : ClippedDiagram::ofCells(diagram, region, some);
    if (!clipped) {
      EXPECT_TRUE(clipped.error().message.ends_with(".")) << clipped.error().message;
      continue;
    }
    (void)clipped->areas();
    (void)clipped->centroids();
    (void)clipped->perimeters();
    (void)clipped->cells();
    (void)clipped->edges();
    (void)clipped->largestEmptyDisc();
    (void)clipped->polygons(1);
  }
  std::ostringstream out;
  for (const auto write : {writeSvg, writeGeoJson, writeWkt, writeObj}) (void)write(out, diagram, {});
}

/// Everything that a program may do to a list.
template <class Item>
std::vector<std::function<void(std::vector<Item>&)>> changesOf(std::vector<Item> values, std::mt19937& random) {
  std::vector<std::function<void(std::vector<Item>&)>> changes;
  changes.push_back([](auto& list) { std::ranges::reverse(list); });
  changes.push_back([](auto& list) { list.clear(); });
  changes.push_back([](auto& list) {
    if (!list.empty()) list.pop_back();
  });
  changes.push_back([](auto& list) {
    if (!list.empty()) list.push_back(list.front());
  });
  changes.push_back([](auto& list) {
    if (list.size() > 1) std::ranges::rotate(list, list.begin() + 1);
  });
  for (const Item& value : values) {
    changes.push_back([value](auto& list) { std::ranges::fill(list, value); });
    changes.push_back([value, &random](auto& list) {
      if (!list.empty()) list[random() % list.size()] = value;
    });
  }
  for (int k = 0; k < 4; ++k) {
    changes.push_back([&random](auto& list) {
      if (!list.empty()) std::swap(list[random() % list.size()], list[random() % list.size()]);
    });
  }
  return changes;
}

const std::vector<std::int32_t> kIndices = {
    -2, -1, 0, 1, 5, 40, 1'000'000, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};
const std::vector<double> kNumbers = {
    0, 1e-300, 1e300, -1e18, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};

/// A list as its numbers, changed.
template <class Scalar, class Item>
void changeAll(const Diagram& diagram, const std::function<std::vector<Item>&(Diagram&)>& listOf,
               const std::vector<Scalar>& values, std::mt19937& random,
               const std::function<void(const Diagram&)>& use) {
  for (const auto& change : changesOf<Scalar>(values, random)) {
    Diagram changed = diagram;
    std::vector<Item>& items = listOf(changed);
    const auto* begin = reinterpret_cast<const Scalar*>(items.data());
    std::vector<Scalar> scalars(begin, begin + items.size() * (sizeof(Item) / sizeof(Scalar)));
    change(scalars);
    items.resize(scalars.size() / (sizeof(Item) / sizeof(Scalar)));
    std::copy_n(scalars.data(), items.size() * (sizeof(Item) / sizeof(Scalar)),
                reinterpret_cast<Scalar*>(items.data()));
    use(changed);
  }
}

void changeEachArray(const Diagram& diagram, std::mt19937& random, const std::function<void(const Diagram&)>& use) {
  changeAll<double, Circle>(
      diagram, [](Diagram & d) -> auto& { return d.circles; }, kNumbers, random, use);
  changeAll<double, Vertex>(
      diagram, [](Diagram & d) -> auto& { return d.vertices; }, kNumbers, random, use);
  changeAll<std::int32_t, std::array<CircleIndex, 3>>(
      diagram, [](Diagram & d) -> auto& { return d.vertexCircles; }, kIndices, random, use);
  changeAll<std::int32_t, Edge>(
      diagram, [](Diagram & d) -> auto& { return d.edges; }, kIndices, random, use);
  changeAll<std::int32_t, HiddenCircle>(
      diagram, [](Diagram & d) -> auto& { return d.hidden; }, kIndices, random, use);
  changeAll<std::int32_t, CircleIndex>(
      diagram, [](Diagram & d) -> auto& { return d.hull; }, kIndices, random, use);
  changeAll<std::int32_t, SideIndex>(
      diagram, [](Diagram & d) -> auto& { return d.links.nextSide; }, kIndices, random, use);
  changeAll<std::int32_t, std::array<SideIndex, 3>>(
      diagram, [](Diagram & d) -> auto& { return d.links.vertexSides; }, kIndices, random, use);
  changeAll<std::int32_t, SideIndex>(
      diagram, [](Diagram & d) -> auto& { return d.links.firstSide; }, kIndices, random, use);
}

TEST(ChangedArrays, AreAResultOrAnError) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(1)));
  for (const Family family : {Family::uniform, Family::grid, Family::hidden}) {
    const auto seed = random();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 ofRun(seed);
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      const Diagram diagram = compute(generate(family, 40, seed), {.metric = metric}).value();
      const Region region = hallAround(diagram);
      ASSERT_TRUE(checkArrays(diagram)) << checkArrays(diagram).error().message;
      changeEachArray(diagram, ofRun, [&](const Diagram& changed) { useAll(changed, region); });
    }
  }
}

TEST(ChangedArrays, OfADiagramOfFewCirclesAreAResultOrAnError) {
  std::mt19937 random(7);
  const Region region = Region::from(Box{-5, -5, 9, 9}).value();
  for (int count = 0; count <= 4; ++count) {
    std::vector<Circle> circles = {{0, 0, 1}, {6, 0, 1}, {3, 1, 0.5}, {0, 8, 2}};
    circles.resize(static_cast<std::size_t>(count));
    const Diagram diagram = compute(circles).value();
    ASSERT_TRUE(checkArrays(diagram)) << checkArrays(diagram).error().message;
    changeEachArray(diagram, random, [&](const Diagram& changed) {
      if (!changed.circles.empty()) useAll(changed, region);
    });
  }
}

TEST(ChangedArrays, AreNamedWhereTheyDoNotFitTogether) {
  const Diagram diagram = compute(generate(Family::uniform, 30, 3)).value();
  const Region region = hallAround(diagram);
  const std::vector<std::pair<std::string, std::function<void(Diagram&)>>> changes = {
      {" at circle 0.", [](Diagram& d) { std::ranges::fill(d.links.firstSide, SideIndex(1)); }},
      {" at side 7.", [](Diagram& d) { d.links.nextSide[7] = 100'000; }},
      {" at ", [](Diagram& d) { d.links.nextSide[7] = 7; }},
      {" at edge 4.", [](Diagram& d) { d.edges[4].start = 100'000; }},
      {" at edge 4.", [](Diagram& d) { d.edges[4].end = 100'000; }},
      {" at edge 4.", [](Diagram& d) { d.edges[4].right = d.edges[4].left; }},
      {" at hidden circle 1.",
       [](Diagram& d) {
         d.hidden = {{2, kNone}, {30, 3}};
       }},
      {" at hidden circle 1.",
       [](Diagram& d) {
         d.hidden = {{2, kNone}, {3, 30}};
       }},
      {" at place of the hull 1.", [](Diagram& d) { d.hull[1] = 30; }},
      {" at place of the hull 0.", [](Diagram& d) { d.hull.push_back(d.hull.front()); }},
      {" at vertex 2.", [](Diagram& d) { d.links.vertexSides[2][1] = kNone; }},
      {" at vertex 2.", [](Diagram& d) { d.vertexCircles[2][1] = -1; }},
      {" at vertex 3.", [](Diagram& d) { d.vertices[3].x = std::numeric_limits<double>::quiet_NaN(); }},
      {" at circle 2.", [](Diagram& d) { d.links.firstSide[2] = 100'000; }},
      {" in their lengths.", [](Diagram& d) { d.vertices.pop_back(); }},
      {" in their lengths.", [](Diagram& d) { d.links.nextSide.pop_back(); }},
      {" in their lengths.", [](Diagram& d) { d.links.vertexSides.pop_back(); }},
      {" in their lengths.", [](Diagram& d) { d.links.firstSide.pop_back(); }},
      {"Circle 5 ", [](Diagram& d) { d.circles[5].x = std::numeric_limits<double>::infinity(); }},
      {"Circle 5 ", [](Diagram& d) { d.circles[5].y = 1e-20; }}};
  for (const auto& [where, change] : changes) {
    Diagram changed = diagram;
    change(changed);
    const auto clipped = ClippedDiagram::from(changed, region);
    ASSERT_FALSE(clipped) << where;
    EXPECT_NE(clipped.error().message.find(where), std::string::npos) << clipped.error().message;
  }
  const std::vector<CircleIndex> missing = {CircleIndex(30)};
  EXPECT_FALSE(ClippedDiagram::ofCells(diagram, region, missing));
}

}  // namespace
}  // namespace circle_voronoi
