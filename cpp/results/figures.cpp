// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/figures.h"

#include <algorithm>
#include <map>

#include "centers.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi_families/families.h"
#include "delaunay.h"
#include "experiments.h"
#include "figure.h"
#include "method.h"

namespace circle_voronoi::results {
namespace {

using Path = std::filesystem::path;

int samplesOn(const Samples& samples, int circle) {
  return static_cast<int>(std::ranges::count(samples.circles, circle));
}

/// The number of edges of the Delaunay graph of the centers between circle 0 and circle 1.
int stepsBetweenCenters(std::span<const Circle> circles) {
  const auto edges = delaunayEdges(centersOf(circles)).edges;
  std::vector<bool> reached(circles.size(), false);
  reached[0] = true;
  int steps = 0;
  for (; !reached[1]; ++steps) {
    const std::vector<bool> before = reached;
    for (const auto& [i, j] : edges) {
      if (before[i]) reached[j] = true;
      if (before[j]) reached[i] = true;
    }
  }
  return steps;
}

/// Edges that circles 0 and 1 share.
int edgesBetween(const Diagram& diagram) {
  return static_cast<int>(std::ranges::count_if(
      diagram.edges, [](const Edge& e) { return std::min(e.left, e.right) == 0 && std::max(e.left, e.right) == 1; }));
}

Json figure5And13(const Path& folder) {
  const auto circles = layersBetween();
  const Samples samples = dynamicSamples(circles, 1);
  const Diagram diagram = diagramOf(circles, touchingDisc(Candidates::dynamic, 1));
  SvgFigure figure;
  figure.pixels = 480;
  figure.frame.bounds = Box{-3.4, -2.6, 1.3, 2.6};
  figure.groups = {"circles"};
  figure.layers = {centersLayer(circles)};
  draw(folder, "figure-5d", circles, diagram, figure);
  figure.groups = {"circles", "edges"};
  figure.layers = {samplesLayer(drawnDynamicSamples(circles, 1))};
  draw(folder, "figure-13a", circles, diagram, figure);
  return {{"n", circles.size()},
          {"stepsBetweenCenters", stepsBetweenCenters(circles)},
          {"areNeighbors", edgesBetween(diagram) > 0},
          {"samplesOnLargest", samplesOn(samples, 0)},
          {"certified", diagram.certificate.certified()}};
}

Json figure6(const Path& folder) {
  const auto circles = sevenCircles();
  const Diagram diagram = diagramOf(circles);
  Json rows = Json::array();
  const auto add = [&](const std::string& name, const Samples& samples, const Diagram& found) {
    SvgFigure figure;
    figure.pixels = 420;
    figure.groups = {"circles"};
    figure.layers = {sampleGraphLayer(samples), samplesLayer(samples)};
    draw(folder, "figure-6-" + name, circles, diagram, figure);
    rows.push_back({{"name", name},
                    {"samples", samples.points.size()},
                    {"pairs", found.stats.counts.antipodalDiscs},
                    {"certified", found.certificate.certified()}});
  };
  add("uniform-20", drawnUniformSamples(circles, 20), diagramOf(circles, touchingDisc(Candidates::uniform, 20)));
  for (const int angular : {0, 1, 3}) {
    add("dynamic-" + std::to_string(angular), drawnDynamicSamples(circles, angular),
        diagramOf(circles, touchingDisc(Candidates::dynamic, angular)));
  }
  return rows;
}

void figure7(const Path& folder) {
  for (const std::string name : {"7a", "7b"}) {
    const auto circles = circlesOf(figureOf(name));
    SvgFigure figure;
    figure.pixels = 480;
    figure.groups = {"circles"};
    figure.layers = {centersLayer(circles), samplesLayer(drawnDynamicSamples(circles, 3))};
    draw(folder, "figure-" + name, circles, diagramOf(circles), figure);
  }
}

Json figure12(const Path& folder) {
  const auto circles = intersectingCircles();
  const Diagram diagram = diagramOf(circles);
  const PrintedResult printed = runPrinted(circles, pairAll(static_cast<int>(circles.size())));
  SvgFigure figure;
  figure.pixels = 480;
  figure.frame.bounds = Box{-4, -4.2, 7.4, 5};
  figure.groups = {"circles"};
  figure.layers = {segmentsLayer(circles, printed), leftoverLayer(circles, printed)};
  draw(folder, "figure-12-printed", circles, diagram, figure);
  figure.groups = {"circles", "edges"};
  figure.layers = {antipodalLayer(circles), leftoverLayer(circles)};
  draw(folder, "figure-12", circles, diagram, figure);
  const auto negative = std::ranges::count_if(diagram.vertices, [](const Vertex& v) { return v.r < 0; });
  return {{"leftoverPrinted", printed.leftover.size()},
          {"leftover", diagram.hull.size()},
          {"verticesInside", negative},
          {"hidden", diagram.hidden.size()}};
}

Json figure13b(const Path& folder) {
  const auto circles = severalEdges();
  const Diagram diagram = diagramOf(circles, touchingDisc(Candidates::dynamic, 1));
  SvgFigure figure;
  figure.pixels = 480;
  figure.groups = {"circles", "edges", "vertices"};
  draw(folder, "figure-13b", circles, diagram, figure);

  std::map<std::array<std::int32_t, 2>, int> edgesOf;
  for (const Edge& e : diagram.edges) ++edgesOf[{std::min(e.left, e.right), std::max(e.left, e.right)}];
  int convex = 0;
  int twoSided = 0;
  for (CircleIndex i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    const auto neighbors = circle_voronoi::neighbors(diagram, i);
    if (neighbors.size() == 2) ++twoSided;
    // A bisector is bent around the smaller circle.
    convex += std::ranges::all_of(neighbors, [&](CircleIndex j) { return circles[j].r >= circles[i].r; });
  }
  return {{"certified", diagram.certificate.certified()},
          {"pairsOfSeveralEdges", std::ranges::count_if(edgesOf, [](const auto& pair) { return pair.second > 1; })},
          {"cellsOfTwoEdges", twoSided},
          {"convexCells", convex}};
}

Json figure14(const Path& folder, std::size_t n) {
  const auto circles = generate(Family::uniform, n, 1);
  const Diagram diagram = diagramOf(circles, touchingDisc(Candidates::dynamic, 1));
  const Box whole = exportBox(circles);
  const Point middle = {(whole.minX + whole.maxX) / 2, (whole.minY + whole.maxY) / 2};
  constexpr double kReach = 20;
  const Box part = {middle.x - kReach, middle.y - kReach, middle.x + kReach, middle.y + kReach};

  SvgFigure figure;
  figure.pixels = 1000;
  figure.groups = {};
  SvgLayer dots{.name = "dots"};
  for (const Circle& c : circles) dots.points.push_back({c.x, c.y});
  const std::vector<Point> corners = {
      {part.minX, part.minY}, {part.maxX, part.minY}, {part.maxX, part.maxY}, {part.minX, part.maxY}};
  SvgLayer box{.name = "box"};
  for (std::size_t k = 0; k < 4; ++k) box.segments.push_back({corners[k], corners[(k + 1) % 4]});
  figure.layers = {dots, box};
  figure.frame.tolerance = 12 * (whole.maxX - whole.minX) / figure.pixels;  // dots in steps of about a pixel
  draw(folder, "figure-14-whole", circles, diagram, figure);

  figure.frame.bounds = part;
  figure.frame.tolerance = std::nullopt;
  figure.pixels = 700;
  figure.groups = {"circles", "edges"};
  figure.layers = {};
  draw(folder, "figure-14-part", circles, diagram, figure);
  return {{"n", n}, {"certified", diagram.certificate.certified()}};
}

}  // namespace

Json drawFigures(const Parameters& parameters) {
  const Path& folder = parameters.folder;
  figure7(folder);
  return {{"5d", figure5And13(folder)},
          {"6", figure6(folder)},
          {"12", figure12(folder)},
          {"13b", figure13b(folder)},
          {"14", figure14(folder, parameters.sizes.back())}};
}

}  // namespace circle_voronoi::results
