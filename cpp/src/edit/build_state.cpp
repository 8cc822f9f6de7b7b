// SPDX-License-Identifier: GPL-3.0-or-later
#include "build_state.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "construct.h"
#include "diagram_of.h"
#include "hide.h"
#include "order.h"
#include "three_touch_disc.h"
#include "triangulate.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// Coordinates may grow by a factor of 2^24 before everything is scaled again. The price is that lengths below 2^-100
/// of the whole are decided in integers, instead of only those below 2^-124.
constexpr double kRoom = 0x1p24;
constexpr double kLargestScaled = 0x1p80;

struct Scaled {
  std::vector<Circle> circles;
  double unit;
  bool isExact;
};

/// Scales the circles. The unit leaves room to grow if this rounds none of them.
Result<Scaled> scale(std::span<const Circle> circles, bool weights) {
  auto validated = validate(circles, weights);
  if (!validated) return validated.error();
  auto& [scaled, unit] = validated.value();
  for (const double factor : {kRoom, 1.0}) {
    Scaled result{{}, unit * factor, true};
    result.circles.reserve(circles.size());
    for (const Circle& c : circles) {
      const auto exact = scaledExactly(c, result.unit);
      if (!exact) break;
      result.circles.push_back(*exact);
    }
    if (result.circles.size() == circles.size()) return result;
  }
  return Scaled{std::move(scaled), unit, false};
}

/// Copies the faces of a correct dual, and its proof, to a state. Vertices come first, so that their numbers have no
/// gaps.
void fillFaces(EditState& state, const Dual& dual, const Proof& proof) {
  state.faceCount = dual.faceCount();
  state.facePlaces = NumberPool(state.faceCount);
  state.sizeToPlaces();
  std::vector<int> placeOf(static_cast<std::size_t>(dual.faceCount()));
  int place = 0;
  for (const bool isVertex : {true, false}) {
    for (int face = 0; face < dual.faceCount(); ++face) {
      if (dual.isFinite(face) == isVertex) placeOf[face] = place++;
    }
  }
  for (int face = 0; face < dual.faceCount(); ++face) state.discs.set(placeOf[face], proof.discs[face]);
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int at = 3 * placeOf[h / 3] + h % 3;
    state.dual.origin[at] = dual.origin[h];
    state.dual.twin[at] = 3 * placeOf[dual.twin[h] / 3] + dual.twin[h] % 3;
    state.proof[at] = proof.halfEdges[h];
    state.noteEdge(at);
  }
  int edges = 0;
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    if (state.isEdge(h)) state.edgeNumber[h] = state.edgeNumber[state.dual.twin[h]] = edges++;
  }
  state.edgePlaces = NumberPool(edges);
}

}  // namespace

std::optional<Circle> scaledExactly(const Circle& circle, double unit) {
  const double factor = 1 / unit;
  // Adding zero turns -0 into +0, as in validate.
  const Circle scaled = {circle.x * factor + 0.0, circle.y * factor + 0.0, circle.r * factor + 0.0};
  if (std::max({std::abs(scaled.x), std::abs(scaled.y), std::abs(scaled.r)}) >= kLargestScaled) return std::nullopt;
  if (Circle{scaled.x * unit, scaled.y * unit, scaled.r * unit} != circle) return std::nullopt;
  return scaled;
}

bool rescale(EditState& state, double unit) {
  std::vector<Circle> circles(state.circles.size());
  for (int slot = 0; slot < static_cast<int>(circles.size()); ++slot) {
    if (state.sites[slot].id == kNone) continue;
    const auto exact = scaledExactly(state.inputOf(slot), unit);
    if (!exact) return false;
    circles[slot] = *exact;
  }
  // A disc is a homogeneous point: with this weight all directions to it keep their bits.
  const double growth = unit / state.unit;
  for (int face = 0; face < state.dual.faceCount(); ++face) {
    if (state.isInUse(face) && !std::isfinite(state.discs[face].w * growth)) return false;
  }
  std::copy(circles.begin(), circles.end(), state.circles.begin());
  for (int face = 0; face < state.dual.faceCount(); ++face) {
    if (!state.isInUse(face)) continue;
    FaceDisc disc = state.discs[face];
    disc.w *= growth;
    state.discs.set(face, disc);
  }
  state.unit = unit;
  return true;
}

