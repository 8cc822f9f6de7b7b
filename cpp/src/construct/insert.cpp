// SPDX-License-Identifier: GPL-3.0-or-later
#include "insert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "face_discs.h"
#include "mix.h"
#include "nearest_circle.h"

namespace circle_voronoi {
namespace {

/// The order of insertion: random rounds, each in the order given; three circles in four go to the last round, three in
/// four of the rest to the one before, and so on (N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO",
/// 2003).
std::vector<int> insertionOrder(std::size_t count) {
  constexpr int kRounds = 16;
  const auto roundOf = [](std::size_t i) { return kRounds - 1 - std::min(kRounds - 1, std::countr_zero(mix(i)) / 2); };
  std::array<std::size_t, kRounds + 1> first{};
  for (std::size_t i = 0; i < count; ++i) ++first[roundOf(i) + 1];
  for (int round = 1; round <= kRounds; ++round) first[round] += first[round - 1];
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[first[roundOf(i)]++] = static_cast<int>(i);
  return order;
}

class Inserter {
 public:
  Inserter(std::span<const Circle> circles, Predicates& predicates)
      : circles_(circles),
        predicates_(predicates),
        nearest_(circles),
        discs_(circles, dual_, predicates),
        edgeOf_(circles.size(), kInfinity) {
    dual_.origin.reserve(6 * circles.size());
    dual_.twin.reserve(6 * circles.size());
  }

  std::optional<Inserted> run() && {
    // Far more flips than a random order makes likely: going on means that rounding led astray.
    const std::int64_t limit = 1000 + 30 * static_cast<std::int64_t>(circles_.size());
    const std::vector<int> order = insertionOrder(circles_.size());
    if (order.size() < 2) return Inserted{};
    start(order[0], order[1]);
    for (std::size_t i = 2; i < order.size(); ++i) {
      insert(order[i]);
      if (flips_ > limit) return std::nullopt;
    }
    return Inserted{std::move(dual_), flips_};
  }

 private:
  void start(int a, int b) {
    dual_.origin = {a, b, kInfinity, b, a, kInfinity};
    dual_.twin = {3, 5, 4, 0, 2, 1};
    edgeOf_[a] = 0;
    edgeOf_[b] = 3;
    for (const int face : {0, 1}) discs_.update(face);
    nearest_.insert(a);
    nearest_.insert(b);
  }

  void insert(int i) {
    split(borderInCell(i, nearest_.nearest({circles_[i].x, circles_[i].y})), i);
    while (!stack_.empty()) {
      const Link link = stack_.back();
      stack_.pop_back();
      if (isLost(link, i)) flipEdge(link.h);
    }
    nearest_.insert(i);
  }

  /// What the cell of a new circle has of an edge of the old diagram: whether anything, and whether the start or the
  /// end. Of both only the start counts: that the new cell has the other it learns on its way around.
  struct Cut {
    bool isCut = false;
    bool hasStart = false;
    bool hasEnd = false;
  };

  struct CutEdge {
    int h = kInfinity;
    Cut cut;
  };

  /// An edge of the cell of circle a, in which the centre of circle i lies, of which the cell of i has a part.
  CutEdge borderInCell(int i, int a) const {
    const int nearest = borderBehind(i, a);
    int left = nearest;
    int right = nearest;
    // Rounding may have put the ray on a neighbouring edge.
    do {
      for (const int h : {left, right}) {
        if (const Cut cut = cutOf(h, i); cut.isCut) return {h, cut};
      }
      left = dual_.twin[Dual::previous(left)];
      right = Dual::next(dual_.twin[right]);
    } while (left != nearest);
    return {nearest, {}};
  }

  /// The edge that the ray from the centre of circle a through that of circle i meets, which leaves the cell of a
  /// there. Were i so small that it barely reached out of a, its cell would be but the rest of the ray.
  int borderBehind(int i, int a) const {
    const Vector toCentre = between(circles_[a], circles_[i]);
    const double l = length(toCentre);
    int best = kInfinity;
    double most = 0;  // the ray meets the bisector with b after 1 / (2 most)
    const int first = edgeOf_[a];
    int h = first;
    do {
      const int b = dual_.target(h);
      double near = 0;
      if (b != kInfinity) {
        const Vector v = between(circles_[a], circles_[b]);
        const double s = circles_[b].r - circles_[a].r;
        near = (s + dot(toCentre, v) / l) / (dot(v, v) - s * s);
      }
      if (best == kInfinity || near > most || (near == most && spans(h, toCentre))) {
        best = h;
        most = near;
      }
      h = dual_.twin[Dual::previous(h)];
    } while (h != first);
    return best;
  }

