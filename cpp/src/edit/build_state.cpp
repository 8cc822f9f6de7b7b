// SPDX-License-Identifier: GPL-3.0-or-later
#include "build_state.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "at.h"
#include "construct.h"
#include "guarded.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// Copies the faces of a correct dual, and its proof, to a state. Vertices come first, so that their numbers have no
/// gaps.
void fillFaces(EditState& state, const Dual& dual, const Proof& proof) {
  state.faceCount = dual.faceCount();
  state.faceNumbers = NumberPool(state.faceCount);
  state.sizeToNumbers();
  std::vector<int> placeOf(static_cast<std::size_t>(dual.faceCount()));
  int place = 0;
  for (const bool isVertex : {true, false}) {
    for (int face = 0; face < dual.faceCount(); ++face) {
      if (dual.isFinite(face) == isVertex) placeOf[at(face)] = place++;
    }
  }
  for (int face = 0; face < dual.faceCount(); ++face) state.discs.set(placeOf[at(face)], proof.discs[at(face)]);
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int to = 3 * placeOf[at(h / 3)] + h % 3;
    state.dual.origin[at(to)] = dual.origin[at(h)];
    state.dual.twin[at(to)] = 3 * placeOf[at(dual.twin[at(h)] / 3)] + dual.twin[at(h)] % 3;
    state.proof[at(to)] = proof.halfEdges[at(h)];
    state.noteEdge(to);
  }
  int edges = 0;
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    if (state.isEdge(h)) state.edgeNumber[at(h)] = state.edgeNumber[at(state.dual.twin[at(h)])] = edges++;
  }
  state.edgeNumbers = NumberPool(edges);
}

}  // namespace

std::array<int, 3> slotsOfVertex(const EditState& state, int face) {
  auto slots = cornersOf(state.dual, 3 * face);
  const auto isBefore = [&](int a, int b) { return state.slots[at(a)].id < state.slots[at(b)].id; };
  std::rotate(slots.begin(), std::min_element(slots.begin(), slots.end(), isBefore), slots.end());
  return slots;
}

Vertex vertexOfFace(const EditState& state, int face) {
  return state.predicates.vertex(cornersOf(state.dual, 3 * face), state.discs[at(face)]).value_or(Vertex{});
}

Result<std::unique_ptr<EditState>> buildState(std::span<const Circle> circles, std::span<const CircleId> ids,
                                              CircleId nextId, const EditorOptions& options) {
  const auto valid = validate(circles, options.weights);
  if (!valid) return valid.error();
  const std::vector<Circle>& rounded = *valid;
  Options ours;
  ours.weights = options.weights;
  ours.threads = options.threads;
  Journal journal(ours.progress);
  State constructed;
  try {
    constructed = construct(rounded, ours, journal);
  } catch (ThrownError& refusal) {
    std::int64_t& circle = refusal.error.circle;
    if (circle != kNone) circle = ids[static_cast<std::size_t>(circle)];
    throw;
  }
  const auto& [sites, dual, verdict] = constructed;
  if (!verdict.isRight()) {
    return errorWith(ErrorCode::notCertified, "No construction led to a certified diagram.");
  }

  auto state = std::make_unique<EditState>();
  state->weights = options.weights;
  state->threads = options.threads;
  state->circleCount = static_cast<int>(circles.size());
  state->visibleCount = static_cast<int>(sites.circles.size());
  state->slotNumbers = NumberPool(state->circleCount);
  state->sizeToNumbers();
  std::vector<int> slots(circles.size(), kNone);  // the slot of each index
  int slot = 0;
  for (; slot < state->visibleCount; ++slot) slots[at(sites.indices[at(slot)])] = slot;
  for (const HiddenCircle& hidden : sites.hidden) slots[at(hidden.circle)] = slot++;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    state->circles[at(slots[i])] = rounded[i];
    state->slots[at(slots[i])].id = ids[i];
    state->ids.add(ids[i], slots[i]);
    state->sizes.add(rounded[i], 1);
  }
  for (const HiddenCircle& hidden : sites.hidden) state->attach(slots[at(hidden.circle)], slots[at(hidden.by)]);
  state->nextId = std::max(nextId, ids.empty() ? CircleId(0) : CircleId(ids.back() + 1));
  fillFaces(*state, dual, verdict.proof);
  state->prepareToCommit();
  state->commit();
  return state;
}

}  // namespace circle_voronoi
