// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "circle_voronoi_families/families.h"
#include "experiments.h"
#include "method.h"
#include "mismatches.h"

namespace circle_voronoi::results {
namespace {

/// The numbers of samples to try, in steps of about a quarter.
constexpr int kSteps[] = {0,  1,  2,  3,   4,   5,   6,   8,   10,  12,  16,  20,  24,  32,  40,
                          50, 64, 80, 100, 128, 160, 200, 256, 320, 400, 512, 640, 800, 1000};

struct Needed {
  int setting = 0;       ///< m or N_s
  double perCircle = 0;  ///< samples on each circle, on average
};

/// The first steps at which conditions hold.
struct FirstSteps {
  std::optional<Needed> nothingMissed;  ///< every empty antipodal disc is among the candidates
  std::optional<Needed> right;          ///< the diagram is certified
};

/// The visible circles. Hidden circles play no role.
std::vector<Circle> visibleOf(std::span<const Circle> circles) {
  const Diagram diagram = diagramOf(circles);
  std::vector<Circle> visible;
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (hidden < diagram.hidden.size() && diagram.hidden[hidden].circle == static_cast<int>(i)) {
      ++hidden;
    } else {
      visible.push_back(circles[i]);
    }
  }
  return visible;
}

/// The pairs whose antipodal disc is empty, in order.
std::vector<Pair> emptyDiscs(std::span<const Circle> circles) {
  std::vector<Pair> pairs;
  Options options = touchingDisc(Candidates::allPairs);
  options.observer = [&](const TraceEvent& event) {
    if (event.kind != TraceKind::antipodalDiscAccepted) return;
    pairs.push_back({std::min(event.circles[0], event.circles[1]), std::max(event.circles[0], event.circles[1])});
  };
  diagramOf(circles, options);
  std::ranges::sort(pairs);
  return pairs;
}

FirstSteps firstSteps(std::span<const Circle> circles, Candidates candidates) {
  const std::vector<Pair> needed = emptyDiscs(circles);
  FirstSteps first;
  for (const int step : kSteps) {
    if (first.nothingMissed && first.right) break;
    if (candidates == Candidates::uniform && step == 0) continue;
    const Samples samples =
        candidates == Candidates::uniform ? sampleUniformly(circles, step) : dynamicSamples(circles, step);
    const Needed here = {step, static_cast<double>(samples.points.size()) / static_cast<double>(circles.size())};
    if (!first.nothingMissed &&
        std::ranges::includes(pairNeighbors(samples, static_cast<int>(circles.size())), needed)) {
      first.nothingMissed = here;
    }
    if (!first.right && diagramOf(circles, touchingDisc(candidates, step)).certificate.certified()) first.right = here;
  }
  return first;
}

Json summaryOf(std::vector<Needed> needed, std::uint64_t inputs) {
  std::ranges::sort(needed, {}, &Needed::perCircle);
  const auto at = [&](double part) {
    return needed[static_cast<std::size_t>(part * static_cast<double>(needed.size() - 1))].perCircle;
  };
  Json summary = {{"never", inputs - needed.size()}};
  if (needed.empty()) return summary;
  summary["median"] = at(0.5);
  summary["ninetieth"] = at(0.9);
  summary["most"] = at(1);
  summary["settingForAll"] = std::ranges::max(needed, {}, &Needed::setting).setting;
  return summary;
}

}  // namespace

Json neededSamples(const Parameters& parameters) {
  Json rows = Json::array();
  for (const FamilyInfo& family : families()) {
    // In degenerate position, rounding may make the result wrong with any samples.
    if (family.isDegenerate || test::isBeyondTouchingDisc(family.family)) continue;
    Json row = {{"family", family.name}, {"isDisjoint", family.isDisjoint}};
    for (const auto& [name, candidates] :
         {std::pair{"uniform", Candidates::uniform}, std::pair{"dynamic", Candidates::dynamic}}) {
      std::vector<Needed> nothingMissed;
      std::vector<Needed> right;
      for (std::uint64_t trial = 0; trial < parameters.trials; ++trial) {
        const auto circles = visibleOf(test::comparedInput(family.family, parameters.seed, trial));
        const FirstSteps first = firstSteps(circles, candidates);
        if (first.nothingMissed) nothingMissed.push_back(*first.nothingMissed);
        if (first.right) right.push_back(*first.right);
      }
      row[name] = {{"nothingMissed", summaryOf(std::move(nothingMissed), parameters.trials)},
                   {"right", summaryOf(std::move(right), parameters.trials)}};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace circle_voronoi::results
