// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in regions take n log n steps in circles, sides and output.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

/// A diagram and a region.
struct Clipping {
  Diagram diagram;
  Region region;

  explicit Clipping(const GrowthInput& input) : diagram(compute(input.circles).value()), region(input.region()) {}
};

/// A square ring around a point, counter-clockwise.
Region::Ring squareAround(Point p, double half) {
  return {{p.x - half, p.y - half}, {p.x + half, p.y - half}, {p.x + half, p.y + half}, {p.x - half, p.y + half}};
}

/// Rooms with a hole each in one cell. Each touches the next one in a corner.
GrowthInput rooms(std::size_t size) {
  GrowthInput input = {{{0, 0, 1}}, {}};
  for (std::size_t k = 0; k < size / 4; ++k) {
    const auto place = static_cast<double>(k);
    input.polygons.push_back({squareAround({place, place}, 0.5), squareAround({place, place}, 0.2)});
  }
  return input;
}

constexpr std::array kRooms = {GrowthFamily{"rooms", rooms}};

/// One polygon of teeth with a hole each. All teeth end in the cell of the first circle, apart from each other.
GrowthInput teeth(std::size_t size) {
  const std::size_t count = size / 8;
  const double height = 2 * static_cast<double>(count);
  GrowthInput input = {{{0, height / 2, 1}, {height, height / 2, 1}}, {{{{height, 0}, {height, height}}}}};
  auto& polygon = input.polygons[0];
  for (std::size_t k = count; k-- > 0;) {
    const double low = 2 * static_cast<double>(k);
    const double root = 0.9 * height;
    for (const Point& p : {Point{root, low + 1.5}, {0, low + 1.5}, {0, low + 0.5}, {root, low + 0.5}}) {
      polygon[0].push_back(p);
    }
    polygon.push_back(squareAround({0.1 * height, low + 1}, 0.2));
  }
  return input;
}

constexpr std::array kTeeth = {GrowthFamily{"teeth", teeth}};

/// A promise of a function of a clipped diagram.
template <class Use>
auto ofClipped(Use use) {
  return [use](const GrowthInput& input) {
    const auto clipping = std::make_shared<Clipping>(input);
    const auto clipped = kept(ClippedDiagram::from(clipping->diagram, clipping->region).value());
    return [clipping, clipped, use] { use(*clipped); };
  };
}

TEST(GrowthOfClips, OfAllCells) {
  expectGrowth({"ClippedDiagram::from", "clipped_diagram.h", [](const GrowthInput& input) {
                  const auto clipping = std::make_shared<Clipping>(input);
                  return [clipping] {
                    static_cast<void>(ClippedDiagram::from(clipping->diagram, clipping->region).value());
                  };
                }});
}

/// The first cell is that of the hub.
TEST(GrowthOfClips, OfOneCell) {
  expectGrowth({"ClippedDiagram::ofCells", "clipped_diagram.h", [](const GrowthInput& input) {
                  const auto clipping = std::make_shared<Clipping>(input);
                  return [clipping] {
                    const std::array<CircleIndex, 1> first = {CircleIndex(0)};
                    const auto clipped = ClippedDiagram::ofCells(clipping->diagram, clipping->region, first).value();
                    static_cast<void>(clipped.outline(0));
                    static_cast<void>(clipped.area(0));
                    static_cast<void>(clipped.neighbors(0));
                  };
                }});
}

TEST(GrowthOfClips, OfCellsOneByOne) {
  expectGrowth({"ClippedDiagram::ofCells of each cell", "clipped_diagram.h", [](const GrowthInput& input) {
                  const auto clipping = std::make_shared<Clipping>(input);
                  return [clipping] {
                    for (std::size_t i = 0; i < clipping->diagram.circles.size(); ++i) {
                      const std::array<CircleIndex, 1> one = {CircleIndex(static_cast<std::int32_t>(i))};
                      static_cast<void>(ClippedDiagram::ofCells(clipping->diagram, clipping->region, one).value());
                    }
                  };
                }});
}

TEST(GrowthOfClips, OfHolesInManyLoopsOfACell) {
  for (const bool isCut : {false, true}) {
    expectGrowth({"ClippedDiagram::outline", "clipped_diagram.h",
                  [isCut](const GrowthInput& input) {
                    const auto clipping = std::make_shared<Clipping>(input);
                    std::optional<double> distance;
                    if (isCut) distance = 0.45 * clipping->diagram.circles[1].x;
                    const auto clipped =
                        kept(ClippedDiagram::from(clipping->diagram, clipping->region, distance).value());
                    return [clipping, clipped] { EXPECT_GT(clipped->outline(0).size(), 10U); };
                  },
                  kTeeth});
  }
}

TEST(GrowthOfClips, OfNeighbors) {
  expectGrowth({"ClippedDiagram::neighbors", "clipped_diagram.h", ofClipped([](const ClippedDiagram& clipped) {
                  for (std::size_t i = 0; i < clipped.diagram().circles.size(); ++i) {
                    static_cast<void>(clipped.neighbors(static_cast<std::int32_t>(i)));
                  }
                })});
}

TEST(GrowthOfClips, OfPolygons) {
  expectGrowth({"ClippedDiagram::polygons", "clipped_diagram.h",
                ofClipped([](const ClippedDiagram& clipped) { static_cast<void>(clipped.polygons(1e-3)); })});
  expectGrowth({"ClippedDiagram::polygons", "clipped_diagram.h",
                ofClipped([](const ClippedDiagram& clipped) { static_cast<void>(clipped.polygons(1e-3)); }), kRooms});
}

TEST(GrowthOfClips, OfEdges) {
  expectGrowth({"ClippedDiagram::edges", "clipped_diagram.h",
                ofClipped([](const ClippedDiagram& clipped) { static_cast<void>(clipped.edges()); })});
}

}  // namespace
}  // namespace circle_voronoi::test