  /// Whether a direction from the origin of h meets that part of its bisector which is between the discs of h.
  bool spans(int h, Vector direction) const {
    const Vector before = discs_.direction(Dual::next(dual_.twin[h]));
    const Vector after = discs_.direction(h);
    const bool isAfter = cross(before, direction) >= 0;
    const bool isBefore = cross(direction, after) >= 0;
    if (cross(before, after) < 0) return isAfter || isBefore;
    // Not the opposite direction, if there is next to nothing between the discs.
    const bool isAhead = dot(before, direction) > 0 || dot(after, direction) > 0 || dot(before, after) < 0;
    return isAfter && isBefore && isAhead;
  }

  struct Disc {
    Predicates::Triple corners;
    FaceDisc disc;
  };

  Disc discOf(const Predicates::Triple& corners) const { return {corners, predicates_.disc(corners)}; }
  Disc discAt(int h) const { return {cornersOf(dual_, h), discs_[h / 3]}; }

  /// 1 if a disc comes before another along the bisector of a and b with a on the left, 0 if they are the same.
  int order(int a, int b, const Disc& first, const Disc& second) const {
    const int from = predicates_.looksFromFirst(a, b) ? a : b;
    const int sign = turn(from, first, second);
    return from == a ? sign : -sign;
  }

  Cut cutOf(int h, int i) const {
    const auto [a, b, c] = cornersOf(dual_, h);
    const int t = dual_.twin[h];
    const int d = dual_.origin[Dual::previous(t)];
    if (b == kInfinity) {
      const bool hasStart = predicates_.tangentSide(a, d, i) > 0;
      const bool hasEnd = predicates_.tangentSide(c, a, i) > 0;
      return {hasStart || hasEnd || spans(h, between(circles_[a], circles_[i])), hasStart, hasEnd && !hasStart};
    }
    // The edge goes from the disc of t to that of h. On its bisector the cell of i begins at `enter`, ends at `leave`.
    const Disc enter = discOf({a, b, i});
    const Disc leave = discOf({b, a, i});
    const bool hasStart = leave.disc.exists && (d == kInfinity || order(a, b, discAt(t), leave) > 0);
    const bool hasEnd = enter.disc.exists && (c == kInfinity || order(a, b, enter, discAt(h)) > 0);
    if (!leave.disc.exists && !enter.disc.exists) {
      const int side = predicates_.tangentSide(a, b, i);
      return {side > 0 || (side == 0 && liesNearer(i, a, b)), false, false};
    }
    if (!leave.disc.exists || !enter.disc.exists) return {hasStart || hasEnd, false, false};
    if (order(a, b, enter, leave) >= 0) return {hasStart && hasEnd, false, false};
    return {hasStart || hasEnd, hasStart, !hasStart};
  }

  /// Whether circle i is nearer than a and b to where the line through the centres of these crosses their bisector.
  bool liesNearer(int i, int a, int b) const {
    const Vector v = between(circles_[a], circles_[b]);
    const double l = length(v);
    const double distance = (l - circles_[a].r - circles_[b].r) / 2;
    const double t = (circles_[a].r + distance) / l;
    const Point p = {circles_[a].x + t * v.x, circles_[a].y + t * v.y};
    return length({circles_[i].x - p.x, circles_[i].y - p.y}) - circles_[i].r < distance;
  }

  /// Puts circle i between the circles of an edge, which becomes two.
  void split(const CutEdge& edge, int i) {
    const int h = edge.h;
    const int t = dual_.twin[h];
    const int a = dual_.origin[h];
    const int b = dual_.origin[t];
    const int x = dual_.halfEdgeCount();
    dual_.origin.insert(dual_.origin.end(), {b, a, i, a, b, i});
    dual_.twin.insert(dual_.twin.end(), {h, x + 5, x + 4, t, x + 2, x + 1});
    dual_.twin[h] = x;
    dual_.twin[t] = x + 3;
    discs_.update(x / 3);
    discs_.update(x / 3 + 1);
    edgeOf_[i] = x + 2;
    const Disc near = edge.cut.hasStart ? discAt(t) : edge.cut.hasEnd ? discAt(h) : Disc{};
    stack_ = {{x, edge.cut.hasEnd, near}, {x + 3, edge.cut.hasStart, near}};
  }

