// SPDX-License-Identifier: GPL-3.0-or-later
#include "step.h"

#include <algorithm>
#include <tuple>

#include "at.h"
#include "construct.h"
#include "flip.h"
#include "repair.h"
#include "sort_unique.h"
#include "wrong_faces.h"

namespace circle_voronoi {
namespace {

/// Computing the whole diagram is faster than a step that hides more than kFew circles plus 1 / kHiddenShare of all, or
/// shows more than kFew plus 1 / kShownShare.
constexpr int kFew = 32;
constexpr int kHiddenShare = 2;
constexpr int kShownShare = 4;
/// The size of a sample that is large enough to estimate such a share.
constexpr std::size_t kSample = 128;

/// Returns whether one circle contains another, up to rounding.
bool covers(const Circle& outer, const Circle& inner) {
  return distanceFrom(centerOf(outer), inner) + 2 * inner.r <= outer.r;
}

}  // namespace

std::optional<EditWay> Stepper::insert(const Circle& circle, CircleId id, int hint) {
  if (coversMany(circle)) return std::nullopt;
  begin();
  const int slot = state_.addSlot(circle, id);
  reportCircle(TraceKind::circleInserted, slot, circle);
  if (!put(slot, hint) || !putWaiting(hint)) return std::nullopt;
  return certify(kNone);
}

std::optional<EditWay> Stepper::remove(int slot) {
  begin();
  if (!state_.isVisible(slot)) {
    state_.detach(slot);
    reportCircle(TraceKind::circleRemoved, slot, state_.circles[at(slot)]);
    state_.removeSlot(slot);
    return certify(kNone);
  }
  const int hint = neighborOf(slot);
  if (!takeOut(slot) || !releaseHidden(slot, kNone)) return std::nullopt;
  if (!waiting_.empty()) mendForInsertion();
  reportCircle(TraceKind::circleRemoved, slot, state_.circles[at(slot)]);
  state_.removeSlot(slot);
  if (!putWaiting(hint)) return std::nullopt;
  return certify(kNone);
}

std::optional<EditWay> Stepper::replace(int slot, const Circle& circle) {
  if (coversMany(circle)) return std::nullopt;
  const EditState::Mark mark = begin();
  const bool isVisible = state_.isVisible(slot);
  if (isVisible && staysNear(slot, circle)) {
    if (move(slot, circle) && isRight(slot)) return EditWay::local;
    state_.rollBack(mark);
    reportCircle(TraceKind::circleReplaced, slot, state_.circles[at(slot)]);
    if (state_.reporter != nullptr) state_.reporter->reportChanges();
  }
  int hint = slot;
  if (isVisible) {
    hint = neighborOf(slot);
    if (!takeOut(slot)) return std::nullopt;
    mendForInsertion();
  } else {
    hint = state_.slots[at(slot)].hider;
    state_.detach(slot);
  }
  reportCircle(TraceKind::circleReplaced, slot, circle);
  state_.setCircle(slot, circle);
  if (!put(slot, hint) || !releaseHidden(slot, hiderBy(slot)) || !putWaiting(hint)) return std::nullopt;
  return certify(slot);
}

EditState::Mark Stepper::begin() {
  waiting_.clear();
  return state_.beginStep();
}

void Stepper::reportCircle(TraceKind kind, int slot, const Circle& circle) {
  if (state_.reporter != nullptr) state_.reporter->reportCircle(kind, slot, circle);
}

/// Puts a circle into the dual, or into the list of a circle that hides it. It must be in neither before. Returns true
/// on success.
bool Stepper::put(int slot, int hint) {
  if (state_.visibleCount == 0) return false;
  const Location place = locator_.locate(state_, centerOf(state_.circles[at(slot)]), hint);
  locator_.countSteps(place);
  int hider = place.slot;
  auto outcome = CellInserter::Outcome::hidden;
  if (state_.visibleCount > 1) {
    outcome = inserter_.insert(slot, place.halfEdge);
    hider = inserter_.hider();
  } else if (!state_.predicates.contains(state_.circles[at(hider)], state_.circles[at(slot)])) {
    return false;
  }
  if (outcome == CellInserter::Outcome::astray) return false;
  if (outcome == CellInserter::Outcome::hidden) {
    if (!state_.hides(hider, slot)) return putBefore(slot, hider);
    state_.attach(slot, hider);
    return true;
  }
  state_.willChangeSlot(slot);
  state_.hasNoCell[at(slot)] = 0;
  ++state_.visibleCount;
  for (const int hidden : inserter_.hidden()) {
    --state_.visibleCount;
    while (state_.slots[at(hidden)].firstHidden != kNone) {
      const int inner = state_.slots[at(hidden)].firstHidden;
      state_.detach(inner);
      state_.attach(inner, slot);
    }
    state_.attach(hidden, slot);
  }
  return state_.visibleCount > 1;
}

/// Replaces a visible circle by an identical one with a lower id, which hides it. Returns true on success.
bool Stepper::putBefore(int slot, int identical) {
  const int hint = neighborOf(identical);
  if (!takeOut(identical)) return false;
  mendForInsertion();
  waiting_.push_back(identical);
  return put(slot, hint) && releaseHidden(identical, hiderBy(slot));
}

/// Takes a visible circle out of the dual. The circle keeps its list, which the caller must release. Returns true on
/// success.
bool Stepper::takeOut(int slot) {
  if (state_.visibleCount <= 2) return false;
  if (state_.reporter != nullptr) state_.reporter->setShrinking(slot);
  if (!shrinker_.takeOut(state_, slot)) return false;
  if (state_.reporter != nullptr) {
    state_.reporter->reportPending();
    state_.reporter->setShrinking(kPointAtInfinity);
  }
  --state_.visibleCount;
  state_.willChangeSlot(slot);
  state_.hasNoCell[at(slot)] = 1;
  return true;
}

/// Flips edges that a removal has left wrong, because an insertion into a wrong dual may make all of it wrong.
void Stepper::mendForInsertion() {
  if (!changedWrongFaces().empty()) flipChanged();
}

/// Returns the circle itself if it is visible, otherwise its hider.
int Stepper::hiderBy(int slot) const { return state_.isVisible(slot) ? slot : state_.slots[at(slot)].hider; }

/// Moves the circles in the list of `slot` to the list of `hider`, which may be the same circle. The circles that
/// `hider` does not hide wait. Returns whether these are few enough.
bool Stepper::releaseHidden(int slot, int hider) {
  const std::size_t most = kFew + static_cast<std::size_t>(state_.circleCount / kShownShare);
  for (int inner = state_.slots[at(slot)].firstHidden; inner != kNone;) {
    const int next = state_.slots[at(inner)].next;
    const bool isHidden = hider != kNone && state_.hides(hider, inner);
    if (!isHidden || hider != slot) state_.detach(inner);
    if (!isHidden) {
      waiting_.push_back(inner);
    } else if (hider != slot) {
      state_.attach(inner, hider);
    }
    if (waiting_.size() > most) return false;
    inner = next;
  }
  return true;
}

/// Returns whether a circle covers so large a share of the visible circles that the whole diagram must be computed. A
/// sample gives an estimate.
bool Stepper::coversMany(const Circle& circle) const {
  const std::size_t slots = state_.slots.size();
  const std::size_t sample = std::min(slots, kSample);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < sample; ++i) {
    const auto slot = static_cast<int>(i * slots / sample);
    covered += state_.isVisible(slot) && covers(circle, state_.circles[at(slot)]);
  }
  return covered * slots > sample * (kFew + static_cast<std::size_t>(state_.circleCount / kHiddenShare));
}

