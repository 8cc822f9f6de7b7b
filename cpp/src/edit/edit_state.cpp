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
  const auto slots = static_cast<std::size_t>(siteNumbers.count());
  circles.resize(slots);
  predicates.setCircles(circles);
  discs.setCircles(circles);
  sites.resize(slots);
  hasNoCell.resize(slots);
  edgeOf.resize(slots, kNone);
  savedSiteAt_.resize(slots, kNone);
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

void EditState::willChangeSite(int slot) {
  const int last = savedSiteAt_[at(slot)];
  if (last != kNone && static_cast<std::size_t>(last) >= stepSites_) return;
  siteLog.push_back({slot, last, sites[at(slot)], circles[at(slot)], hasNoCell[at(slot)]});
  savedSiteAt_[at(slot)] = static_cast<int>(siteLog.size() - 1);
}

int EditState::addSite(const Circle& circle, CircleId id) {
  const int slot = siteNumbers.take();
  if (slot >= static_cast<int>(savedSiteAt_.size())) sizeToNumbers();
  willChangeSite(slot);
  const bool isNew = id == kNone;
  if (isNew) id = nextId;
  ids.add(id, slot);
  sites[at(slot)] = {id};
  if (isNew) ++nextId;
  circles[at(slot)] = circle;
  hasNoCell[at(slot)] = 1;
  ++circleCount;
  sizes.add(circle, 1);
  return slot;
}

void EditState::removeSite(int slot) {
  willChangeSite(slot);
  siteNumbers.release(slot);
  sites[at(slot)].id = kNone;  // if it still has a list, the judge rejects the step
  --circleCount;
  sizes.add(circles[at(slot)], -1);
}

void EditState::setCircle(int slot, const Circle& circle) {
  willChangeSite(slot);
  sizes.add(circles[at(slot)], -1);
  circles[at(slot)] = circle;
  sizes.add(circle, 1);
}

void EditState::attach(int slot, int hider) {
  willChangeSite(slot);
  willChangeSite(hider);
  const int next = sites[at(hider)].firstHidden;
  if (next != kNone) {
    willChangeSite(next);
    sites[at(next)].previous = slot;
  }
  sites[at(hider)].firstHidden = slot;
  sites[at(slot)].hider = hider;
  sites[at(slot)].next = next;
  sites[at(slot)].previous = kNone;
  hasNoCell[at(slot)] = 1;
}

void EditState::detach(int slot) {
  willChangeSite(slot);
  Site& site = sites[at(slot)];
  if (site.previous != kNone) {
    willChangeSite(site.previous);
    sites[at(site.previous)].next = site.next;
  } else {
    willChangeSite(site.hider);
    sites[at(site.hider)].firstHidden = site.next;
  }
  if (site.next != kNone) {
    willChangeSite(site.next);
    sites[at(site.next)].previous = site.previous;
  }
  site.hider = site.next = site.previous = kNone;
}

EditState::Mark EditState::beginStep() {
  stepFaces_ = faceLog.size();
  stepSites_ = siteLog.size();
  return {stepFaces_, stepSites_, faceNumbers.mark(), siteNumbers.mark(), nextId, circleCount, visibleCount,
          faceCount,  sizes};
}

void EditState::rollBack(const Mark& mark) noexcept {
  while (siteLog.size() > mark.sites) {
    const SavedSite& saved = siteLog.back();
    const int slot = saved.slot;
    if (saved.site.id == kNone && sites[at(slot)].id != kNone) ids.remove(sites[at(slot)].id);
    sites[at(slot)] = saved.site;
    circles[at(slot)] = saved.circle;
    hasNoCell[at(slot)] = saved.hasNoCell;
    savedSiteAt_[at(slot)] = saved.before;
    siteLog.pop_back();
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
  siteNumbers.rollBack(mark.siteNumbers);
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
  siteNumbers.prepare();
  edgeNumbers.prepare();
}

void EditState::commit() noexcept {
  for (const SavedSite& saved : siteLog) {
    const CircleId id = saved.site.id;
    if (id != kNone && sites[at(saved.slot)].id != id && ids.slotOf(id) != kNone) ids.remove(id);
    savedSiteAt_[at(saved.slot)] = kNone;
  }
  for (const SavedFace& saved : faceLog) savedFaceAt_[at(saved.face)] = kNone;
  siteLog.clear();
  faceLog.clear();
  faceNumbers.commit();
  siteNumbers.commit();
  edgeNumbers.commit();
  committed_ = beginStep();
}

void EditState::rollBackAll() noexcept {
  rollBack(committed_);
  edgeNumbers.rollBackAll();
}

}  // namespace circle_voronoi
