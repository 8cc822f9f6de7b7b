// SPDX-License-Identifier: GPL-3.0-or-later
#include "shrink_cell.h"

#include <algorithm>
#include <cmath>

#include "at.h"

namespace circle_voronoi {
namespace {

/// Returns the radius at which a circle with the center of `c` would touch a disc: the distance between the centers
/// minus the disc's radius. `origin` is the circle that the disc is relative to.
double touchingRadius(const Circle& c, const FaceDisc& disc, const Circle& origin) {
  const Vector e = between(c, origin);
  const Vector seen = {disc.v.x + disc.w * e.x, disc.v.y + disc.w * e.y};
  // |seen| / w - |v| / w + origin.r, without its cancellation where w is small.
  return (2 * dot(disc.v, e) + disc.w * dot(e, e)) / (length(seen) + length(disc.v)) + origin.r;
}

}  // namespace

bool CellShrinker::takeOut(EditState& state, int slot) {
  Dual& dual = state.dual;
  spokes_.clear();
  events_.clear();
  const int first = state.edgeOf[at(slot)];
  int h = first;
  do {
    const int i = static_cast<int>(spokes_.size());
    spokes_.push_back({h, i - 1, i + 1, {}});
    // The faces beside the spokes, and the faces beyond them.
    state.willChange(h / 3);
    state.willChange(dual.twin[at(Dual::next(h))] / 3);
    h = dual.around(h);
  } while (h != first);
  int left = static_cast<int>(spokes_.size());
  spokes_.front().before = left - 1;
  spokes_.back().after = 0;
  if (left < 2) return false;
  for (int i = 0; i < left && left > 2; ++i) look(state, i);

  int kept = 0;
  for (; left > 2; --left) {
    int vanishing = nextToVanish();
    if (vanishing == kNone) vanishing = anyToVanish(state.dual, kept);
    if (vanishing == kNone) return false;
    Spoke& spoke = spokes_[static_cast<std::size_t>(vanishing)];
    Spoke& before = spokes_[static_cast<std::size_t>(spoke.before)];
    Spoke& after = spokes_[static_cast<std::size_t>(spoke.after)];
    // Faces (i, b, c) left of the spoke and (i, a, b) right of it become (a, b, c) and (i, a, c).
    const int ib = spoke.halfEdge;
    const int ci = Dual::previous(ib);
    const int ab = Dual::next(before.halfEdge);
    const int bi = Dual::next(ab);
    const int beyondCi = dual.twin[at(ci)];
    if (state.reporter != nullptr) {
      for (const int changed : {ib, ab}) state.reporter->willChange(changed / 3);
    }
    dual.origin[at(ib)] = dual.origin[at(ab)];
    dual.origin[at(bi)] = dual.origin[at(ci)];
    dual.link(ib, dual.twin[at(ab)]);
    dual.link(bi, beyondCi);
    dual.link(ab, ci);
    state.discs.set(ib / 3, spoke.disc);
    before.after = spoke.after;
    after.before = spoke.before;
    kept = spoke.before;
    ++spoke.turn;
    if (left > 3) {
      look(state, spoke.before);
      look(state, spoke.after);
    }
  }

  // Faces (i, a, c) and (i, c, a) vanish.
  const Spoke& one = spokes_[static_cast<std::size_t>(kept)];
  const Spoke& other = spokes_[static_cast<std::size_t>(one.after)];
  const int ac = dual.twin[at(Dual::next(one.halfEdge))];
  const int ca = dual.twin[at(Dual::next(other.halfEdge))];
  for (const int beyond : {ac, ca}) {
    if (beyond / 3 == one.halfEdge / 3 || beyond / 3 == other.halfEdge / 3) return false;
  }
  dual.link(ac, ca);
  state.removeFace(one.halfEdge / 3);
  state.removeFace(other.halfEdge / 3);
  state.noteEdges();
  return true;
}

int CellShrinker::nextToVanish() {
  while (!events_.empty()) {
    std::pop_heap(events_.begin(), events_.end());
    const Event event = events_.back();
    events_.pop_back();
    if (spokes_[static_cast<std::size_t>(event.spoke)].turn == event.turn) return event.spoke;
  }
  return kNone;
}

int CellShrinker::anyToVanish(const Dual& dual, int from) const {
  int index = from;
  do {
    const Spoke& spoke = spokes_[static_cast<std::size_t>(index)];
    const int before = dual.target(spokes_[static_cast<std::size_t>(spoke.before)].halfEdge);
    const int after = dual.target(spokes_[static_cast<std::size_t>(spoke.after)].halfEdge);
    const int to = dual.target(spoke.halfEdge);
    if (before != after && before != to && to != after) return index;
    index = spoke.after;
  } while (index != from);
  return kNone;
}

void CellShrinker::look(EditState& state, int index) {
  Spoke& spoke = spokes_[static_cast<std::size_t>(index)];
  ++spoke.turn;
  const int h = spoke.halfEdge;
  const int slot = state.dual.origin[at(h)];
  const int a = state.dual.target(spokes_[static_cast<std::size_t>(spoke.before)].halfEdge);
  const int b = state.dual.target(h);
  const int c = state.dual.target(spokes_[static_cast<std::size_t>(spoke.after)].halfEdge);
  if (a == c || a == b || b == c) return;
  spoke.disc = state.predicates.disc({a, b, c});
  if (!spoke.disc.exists) return;
  const double radius = touchingRadius(state.circles[at(slot)], spoke.disc, state.circles[at(spoke.disc.origin)]);
  if (std::isnan(radius)) return;
  events_.push_back({radius, index, spoke.turn});
  std::push_heap(events_.begin(), events_.end());
}

}  // namespace circle_voronoi