/// Puts the waiting circles, the largest first, so that none hides one that was put before. Returns true on success.
bool Stepper::putWaiting(int hint) {
  const auto rank = [&](int slot) { return std::tuple(-state_.circles[at(slot)].r, state_.slots[at(slot)].id); };
  std::sort(waiting_.begin(), waiting_.end(), [&](int a, int b) { return rank(a) < rank(b); });
  bool isWell = true;
  for (std::size_t i = 0; i < waiting_.size() && isWell; ++i) isWell = put(waiting_[i], hint);
  waiting_.clear();
  return isWell;
}

/// Returns a neighbor of a visible circle, or kNone if there is none.
int Stepper::neighborOf(int slot) const {
  const int first = state_.edgeOf[at(slot)];
  if (first == kNone) return kNone;
  int h = first;
  do {
    if (state_.dual.target(h) != kPointAtInfinity) return state_.dual.target(h);
    h = state_.dual.around(h);
  } while (h != first);
  return kNone;
}

/// Returns whether a visible circle that becomes `circle` would still be nearer to its own center than its neighbors
/// are, and hide none of them.
bool Stepper::staysNear(int slot, const Circle& circle) const {
  if (state_.visibleCount < 2) return false;
  const Dual& dual = state_.dual;
  const int first = state_.edgeOf[at(slot)];
  int h = first;
  do {
    const int neighbor = dual.target(h);
    if (neighbor != kPointAtInfinity && (distanceFrom(centerOf(circle), state_.circles[at(neighbor)]) <= -circle.r ||
                                         covers(circle, state_.circles[at(neighbor)]))) {
      return false;
    }
    h = dual.around(h);
  } while (h != first);
  return true;
}

