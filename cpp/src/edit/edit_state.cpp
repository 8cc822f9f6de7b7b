// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_state.h"

#include "at.h"

namespace circle_voronoi {

void EditState::sizeToNumbers() {
  const auto faces = static_cast<std::size_t>(faceNumbers.count());
  dual.twin.resize(3 * faces, kNone);
  proof.resize(3 * faces);
  edgeNumber.resize(3 * faces, kNone);
  discs.resize(faces);
  // The size of `origin` counts the faces. So if memory runs out in between, the arrays above are no smaller.
  dual.origin.resize(3 * faces, kPointAtInfinity);
  savedFaceAt_.resize(faces, kNone);
  const auto count = static_cast<std::size_t>(slotNumbers.count());
  circles.resize(count);
  predicates.setCircles(circles);
  discs.setCircles(circles);
  slots.resize(count);
  hasNoCell.resize(count);
  edgeOf.resize(count, kNone);
  savedSlotAt_.resize(count, kNone);
}

int EditState::addFace() {
  const int face = faceNumbers.take();
  // This array of faces is resized last. If it has room, all have, even if memory ran out in between.
  if (face >= static_cast<int>(savedFaceAt_.size())) sizeToNumbers();
  willChange(face);
  ++faceCount;
  return face;
}

void EditState::removeFace(int face) {
  willChange(face);
  for (int h = 3 * face; h < 3 * face + 3; ++h) dual.twin[at(h)] = kNone;
  faceNumbers.release(face);
  --faceCount;
}

void EditState::willChange(int face) {
  if (reporter != nullptr) reporter->willChange(face);
  const int last = savedFaceAt_[at(face)];
  if (last != kNone && static_cast<std::size_t>(last) >= stepFaces_) return;
  const int h = 3 * face;
  const auto three = [h](const auto& list) { return std::array{list[at(h)], list[at(h + 1)], list[at(h + 2)]}; };
  faceLog.push_back(
      {face, last, three(dual.origin), three(dual.twin), three(edgeNumber), three(proof), discs[at(face)]});
  savedFaceAt_[at(face)] = static_cast<int>(faceLog.size() - 1);
}

void EditState::willChangeSlot(int slot) {
  const int last = savedSlotAt_[at(slot)];
  if (last != kNone && static_cast<std::size_t>(last) >= stepSlots_) return;
  slotLog.push_back({slot, last, slots[at(slot)], circles[at(slot)], hasNoCell[at(slot)]});
  savedSlotAt_[at(slot)] = static_cast<int>(slotLog.size() - 1);
}

int EditState::addSlot(const Circle& circle, CircleId id) {
  const int slot = slotNumbers.take();
  if (slot >= static_cast<int>(savedSlotAt_.size())) sizeToNumbers();
  willChangeSlot(slot);
  const bool isNew = id == kNone;
  if (isNew) id = nextId;
  ids.add(id, slot);
  slots[at(slot)] = {id};
  if (isNew) ++nextId;
  circles[at(slot)] = circle;
  hasNoCell[at(slot)] = 1;
  ++circleCount;
  sizes.add(circle, 1);
  return slot;
}

void EditState::removeSlot(int slot) {
  willChangeSlot(slot);
  slotNumbers.release(slot);
  slots[at(slot)].id = kNone;  // if it still has a list, the judge rejects the step
  --circleCount;
  sizes.add(circles[at(slot)], -1);
}

void EditState::setCircle(int slot, const Circle& circle) {
  willChangeSlot(slot);
  sizes.add(circles[at(slot)], -1);
  circles[at(slot)] = circle;
  sizes.add(circle, 1);
}

void EditState::attach(int slot, int hider) {
  willChangeSlot(slot);
  willChangeSlot(hider);
  const int next = slots[at(hider)].firstHidden;
  if (next != kNone) {
    willChangeSlot(next);
    slots[at(next)].previous = slot;
  }
  slots[at(hider)].firstHidden = slot;
  slots[at(slot)].hider = hider;
  slots[at(slot)].next = next;
  slots[at(slot)].previous = kNone;
  hasNoCell[at(slot)] = 1;
}

void EditState::detach(int slot) {
  willChangeSlot(slot);
  Slot& data = slots[at(slot)];
  if (data.previous != kNone) {
    willChangeSlot(data.previous);
    slots[at(data.previous)].next = data.next;
  } else {
    willChangeSlot(data.hider);
    slots[at(data.hider)].firstHidden = data.next;
  }
  if (data.next != kNone) {
    willChangeSlot(data.next);
    slots[at(data.next)].previous = data.previous;
  }
  data.hider = data.next = data.previous = kNone;
}

EditState::Mark EditState::beginStep() {
  stepFaces_ = faceLog.size();
  stepSlots_ = slotLog.size();
  return {stepFaces_, stepSlots_, faceNumbers.mark(), slotNumbers.mark(), nextId, circleCount, visibleCount,
          faceCount,  sizes};
}

void EditState::rollBack(const Mark& mark) noexcept {
  while (slotLog.size() > mark.slots) {
    const SavedSlot& saved = slotLog.back();
    const int slot = saved.slot;
    if (saved.data.id == kNone && slots[at(slot)].id != kNone) ids.remove(slots[at(slot)].id);
    slots[at(slot)] = saved.data;
    circles[at(slot)] = saved.circle;
    hasNoCell[at(slot)] = saved.hasNoCell;
    savedSlotAt_[at(slot)] = saved.before;
    slotLog.pop_back();
  }
  for (std::size_t i = faceLog.size(); i-- > mark.faces;) {
    const SavedFace& saved = faceLog[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t h = 3 * static_cast<std::size_t>(saved.face) + k;
      dual.origin[h] = saved.origin[k];
      dual.twin[h] = saved.twin[k];
      edgeNumber[h] = saved.edgeNumber[k];
      proof[h] = saved.proof[k];
    }
    discs.set(saved.face, saved.disc);
    savedFaceAt_[at(saved.face)] = saved.before;
  }
  for (std::size_t i = mark.faces; i < faceLog.size(); ++i) noteEdgesOf(faceLog[i].face);
  faceLog.resize(mark.faces);
  faceNumbers.rollBack(mark.faceNumbers);
  slotNumbers.rollBack(mark.slotNumbers);
  nextId = mark.nextId;
  circleCount = mark.circleCount;
  visibleCount = mark.visibleCount;
  faceCount = mark.faceCount;
  sizes = mark.sizes;
}

void EditState::noteEdgesOf(int face) noexcept {
  if (!isInUse(face)) return;
  for (int h = 3 * face; h < 3 * face + 3; ++h) noteEdge(h);
}

void EditState::noteEdges() {
  for (std::size_t i = stepFaces_; i < faceLog.size(); ++i) noteEdgesOf(faceLog[i].face);
}

void EditState::prepareToCommit() {
  faceNumbers.prepare();
  slotNumbers.prepare();
  edgeNumbers.prepare();
}

void EditState::commit() noexcept {
  for (const SavedSlot& saved : slotLog) {
    const CircleId id = saved.data.id;
    if (id != kNone && slots[at(saved.slot)].id != id && ids.slotOf(id) != kNone) ids.remove(id);
    savedSlotAt_[at(saved.slot)] = kNone;
  }
  for (const SavedFace& saved : faceLog) savedFaceAt_[at(saved.face)] = kNone;
  slotLog.clear();
  faceLog.clear();
  faceNumbers.commit();
  slotNumbers.commit();
  edgeNumbers.commit();
  committed_ = beginStep();
}

void EditState::rollBackAll() noexcept {
  rollBack(committed_);
  edgeNumbers.rollBackAll();
}

}  // namespace circle_voronoi