bool makeRoom(EditState& state, std::span<const Circle> circles) {
  const auto validated = validate(circles, state.weights);
  if (!validated || validated.value().unit <= state.unit) return false;
  return rescale(state, validated.value().unit * kRoom) || rescale(state, validated.value().unit);
}

std::array<int, 3> slotsOfVertex(const EditState& state, int face) {
  auto slots = cornersOf(state.dual, 3 * face);
  const auto isBefore = [&](int a, int b) { return state.sites[a].id < state.sites[b].id; };
  std::rotate(slots.begin(), std::min_element(slots.begin(), slots.end(), isBefore), slots.end());
  return slots;
}

std::optional<Vertex> vertexOfFace(const EditState& state, int face) {
  const auto [i, j, k] = slotsOfVertex(state, face);
  return vertexOf(state.circles[i], state.circles[j], state.circles[k], state.unit);
}

std::optional<Error> vertexError(const EditState& state) {
  for (int face = 0; face < state.dual.faceCount(); ++face) {
    if (!state.isVertex(face) || vertexOfFace(state, face)) continue;
    const auto [i, j, k] = slotsOfVertex(state, face);
    return vertexBeyondDoubles({state.sites[i].id, state.sites[j].id, state.sites[k].id});
  }
  return std::nullopt;
}

Result<std::unique_ptr<EditState>> buildState(std::span<const Circle> circles, std::span<const CircleId> ids,
                                              bool weights) {
  auto scaledOrError = scale(circles, weights);
  if (!scaledOrError) return scaledOrError.error();
  const Scaled& scaled = scaledOrError.value();
  const Progress silent;
  Journal journal(silent);
  Sites sites = triangulate(hide(order(scaled.circles)));
  if (auto error = refusalOfHidden(scaled.circles, sites.hidden)) {
    if (error->circle != kNone) error->circle = ids[static_cast<std::size_t>(error->circle)];
    return *std::move(error);
  }
  const Construction construction = constructAutomatically(sites, {}, journal);
  if (!construction.isRight()) {
    return Error{ErrorCode::notCertified, -1, "No construction led to a certified diagram."};
  }

  auto state = std::make_unique<EditState>();
  state->weights = weights;
  state->unit = scaled.unit;
  state->hasScale = std::any_of(circles.begin(), circles.end(), [](const Circle& c) { return c != Circle{}; });
  state->circleCount = static_cast<int>(circles.size());
  state->visibleCount = static_cast<int>(sites.circles.size());
  state->sitePlaces = NumberPool(state->circleCount);
  state->sizeToPlaces();
  std::vector<int> slots(circles.size(), kNone);  // the slot of each index
  int slot = 0;
  for (; slot < state->visibleCount; ++slot) slots[sites.indices[slot]] = slot;
  for (const HiddenCircle& hidden : sites.hidden) slots[hidden.circle] = slot++;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    state->circles[slots[i]] = scaled.circles[i];
    state->sites[slots[i]].id = ids[i];
    state->ids.add(ids[i], slots[i]);
  }
  if (!scaled.isExact) {
    state->inexact.resize(circles.size());
    for (std::size_t i = 0; i < circles.size(); ++i) state->inexact[slots[i]] = circles[i];
  }
  for (const HiddenCircle& hidden : sites.hidden) state->attach(slots[hidden.circle], slots[hidden.by]);
  state->nextId = ids.empty() ? 0 : ids.back() + 1;
  fillFaces(*state, construction.dual, construction.verdict.proof);
  state->prepareToKeep();
  state->keep();
  return state;
}

}  // namespace circle_voronoi
