// SPDX-License-Identifier: GPL-3.0-or-later
#include "shrink_cell.h"

#include <algorithm>
#include <cmath>

namespace circle_voronoi {
namespace {

/// The radius at which a circle with the centre of `c` would touch a disc: its distance from the disc's centre, less
/// the disc's radius.
double touchingRadius(const Circle& c, const FaceDisc& disc, const Circle& origin) {
  const Vector e = between(c, origin);
  const Vector seen = {disc.v.x + disc.w * e.x, disc.v.y + disc.w * e.y};
  // |seen| / w - |v| / w + origin.r, without its cancellation where w is small.
  return (2 * dot(disc.v, e) + disc.w * dot(e, e)) / (length(seen) + length(disc.v)) + origin.r;
}

}  // namespace

bool CellShrinker::takeOut(int circle) {
  spokes_.clear();
  events_.clear();
  const int first = edgeOf_[circle];
  int h = first;
  do {
    const int i = static_cast<int>(spokes_.size());
    spokes_.push_back({h, i - 1, i + 1, {}});
    // Both faces beside each neighbour, and what lies beyond.
    keeper_.willChange(h / 3);
    keeper_.willChange(dual_.twin[Dual::next(h)] / 3);
    h = dual_.twin[Dual::previous(h)];
  } while (h != first);
  int left = static_cast<int>(spokes_.size());
  spokes_.front().before = left - 1;
  spokes_.back().after = 0;
  if (left < 2) return false;
  for (int i = 0; i < left && left > 2; ++i) look(i);

  int kept = 0;
  for (; left > 2; --left) {
    const int vanishing = nextToVanish();
    if (vanishing == kNone) {
      noteEdges(kNone, kNone);
      int stuck = kept;
      do {
        discs_.update(spokes_[static_cast<std::size_t>(stuck)].halfEdge / 3);
        stuck = spokes_[static_cast<std::size_t>(stuck)].after;
      } while (stuck != kept);
      return false;
    }
    Spoke& spoke = spokes_[static_cast<std::size_t>(vanishing)];
    Spoke& before = spokes_[static_cast<std::size_t>(spoke.before)];
    Spoke& after = spokes_[static_cast<std::size_t>(spoke.after)];
    // Faces (i, b, c) left of the spoke and (i, a, b) right of it become (a, b, c) and (i, a, c).
    const int ib = spoke.halfEdge;
    const int ci = Dual::previous(ib);
    const int ab = Dual::next(before.halfEdge);
    const int bi = Dual::next(ab);
    const int beyondCi = dual_.twin[ci];
    for (const int changed : {ib, ab}) keeper_.willChange(changed / 3);
    dual_.origin[ib] = dual_.origin[ab];
    dual_.origin[bi] = dual_.origin[ci];
    dual_.link(ib, dual_.twin[ab]);
    dual_.link(bi, beyondCi);
    dual_.link(ab, ci);
    discs_.set(ib / 3, spoke.disc);
    before.after = spoke.after;
    after.before = spoke.before;
    kept = spoke.before;
    ++spoke.turn;
    if (left > 3) {
      look(spoke.before);
      look(spoke.after);
    }
  }

  // Faces (i, a, c) and (i, c, a) vanish.
  const Spoke& one = spokes_[static_cast<std::size_t>(kept)];
  const Spoke& other = spokes_[static_cast<std::size_t>(one.after)];
  const int ac = dual_.twin[Dual::next(one.halfEdge)];
  const int ca = dual_.twin[Dual::next(other.halfEdge)];
  for (const int beyond : {ac, ca}) {
    if (beyond / 3 == one.halfEdge / 3 || beyond / 3 == other.halfEdge / 3) return false;
  }
  dual_.link(ac, ca);
  noteEdges(one.halfEdge / 3, other.halfEdge / 3);
  noteEdge(ac);
  noteEdge(ca);
  keeper_.removeFace(one.halfEdge / 3);
  keeper_.removeFace(other.halfEdge / 3);
  return true;
}

void CellShrinker::noteEdges(int vanishing, int other) {
  for (const Spoke& spoke : spokes_) {
    const int face = spoke.halfEdge / 3;
    if (face == vanishing || face == other) continue;
    for (int h = 3 * face; h < 3 * face + 3; ++h) noteEdge(h);
  }
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

void CellShrinker::look(int index) {
  Spoke& spoke = spokes_[static_cast<std::size_t>(index)];
  ++spoke.turn;
  const int h = spoke.halfEdge;
  const int circle = dual_.origin[h];
  const int a = dual_.target(spokes_[static_cast<std::size_t>(spoke.before)].halfEdge);
  const int b = dual_.target(h);
  const int c = dual_.target(spokes_[static_cast<std::size_t>(spoke.after)].halfEdge);
  if (a == c || a == b || b == c) return;
  spoke.disc = discs_.predicates().disc({a, b, c});
  if (!spoke.disc.exists) return;
  const double radius = touchingRadius(discs_.circles()[circle], spoke.disc, discs_.circles()[spoke.disc.origin]);
  if (std::isnan(radius)) return;
  events_.push_back({radius, index, spoke.turn});
  std::push_heap(events_.begin(), events_.end());
}

}  // namespace circle_voronoi