  /// A half-edge opposite the new circle. Its bisector, with its origin on the left, comes from the disc of the old
  /// face beyond it, leaves the old cells at that of its own face, and comes to `near` in the new cell: in this order,
  /// or the new cell has all of it.
  struct Link {
    int h;
    bool isWithin;  ///< the last two are known to be out of order
    Disc near;      ///< of an old face that is gone; without corners if it was on no disc that the new cell came in
  };

  /// Whether the new circle takes away an edge.
  bool isLost(const Link& link, int i) const {
    // The edge across would be a loop.
    if (dual_.origin[Dual::previous(dual_.twin[link.h])] == i) return false;
    if (link.isWithin) return true;
    const bool hasNear = link.near.corners[0] != link.near.corners[1];
    return isAtInfinity(link.h) && hasNear ? isHullLost(link) : discs_.flawOf(link.h) != Flaw::none;
  }

  /// The same of an edge to infinity: the tangent lines of its circle turn all around it, so that only the order of
  /// three of them tells.
  bool isHullLost(const Link& link) const {
    const Disc border = discAt(link.h);
    const Disc beyond = discAt(dual_.twin[link.h]);
    const bool isOutgoing = dual_.origin[link.h] != kInfinity;
    const int from = isOutgoing ? dual_.origin[link.h] : dual_.target(link.h);
    const int toBeyond = turn(from, border, beyond);
    const int toNear = turn(from, beyond, link.near);
    const int turns = toBeyond + toNear + turn(from, link.near, border);
    if (turns != 0) return isOutgoing ? turns > 0 : turns < 0;
    // Two are the same. If the old ones are, the new cell has both.
    const auto u = predicates_.direction(from, beyond.disc);
    const auto v = predicates_.direction(from, link.near.disc);
    return toNear == 0 && toBeyond != 0 && u.x * v.x + u.y * v.y > 0;
  }

  bool isAtInfinity(int h) const { return dual_.origin[h] == kInfinity || dual_.target(h) == kInfinity; }

  /// The sign of the turn around a circle from a disc to another.
  int turn(int from, const Disc& first, const Disc& second) const {
    const int sign =
        predicates_.filteredCross(predicates_.direction(from, first.disc), predicates_.direction(from, second.disc));
    return sign != 0 ? sign : predicates_.exactCross(from, first.corners, second.corners);
  }

  /// Faces (a, b, i) and (b, a, d) become (a, d, i) and (b, i, d).
  void flipEdge(int h) {
    const int t = dual_.twin[h];
    const int bi = Dual::next(h);
    const int ad = Dual::next(t);
    const int ia = Dual::previous(h);
    const int db = Dual::previous(t);
    const Disc lost = discAt(t);
    link(h, dual_.twin[ad]);
    link(t, dual_.twin[bi]);
    dual_.origin[bi] = dual_.origin[db];
    dual_.origin[ad] = dual_.origin[ia];
    link(bi, ad);
    discs_.update(h / 3);
    discs_.update(t / 3);
    for (const int kept : {h, t, ia, db}) {
      if (dual_.origin[kept] != kInfinity) edgeOf_[dual_.origin[kept]] = kept;
    }
    for (const int link : {h, db}) stack_.push_back({link, isWithin(link, lost), lost});
    ++flips_;
  }

  /// Whether the new cell, which has the disc given, has all of the bisector on this side of it.
  bool isWithin(int h, const Disc& lost) const {
    const int a = dual_.origin[h];
    const int b = dual_.target(h);
    if (!discs_.exists(h / 3)) return true;
    if (a == kInfinity || b == kInfinity || lost.disc.w == 0) return false;
    return order(a, b, discAt(h), lost) < 0;
  }

  void link(int h, int t) {
    dual_.twin[h] = t;
    dual_.twin[t] = h;
  }

  std::span<const Circle> circles_;
  Predicates& predicates_;
  Dual dual_;
  NearestCircle nearest_;
  FaceDiscs discs_;
  std::vector<int> edgeOf_;
  std::vector<Link> stack_;
  std::int64_t flips_ = 0;
};

}  // namespace

std::optional<Inserted> insertAll(std::span<const Circle> circles, Predicates& predicates) {
  return Inserter(circles, predicates).run();
}

}  // namespace circle_voronoi
