// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over regions and diagrams in them. Any bytes are an input: three say which metric, how many points
// the region has, whether they are sorted and at which distance cells are cut; two for each point take it from a grid,
// from the vertices of the diagram, from the centers of circles, from the middles between neighbors, or from one
// rounding step beside these; the rest are circles (fuzz_input.h). For all inputs,
// - rings are a region, or an error says in one sentence why not;
// - the region is clipped to;
// - the outlines of the cells are closed, and cells beside each other share the pieces of their edges to the bit;
// - the parts of edges are those of the outlines;
// - the areas of the cells sum to that of the region, without a distance;
// - polygons at any tolerance are finite.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "fuzz_input.h"

namespace circle_voronoi::fuzz {
namespace {

constexpr std::size_t kMostPoints = 24;
/// The error of areas by rounding, as a share of the perimeter times the size of the region.
constexpr double kRounding = 1e-15;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

/// The extent of the circles' centers.
Box boxOf(const Diagram& diagram) {
  Box box = {1e300, 1e300, -1e300, -1e300};
  for (const Circle& c : diagram.circles) {
    box = {std::min(box.minX, c.x), std::min(box.minY, c.y), std::max(box.maxX, c.x), std::max(box.maxY, c.y)};
  }
  return box;
}

Point pointOf(const Diagram& diagram, const Box& box, std::uint8_t first, std::uint8_t second) {
  const double size = std::max({box.maxX - box.minX, box.maxY - box.minY, std::abs(box.minX) * 1e-6, 1e-100});
  Point p = {box.minX + size * (static_cast<std::int8_t>(first) & ~3) / 64,
             box.minY + size * static_cast<std::int8_t>(second) / 64};
  const std::size_t kind = first % 4;
  if (kind == 1 && !diagram.vertices.empty()) {
    const Vertex& v = diagram.vertices[second % diagram.vertices.size()];
    p = {v.x, v.y};
  }
  if (kind == 2 && !diagram.circles.empty()) {
    const Circle& c = diagram.circles[second % diagram.circles.size()];
    p = {c.x, c.y};
  }
  if (kind == 3 && !diagram.edges.empty()) {
    // For equal radii a point of the edge, or of its bisector.
    const Edge& edge = diagram.edges[second % diagram.edges.size()];
    const Circle& c = diagram.circles[at(edge.left)];
    const Circle& d = diagram.circles[at(edge.right)];
    p = {(c.x + d.x) / 2, (c.y + d.y) / 2};
  }
  if ((first & 4) != 0 && kind != 0) p.x = std::nextafter(p.x, 1e308);
  return p;
}

/// A distance at which discs meet corners or vertices, touch each other, or are points; nothing for most choices.
std::optional<double> distanceOf(const Diagram& diagram, const Region& region, std::uint8_t choice) {
  if (choice == 0) return std::nullopt;
  const std::size_t which = choice / 4;
  const Circle& c = diagram.circles[which % diagram.circles.size()];
  const Circle& d = diagram.circles[(which + 1) % diagram.circles.size()];
  const double r = diagram.metric == Metric::circles ? c.r : 0;
  const double other = diagram.metric == Metric::circles ? d.r : 0;
  if (choice % 4 == 0) return -r;
  if (choice % 4 == 1 && !diagram.vertices.empty()) return diagram.vertices[which % diagram.vertices.size()].r;
  if (choice % 4 == 2) return (std::hypot(d.x - c.x, d.y - c.y) - r - other) / 2;
  const Point p = region.points()[which % region.sideCount()];
  return std::hypot(p.x - c.x, p.y - c.y) - r;
}

void checkClip(const Diagram& diagram, const Region& region, std::optional<double> distance) {
  const auto clipped = ClippedDiagram::from(diagram, region, distance);
  if (!clipped && !isExact(diagram)) return;
  require(clipped.ok(), clipped ? "" : "a region is not clipped to: " + clipped.error().message);
  std::map<std::tuple<std::int32_t, double, double, double, double>, std::array<int, 2>> pieces;
  for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
    for (const auto& loop : clipped->outline(static_cast<std::int32_t>(i))) {
      require(!loop.empty(), "a loop has no pieces");
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const EdgeCurve& curve = loop[k].curve;
        require(curve.end == loop[(k + 1) % loop.size()].curve.start, "an outline is open");
        if (loop[k].side == kNone) continue;
        const bool isAlong = loop[k].side % 2 == 0;
        const Point start = isAlong ? curve.start : curve.end;
        const Point end = isAlong ? curve.end : curve.start;
        ++pieces[{Diagram::edgeOf(loop[k].side), start.x, start.y, end.x, end.y}][isAlong ? 0 : 1];
      }
    }
  }
  for (const auto& [piece, count] : pieces) require(count[0] == count[1], "a piece of an edge belongs to one cell");
  const ClippedEdges edges = clipped->edges();
  std::size_t listed = 0;
  for (std::size_t k = 0; k < edges.edge.size(); ++k) {
    const auto found = pieces.find({edges.edge[k], edges.start[k].x, edges.start[k].y, edges.end[k].x, edges.end[k].y});
    require(found != pieces.end(), "a part of an edge is in no outline");
    ++listed;
  }
  std::size_t drawn = 0;
  for (const auto& [piece, count] : pieces) drawn += static_cast<std::size_t>(count[0]);
  require(listed == drawn, "an outline has a piece that is no part of an edge");

