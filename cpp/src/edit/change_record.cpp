// SPDX-License-Identifier: GPL-3.0-or-later
#include "change_record.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "at.h"
#include "build_state.h"

namespace circle_voronoi {
namespace {

void reserveRemoved(Change& change, std::size_t vertices, std::size_t edges) {
  change.removedVertices.reserve(vertices);
  change.removedEdges.reserve(edges);
}

void reserveAdded(Change& change, std::size_t vertices, std::size_t edges) {
  change.addedVertices.reserve(vertices);
  change.vertices.reserve(vertices);
  change.vertexCircles.reserve(vertices);
  change.addedEdges.reserve(edges);
  change.edges.reserve(edges);
}

/// Adds a vertex of the new diagram.
void addVertex(Change& change, const EditState& state, int face) {
  const auto [i, j, k] = slotsOfVertex(state, face);
  change.addedVertices.push_back(face);
  change.vertices.push_back(vertexOfFace(state, face));
  change.vertexCircles.push_back({state.slots[at(i)].id, state.slots[at(j)].id, state.slots[at(k)].id});
}

/// Adds an edge of the new diagram.
void addEdge(Change& change, const EditState& state, int h) {
  const int t = state.dual.twin[at(h)];
  const auto vertexOf = [&](int face) { return state.dual.isFinite(face) ? face : kNone; };
  change.addedEdges.push_back(state.edgeNumber[at(h)]);
  change.edges.push_back(
      {state.idOf(state.dual.origin[at(h)]), state.idOf(state.dual.origin[at(t)]), vertexOf(t / 3), vertexOf(h / 3)});
}

/// A step of the hull, given by h, an edge between two circles in a face at infinity. It leads from the side of h,
/// which goes to infinity, to the side that follows around the same cell.
struct HullStep {
  int toInfinity;    ///< the half-edge from infinity to the circle of the cell
  int fromInfinity;  ///< the half-edge of the side that follows
};

HullStep hullStep(const Dual& dual, int h) {
  const int toInfinity = Dual::previous(h);
  return {toInfinity, dual.twin[at(Dual::previous(dual.twin[at(toInfinity)]))]};
}

/// Returns the half-edge between the two circles of a face at infinity.
int hullEdge(const Dual& dual, int face) {
  int h = 3 * face;
  while (dual.origin[at(Dual::previous(h))] != kPointAtInfinity) ++h;
  return h;
}

void addHullSide(Change& change, const EditState& state, int h) {
  const auto sideOf = [&](int side) {
    return 2 * state.edgeNumber[at(side)] + static_cast<int>(side > state.dual.twin[at(side)]);
  };
  change.hullSides.push_back({sideOf(h), sideOf(hullStep(state.dual, h).fromInfinity)});
}

void addCircles(Change& change, const EditState& state) {
  for (const auto* list : {&change.inserted, &change.replaced}) {
    for (const CircleId id : *list) change.circles.push_back(state.circles[at(state.ids.slotOf(id))]);
  }
}

}  // namespace

Result<Change> ChangeRecorder::record(EditState& state, EditWay way) {
  for (const int slot : marked_) marks_[at(slot)] = {};
  marked_.clear();
  marks_.resize(state.slots.size());
  Change change;
  change.way = way;
  const std::size_t faces = state.faceLog.size();
  change.cells.reserve(faces);
  reserveRemoved(change, faces, 2 * faces);
  reserveAdded(change, faces, 2 * faces);
  recordCircles(change, state);
  recordVertices(change, state);
  recordEdges(change, state);
  recordHull(change, state);
  return change;
}

ChangeRecorder::Mark& ChangeRecorder::markOf(int slot) {
  Mark& mark = marks_[at(slot)];
  if (!mark.isListed) {
    marked_.push_back(slot);
    mark.isListed = true;
  }
  return mark;
}

void ChangeRecorder::recordCircles(Change& change, const EditState& state) {
  for (const EditState::SavedSlot& saved : state.slotLog) {
    if (saved.before != kNone) continue;
    const CircleId id = state.slots[at(saved.slot)].id;
    const bool was = saved.data.id != kNone;
    const bool is = id != kNone;
    const bool isVisible = state.isVisible(saved.slot);
    if (was && !is) change.removed.push_back(saved.data.id);
    if (is && !was) change.inserted.push_back(id);
    if (is && was && saved.circle != state.circles[at(saved.slot)]) {
      change.replaced.push_back(id);
      markOf(saved.slot).isMoved = true;
    }
    if (was && isVisible && !saved.wasVisible()) change.shown.push_back(id);
    if (!is || isVisible) continue;
    const bool isNew = !was || saved.wasVisible();
    const int hider = state.slots[at(saved.slot)].hider;
    if (isNew) change.hidden.push_back(id);
    // An edit does not reuse slots that it releases, so a slot still stands for the same circle.
    if (isNew || saved.data.hider != hider) change.hiders.push_back({id, state.slots[at(hider)].id});
  }
  addCircles(change, state);
}

void ChangeRecorder::recordVertices(Change& change, EditState& state) {
  for (EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone) continue;
    const auto corners = cornersOf(state.dual, 3 * saved.face);
    const auto isMoved = [&](int slot) { return slot != kPointAtInfinity && marks_[at(slot)].isMoved; };
    const bool isInUse = state.isInUse(saved.face);
    saved.isChanged = isInUse != saved.wasInUse() || corners != saved.origin ||
                      (isInUse && std::any_of(corners.begin(), corners.end(), isMoved));
    if (!saved.isChanged) continue;
    if (saved.wasVertex()) change.removedVertices.push_back(saved.face);
    if (!state.isVertex(saved.face)) continue;
    addVertex(change, state, saved.face);
  }
}

