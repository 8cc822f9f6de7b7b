// SPDX-License-Identifier: GPL-3.0-or-later
#include "insert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "at.h"
#include "dual_keeper.h"
#include "face_discs.h"
#include "insert_cell.h"
#include "mix.h"
#include "waiting_circles.h"

namespace circle_voronoi {
namespace {

/// The order of insertion: random rounds, each in the order given. The last round has three quarters of the circles,
/// and each earlier round three quarters of the rest (N. Amenta, S. Choi, G. Rote, "Incremental constructions con
/// BRIO", 2003).
std::vector<int> orderInRounds(std::size_t count) {
  constexpr int kRounds = 16;
  const auto roundOf = [](std::size_t i) { return kRounds - 1 - std::min(kRounds - 1, std::countr_zero(mix(i)) / 2); };
  std::array<std::size_t, kRounds + 1> first{};
  for (std::size_t i = 0; i < count; ++i) ++first[at(roundOf(i) + 1)];
  for (int round = 1; round <= kRounds; ++round) first[at(round)] += first[at(round - 1)];
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[first[at(roundOf(i))]++] = static_cast<int>(i);
  return order;
}

/// In a cell with no more edges all are looked at.
constexpr std::size_t kFewSectors = 16;

/// From the center of a circle to that of another.
struct Ray {
  Vector to;
  double length;

  Ray(const Circle& from, const Circle& circle) : to(between(from, circle)), length(circle_voronoi::length(to)) {}

  Vector direction() const { return {to.x / length, to.y / length}; }
};

/// The bisector of a circle and a neighbor, as rays from the circle's center see it.
class Bisector {
 public:
  /// At infinity.
  Bisector() = default;
  Bisector(const Circle& circle, const Circle& neighbor) : v_(between(circle, neighbor)), s_(neighbor.r - circle.r) {
    g_ = dot(v_, v_) - s_ * s_;
  }

  /// The inverse of twice the distance at which a ray meets it, 0 if it does not.
  double nearness(const Ray& ray) const {
    const Vector direction = ray.direction();
    const double along = dot(direction, v_);
    // (s + along) / g, without its cancellation where s and along are nearly opposite.
    if ((s_ < 0) == (along < 0)) return std::max(0.0, (along + s_) / g_);
    const double across = cross(direction, v_);
    return std::max(0.0, (1 - across * across / g_) / (along - s_));
  }

 private:
  Vector v_ = {0, 0};
  double s_ = 0;
  double g_ = 1;
};

class Inserter : private DualKeeper {
 public:
  Inserter(std::span<const Circle> circles, Predicates& predicates)
      : circles_(circles),
        predicates_(predicates),
        discs_(circles, dual_, predicates),
        edgeOf_(circles.size(), kPointAtInfinity),
        isHidden_(circles.size()),
        inserter_({dual_, discs_, edgeOf_, isHidden_, *this}),
        waiting_(circles.size()) {
    dual_.origin.reserve(6 * circles.size());
    dual_.twin.reserve(6 * circles.size());
  }

  std::optional<Inserted> run() && {
    std::vector<int> order = orderInRounds(circles_.size());
    if (order.empty()) return Inserted{};
    // Start with the largest circle, which no other hides. Then two circles stay visible unless it hides all others.
    const auto largest = std::max_element(order.begin(), order.end(),
                                          [&](int i, int j) { return circles_[at(i)].r < circles_[at(j)].r; });
    std::rotate(order.begin(), largest, largest + 1);
    std::size_t second = 1;
    for (; second < order.size() && hides(order[0], order[second]); ++second) isHidden_[at(order[second])] = 1;
    if (second < order.size()) {
      start(order[0], order[second]);
      for (std::size_t i = second + 1; i < order.size(); ++i) wait(order[i], order[0], order[second]);
      for (std::size_t i = second + 1; i < order.size(); ++i) {
        if (!isHidden_[at(order[i])] && !insert(order[i])) return std::nullopt;
      }
    }
    return Inserted{compact(), std::move(isHidden_), inserter_.flips()};
  }

 private:
  bool hides(int i, int j) const {
    return circles_[at(i)].r >= circles_[at(j)].r && predicates_.contains(circles_[at(i)], circles_[at(j)]);
  }