/// Changes a visible circle in its place in the dual. Returns true on success.
bool Stepper::move(int slot, const Circle& circle) {
  Dual& dual = state_.dual;
  reportCircle(TraceKind::circleReplaced, slot, circle);
  state_.setCircle(slot, circle);
  edges_.clear();
  const int first = state_.edgeOf[at(slot)];
  int h = first;
  do {
    state_.willChange(h / 3);
    state_.discs.update(h / 3);
    edges_.push_back(Dual::next(h));
    edges_.push_back(h);
    h = dual.around(h);
  } while (h != first);
  const Flips flips = flipFrom(dual, state_.discs, edges_, state_);
  state_.noteEdges();
  if (!flips.wrong.empty()) return false;
  return releaseHidden(slot, slot) && putWaiting(slot);
}

/// Returns how the step is certified, after flips or a patch if necessary. Returns nothing if certification fails.
std::optional<EditWay> Stepper::certify(int moved) {
  if (isRight(moved)) return EditWay::local;
  if (isBroken_) return std::nullopt;
  const std::vector<int> wrong = changedWrongFaces();
  // Where centers are nearly on a line, flips around a face without a disc may run on along that line.
  const bool haveDiscs = std::all_of(wrong.begin(), wrong.end(), [&](int face) { return state_.discs.exists(face); });
  if (wrong.size() <= kFew && !haveDiscs && patch(moved)) return EditWay::patch;
  if (isBroken_) return std::nullopt;
  flipChanged();
  if (isRight(moved)) return EditWay::local;
  if (!isBroken_ && patch(moved)) return EditWay::patch;
  return std::nullopt;
}

/// Judges the step and settles its ties. Returns whether the result is right.
bool Stepper::isRight(int moved) {
  StepVerdict verdict = judge_.judge(state_, moved);
  if (verdict == StepVerdict::right && !judge_.unsettled().empty()) {
    edges_.assign(judge_.unsettled().begin(), judge_.unsettled().end());
    flipTies(state_.dual, state_.discs, edges_, state_);
    state_.noteEdges();
    verdict = judge_.judge(state_, moved);
  }
  isBroken_ = verdict == StepVerdict::broken;
  return verdict == StepVerdict::right && judge_.unsettled().empty();
}

/// Returns the half-edges of all faces that have changed in this step.
std::span<const int> Stepper::changedEdges() {
  edges_.clear();
  for (std::size_t i = state_.stepFaces(); i < state_.faceLog.size(); ++i) {
    const int face = state_.faceLog[i].face;
    if (state_.isInUse(face)) edges_.insert(edges_.end(), {3 * face, 3 * face + 1, 3 * face + 2});
  }
  return edges_;
}

/// Returns the faces that have changed in this step and are seen to be wrong.
std::vector<int> Stepper::changedWrongFaces() { return wrongFaces(state_.discs, changedEdges()); }

/// Flips from the edges of all faces that have changed in this step.
void Stepper::flipChanged() {
  flipFrom(state_.dual, state_.discs, changedEdges(), state_);
  state_.noteEdges();
}

/// Replaces wrong parts by a diagram of the circles around them, in growing patches. Returns true on success.
bool Stepper::patch(int moved) {
  Counts counts;
  const Dual& dual = state_.dual;
  std::vector<int> wrong = changedWrongFaces();
  for (const int reach : {1, 2, 4, 8}) {
    if (wrong.empty()) break;
    // The repair may change the patches and the faces around them.
    std::vector<int> near = wrong;
    for (int distance = 0; distance <= reach; ++distance) {
      std::vector<int> beyond;
      for (const int face : near) {
        state_.willChange(face);
        for (int h = 3 * face; h < 3 * face + 3; ++h) beyond.push_back(dual.twin[at(h)] / 3);
      }
      near.insert(near.end(), beyond.begin(), beyond.end());
      sortUnique(near);
    }
    for (const int face : near) state_.willChange(face);
    repair(state_.dual, state_.discs, wrong, reach,
           [&](std::span<const Circle> circles) { return solveLocally(circles, counts); });
    state_.noteEdges();
    if (isRight(moved)) return true;
    if (isBroken_) return false;
  }
  return false;
}

}  // namespace circle_voronoi
