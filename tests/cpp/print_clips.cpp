// SPDX-License-Identifier: GPL-3.0-or-later
// Prints clips of all families (clip_families.h) for other programs to judge, one JSON object in a line: `family`,
// `region` and `cells`, each of which is a list of polygons, which are lists of rings, and the `areas` of the cells.
// Usage: circle_voronoi_print_clips COUNT SEED, for COUNT clips of each family.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/comparison.h"
#include "clip_families.h"

namespace circle_voronoi::test {
namespace {

using Json = nlohmann::json;

Json ringOf(std::span<const Point> points, std::int32_t begin, std::int32_t end) {
  Json ring = Json::array();
  for (std::int32_t k = begin; k < end; ++k) {
    ring.push_back({points[static_cast<std::size_t>(k)].x, points[static_cast<std::size_t>(k)].y});
  }
  return ring;
}

/// Polygons from `first` to before `last`.
Json polygonsOf(std::span<const Point> points, std::span<const std::int32_t> ringOffsets,
                std::span<const std::int32_t> pointOffsets, std::int32_t first, std::int32_t last) {
  Json polygons = Json::array();
  for (std::int32_t p = first; p < last; ++p) {
    Json polygon = Json::array();
    for (std::int32_t r = ringOffsets[static_cast<std::size_t>(p)]; r < ringOffsets[static_cast<std::size_t>(p) + 1];
         ++r) {
      polygon.push_back(
          ringOf(points, pointOffsets[static_cast<std::size_t>(r)], pointOffsets[static_cast<std::size_t>(r) + 1]));
    }
    polygons.push_back(polygon);
  }
  return polygons;
}

void print(const ClipFamily& family, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  constexpr std::array kTolerances = {1.0, 0.05, 1e-3};
  for (int done = 0; done < count;) {
    const ClipInput input = family.make(random);
    const auto region = Region::fromRings(input.rings);
    if (!region || !hasPolygons(input)) continue;
    const Diagram diagram = computeComparison(input.circles, input.metric).value();
    const auto clipped = ClippedDiagram::from(diagram, *region).value();
    const Box box = region->bounds();
    const double extent = std::max(box.maxX - box.minX, box.maxY - box.minY);
    const double tolerance = kTolerances[static_cast<std::size_t>(done++ % 3)] * extent;
    const ClippedPolygons polygons = clipped.polygons(tolerance);
    Json cells = Json::array();
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      cells.push_back(polygonsOf(polygons.points, polygons.ringOffsets, polygons.pointOffsets,
                                 polygons.polygonOffsets[i], polygons.polygonOffsets[i + 1]));
    }
    const Json line = {{"family", family.name},
                       {"clip", done},
                       {"region", polygonsOf(region->points(), region->polygonOffsets(), region->ringOffsets(), 0,
                                             static_cast<std::int32_t>(region->polygonCount()))},
                       {"cells", cells},
                       {"areas", clipped.areas()}};
    std::cout << line.dump() << '\n';
  }
}

}  // namespace
}  // namespace circle_voronoi::test

int main(int argc, char** argv) {
  using namespace circle_voronoi::test;
  if (argc != 3) return 2;
  for (const ClipFamily& family : clipFamilies())
    print(family, std::atoi(argv[1]), std::strtoull(argv[2], nullptr, 10));
  return std::cout.good() ? 0 : 1;
}