  const Box box = region.bounds();
  const double size = std::max(box.maxX - box.minX, box.maxY - box.minY);
  const double area = region.area();
  if (!distance && size > 1e-100 && size < 1e100) {
    double sum = 0;
    double total = 0;
    for (const double one : clipped->areas()) {
      sum += one;
      total += std::abs(one);
    }
    require(std::abs(sum - area) <= 1e-12 * total + kRounding * region.perimeter() * size,
            "the areas sum to " + std::to_string(sum) + ", not to " + std::to_string(area));
  }
  for (const double tolerance : {1e-3 * size, 10 * size}) {
    if (!(tolerance > 0) || !std::isfinite(tolerance)) continue;
    const ClippedPolygons polygons = clipped->polygons(tolerance);
    require(polygons.polygonOffsets.size() == diagram.circles.size() + 1, "a cell has no row of polygons");
    require(at(polygons.pointOffsets.back()) == polygons.points.size(), "points belong to no ring");
    for (const Point& p : polygons.points) require(std::isfinite(p.x) && std::isfinite(p.y), "a point is not finite");
  }
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace circle_voronoi;
  using namespace circle_voronoi::fuzz;
  if (size < 4) return 0;
  const auto metric = static_cast<Metric>(data[0] % 3);
  const std::size_t count = std::min<std::size_t>(data[1] % (kMostPoints + 1), (size - 3) / 2);
  const Input input = decode({data + 3 + 2 * count, size - 3 - 2 * count});
  const auto diagram = compute(input.circles, {.metric = metric});
  if (!diagram || diagram->circles.empty()) return 0;
  const Box box = boxOf(*diagram);
  std::vector<Region::Ring> rings(1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint8_t first = data[3 + 2 * k];
    if (first == 255 && !rings.back().empty()) rings.emplace_back();
    rings.back().push_back(pointOf(*diagram, box, first, data[4 + 2 * k]));
  }
  if (data[2] % 4 != 0) {
    for (Region::Ring& ring : rings) {
      Point middle;
      for (const Point& p : ring) {
        middle.x += p.x / static_cast<double>(ring.size());
        middle.y += p.y / static_cast<double>(ring.size());
      }
      std::ranges::stable_sort(ring, {}, [&](Point p) { return std::atan2(p.y - middle.y, p.x - middle.x); });
    }
  }
  const auto region = Region::fromRings(rings);
  if (!region) {
    require(region.error().message.ends_with("."), "an error is no sentence: " + region.error().message);
    return 0;
  }
  checkClip(*diagram, *region, distanceOf(*diagram, *region, data[2] / 4));
  return 0;
}