/// Returns whether half-edge k of a saved face belongs to another edge now: a face beside it has changed, or it has
/// another twin.
bool isOtherEdge(const EditState& state, const EditState::SavedFace& saved, std::size_t k) {
  const int t = state.dual.twin[at(3 * saved.face + static_cast<int>(k))];
  if (saved.isChanged || t != saved.twin[k]) return true;
  const EditState::SavedFace* beyond = state.firstSaved(t / 3);
  return beyond != nullptr && beyond->isChanged;
}

void ChangeRecorder::recordEdges(Change& change, EditState& state) {
  const Dual& dual = state.dual;
  const auto addCell = [&](int slot) {
    if (slot == kPointAtInfinity || !state.isVisible(slot)) return;
    Mark& mark = markOf(slot);
    if (!mark.hasCell) change.cells.push_back(state.slots[at(slot)].id);
    mark.hasCell = true;
  };
  for (const EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone || !saved.wasInUse()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int h = 3 * saved.face + static_cast<int>(k);
      const int t = saved.twin[k];
      if (h > t || saved.edgeNumber[k] == kNone) continue;
      if (!isOtherEdge(state, saved, k)) continue;
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
      const int t = dual.twin[at(h)];
      if (!state.isInUse(saved.face) || !isOtherEdge(state, saved, k)) continue;
      if (!state.isEdge(h)) {
        // An edge at infinity has no number. Any other edge is added by its other half.
        if (dual.origin[at(h)] == kPointAtInfinity || dual.target(h) == kPointAtInfinity)
          state.edgeNumber[at(h)] = kNone;
        continue;
      }
      const EdgeIndex number =
          reused < change.removedEdges.size() ? change.removedEdges[reused++] : EdgeIndex(state.edgeNumbers.take());
      state.edgeNumber[at(h)] = state.edgeNumber[at(t)] = number;
      addEdge(change, state, h);
      addCell(dual.origin[at(h)]);
      addCell(dual.origin[at(t)]);
    }
  }
  for (; reused < change.removedEdges.size(); ++reused) state.edgeNumbers.release(change.removedEdges[reused]);
}

/// Records the steps of the hull that have changed. Each depends on its own face at infinity and on the one before.
void ChangeRecorder::recordHull(Change& change, const EditState& state) {
  const Dual& dual = state.dual;
  const auto isOther = [&](int h) {
    const EditState::SavedFace* saved = state.firstSaved(h / 3);
    return saved != nullptr && isOtherEdge(state, *saved, static_cast<std::size_t>(h % 3));
  };
  const auto add = [&](int h) {
    const auto [toInfinity, fromInfinity] = hullStep(dual, h);
    if (isOther(h) || isOther(toInfinity) || isOther(fromInfinity)) addHullSide(change, state, h);
  };
  for (const EditState::SavedFace& saved : state.faceLog) {
    if (saved.before != kNone || !state.isInUse(saved.face) || dual.isFinite(saved.face)) continue;
    const int h = hullEdge(dual, saved.face);
    add(h);
    const int before = dual.aroundClockwise(Dual::next(h));
    if (state.firstSaved(before / 3) == nullptr) add(before);
  }
}

Result<Change> ChangeRecorder::recordWhole(const EditState& before, const EditState& after) {
  Change change;
  change.way = EditWay::whole;
  // Each face has three half-edges, and each edge has two.
  const auto faces = static_cast<std::size_t>(before.faceCount);
  const auto facesAfter = static_cast<std::size_t>(after.faceCount);
  reserveRemoved(change, faces, 3 * faces / 2);
  reserveAdded(change, facesAfter, 3 * facesAfter / 2);
  change.cells.reserve(static_cast<std::size_t>(after.visibleCount));
  before.ids.forEach([&](CircleId id, int slot) {
    const int now = after.ids.slotOf(id);
    if (now == kNone) {
      change.removed.push_back(id);
      return;
    }
    if (before.circles[at(slot)] != after.circles[at(now)]) change.replaced.push_back(id);
    if (before.isVisible(slot) && !after.isVisible(now)) change.hidden.push_back(id);
    if (!before.isVisible(slot) && after.isVisible(now)) change.shown.push_back(id);
  });
  after.ids.forEach([&](CircleId id, int slot) {
    const int was = before.ids.slotOf(id);
    if (was == kNone) change.inserted.push_back(id);
    if (after.isVisible(slot)) {
      change.cells.push_back(id);
      return;
    }
    if (was == kNone) change.hidden.push_back(id);
    const CircleId by = after.slots[at(after.slots[at(slot)].hider)].id;
    const bool isSame =
        was != kNone && !before.isVisible(was) && before.slots[at(before.slots[at(was)].hider)].id == by;
    if (!isSame) change.hiders.push_back({id, by});
  });
  addCircles(change, after);
  for (int face = 0; face < before.dual.faceCount(); ++face) {
    if (before.isVertex(face)) change.removedVertices.push_back(face);
  }
  for (int face = 0; face < after.dual.faceCount(); ++face) {
    if (after.isVertex(face)) addVertex(change, after, face);
  }
  for (int h = 0; h < before.dual.halfEdgeCount(); ++h) {
    if (before.isEdge(h)) change.removedEdges.push_back(before.edgeNumber[at(h)]);
  }
  for (int h = 0; h < after.dual.halfEdgeCount(); ++h) {
    if (after.isEdge(h)) addEdge(change, after, h);
  }
  for (int face = 0; face < after.dual.faceCount(); ++face) {
    if (after.isInUse(face) && !after.dual.isFinite(face)) addHullSide(change, after, hullEdge(after.dual, face));
  }
  return change;
}

}  // namespace circle_voronoi
