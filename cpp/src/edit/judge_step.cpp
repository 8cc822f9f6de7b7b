// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_step.h"

#include <algorithm>
#include <cstddef>

#include "at.h"
#include "settle_ties.h"

namespace circle_voronoi {
StepVerdict StepJudge::judge(EditState& state, int moved) {
  unsettled_.clear();
  for (const int slot : touched_) turns_[at(slot)] = 0;  // in case memory ran out the last time
  touched_.clear();
  turns_.resize(state.slots.size());
  hullTurns_ = 0;
  const int faceCount = state.visibleCount < 2 ? 0 : 2 * state.visibleCount - 2;
  if (state.faceCount != faceCount) return StepVerdict::broken;
  StepProver prover(state.dual, state.circles, state.predicates, state.discs, state.proof);
  if (const StepVerdict verdict = judgeFaces(state, moved, prover); verdict != StepVerdict::right) return verdict;
  const bool areRight = areEdgesRight(state, prover);
  // Call areTurnsRight in any case, because it resets the counts to zero.
  return areTurnsRight(state) && areRight && areCirclesRight(state, moved) ? StepVerdict::right : StepVerdict::wrong;
}

/// Checks adjacency and computes the discs of changed faces. Their neighbors, whose edges change, are logged, too.
StepVerdict StepJudge::judgeFaces(EditState& state, int moved, StepProver& prover) {
  const Dual& dual = state.dual;
  StepVerdict verdict = StepVerdict::right;
  for (std::size_t i = state.stepFaces(); i < state.faceLog.size(); ++i) {
    const int face = state.faceLog[i].face;
    const auto corners = cornersOf(dual, 3 * face);
    const bool isInUse = state.isInUse(face);
    const bool isChanged = isInUse != state.faceLog[i].wasInUse() || corners != state.faceLog[i].origin ||
                           (moved != kNone && std::find(corners.begin(), corners.end(), moved) != corners.end());
    state.faceLog[i].isChanged = isChanged;
    if (!isInUse) continue;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      if (!dual.fits(h)) return StepVerdict::broken;
      if (dual.origin[at(h)] != kPointAtInfinity && !state.isVisible(dual.origin[at(h)])) return StepVerdict::broken;
      if (isChanged) state.willChange(dual.twin[at(h)] / 3);
    }
    if (!isChanged) continue;
    state.discs.update(face);
    if (!prover.proveFace(face)) verdict = StepVerdict::wrong;
  }
  return verdict;
}

void StepJudge::addTurns(int around, int neighbor, int count) {
  if (around == kPointAtInfinity) return;
  touched_.push_back(around);
  turns_[at(around)] += count;
  if (neighbor == kPointAtInfinity) hullTurns_ += count;
}

/// Checks the changed edges: neither circle beside an edge hides the other, and ends are in order. Subtracts the former
/// contributions of these edges to the turns and adds the new ones.
bool StepJudge::areEdgesRight(EditState& state, StepProver& prover) {
  const Dual& dual = state.dual;
  const auto isChanged = [&](int face) {
    const EditState::SavedFace* saved = state.savedInStep(face);
    return saved != nullptr && saved->isChanged;
  };
  for (std::size_t i = state.stepFaces(); i < state.faceLog.size(); ++i) {
    const EditState::SavedFace& saved = state.faceLog[i];
    for (std::size_t k = 0; saved.wasInUse() && k < 3; ++k) {
      const int h = 3 * saved.face + static_cast<int>(k);
      if (!saved.isChanged && dual.twin[at(h)] == saved.twin[k] && !isChanged(saved.twin[k] / 3)) continue;
      addTurns(saved.origin[k], saved.origin[(k + 1) % 3], -static_cast<int>(saved.proof[k].passes));
    }
  }
  for (std::size_t i = state.stepFaces(); i < state.faceLog.size(); ++i) {
    const EditState::SavedFace& saved = state.faceLog[i];
    if (!state.isInUse(saved.face)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int h = 3 * saved.face + static_cast<int>(k);
      const int t = dual.twin[at(h)];
      const bool isOther = saved.isChanged || t != saved.twin[k] || isChanged(t / 3);
      // If both faces are in the log, one half of the edge is enough.
      if (!isOther || (h > t && state.savedInStep(t / 3) != nullptr)) continue;
      const int a = dual.origin[at(h)];
      const int b = dual.origin[at(t)];
      if (a != kPointAtInfinity && b != kPointAtInfinity && state.predicates.hiddenOf(a, b) != kPointAtInfinity) {
        return false;
      }
      const int order = prover.proveEdge(h);
      if (order < 0) return false;
      if (order == 0 && !isSettledTie(dual, h, state.circles)) unsettled_.push_back(h);
      addTurns(a, b, static_cast<int>(state.proof[at(h)].passes));
      addTurns(b, a, static_cast<int>(state.proof[at(t)].passes));
    }
  }
  return true;
}

/// Checks that each visible region, and the hull, still makes one full turn.
bool StepJudge::areTurnsRight(const EditState& state) {
  for (std::size_t i = state.stepSlots(); i < state.slotLog.size(); ++i) {
    const EditState::SavedSlot& saved = state.slotLog[i];
    touched_.push_back(saved.slot);
    turns_[at(saved.slot)] -= static_cast<int>(state.isVisible(saved.slot)) - static_cast<int>(saved.wasVisible());
  }
  bool areRight = hullTurns_ == 0;
  for (const int slot : touched_) {
    areRight = areRight && turns_[at(slot)] == 0;
    turns_[at(slot)] = 0;
  }
  return areRight;
}

/// Checks that each hidden circle that may have changed is in the list of a visible circle that contains it.
bool StepJudge::areCirclesRight(EditState& state, int moved) const {
  const auto isRightlyHidden = [&](int slot) {
    const int hider = state.slots[at(slot)].hider;
    return hider != kNone && state.isVisible(hider) && state.hides(hider, slot);
  };
  for (std::size_t i = state.stepSlots(); i < state.slotLog.size(); ++i) {
    const int slot = state.slotLog[i].slot;
    if (state.isVisible(slot)) continue;
    const Slot& data = state.slots[at(slot)];
    if (data.firstHidden != kNone || (data.id != kNone && !isRightlyHidden(slot))) return false;
  }
  if (moved == kNone) return true;
  for (int slot = state.slots[at(moved)].firstHidden; slot != kNone; slot = state.slots[at(slot)].next) {
    if (!isRightlyHidden(slot)) return false;
  }
  return true;
}

}  // namespace circle_voronoi
