// SPDX-License-Identifier: GPL-3.0-or-later
#include "insert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "face_discs.h"
#include "mix.h"
#include "waiting_circles.h"

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

/// In a cell with no more edges all are looked at.
constexpr std::size_t kFewSectors = 16;

/// Grows with the angle of a direction, from 0 to 4 in a turn.
double angleOf(Vector v) {
  const double size = std::abs(v.x) + std::abs(v.y);
  const double along = size > 0 ? v.x / size : 1;
  return v.y >= 0 ? 1 - along : 3 + along;
}

/// From the centre of a circle to that of another.
struct Ray {
  Vector to;
  double length;

  Ray(const Circle& from, const Circle& circle) : to(between(from, circle)), length(circle_voronoi::length(to)) {}
};

/// The bisector of a circle and a neighbour, as rays from the circle's centre see it.
class Bisector {
 public:
  /// At infinity.
  Bisector() = default;
  Bisector(const Circle& circle, const Circle& neighbor)
      : v_(between(circle, neighbor)), s_(neighbor.r - circle.r), g_(dot(v_, v_) - s_ * s_) {}

  /// The inverse of twice the distance at which a ray meets it, 0 if it does not.
  double nearness(const Ray& ray) const {
    const double along = dot(ray.to, v_) / ray.length;
    // (s + along) / g, without its cancellation where s and along are nearly opposite.
    if ((s_ < 0) == (along < 0)) return std::max(0.0, (along + s_) / g_);
    const double across = cross(ray.to, v_) / ray.length;
    return std::max(0.0, (1 - across * across / g_) / (along - s_));
  }

 private:
  Vector v_ = {0, 0};
  double s_ = 0;
  double g_ = 1;
};

class Inserter {
 public:
  Inserter(std::span<const Circle> circles, Predicates& predicates)
      : circles_(circles),
        predicates_(predicates),
        discs_(circles, dual_, predicates),
        edgeOf_(circles.size(), kInfinity),
        isHidden_(circles.size()),
        waiting_(circles.size()) {
    dual_.origin.reserve(6 * circles.size());
    dual_.twin.reserve(6 * circles.size());
  }

  std::optional<Inserted> run() && {
    std::vector<int> order = insertionOrder(circles_.size());
    if (order.empty()) return Inserted{};
    // The largest first: no other hides it, so that there are always two as soon as it does not hide all.
    const auto largest =
        std::max_element(order.begin(), order.end(), [&](int i, int j) { return circles_[i].r < circles_[j].r; });
    std::rotate(order.begin(), largest, largest + 1);
    std::size_t second = 1;
    for (; second < order.size() && hides(order[0], order[second]); ++second) isHidden_[order[second]] = 1;
    if (second < order.size()) {
      start(order[0], order[second]);
      for (std::size_t i = second + 1; i < order.size(); ++i) wait(order[i], order[0], order[second]);
      for (std::size_t i = second + 1; i < order.size(); ++i) {
        if (!isHidden_[order[i]] && !insert(order[i])) return std::nullopt;
      }
    }
    return Inserted{compact(), std::move(isHidden_), flips_};
  }

 private:
  bool hides(int i, int j) const {
    return circles_[i].r >= circles_[j].r && predicates_.contains(circles_[i], circles_[j]);
  }

  void start(int a, int b) {
    dual_.origin = {a, b, kInfinity, b, a, kInfinity};
    dual_.twin = {3, 5, 4, 0, 2, 1};
    waiting_.resize(6);
    edgeOf_[a] = 0;
    edgeOf_[b] = 3;
    for (const int face : {0, 1}) discs_.update(face);
  }

  // Each circle that is still to come waits at a half-edge: in the cell of its origin its centre lies in the sector of
  // its bisector. A new cell that has the centre has a part of that bisector, as cells are star-shaped.

  double distance(int from, int to) const { return length(between(circles_[from], circles_[to])) - circles_[to].r; }

  /// Whether the circle of the cell in which the centre of circle j lies hides j, which then waits no longer.
  bool isKnownHidden(int i, int j) {
    if (!hides(i, j)) return false;
    isHidden_[j] = 1;
    waiting_.leave(j);
    return true;
  }

  /// Lets a circle wait in one of the first two cells.
  void wait(int j, int a, int b) {
    const int from = distance(j, a) <= distance(j, b) ? a : b;
    if (isKnownHidden(from, j)) return;
    const int h = edgeOf_[from];
    const double nearness = bisectorOf(h).nearness(Ray(circles_[from], circles_[j]));
    waiting_.add(nearness > 0 ? h : dual_.twin[Dual::previous(h)], j);
  }