  void start(int a, int b) {
    dual_.origin = {a, b, kPointAtInfinity, b, a, kPointAtInfinity};
    dual_.twin = {3, 5, 4, 0, 2, 1};
    waiting_.resize(6);
    edgeOf_[at(a)] = 0;
    edgeOf_[at(b)] = 3;
    for (const int face : {0, 1}) discs_.update(face);
  }

  // Each circle that has not been inserted yet is kept with a half-edge. The circle's center lies in the cell of the
  // half-edge's origin, in the sector between that origin's center and the edge. Cells are star-shaped, so a new cell
  // that contains the circle's center also contains a part of the edge.

  /// Whether circle b is nearer to the center of circle j than circle a is.
  bool isNearer(int j, int a, int b) const {
    return leadOf({circles_[at(j)].x, circles_[at(j)].y}, circles_[at(a)], circles_[at(b)]).value > 0;
  }

  /// Whether the circle of the cell in which the center of circle j lies hides j, which then waits no longer.
  bool isKnownHidden(int i, int j) {
    if (!hides(i, j)) return false;
    isHidden_[at(j)] = 1;
    waiting_.leave(j);
    return true;
  }

  /// Lets a circle wait in one of the first two cells.
  void wait(int j, int a, int b) {
    const int from = isNearer(j, a, b) ? b : a;
    if (isKnownHidden(from, j)) return;
    const int h = edgeOf_[at(from)];
    const double nearness = bisectorOf(h).nearness(Ray(circles_[at(from)], circles_[at(j)]));
    waiting_.add(nearness > 0 ? h : dual_.around(h), j);
  }

  /// The bisector of a half-edge.
  Bisector bisectorOf(int h) const {
    const int b = dual_.target(h);
    return b == kPointAtInfinity ? Bisector() : Bisector(circles_[at(dual_.origin[at(h)])], circles_[at(b)]);
  }

  /// Whether all went well.
  bool insert(int i) {
    const int h = waiting_.listOf(i);
    waiting_.leave(i);
    switch (inserter_.insert(i, h)) {
      case CellInserter::Outcome::inserted:
        settle(i);
        break;
      case CellInserter::Outcome::hidden:
        isHidden_[at(i)] = 1;
        break;
      case CellInserter::Outcome::astray:
        return false;
    }
    return true;
  }

  int addFace() override {
    if (!removedFaces_.empty()) {
      const int face = removedFaces_.back();
      removedFaces_.pop_back();
      return face;
    }
    const int face = dual_.faceCount();
    dual_.origin.resize(dual_.origin.size() + 3);
    dual_.twin.resize(dual_.twin.size() + 3);
    waiting_.resize(dual_.twin.size());
    discs_.clear(face);
    return face;
  }

  void removeFace(int face) override { removedFaces_.push_back(face); }
  void willChange(int) override {}
  void willHide(int) override {}
  void replaceEdge(int from, int to) override { waiting_.move(from, to); }
  void dropEdge(int h) override { waiting_.take(h, arrivals_); }

  /// Whether the center of circle j lies in the sector of h, up to rounding.
  bool spans(int h, int j) const {
    return discs_.spans(h, between(circles_[at(dual_.origin[at(h)])], circles_[at(j)]));
  }

  /// Moves the circles that wait beside the new cell to their new sectors.
  void settle(int i) {
    const int first = edgeOf_[at(i)];
    int spoke = first;
    do {
      const int a = dual_.target(spoke);
      if (a != kPointAtInfinity) settleBeside(i, dual_.twin[at(spoke)]);
      spoke = dual_.around(spoke);
    } while (spoke != first);
    if (!arrivals_.empty()) settleInside(i);
    arrivals_.clear();
  }

