// SPDX-License-Identifier: GPL-3.0-or-later
// Prints clips of all families (clip_families.h) for other programs to judge, one JSON object in a line: `family`,
// `region` and `cells`, each of which is a list of polygons, which are lists of rings, and the `areas` of the cells.
// Usage: circle_voronoi_print_clips COUNT SEED, for COUNT clips of each family.
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "clip_families.h"
#include "rings.h"

namespace circle_voronoi::test {
namespace {

using Json = nlohmann::json;

Json jsonOf(const std::vector<std::vector<Region::Ring>>& polygons) {
  Json all = Json::array();
  for (const auto& rings : polygons) {
    Json& polygon = all.emplace_back(Json::array());
    for (const Region::Ring& points : rings) {
      Json& ring = polygon.emplace_back(Json::array());
      for (const Point& p : points) ring.push_back({p.x, p.y});
    }
  }
  return all;
}

void print(const ClipFamily& family, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  constexpr std::array kTolerances = {1.0, 0.05, 1e-3};
  for (int done = 0; done < count;) {
    const ClipInput input = family.make(random);
    const auto region = Region::fromRings(input.rings);
    if (!region || !hasPolygons(input)) continue;
    const Diagram diagram = compute(input.circles, {.metric = input.metric}).value();
    const auto clipped = ClippedDiagram::from(diagram, *region).value();
    const double tolerance = kTolerances[static_cast<std::size_t>(done++ % 3)] * extentOf(*region);
    const ClippedPolygons polygons = clipped.polygons(tolerance);
    Json cells = Json::array();
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      cells.push_back(jsonOf(polygonsOf(polygons, i)));
    }
    const Json line = {{"family", family.name},
                       {"clip", done},
                       {"region", jsonOf(polygonsOf(*region))},
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