  /// The bisector of a half-edge.
  Bisector bisectorOf(int h) const {
    const int b = dual_.target(h);
    return b == kInfinity ? Bisector() : Bisector(circles_[dual_.origin[h]], circles_[b]);
  }

  /// Far more than a random order makes likely: going on means that rounding led astray.
  bool isAstray() const {
    const std::int64_t limit = 1000 + 30 * static_cast<std::int64_t>(circles_.size());
    return flips_ > limit || looks_ > limit;
  }

  /// Whether all went well.
  bool insert(int i) {
    const int h = waiting_.listOf(i);
    waiting_.leave(i);
    const auto edge = cutEdge(h, i);
    if (!edge) {
      isHidden_[i] = 1;
      return true;
    }
    split(*edge, i);
    while (!stack_.empty() && !isAstray()) {
      const Link link = stack_.back();
      stack_.pop_back();
      if (isLost(link, i)) flipEdge(link.h, i);
    }
    if (isAstray() || !removeLost()) return false;
    settle(i);
    return true;
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

  /// An edge of the old diagram that the cell of circle i cuts; nothing if another circle hides i. It is one of the
  /// cell in which the centre of i lies, most often `likely`; where rounding has led astray, the way goes from cell to
  /// cell until no neighbour is nearer.
  std::optional<CutEdge> cutEdge(int likely, int i) {
    int start = likely;
    while (true) {
      auto edge = cutEdgeAround(start, i);
      if (!edge || edge->cut.isCut) return edge;
      const int nearest = nearestAround(start, i);
      if (distance(i, dual_.target(nearest)) >= distance(i, dual_.origin[start])) break;
      start = dual_.twin[nearest];
    }
    // The centre may lie on the border of the cell.
    const double least = distance(i, dual_.origin[start]);
    const double rounding = 1e-14 * (std::abs(least) + circles_[dual_.origin[start]].r);
    int h = start;
    do {
      const int b = dual_.target(h);
      if (b != kInfinity && distance(i, b) <= least + rounding) {
        auto edge = cutEdgeAround(dual_.twin[h], i);
        if (!edge || edge->cut.isCut) return edge;
      }
      h = dual_.twin[Dual::previous(h)];
    } while (h != start);
    return CutEdge{start, {}};
  }

  /// The half-edge around the origin of one to the neighbour that is nearest to the centre of circle i.
  int nearestAround(int start, int i) {
    int nearest = start;
    double least = std::numeric_limits<double>::infinity();
    int h = start;
    do {
      ++looks_;
      const int b = dual_.target(h);
      if (b != kInfinity && distance(i, b) < least) {
        nearest = h;
        least = distance(i, b);
      }
      h = dual_.twin[Dual::previous(h)];
    } while (h != start);
    return nearest;
  }

  /// The same around one cell: from an edge that is likely to be cut to both sides.
  std::optional<CutEdge> cutEdgeAround(int likely, int i) {
    if (hides(dual_.origin[likely], i)) return std::nullopt;
    int left = likely;
    int right = likely;
    do {
      for (const int h : {left, right}) {
        ++looks_;
        const int b = dual_.target(h);
        if (b != kInfinity && hides(b, i)) return std::nullopt;
        if (const Cut cut = cutOf(h, i); cut.isCut) return CutEdge{h, cut};
      }
      left = dual_.twin[Dual::previous(left)];
      right = Dual::next(dual_.twin[right]);
    } while (left != likely);
    return CutEdge{likely, {}};
  }

  /// Whether the ray from the origin of h through the centre of circle j meets that part of its bisector which is
  /// between the discs of h, up to rounding.
  bool spans(int h, int j) const {
    const Vector direction = between(circles_[dual_.origin[h]], circles_[j]);
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

  static bool isTangentLine(const Disc& disc) {
    return std::find(disc.corners.begin(), disc.corners.end(), kInfinity) != disc.corners.end();
  }

  /// 1 if a disc comes before another along the bisector of a and b with a on the left, 0 if they are the same.
  int order(int a, int b, const Disc& first, const Disc& second) const {
    const int from = predicates_.looksFromFirst(a, b) ? a : b;
    const int sign = turn(from, first, second);
    return from == a ? sign : -sign;
  }

  Cut cutOf(int h, int i) const {
    const auto [a, b, c] = cornersOf(dual_, h);
    if (hides(i, a) || (b != kInfinity && hides(i, b))) return {true, true, false};
    const int t = dual_.twin[h];
    const int d = dual_.origin[Dual::previous(t)];
    if (b == kInfinity) {
      const bool hasStart = predicates_.tangentSide(a, d, i) > 0;
      const bool hasEnd = predicates_.tangentSide(c, a, i) > 0;
      const bool isWithin = turns(a, discAt(t), discOf({a, i, kInfinity}), discAt(h)) > 0;
      return {hasStart || hasEnd || isWithin, hasStart, hasEnd && !hasStart};
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

  /// The first half-edge of a new face.
  int addFace() {
    if (!removedFaces_.empty()) {
      const int face = removedFaces_.back();
      removedFaces_.pop_back();
      return 3 * face;
    }
    const int first = dual_.halfEdgeCount();
    dual_.origin.resize(first + 3);
    dual_.twin.resize(first + 3);
    waiting_.resize(first + 3);
    discs_.clear(first / 3);
    return first;
  }

  /// Finds the disc of a face with a new circle. It has none if that hides one of the others.
  void renewDisc(int face, int i) {
    bool isLost = false;
    for (const int corner : cornersOf(dual_, 3 * face)) {
      if (corner == i || corner == kInfinity) continue;
      if (!isHidden_[corner] && hides(i, corner)) {
        isHidden_[corner] = 1;
        lost_.push_back(corner);
      }
      isLost = isLost || isHidden_[corner];
    }
    if (isLost) {
      discs_.clear(face);
    } else {
      discs_.update(face);
    }
  }

  /// Puts circle i between the circles of an edge, which becomes two.
  void split(const CutEdge& edge, int i) {
    const int h = edge.h;
    const int t = dual_.twin[h];
    const Disc near = edge.cut.hasStart ? discAt(t) : edge.cut.hasEnd ? discAt(h) : Disc{};
    const int atH = addFace();
    const int atT = addFace();
    const auto fill = [&](int first, int beyond) {
      dual_.origin[first] = dual_.target(beyond);
      dual_.origin[first + 1] = dual_.origin[beyond];
      dual_.origin[first + 2] = i;
      link(first, beyond);
    };
    fill(atH, h);
    fill(atT, t);
    link(atH + 1, atT + 2);
    link(atH + 2, atT + 1);
    edgeOf_[i] = atH + 2;
    renewDisc(atH / 3, i);
    renewDisc(atT / 3, i);
    stack_ = {{atH, edge.cut.hasEnd, near}, {atT, edge.cut.hasStart, near}};
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
    if (link.isWithin || !discs_.exists(link.h / 3)) return true;
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
    const int sign = turns(from, border, beyond, link.near);
    if (sign != 0) return isOutgoing ? sign > 0 : sign < 0;
    // Two are the same. If the old ones are, the new cell has both.
    const auto u = predicates_.direction(from, beyond.disc);
    const auto v = predicates_.direction(from, link.near.disc);
    return turn(from, beyond, link.near) == 0 && turn(from, border, beyond) != 0 && u.x * v.x + u.y * v.y > 0;
  }

  /// Positive if three discs follow one another counter-clockwise around a circle, negative if clockwise, 0 if two are
  /// in the same direction.
  int turns(int from, const Disc& first, const Disc& second, const Disc& third) const {
    return turn(from, first, second) + turn(from, second, third) + turn(from, third, first);
  }

  bool isAtInfinity(int h) const { return dual_.origin[h] == kInfinity || dual_.target(h) == kInfinity; }

  /// The sign of the turn around a circle from a disc to another.
  int turn(int from, const Disc& first, const Disc& second) const {
    const int sign =
        predicates_.filteredCross(predicates_.direction(from, first.disc), predicates_.direction(from, second.disc));
    return sign != 0 ? sign : predicates_.exactCross(from, first.corners, second.corners);
  }

  /// Faces (a, b, i) and (b, a, d) become (a, d, i) and (b, i, d). Who waits at the lost edge goes to the edges to i.
  void flipEdge(int h, int i) {
    const int t = dual_.twin[h];
    const int bi = Dual::next(h);
    const int ad = Dual::next(t);
    const int ia = Dual::previous(h);
    const int db = Dual::previous(t);
    const Disc lost = discAt(t);
    waiting_.move(h, dual_.twin[ia]);
    waiting_.move(bi, t);
    waiting_.move(ad, h);
    link(h, dual_.twin[ad]);
    link(t, dual_.twin[bi]);
    dual_.origin[bi] = dual_.origin[db];
    dual_.origin[ad] = dual_.origin[ia];
    link(bi, ad);
    renewDisc(h / 3, i);
    renewDisc(t / 3, i);
    for (const int kept : {h, t, ia, db}) noteEdge(kept);
    for (const int link : {h, db}) stack_.push_back({link, isWithin(link, lost), lost});
    ++flips_;
  }

  /// Whether the new cell, which has the disc given, has all of the bisector on this side of it.
  bool isWithin(int h, const Disc& lost) const {
    const int a = dual_.origin[h];
    const int b = dual_.target(h);
    if (!discs_.exists(h / 3)) return true;
    if (a == kInfinity || b == kInfinity || isTangentLine(lost)) return false;
    return order(a, b, discAt(h), lost) < 0;
  }

  /// Takes the circles away that the new one hides, which leaves them but two edges. Whether it did.
  bool removeLost() {
    while (!lost_.empty()) {
      const auto removed = std::remove_if(lost_.begin(), lost_.end(), [&](int circle) { return remove(circle); });
      if (removed == lost_.end()) return false;
      lost_.erase(removed, lost_.end());
    }
    return true;
  }

  /// Faces (circle, p, q) and (circle, q, p) vanish. Whether the circle had two edges.
  bool remove(int circle) {
    const int g = edgeOf_[circle];
    const int h = dual_.twin[Dual::previous(g)];
    if (h == g || dual_.twin[Dual::previous(h)] != g) return false;
    const int pq = dual_.twin[Dual::next(h)];
    const int qp = dual_.twin[Dual::next(g)];
    if (pq / 3 == g / 3) return false;
    waiting_.take(g, arrivals_);
    waiting_.take(h, arrivals_);
    for (const int lost : {Dual::next(g), Dual::previous(h)}) waiting_.move(lost, pq);
    for (const int lost : {Dual::next(h), Dual::previous(g)}) waiting_.move(lost, qp);
    link(pq, qp);
    noteEdge(pq);
    noteEdge(qp);
    removedFaces_.push_back(g / 3);
    removedFaces_.push_back(h / 3);
    return true;
  }

  /// Finds those that wait beside the new cell their sector anew.
  void settle(int i) {
    const int first = edgeOf_[i];
    int spoke = first;
    do {
      const int a = dual_.target(spoke);
      if (a != kInfinity) settleBeside(i, dual_.twin[spoke]);
      spoke = dual_.twin[Dual::previous(spoke)];
    } while (spoke != first);
    if (!arrivals_.empty()) settleInside(i);
    arrivals_.clear();
  }

  /// The same of those at one edge to the new circle and at the two beside it.
  void settleBeside(int i, int toNew) {
    const int a = dual_.origin[toNew];
    const int right = Dual::next(dual_.twin[toNew]);
    const int left = dual_.twin[Dual::previous(toNew)];
    movers_.clear();
    for (const int h : {right, toNew, left}) waiting_.take(h, movers_);
    if (movers_.empty()) return;
    const Bisector toRight = bisectorOf(right);
    const Bisector toLeft = bisectorOf(left);
    const Bisector toMiddle(circles_[a], circles_[i]);
    for (const int j : movers_) {
      const Ray ray(circles_[a], circles_[j]);
      if (distance(j, i) < ray.length - circles_[a].r) {
        if (!isKnownHidden(i, j)) arrivals_.push_back(j);
        continue;
      }
      Met met = nearer({right, toRight.nearness(ray)}, {left, toLeft.nearness(ray)}, j);
      if (const double nearness = toMiddle.nearness(ray); nearness > met.nearness) {
        // The new cell may have another border with this one beyond the next.
        met = {toNew, nearness};
        for (const int beyond : {Dual::next(dual_.twin[right]), dual_.twin[Dual::previous(left)]}) {
          if (dual_.target(beyond) == i) met = nearer(met, {beyond, nearness}, j);
        }
      }
      waiting_.add(met.h, j);
    }
  }

  /// An edge of a cell, and how near a ray meets its bisector.
  struct Met {
    int h;
    double nearness;
  };

  /// Of two edges of a cell the one that the ray through the centre of circle j meets first.
  Met nearer(const Met& first, const Met& second, int j) const {
    if (first.nearness != second.nearness) return first.nearness > second.nearness ? first : second;
    // A bisector that it never meets, or two parts of one bisector.
    const bool isFirstAtInfinity = dual_.target(first.h) == kInfinity;
    if (isFirstAtInfinity != (dual_.target(second.h) == kInfinity)) return isFirstAtInfinity ? first : second;
    return !spans(first.h, j) && spans(second.h, j) ? second : first;
  }

  /// Finds those whose centres the new cell has their sectors in it.
  void settleInside(int i) {
    sectors_.clear();
    const int first = edgeOf_[i];
    int spoke = first;
    do {
      // Where one sector ends the next begins.
      const int next = dual_.twin[Dual::previous(spoke)];
      sectors_.push_back({angleOf(discs_.direction(spoke)), next, bisectorOf(next)});
      spoke = next;
    } while (spoke != first);
    std::sort(sectors_.begin(), sectors_.end(),
              [](const Sector& a, const Sector& b) { return std::pair(a.angle, a.h) < std::pair(b.angle, b.h); });
    for (const int j : arrivals_) {
      const Ray ray(circles_[i], circles_[j]);
      const bool areFew = sectors_.size() <= kFewSectors;
      int h = areFew ? kInfinity : sectorByAngle(ray, j);
      if (h == kInfinity) {
        Met met = {first, bisectorOf(first).nearness(ray)};
        for (const Sector& sector : sectors_) met = nearer(met, {sector.h, sector.bisector.nearness(ray)}, j);
        h = met.h;
        if (!areFew) looks_ += static_cast<std::int64_t>(sectors_.size());
      }
      waiting_.add(h, j);
    }
  }

  /// A sector of the new cell, from the angle at which it begins.
  struct Sector {
    double angle;
    int h;
    Bisector bisector;
  };

  /// The sector of the new cell that has the centre of circle j, or kInfinity if rounding has put them out of order.
  int sectorByAngle(const Ray& ray, int j) const {
    const double angle = angleOf(ray.to);
    const auto after = std::upper_bound(sectors_.begin(), sectors_.end(), angle,
                                        [](double value, const Sector& sector) { return value < sector.angle; });
    const Sector& sector = after == sectors_.begin() ? sectors_.back() : *std::prev(after);
    const Met met = {sector.h, sector.bisector.nearness(ray)};
    const auto isBefore = [&](int other) {
      return nearer(met, {other, bisectorOf(other).nearness(ray)}, j).h == sector.h;
    };
    const bool isThere = spans(sector.h, j) && isBefore(dual_.twin[Dual::previous(sector.h)]) &&
                         isBefore(Dual::next(dual_.twin[sector.h]));
    return isThere ? sector.h : kInfinity;
  }

  /// The dual without the faces that were removed.
  Dual compact() {
    std::sort(removedFaces_.begin(), removedFaces_.end());
    int count = dual_.faceCount();
    for (auto hole = removedFaces_.begin(), end = removedFaces_.end(); hole != end;) {
      --count;
      if (count == *(end - 1)) {
        --end;
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        dual_.origin[3 * *hole + k] = dual_.origin[3 * count + k];
        link(3 * *hole + k, dual_.twin[3 * count + k]);
      }
      ++hole;
    }
    dual_.origin.resize(3 * static_cast<std::size_t>(count));
    dual_.twin.resize(3 * static_cast<std::size_t>(count));
    return std::move(dual_);
  }

  void noteEdge(int h) {
    if (dual_.origin[h] != kInfinity) edgeOf_[dual_.origin[h]] = h;
  }

  void link(int h, int t) {
    dual_.twin[h] = t;
    dual_.twin[t] = h;
  }

  std::span<const Circle> circles_;
  Predicates& predicates_;
  Dual dual_;
  FaceDiscs discs_;
  std::vector<int> edgeOf_;  ///< of each circle in the dual a half-edge that starts from it
  std::vector<char> isHidden_;
  WaitingCircles waiting_;
  std::vector<Link> stack_;
  std::vector<int> lost_;          ///< the circles that the new one hides
  std::vector<int> removedFaces_;  ///< places for new ones
  std::vector<int> movers_;        ///< those that waited at an edge beside the new cell
  std::vector<int> arrivals_;      ///< those whose centres the new cell has
  std::vector<Sector> sectors_;
  std::int64_t flips_ = 0;
  std::int64_t looks_ = 0;
};

}  // namespace

std::optional<Inserted> insertAll(std::span<const Circle> circles, Predicates& predicates) {
  return Inserter(circles, predicates).run();
}

}  // namespace circle_voronoi