  /// Settles the waiting circles at one edge to the new circle and at the two edges beside it.
  void settleBeside(int i, int toNew) {
    const int a = dual_.origin[at(toNew)];
    const int right = dual_.aroundClockwise(toNew);
    const int left = dual_.around(toNew);
    movers_.clear();
    for (const int h : {right, toNew, left}) waiting_.take(h, movers_);
    if (movers_.empty()) return;
    const Bisector toRight = bisectorOf(right);
    const Bisector toLeft = bisectorOf(left);
    const Bisector toMiddle(circles_[at(a)], circles_[at(i)]);
    for (const int j : movers_) {
      const Ray ray(circles_[at(a)], circles_[at(j)]);
      if (isNearer(j, a, i)) {
        if (!isKnownHidden(i, j)) arrivals_.push_back(j);
        continue;
      }
      Met met = nearer({right, toRight.nearness(ray)}, {left, toLeft.nearness(ray)}, j);
      if (const double nearness = toMiddle.nearness(ray); nearness > met.nearness) {
        // The new cell may have another border with this one beyond the next.
        met = {toNew, nearness};
        for (const int beyond : {dual_.aroundClockwise(right), dual_.around(left)}) {
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

  /// Returns which of two edges of a cell the ray through the center of circle j meets first.
  Met nearer(const Met& first, const Met& second, int j) const {
    if (first.nearness != second.nearness) return first.nearness > second.nearness ? first : second;
    // A bisector that it never meets, or two parts of one bisector.
    const bool isFirstAtInfinity = dual_.target(first.h) == kPointAtInfinity;
    if (isFirstAtInfinity != (dual_.target(second.h) == kPointAtInfinity)) return isFirstAtInfinity ? first : second;
    return !spans(first.h, j) && spans(second.h, j) ? second : first;
  }

  /// Finds sectors for the circles whose centers lie in the new cell.
  void settleInside(int i) {
    sectors_.clear();
    const int first = edgeOf_[at(i)];
    int spoke = first;
    do {
      // The next sector begins where this one ends.
      const int next = dual_.around(spoke);
      sectors_.push_back({pseudoAngle(discs_.direction(spoke)), next, bisectorOf(next)});
      spoke = next;
    } while (spoke != first);
    std::sort(sectors_.begin(), sectors_.end(),
              [](const Sector& a, const Sector& b) { return std::pair(a.angle, a.h) < std::pair(b.angle, b.h); });
    for (const int j : arrivals_) {
      const Ray ray(circles_[at(i)], circles_[at(j)]);
      const bool areFew = sectors_.size() <= kFewSectors;
      int h = areFew ? kPointAtInfinity : sectorByAngle(ray, j);
      if (h == kPointAtInfinity) {
        Met met = {first, bisectorOf(first).nearness(ray)};
        for (const Sector& sector : sectors_) met = nearer(met, {sector.h, sector.bisector.nearness(ray)}, j);
        h = met.h;
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

  /// The sector of the new cell that has the center of circle j, or kPointAtInfinity if rounding has put them out of
  /// order.
  int sectorByAngle(const Ray& ray, int j) const {
    const double angle = pseudoAngle(ray.to);
    const auto after = std::upper_bound(sectors_.begin(), sectors_.end(), angle,
                                        [](double value, const Sector& sector) { return value < sector.angle; });
    const Sector& sector = after == sectors_.begin() ? sectors_.back() : *std::prev(after);
    const Met met = {sector.h, sector.bisector.nearness(ray)};
    const auto isBefore = [&](int other) {
      return nearer(met, {other, bisectorOf(other).nearness(ray)}, j).h == sector.h;
    };
    const bool isThere =
        spans(sector.h, j) && isBefore(dual_.around(sector.h)) && isBefore(dual_.aroundClockwise(sector.h));
    return isThere ? sector.h : kPointAtInfinity;
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
        dual_.origin[at(3 * *hole + k)] = dual_.origin[at(3 * count + k)];
        dual_.link(3 * *hole + k, dual_.twin[at(3 * count + k)]);
      }
      ++hole;
    }
    dual_.origin.resize(3 * static_cast<std::size_t>(count));
    dual_.twin.resize(3 * static_cast<std::size_t>(count));
    return std::move(dual_);
  }

  std::span<const Circle> circles_;
  Predicates& predicates_;
  Dual dual_;
  FaceDiscs discs_;
  std::vector<int> edgeOf_;  ///< of each circle in the dual a half-edge that starts from it
  std::vector<char> isHidden_;
  CellInserter inserter_;
  WaitingCircles waiting_;
  std::vector<int> removedFaces_;  ///< places for new ones
  std::vector<int> movers_;        ///< the circles that waited at an edge beside the new cell
  std::vector<int> arrivals_;      ///< the circles whose centers lie in the new cell
  std::vector<Sector> sectors_;
};

}  // namespace

std::optional<Inserted> insertAll(std::span<const Circle> circles, Predicates& predicates) {
  return Inserter(circles, predicates).run();
}

}  // namespace circle_voronoi
