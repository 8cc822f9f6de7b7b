// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>

#include "compare.h"
#include "experiments.h"
#include "figure.h"
#include "method.h"
#include "mismatches.h"
#include "oracle.h"
#include "three_touch_disc.h"
#include "trial.h"

namespace circle_voronoi::results {
namespace {

struct Counterexample {
  std::string family;
  std::vector<Circle> circles;
};

/// A square around the circles and the vertices of their diagram.
Box frameOf(std::span<const Circle> circles) {
  std::vector<Circle> shown(circles.begin(), circles.end());
  for (const Vertex& v : diagramOf(circles).vertices) shown.push_back({v.x, v.y, 0});
  const Box box = exportBox(shown);
  const Point middle = {(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2};
  const double reach = 0.6 * std::max(box.maxX - box.minX, box.maxY - box.minY);
  return {middle.x - reach, middle.y - reach, middle.x + reach, middle.y + reach};
}

/// The visibility of a picture: its smallest radius in units of the picture.
double clarity(const Counterexample& example) {
  const Box box = frameOf(example.circles);
  return std::ranges::min(example.circles, {}, &Circle::r).r / (box.maxX - box.minX);
}

bool isBetter(const Counterexample& example, const Counterexample& than) {
  if (example.circles.size() != than.circles.size()) return example.circles.size() < than.circles.size();
  return clarity(example) > clarity(than);
}

/// Draws the correct diagram and, above it, the result of the printed rules, in one picture each.
void drawCounterexample(const std::filesystem::path& folder, const Counterexample& example) {
  const auto& circles = example.circles;
  const PrintedResult printed = runPrinted(circles, pairAll(static_cast<int>(circles.size())));
  const Diagram diagram = diagramOf(circles);
  SvgFigure figure;
  figure.pixels = 420;
  figure.frame.bounds = frameOf(circles);
  figure.groups = {"circles", "edges", "vertices"};
  draw(folder, "counterexample-right", circles, diagram, figure);
  figure.groups = {"circles"};
  figure.layers = {segmentsLayer(circles, printed), leftoverLayer(circles, printed)};
  draw(folder, "counterexample-printed", circles, diagram, figure);
}

using Triple = std::array<CircleIndex, 3>;

/// Returns the sorted vertices outside all circles, each rotated so that its smallest circle comes first.
std::vector<Triple> outerVertices(std::span<const Circle> circles, const Diagram& diagram) {
  const auto circle = [&](std::int32_t i) { return circles[i]; };
  std::vector<Triple> triples;
  for (Triple triple : diagram.vertexCircles) {
    const auto disc = threeTouchDisc(circle(triple[0]), circle(triple[1]), circle(triple[2]));
    if (disc && disc->disc.r < 0) continue;
    std::ranges::rotate(triple, std::ranges::min_element(triple));
    triples.push_back(triple);
  }
  std::ranges::sort(triples);
  return triples;
}

/// Whether the result differs from the exact diagram. If circles may overlap, only vertices outside all circles count:
/// the paper claims nothing about vertices inside.
bool isPrintedWrong(std::span<const Circle> circles, const PrintedResult& printed, const Diagram& exact,
                    const FamilyInfo& family) {
  if (!family.isDisjoint) return outerVertices(circles, printed.diagram) != outerVertices(circles, exact);
  return !(family.isDegenerate ? test::differenceAfterMerging(printed.diagram, exact, circles)
                               : test::difference(printed.diagram, exact))
              .empty();
}

}  // namespace

Json printedRules(const Parameters& parameters) {
  Json rows = Json::array();
  std::optional<Counterexample> best;
  for (const FamilyInfo& family : families()) {
    // Merged vertices can be compared only if no circles intersect.
    if (test::isBeyondTouchingDisc(family.family) || (family.isDegenerate && !family.isDisjoint)) continue;
    int wrongSampled = 0;
    int wrongOfAllPairs = 0;
    for (std::uint64_t trial = 0; trial < parameters.trials; ++trial) {
      const auto circles = test::comparedInput(family.family, parameters.seed, trial);
      const Diagram exact = oracle::exactDiagram(circles);
      const auto fails = [&](std::span<const Pair> pairs) {
        return isPrintedWrong(circles, runPrinted(circles, pairs), exact, family);
      };
      if (fails(dynamicPairs(circles, 1))) ++wrongSampled;
      if (!fails(pairAll(static_cast<int>(circles.size())))) continue;
      if (++wrongOfAllPairs > 1) continue;
      const auto failsToo = [&](std::span<const Circle> fewer) {
        const PrintedResult printed = runPrinted(fewer, pairAll(static_cast<int>(fewer.size())));
        return fewer.size() > 2 && isPrintedWrong(fewer, printed, oracle::exactDiagram(fewer), family);
      };
      const Counterexample example{std::string(family.name), test::shrink(circles, failsToo)};
      if (!best || isBetter(example, *best)) best = example;
    }
    rows.push_back({{"family", family.name},
                    {"isDisjoint", family.isDisjoint},
                    {"wrongSampled", wrongSampled},
                    {"wrongOfAllPairs", wrongOfAllPairs}});
  }
  Json result = {{"families", std::move(rows)}};
  if (!best) return result;
  drawCounterexample(parameters.folder, *best);
  result["counterexample"] = {{"family", best->family}, {"circles", Json::array()}};
  for (const Circle& c : best->circles) result["counterexample"]["circles"].push_back({c.x, c.y, c.r});
  return result;
}

}  // namespace circle_voronoi::results
