// SPDX-License-Identifier: GPL-3.0-or-later
#include "insert_cell.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "at.h"

namespace circle_voronoi {

CellInserter::Outcome CellInserter::insert(int i, int likely) {
  hidden_.clear();
  lost_.clear();
  const auto edge = cutEdge(likely, i);
  if (!edge) return Outcome::hidden;
  split(*edge, i);
  while (!stack_.empty()) {
    const Link link = stack_.back();
    stack_.pop_back();
    if (isLost(link, i)) flipEdge(link.h, i);
  }
  return removeLost() ? Outcome::inserted : Outcome::astray;
}

std::optional<CellInserter::CutEdge> CellInserter::cutEdge(int likely, int i) {
  int start = likely;
  while (true) {
    auto edge = cutEdgeAround(start, i);
    if (!edge || edge->cut.isCut) return edge;
    const int nearest = nearestAround(start, i);
    if (leadAt(i, dual_.origin[at(start)], dual_.target(nearest)).sign() <= 0) break;
    start = dual_.twin[at(nearest)];
  }
  return cutEdgeBeyond(start, i);
}

std::optional<CellInserter::CutEdge> CellInserter::cutEdgeBeyond(int start, int i) {
  std::set<int> seen = {dual_.origin[at(start)]};
  std::vector<int> spokes = {start};
  for (std::size_t next = 0; next < spokes.size(); ++next) {
    int h = spokes[next];
    do {
      const int beyond = dual_.twin[at(h)];
      if (dual_.origin[at(beyond)] != kPointAtInfinity && seen.insert(dual_.origin[at(beyond)]).second) {
        auto edge = cutEdgeAround(beyond, i);
        if (!edge || edge->cut.isCut) return edge;
        spokes.push_back(beyond);
      }
      h = dual_.around(h);
    } while (h != spokes[next]);
  }
  return CutEdge{start, {}};
}

int CellInserter::nearestAround(int start, int i) {
  int nearest = dual_.target(start) == kPointAtInfinity ? dual_.around(start) : start;
  int h = nearest;
  do {
    const int b = dual_.target(h);
    if (b != kPointAtInfinity && leadAt(i, dual_.target(nearest), b).value > 0) nearest = h;
    h = dual_.around(h);
  } while (h != start);
  return nearest;
}

std::optional<CellInserter::CutEdge> CellInserter::cutEdgeAround(int likely, int i) {
  const auto isHider = [&](int a) {
    if (a == kPointAtInfinity || !hides(a, i)) return false;
    hider_ = a;
    return true;
  };
  if (isHider(dual_.origin[at(likely)])) return std::nullopt;
  int left = likely;
  int right = likely;
  do {
    for (const int h : {left, right}) {
      if (isHider(dual_.target(h))) return std::nullopt;
      if (const Cut cut = cutOf(h, i); cut.isCut) return CutEdge{h, cut};
    }
    left = dual_.around(left);
    right = dual_.aroundClockwise(right);
  } while (left != likely);
  return CutEdge{likely, {}};
}

CellInserter::Disc CellInserter::faceDisc(const Predicates::Triple& corners) const {
  return {corners, predicates_.disc(corners)};
}

CellInserter::Disc CellInserter::discAt(int h) const { return {cornersOf(dual_, h), discs_[at(h / 3)]}; }

bool CellInserter::isTangentLine(const Disc& disc) {
  return std::find(disc.corners.begin(), disc.corners.end(), kPointAtInfinity) != disc.corners.end();
}

int CellInserter::orderAlongEdge(int a, int b, const Disc& first, const Disc& second) const {
  const int from = predicates_.looksFromFirst(a, b) ? a : b;
  const int sign = turn(from, first, second);
  return from == a ? sign : -sign;
}

CellInserter::Cut CellInserter::cutOf(int h, int i) const {
  const auto [a, b, c] = cornersOf(dual_, h);
  if (hides(i, a) || (b != kPointAtInfinity && hides(i, b))) return {true, true, false};
  const int t = dual_.twin[at(h)];
  const int d = dual_.origin[at(Dual::previous(t))];
  if (b == kPointAtInfinity) {
    const int start = predicates_.tangentSide(a, d, i);
    const int end = predicates_.tangentSide(c, a, i);
    if (start > 0 || end > 0) return {true, start > 0, start <= 0};
    // Circle i may touch a tangent line at an end of the arc that a has of the hull. It reaches beyond the arc if a
    // touches the line between the neighbor and i.
    const bool isCut = start == 0 || end == 0
                           ? (start < 0 || touchesBetween(d, i, a)) && (end < 0 || touchesBetween(c, i, a))
                           : turns(a, discAt(t), faceDisc({a, i, kPointAtInfinity}), discAt(h)) > 0;
    return {isCut, false, false};
  }
  // The edge goes from the disc of t to that of h. On its bisector the cell of i begins at `enter`, ends at `leave`.
  const Disc enter = faceDisc({a, b, i});
  const Disc leave = faceDisc({b, a, i});
  const bool hasStart = leave.disc.exists && (d == kPointAtInfinity || orderAlongEdge(a, b, discAt(t), leave) > 0);
  const bool hasEnd = enter.disc.exists && (c == kPointAtInfinity || orderAlongEdge(a, b, enter, discAt(h)) > 0);
  if (!leave.disc.exists && !enter.disc.exists) {
    const int side = predicates_.tangentSide(a, b, i);
    // All circles on one tangent line: far along the edge, the circle that touches the line between the other two is
    // the nearest.
    return {side > 0 || (side == 0 && touchesBetween(a, b, i)), false, false};
  }
  if (!leave.disc.exists || !enter.disc.exists) return {hasStart || hasEnd, false, false};
  if (orderAlongEdge(a, b, enter, leave) >= 0) return {hasStart && hasEnd, false, false};
  return {hasStart || hasEnd, hasStart, !hasStart};
}

void CellInserter::renewDisc(int face, int i) {
  bool isLost = false;
  for (const int corner : cornersOf(dual_, 3 * face)) {
    if (corner == i || corner == kPointAtInfinity) continue;
    if (!isHidden_[at(corner)] && hides(i, corner)) {
      keeper_.willHide(corner);
      isHidden_[at(corner)] = 1;
      hidden_.push_back(corner);
      lost_.push_back(corner);
    }
    isLost = isLost || isHidden_[at(corner)];
  }
  if (isLost) {
    discs_.clear(face);
  } else {
    discs_.update(face);
  }
}

void CellInserter::split(const CutEdge& edge, int i) {
  const int h = edge.h;
  const int t = dual_.twin[at(h)];
  const Disc near = edge.cut.hasStart ? discAt(t) : edge.cut.hasEnd ? discAt(h) : Disc{};
  const int atH = 3 * keeper_.addFace();
  const int atT = 3 * keeper_.addFace();
  keeper_.willChange(h / 3);
  keeper_.willChange(t / 3);
  const auto fill = [&](int first, int beyond) {
    dual_.origin[at(first)] = dual_.target(beyond);
    dual_.origin[at(first + 1)] = dual_.origin[at(beyond)];
    dual_.origin[at(first + 2)] = i;
    dual_.link(first, beyond);
  };
  fill(atH, h);
  fill(atT, t);
  dual_.link(atH + 1, atT + 2);
  dual_.link(atH + 2, atT + 1);
  edgeOf_[at(i)] = atH + 2;
  renewDisc(atH / 3, i);
  renewDisc(atT / 3, i);
  stack_ = {{atH, edge.cut.hasEnd, near}, {atT, edge.cut.hasStart, near}};
}

bool CellInserter::isLost(const Link& link, int i) const {
  // The edge across would be a loop.
  if (dual_.origin[at(Dual::previous(dual_.twin[at(link.h)]))] == i) return false;
  if (link.isWithin || !discs_.exists(link.h / 3)) return true;
  const bool hasNear = link.near.corners[0] != link.near.corners[1];
  return isAtInfinity(link.h) && hasNear ? isHullLost(link) : discs_.flawOf(link.h) != Flaw::none;
}

bool CellInserter::isHullLost(const Link& link) const {
  const Disc border = discAt(link.h);
  const Disc beyond = discAt(dual_.twin[at(link.h)]);
  const bool isOutgoing = dual_.origin[at(link.h)] != kPointAtInfinity;
  const int from = isOutgoing ? dual_.origin[at(link.h)] : dual_.target(link.h);
  const int sign = turns(from, border, beyond, link.near);
  if (sign != 0) return isOutgoing ? sign > 0 : sign < 0;
  // Two of the three discs are equal or opposite. If the old ones are equal, the new cell covers both.
  const auto isSame = [&](const Disc& first, const Disc& second) {
    const auto u = predicates_.direction(from, first.disc);
    const auto v = predicates_.direction(from, second.disc);
    return turn(from, first, second) == 0 && u.x * v.x + u.y * v.y > 0;
  };
  return isSame(beyond, link.near) && !isSame(border, beyond);
}

int CellInserter::turns(int from, const Disc& first, const Disc& second, const Disc& third) const {
  return turn(from, first, second) + turn(from, second, third) + turn(from, third, first);
}

bool CellInserter::isAtInfinity(int h) const {
  return dual_.origin[at(h)] == kPointAtInfinity || dual_.target(h) == kPointAtInfinity;
}

int CellInserter::turn(int from, const Disc& first, const Disc& second) const {
  return predicates_.turn(from, first.corners, first.disc, second.corners, second.disc);
}

void CellInserter::flipEdge(int h, int i) {
  const int t = dual_.twin[at(h)];
  const int bi = Dual::next(h);
  const int ad = Dual::next(t);
  const int ia = Dual::previous(h);
  const int db = Dual::previous(t);
  const Disc lost = discAt(t);
  for (const int changed : {h, t, dual_.twin[at(ad)], dual_.twin[at(bi)]}) keeper_.willChange(changed / 3);
  keeper_.replaceEdge(h, dual_.twin[at(ia)]);
  keeper_.replaceEdge(bi, t);
  keeper_.replaceEdge(ad, h);
  dual_.flip(h);
  renewDisc(h / 3, i);
  renewDisc(t / 3, i);
  for (const int kept : {h, t, ia, db}) noteEdge(kept);
  for (const int link : {h, db}) stack_.push_back({link, isWithin(link, lost), lost});
  ++flips_;
}

bool CellInserter::isWithin(int h, const Disc& lost) const {
  const int a = dual_.origin[at(h)];
  const int b = dual_.target(h);
  if (!discs_.exists(h / 3)) return true;
  if (a == kPointAtInfinity || b == kPointAtInfinity || isTangentLine(lost)) return false;
  return orderAlongEdge(a, b, discAt(h), lost) < 0;
}

bool CellInserter::removeLost() {
  while (!lost_.empty()) {
    const auto removed = std::remove_if(lost_.begin(), lost_.end(), [&](int circle) { return remove(circle); });
    if (removed == lost_.end()) return false;
    lost_.erase(removed, lost_.end());
  }
  return true;
}

bool CellInserter::remove(int circle) {
  const int g = edgeOf_[at(circle)];
  const int h = dual_.around(g);
  if (h == g || dual_.around(h) != g) return false;
  const int pq = dual_.twin[at(Dual::next(h))];
  const int qp = dual_.twin[at(Dual::next(g))];
  if (pq / 3 == g / 3) return false;
  keeper_.dropEdge(g);
  keeper_.dropEdge(h);
  keeper_.willChange(pq / 3);
  keeper_.willChange(qp / 3);
  for (const int lost : {Dual::next(g), Dual::previous(h)}) keeper_.replaceEdge(lost, pq);
  for (const int lost : {Dual::next(h), Dual::previous(g)}) keeper_.replaceEdge(lost, qp);
  dual_.link(pq, qp);
  noteEdge(pq);
  noteEdge(qp);
  keeper_.removeFace(g / 3);
  keeper_.removeFace(h / 3);
  return true;
}

}  // namespace circle_voronoi
