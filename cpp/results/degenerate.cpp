// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "circle_voronoi/merged.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi_families/families.h"
#include "circle_voronoi_families/figures.h"
#include "experiments.h"
#include "figure.h"
#include "method.h"

namespace circle_voronoi::results {
namespace {

constexpr std::size_t kColumns = 10;  ///< the columns of the grids

constexpr std::string_view kCases[] = {"15a", "15b", "15d", "15e", "15f"};

/// The number of merged vertices of each degree.
std::map<std::string, int> degreesOf(const MergedDiagram& merged) {
  std::map<std::string, int> degrees;
  for (std::size_t v = 0; v + 1 < merged.firstCircle.size(); ++v) {
    ++degrees[std::to_string(merged.firstCircle[v + 1] - merged.firstCircle[v])];
  }
  return degrees;
}

/// The spread of the vertices whose disc is close to the reference disc.
double spreadOf(const Diagram& diagram, double reference) {
  double most = 0;
  for (const Vertex& v : diagram.vertices) {
    if (std::abs(v.r - reference) < 1e-6 * reference) most = std::max(most, std::hypot(v.x, v.y));
  }
  return 2 * most;
}

/// Counts the squares of four centers of a grid that have two triangles, and the triangles that lie in no square.
Json quasiTriangulation(const Diagram& diagram) {
  std::map<std::array<std::size_t, 2>, int> trianglesIn;
  int outside = 0;
  for (const auto& triple : diagram.vertexCircles) {
    std::array<std::size_t, 2> low = {kColumns, kColumns};
    std::array<std::size_t, 2> high = {0, 0};
    for (const std::int32_t circle : triple) {
      const std::array<std::size_t, 2> place = {static_cast<std::size_t>(circle) % kColumns,
                                                static_cast<std::size_t>(circle) / kColumns};
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], place[k]);
        high[k] = std::max(high[k], place[k]);
      }
    }
    if (high[0] - low[0] == 1 && high[1] - low[1] == 1) {
      ++trianglesIn[low];
    } else {
      ++outside;
    }
  }
  const auto twos = std::ranges::count_if(trianglesIn, [](const auto& square) { return square.second == 2; });
  return {{"squares", (kColumns - 1) * (kColumns - 1)},
          {"squaresOfTwoTriangles", twos},
          {"trianglesElsewhere", outside},
          {"pairs", neighborPairs(diagram).size()}};
}

/// Draws figure 15 c: the middle, enlarged until rounding is visible. Browsers cannot draw such small lengths, so the
/// circles are multiplied by a power of two, which does not change the diagram.
void drawMiddle(const std::filesystem::path& folder, std::span<const Circle> circles, double spread) {
  const double scale = std::exp2(-std::ilogb(spread));
  std::vector<Circle> large;
  for (const Circle& c : circles) large.push_back({scale * c.x, scale * c.y, scale * c.r});
  SvgFigure figure;
  figure.pixels = 420;
  const double reach = scale * spread / 12;
  figure.frame.bounds = Box{-reach, -reach, reach, reach};
  figure.groups = {"edges", "vertices"};
  draw(folder, "figure-15c", large, diagramOf(large), figure);
}

void drawCase(const std::filesystem::path& folder, std::string_view name, std::span<const Circle> circles,
              const Diagram& diagram) {
  SvgFigure figure;
  figure.pixels = 420;
  figure.groups = {"circles", "edges"};
  if (name == "15f") figure.groups = {"circles", "dual"};
  if (name == "15a") figure.groups.push_back("vertices");
  draw(folder, "figure-" + std::string(name), circles, diagram, figure);
  if (name == "15b") drawMiddle(folder, circles, spreadOf(diagram, 50));
}

}  // namespace

Json degeneratePositions(const Parameters& parameters) {
  Json cases = Json::array();
  for (const std::string_view name : kCases) {
    const Figure& its = figureOf(name);
    const auto circles = circlesOf(its);
    const Diagram method = diagramOf(circles, touchingDisc(Candidates::dynamic, 1));
    const Diagram diagram = diagramOf(circles);
    Json row = {{"figure", name},
                {"family", familyName(its.family)},
                {"n", its.count},
                {"certifiedByMethod", method.certificate.certified()},
                {"certifiedByAuto", diagram.certificate.certified()},
                {"vertices", diagram.vertices.size()},
                {"degrees", degreesOf(mergeVertices(diagram))}};
    if (name == "15b") row["spread"] = spreadOf(diagram, 50);
    if (name == "15f") row["quasiTriangulation"] = quasiTriangulation(diagram);
    cases.push_back(std::move(row));
    drawCase(parameters.folder, name, circles, diagram);
  }
  Json discs = Json::array();
  for (const std::size_t n : {8, 16, 32, 64, 128, 256, 512, 1024}) {
    const Diagram diagram = diagramOf(generate(Family::cocircularEqual, n, 1), touchingDisc(Candidates::dynamic, 1));
    discs.push_back({{"n", n}, {"threeTouchDiscs", diagram.stats.counts.threeTouchDiscs}});
  }
  return {{"cases", std::move(cases)}, {"aroundOneDisc", std::move(discs)}};
}

}  // namespace circle_voronoi::results
