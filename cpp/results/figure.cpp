// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "centers.h"
#include "circle_voronoi/compute.h"
#include "delaunay.h"
#include "method.h"

namespace circle_voronoi::results {
namespace {

// The image cannot see the color scheme of GitHub's page, only the preference of the reader's system. Therefore it has
// its own background.
constexpr std::string_view kStyle = R"(svg { background: #ffffff; }
.cells { fill: none; }
.circles { fill: #e0a458; fill-opacity: 0.55; stroke: #b0701c; stroke-width: 1; }
.edges { stroke: #27447c; stroke-width: 1.3; }
.dual { stroke: #6b7785; stroke-width: 0.9; }
.hull { stroke: #8a6d1d; }
.samples { fill: none; stroke: #c0392b; stroke-width: 3; stroke-linecap: round; }
.dots { fill: none; stroke: #b0701c; stroke-linecap: round; }
.dots path { vector-effect: none; stroke-width: 1.5; }
.centers { fill: none; stroke: #c0392b; stroke-width: 0.7; stroke-opacity: 0.7; }
.sample-graph { fill: none; stroke: #6b7785; stroke-width: 0.7; }
.antipodal { fill: #5a8fd6; fill-opacity: 0.25; stroke: #3f74bb; stroke-width: 0.8; }
.leftover { fill: none; stroke: #a8327a; stroke-width: 1.6; }
.segments { fill: none; stroke: #c0392b; stroke-width: 2.4; }
.box { fill: none; stroke: #27447c; stroke-width: 2; }
@media (prefers-color-scheme: dark) {
svg { background: #12161d; }
.circles { fill: #b97f3a; stroke: #e6b06a; }
.edges { stroke: #8fb3ef; }
.dual { stroke: #93a0b1; }
.hull { stroke: #d9bd6a; }
.samples, .segments, .centers { stroke: #ff8a75; }
.box { stroke: #ffffff; }
.dots { stroke: #e6b06a; }
.sample-graph { stroke: #8d99a8; }
.antipodal { fill: #5a8fd6; stroke: #8fb8f0; }
.leftover { stroke: #f07fc4; }
}
)";

const Circle& at(std::span<const Circle> circles, int i) { return circles[i]; }

/// The point of a circle towards the center of a disc.
Point footOf(const Circle& circle, Vector direction) {
  const double size = length(direction);
  const double part = size == 0 ? 0 : circle.r / size;
  return {circle.x + part * direction.x, circle.y + part * direction.y};
}

std::array<Point, 2> arrow(std::span<const Circle> circles, int a, int b, const Vertex& disc) {
  const auto foot = [&](int i) {
    return footOf(at(circles, i), {disc.x - at(circles, i).x, disc.y - at(circles, i).y});
  };
  return {foot(a), foot(b)};
}

SvgLayer graphLayer(std::string name, std::span<const Point> points) {
  SvgLayer layer{.name = std::move(name)};
  for (const auto& [s, t] : delaunayEdges(points).edges) {
    layer.segments.push_back({points[s], points[t]});
  }
  return layer;
}

}  // namespace

SvgLayer samplesLayer(const Samples& samples) { return {.name = "samples", .points = samples.points}; }

SvgLayer centersLayer(std::span<const Circle> circles) { return graphLayer("centers", centersOf(circles)); }

SvgLayer sampleGraphLayer(const Samples& samples) { return graphLayer("sample-graph", samples.points); }

SvgLayer leftoverLayer(std::span<const Circle> circles) {
  struct PlacedEdge {
    std::int32_t a;
    std::int32_t b;
    Vertex disc;
  };
  std::vector<PlacedEdge> alive;
  Options options = touchingDisc(Candidates::allPairs);
  options.observer = [&](const TraceEvent& event) {
    const auto& [a, b, none] = event.circles;
    if (event.kind == TraceKind::directedEdgePlaced) alive.push_back({a, b, event.disc});
    if (event.kind != TraceKind::directedEdgeDeleted) return;
    // If there are several edges between the same circles, choose the last whose disc of R_min is no larger: each edge
    // has the part of the bisector from its disc to the next.
    const auto gone = std::ranges::find_if(alive.rbegin(), alive.rend(), [&](const PlacedEdge& edge) {
      return edge.a == a && edge.b == b && edge.disc.r <= event.disc.r;
    });
    if (gone != alive.rend()) alive.erase(std::next(gone).base());
  };
  const Diagram diagram = diagramOf(circles, options);
  if (alive.size() != diagram.hull.size()) throw std::logic_error("The leftover directed edges are not the hull.");
  SvgLayer layer{.name = "leftover", .areArrows = true};
  for (const auto& [a, b, disc] : alive) layer.segments.push_back(arrow(circles, a, b, disc));
  return layer;
}

SvgLayer antipodalLayer(std::span<const Circle> circles) {
  SvgLayer layer{.name = "antipodal"};
  Options options = touchingDisc(Candidates::allPairs);
  options.observer = [&](const TraceEvent& event) {
    if (event.kind != TraceKind::antipodalDiscAccepted || event.disc.r <= 0) return;
    layer.discs.push_back({event.disc.x, event.disc.y, event.disc.r});
  };
  diagramOf(circles, options);
  return layer;
}

SvgLayer leftoverLayer(std::span<const Circle> circles, const PrintedResult& printed) {
  SvgLayer layer{.name = "leftover", .areArrows = true};
  for (const PrintedEdge& de : printed.leftover) {
    layer.segments.push_back({footOf(at(circles, de.a), de.fromA), footOf(at(circles, de.b), de.fromB)});
  }
  return layer;
}

SvgLayer segmentsLayer(std::span<const Circle> circles, const PrintedResult& printed) {
  SvgLayer layer{.name = "segments"};
  for (const PrintedSegment& segment : printed.segments) {
    EdgeCurve curve;
    curve.bisector = bisector(at(circles, segment.b), at(circles, segment.a));
    curve.start = {segment.from.x, segment.from.y};
    curve.end = {segment.to.x, segment.to.y};
    curve.from = parameterAt(curve.bisector, curve.start);
    curve.to = parameterAt(curve.bisector, curve.end);
    if (curve.from > curve.to) {
      std::swap(curve.from, curve.to);
      std::swap(curve.start, curve.end);
    }
    layer.arcs.push_back(curve);
  }
  return layer;
}

std::string figureStyle() { return std::string(kStyle); }

void draw(const std::filesystem::path& folder, const std::string& name, std::span<const Circle> circles,
          const Diagram& diagram, SvgFigure figure) {
  std::filesystem::create_directories(folder);
  const auto path = folder / (name + ".svg");
  std::ofstream file(path);
  figure.style = figureStyle();
  const Box box = figure.frame.bounds.value_or(exportBox(circles));
  if (!figure.frame.tolerance) {
    // A tenth of a pixel.
    figure.frame.tolerance = 0.1 * std::max(box.maxX - box.minX, box.maxY - box.minY) / figure.pixels;
  }
  const auto written = writeSvgFigure(file, diagram, figure);
  file.close();
  if (!written || !file) throw std::runtime_error("Cannot write " + path.string());
}

}  // namespace circle_voronoi::results
