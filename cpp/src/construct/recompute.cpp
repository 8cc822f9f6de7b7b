// SPDX-License-Identifier: GPL-3.0-or-later
#include "recompute.h"

#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>

#include "construct.h"
#include "diagram_of.h"
#include "journal.h"
#include "topology.h"
#include "validate.h"

namespace circle_voronoi {

std::optional<Diagram> recompute(const Diagram& before, std::span<const Circle> circles) {
  auto rounded = validate(circles, before.weights);
  auto dual = dualOf({before.vertexCircles, before.edges, before.hull}, static_cast<int>(circles.size()));
  if (!rounded || !std::holds_alternative<Dual>(dual)) return {};
  State state;
  Sites& sites = state.sites;
  sites.circles = std::move(*rounded);
  sites.indices.resize(circles.size());
  std::iota(sites.indices.begin(), sites.indices.end(), 0);
  sites.centers = std::move(std::get<Dual>(dual));

  const Progress progress;
  Journal journal(progress);
  constructByFlips(state, {}, journal, Threads());
  if (!state.verdict.isRight()) return {};
  Diagram result = diagramOf(circles, std::move(state));
  result.weights = before.weights;
  result.stats = std::move(journal.stats);
  result.stats.method = Method::automatic;
  result.stats.counts.circles = static_cast<std::int64_t>(circles.size());
  return result;
}

}  // namespace circle_voronoi
