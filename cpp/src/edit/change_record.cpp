// SPDX-License-Identifier: GPL-3.0-or-later
#include "change_record.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "build_state.h"
#include "diagram_of.h"

namespace circle_voronoi {
namespace {

/// Adds a vertex that is there now; an error if no double can hold it.
std::optional<Error> addVertex(Change& change, const EditState& state, int face) {
  const auto [i, j, k] = slotsOfVertex(state, face);
  const std::array<CircleId, 3> ids = {state.sites[i].id, state.sites[j].id, state.sites[k].id};
  const auto vertex = vertexOfFace(state, face);
  if (!vertex) return vertexBeyondDoubles({ids[0], ids[1], ids[2]});
  change.addedVertices.push_back(face);
  change.vertices.push_back(*vertex);
  change.vertexCircles.push_back(ids);
  return std::nullopt;
}

/// Adds an edge that is there now.
void addEdge(Change& change, const EditState& state, int h) {
  const int t = state.dual.twin[h];
  const auto vertexOf = [&](int face) { return state.dual.isFinite(face) ? face : kNone; };
  change.addedEdges.push_back(state.edgeNumber[h]);
  change.edges.push_back(
      {state.idOf(state.dual.origin[h]), state.idOf(state.dual.origin[t]), vertexOf(t / 3), vertexOf(h / 3)});
}

bool isEdge(const EditState& state, int h) {
  return state.isInUse(h / 3) && h < state.dual.twin[h] && state.dual.origin[h] != kInfinity &&
         state.dual.target(h) != kInfinity;
}

}  // namespace

Result<Change> ChangeRecorder::record(EditState& state, EditWay way) {
  for (const int slot : marked_) marks_[slot] = {};
  marked_.clear();
  marks_.resize(state.sites.size());
  Change change;
  change.way = way;
  recordCircles(change, state);
  if (auto error = recordVertices(change, state)) return *std::move(error);
  recordEdges(change, state);
  return change;
}

ChangeRecorder::Mark& ChangeRecorder::markOf(int slot) {
  Mark& mark = marks_[slot];
  if (!mark.isListed) {
    marked_.push_back(slot);
    mark.isListed = true;
  }
  return mark;
}

void ChangeRecorder::recordCircles(Change& change, const EditState& state) {
  for (const EditState::SavedSite& saved : state.siteLog) {
    if (saved.before != kNone) continue;
    const std::int32_t id = state.sites[saved.slot].id;
    const bool was = saved.site.id != kNone;
    const bool is = id != kNone;
    const bool isVisible = state.isVisible(saved.slot);
    if (was && !is) change.removed.push_back(saved.site.id);
    if (is && !was) change.inserted.push_back(id);
    if (is && was && saved.circle != state.circles[saved.slot]) {
      change.replaced.push_back(id);
      markOf(saved.slot).isMoved = true;
    }
    if (is && !isVisible && (!was || saved.wasVisible())) change.hidden.push_back(id);
    if (was && isVisible && !saved.wasVisible()) change.shown.push_back(id);
  }
}

std::optional<Error> ChangeRecorder::recordVertices(Change& change, EditState& state) {
  for (EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone) continue;
    const auto corners = cornersOf(state.dual, 3 * saved.face);
    const auto isMoved = [&](int slot) { return slot != kInfinity && marks_[slot].isMoved; };
    const bool isInUse = state.isInUse(saved.face);
    saved.isChanged = isInUse != saved.wasInUse() || corners != saved.origin ||
                      (isInUse && std::any_of(corners.begin(), corners.end(), isMoved));
    if (!saved.isChanged) continue;
    if (saved.wasVertex()) change.removedVertices.push_back(saved.face);
    if (!state.isVertex(saved.face)) continue;
    if (auto error = addVertex(change, state, saved.face)) return error;
  }
  return std::nullopt;
}

void ChangeRecorder::recordEdges(Change& change, EditState& state) {
  const Dual& dual = state.dual;
  const auto isChanged = [&](int face) {
    const EditState::SavedFace* saved = state.firstSaved(face);
    return saved != nullptr && saved->isChanged;
  };
  const auto addCell = [&](int slot) {
    if (slot == kInfinity || !state.isVisible(slot)) return;
    Mark& mark = markOf(slot);
    if (!mark.hasCell) change.cells.push_back(state.sites[slot].id);
    mark.hasCell = true;
  };
  for (const EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone || !saved.wasInUse()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int h = 3 * saved.face + static_cast<int>(k);
      const int t = saved.twin[k];
      if (h > t || saved.edgeNumber[k] == kNone) continue;
      if (!saved.isChanged && dual.twin[h] == t && !isChanged(t / 3)) continue;
      change.removedEdges.push_back(saved.edgeNumber[k]);
      addCell(saved.origin[k]);
      addCell(saved.origin[(k + 1) % 3]);
    }
  }
  std::size_t reused = 0;
  for (const EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int h = 3 * saved.face + static_cast<int>(k);
      const int t = dual.twin[h];
      if (!state.isInUse(saved.face) || (!saved.isChanged && saved.twin[k] == t && !isChanged(t / 3))) continue;
      if (!isEdge(state, h)) {
        // At infinity, or a part of one that the other half adds.
        if (dual.origin[h] == kInfinity || dual.target(h) == kInfinity) state.edgeNumber[h] = kNone;
        continue;
      }
      const int number = reused < change.removedEdges.size() ? change.removedEdges[reused++] : state.edgePlaces.take();
      state.edgeNumber[h] = state.edgeNumber[t] = number;
      addEdge(change, state, h);
      addCell(dual.origin[h]);
      addCell(dual.origin[t]);
    }
  }
  for (; reused < change.removedEdges.size(); ++reused) state.edgePlaces.release(change.removedEdges[reused]);
}

Result<Change> ChangeRecorder::recordWhole(const EditState& before, const EditState& after) {
  Change change;
  change.way = EditWay::whole;
  before.ids.forEach([&](std::int32_t id, int slot) {
    const int now = after.ids.slotOf(id);
    if (now == kNone) {
      change.removed.push_back(id);
      return;
    }
    if (before.inputOf(slot) != after.inputOf(now)) change.replaced.push_back(id);
    if (before.isVisible(slot) && !after.isVisible(now)) change.hidden.push_back(id);
    if (!before.isVisible(slot) && after.isVisible(now)) change.shown.push_back(id);
  });
  after.ids.forEach([&](std::int32_t id, int slot) {
    if (after.isVisible(slot)) change.cells.push_back(id);
    if (before.ids.slotOf(id) != kNone) return;
    change.inserted.push_back(id);
    if (!after.isVisible(slot)) change.hidden.push_back(id);
  });
  for (int face = 0; face < before.dual.faceCount(); ++face) {
    if (before.isVertex(face)) change.removedVertices.push_back(face);
  }
  for (int face = 0; face < after.dual.faceCount(); ++face) {
    if (!after.isVertex(face)) continue;
    if (auto error = addVertex(change, after, face)) return *std::move(error);
  }
  for (int h = 0; h < before.dual.halfEdgeCount(); ++h) {
    if (isEdge(before, h)) change.removedEdges.push_back(before.edgeNumber[h]);
  }
  for (int h = 0; h < after.dual.halfEdgeCount(); ++h) {
    if (isEdge(after, h)) addEdge(change, after, h);
  }
  return change;
}

}  // namespace circle_voronoi
