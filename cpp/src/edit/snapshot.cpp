// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "at.h"
#include "diagram_of.h"
#include "hiders.h"
#include "order.h"

namespace circle_voronoi {
namespace {

/// Returns the dual of the faces in use, without gaps, with sites in place of slots.
Dual compacted(const EditState& state, const std::vector<int>& siteOf) {
  std::vector<int> placeOf(static_cast<std::size_t>(state.dual.faceCount()), kNone);
  int count = 0;
  for (int face = 0; face < state.dual.faceCount(); ++face) {
    if (state.isInUse(face)) placeOf[at(face)] = count++;
  }
  Dual dual;
  dual.origin.reserve(3 * static_cast<std::size_t>(count));
  dual.twin.reserve(3 * static_cast<std::size_t>(count));
  for (int h = 0; h < state.dual.halfEdgeCount(); ++h) {
    if (!state.isInUse(h / 3)) continue;
    const int origin = state.dual.origin[at(h)];
    const int t = state.dual.twin[at(h)];
    dual.origin.push_back(origin == kPointAtInfinity ? kPointAtInfinity : siteOf[at(origin)]);
    dual.twin.push_back(3 * placeOf[at(t / 3)] + t % 3);
  }
  return dual;
}

}  // namespace

Result<Diagram> snapshotOf(const EditState& state) {
  std::vector<Circle> circles;
  std::vector<int> slotOf;  // of each circle
  circles.reserve(static_cast<std::size_t>(state.circleCount));
  state.ids.forEach([&](CircleId, int slot) {
    slotOf.push_back(slot);
    circles.push_back(state.circles[at(slot)]);
  });
  // The search for hiders needs spatial order, which the slots have lost after many edits.
  const OrderedCircles ordered = order(circles);
  State result;
  Sites& sites = result.sites;
  OrderedCircles hidden;
  std::vector<int> siteOf(state.slots.size(), kNone);
  for (std::size_t i = 0; i < ordered.circles.size(); ++i) {
    const int rank = ordered.indices[i];
    const int slot = slotOf[static_cast<std::size_t>(rank)];
    if (state.isVisible(slot)) {
      siteOf[at(slot)] = static_cast<int>(sites.circles.size());
      sites.circles.push_back(ordered.circles[i]);
      sites.indices.push_back(rank);
    } else {
      hidden.circles.push_back(ordered.circles[i]);
      hidden.indices.push_back(rank);
    }
  }
  const Hiders hiders = findHiders({sites.circles, sites.indices}, {hidden.circles, hidden.indices},
                                   std::numeric_limits<std::int64_t>::max());
  for (std::size_t i = 0; i < hidden.indices.size(); ++i) {
    const int hider = hiders.hider[i];
    sites.hidden.push_back({hidden.indices[i], hider == kNone ? kNone : sites.indices[at(hider)]});
  }
  std::sort(sites.hidden.begin(), sites.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  if (auto error = refusalOfHidden(circles, sites.hidden)) return *std::move(error);

  Stats stats;
  stats.method = Method::automatic;
  stats.way = Way::edit;
  stats.counts.circles = static_cast<std::int64_t>(circles.size());
  stats.counts.hidden = static_cast<std::int64_t>(sites.hidden.size());
  result.dual = compacted(state, siteOf);
  Diagram diagram = diagramOf(circles, std::move(result));
  diagram.weights = state.weights;
  diagram.stats = stats;
  return diagram;
}

SnapshotNumbers numbersOf(const EditState& state) {
  SnapshotNumbers numbers;
  numbers.circles.reserve(static_cast<std::size_t>(state.circleCount));
  state.ids.forEach([&](CircleId id, int slot) {
    numbers.circles.push_back(id);
    if (!state.isVisible(slot)) numbers.hiders.push_back(state.slots[at(state.slots[at(slot)].hider)].id);
  });
  // This is the order of topologyOf, because gaps do not change it.
  for (int face = 0; face < state.dual.faceCount(); ++face) {
    if (state.isVertex(face)) numbers.vertices.push_back(face);
  }
  for (int h = 0; h < state.dual.halfEdgeCount(); ++h) {
    if (state.isEdge(h)) numbers.edges.push_back(state.edgeNumber[at(h)]);
  }
  return numbers;
}

}  // namespace circle_voronoi
