// SPDX-License-Identifier: GPL-3.0-or-later
#include "touch.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <utility>

#include "angle.h"
#include "at.h"
#include "portable.h"
#include "rotation_system.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

/// Relative error of a computed distance: about ten times the rounding of a few sums and a root. A disc that touches a
/// circle within it may meet the circle.
constexpr double kDistanceError = 0x1p-46;

struct AntipodalDisc {
  double r = 0;
  int a = 0;
  int b = 0;
  int slotA = 0;
  int slotB = 0;
};

/// A three-touch disc in the queue: DE(a,b) and DE(b,c), parametrically adjacent on b when it was formed.
struct Candidate {
  double r = 0;
  int first = kNoEdge;
  int second = kNoEdge;

  friend bool operator<(const Candidate& u, const Candidate& v) {  // the queue serves the largest first
    if (u.r != v.r) return u.r > v.r;
    return u.first != v.first ? u.first > v.first : u.second > v.second;
  }
};

class Touch {
 public:
  Touch(std::span<const Circle> circles, std::span<const Pair> pairs, const Observer& observer)
      : circles_(circles), observer_(observer), rotations_(circles, pairs), touched_(circles.size(), false) {
    makeDiscs(pairs);
    result_.topology.edges.reserve(3 * circles.size());
    result_.topology.vertexCircles.reserve(2 * circles.size());
  }

  TouchResult run(const ProgressCallback& progress) {
    constexpr std::size_t kDiscsPerReport = 1 << 14;
    std::size_t next = 0;
    while (next < discs_.size() || !queue_.empty()) {
      ++result_.events;
      if (next < discs_.size() && (queue_.empty() || discs_[next].r < queue_.top().r)) {
        if (next + kDiscsAhead < discs_.size()) prepare(discs_[next + kDiscsAhead]);
        processAntipodalDisc(discs_[next++]);
        if (progress && next % kDiscsPerReport == 0) {
          progress(static_cast<double>(next) / static_cast<double>(discs_.size()));
        }
      } else {
        const Candidate candidate = queue_.top();
        queue_.pop();
        if (!queue_.empty()) prepare(queue_.top());
        processThreeTouchDisc(candidate);
      }
    }
    collectHull();
    return std::move(result_);
  }

 private:
  // Discs in the order of their radii come from all over the plane. Fetching what the next ones need before it is
  // needed saves a quarter of the loop's time.

  static constexpr std::size_t kDiscsAhead = 6;

  void prepare(const AntipodalDisc& disc) const {
    prefetch(&circles_[at(disc.a)]);
    prefetch(&circles_[at(disc.b)]);
    rotations_.prefetchSlot(disc.slotA);
    rotations_.prefetchSlot(disc.slotB);
  }

  void prepare(const Candidate& candidate) const {
    rotations_.prefetchEdge(candidate.first);
    rotations_.prefetchEdge(candidate.second);
  }

  // --- antipodal discs (Algorithm 2) ---

  void makeDiscs(std::span<const Pair> pairs) {
    const std::vector<RotationSystem::Slots> slots = rotations_.takeSlots();
    discs_.reserve(pairs.size());
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
      const auto [a, b] = pairs[pair];
      const double gap = length(between(circles_[at(a)], circles_[at(b)])) - circles_[at(a)].r - circles_[at(b)].r;
      discs_.push_back({gap / 2, a, b, slots[pair][0], slots[pair][1]});
    }
    std::sort(discs_.begin(), discs_.end(), [](const AntipodalDisc& s, const AntipodalDisc& t) {
      if (s.r != t.r) return s.r < t.r;
      return s.a != t.a ? s.a < t.a : s.b < t.b;
    });
  }

  Vertex placedDisc(const AntipodalDisc& disc) const {
    const Circle& a = circles_[at(disc.a)];
    const Vector v = between(a, circles_[at(disc.b)]);
    const double part = (a.r + disc.r) / length(v);
    return {a.x + part * v.x, a.y + part * v.y, disc.r};
  }

  /// Returns whether the arc of circle i at `slot`, in the given direction to its partner, is already used for the
  /// diagram.
  bool isUsed(int i, int slot, int partner, Vector direction) const {
    if (!touched_[at(i)]) return false;
    const RotationSystem::Arc arc = rotations_.arcAt(i, slot);
    if (arc.isUsed()) return true;
    const DirectedEdge& in = rotations_.edge(arc.in);
    const DirectedEdge& out = rotations_.edge(arc.out);
    // No disc on the bisector is smaller than the antipodal one. So if a directed edge of the two circles has been
    // placed before it, their discs differ only by rounding, and that edge represents both.
    if (in.a == partner || out.b == partner) return true;
    const Vector from = in.fromB;
    const Vector to = out.fromA;
    // If the two DEs of one antipodal disc are alone on the circle, the whole circle except the footpoint is unused.
    if (arc.isWhole && from.x == to.x && from.y == to.y) return cross(from, direction) == 0 && dot(from, direction) > 0;
    // A footpoint that touches a used arc counts as used.
    return !strictlyBetween(from, direction, to);
  }

  /// A circle next to the footpoint at `slot` of circle i that meets or touches the disc, or kNone (paper,
  /// section 3.3).
  ///
  /// A circle that touches an antipodal disc makes it a three-touch disc, which places the same DEs. If touching counts
  /// as meeting, three-touch discs decide ties. Otherwise two antipodal discs of opposite circles around one disc would
  /// cross.
  int meetingCircle(int i, int slot, const Vertex& disc) const {
    if (!touched_[at(i)]) return kNone;
    const RotationSystem::Arc arc = rotations_.arcAt(i, slot);
    for (const int near : {rotations_.edge(arc.in).a, rotations_.edge(arc.out).b}) {
      const Circle& c = circles_[at(near)];
      const Vector v = {disc.x - c.x, disc.y - c.y};
      const double distance = length(v);
      const double rounding = kDistanceError * (distance + std::abs(c.r) + std::abs(disc.x) + std::abs(disc.y));
      if (distance - c.r <= disc.r + rounding) return near;
    }
    return kNone;
  }

  void processAntipodalDisc(const AntipodalDisc& antipodal) {
    const auto& [radius, a, b, slotA, slotB] = antipodal;
    const Vector v = between(circles_[at(a)], circles_[at(b)]);
    const Vector back = {-v.x, -v.y};
    const Vertex disc = placedDisc(antipodal);
    if (isUsed(a, slotA, b, v) || isUsed(b, slotB, a, back)) {
      tell({TraceKind::antipodalDiscUsed, disc, {a, b, kNone}, kNone});
      return;
    }
    int meeting = meetingCircle(a, slotA, disc);
    if (meeting == kNone) meeting = meetingCircle(b, slotB, disc);
    if (meeting != kNone) {
      tell({TraceKind::antipodalDiscNotEmpty, disc, {a, b, meeting}, kNone});
      return;
    }
    tell({TraceKind::antipodalDiscAccepted, disc, {a, b, kNone}, kNone});
    touched_[at(a)] = true;
    touched_[at(b)] = true;
    // Going along the segment of DE(a,b), b is on the left.
    const int edge = static_cast<int>(result_.topology.edges.size());
    result_.topology.edges.push_back({b, a, kNone, kNone});
    const int forth = rotations_.place({a, b, slotA, slotB, edge, true, v, back});
    const int reverse = rotations_.place({b, a, slotB, slotA, edge, false, back, v});
    for (const int placed : {forth, reverse}) {
      tell({TraceKind::directedEdgePlaced,
            disc,
            {rotations_.edge(placed).a, rotations_.edge(placed).b, kNone},
            kNone,
            {placed, kNone}});
    }
    for (const int placed : {forth, reverse}) formThreeTouchDiscs(placed);
  }

  // --- three-touch discs (Algorithm 3) ---

  /// Returns whether a disc lies ahead of the disc of R_min of `edge` on the bisector, or at it: forward, to the right
  /// of the DE. `toCenterA` and `toCenterB` lead from the centers of its circles to the center of the disc.
  bool isForward(const DirectedEdge& edge, Vector toCenterA, Vector toCenterB) const {
    // The smaller circle sees the whole bisector within less than a full turn around the direction of the larger one.
    const Vector axis = between(circles_[at(edge.a)], circles_[at(edge.b)]);
    return circles_[at(edge.a)].r <= circles_[at(edge.b)].r
               ? compareAngles(axis, edge.fromA, toCenterA) <= 0
               : compareAngles({-axis.x, -axis.y}, edge.fromB, toCenterB) >= 0;
  }

  void formThreeTouchDiscs(int index) {
    const int before = rotations_.adjacentBefore(rotations_.edge(index));
    const int after = rotations_.adjacentAfter(rotations_.edge(index));
    if (before != kNoEdge) formThreeTouchDisc(before, index);
    if (after != kNoEdge) formThreeTouchDisc(index, after);
  }

  void formThreeTouchDisc(int first, int second) {
    const DirectedEdge& ab = rotations_.edge(first);
    const DirectedEdge& bc = rotations_.edge(second);
    if (bc.b == ab.a) return;
    // The disc lies to the right of a -> b -> c: these are clockwise around it.
    const auto disc = threeTouchDisc(circles_[at(ab.a)], circles_[at(bc.b)], circles_[at(ab.b)]);
    if (!disc) return;
    const auto& [toA, toC, toB] = disc->toCenter;
    if (!isForward(ab, toA, toB) || !isForward(bc, toB, toC)) return;
    ++result_.threeTouchDiscs;
    queue_.push({disc->disc.r, first, second});
    tell({TraceKind::threeTouchDiscFormed, disc->disc, {ab.a, ab.b, bc.b}, kNone, {first, second}});
  }

  void processThreeTouchDisc(const Candidate& candidate) {
    const auto& [radius, first, second] = candidate;
    const DirectedEdge ab = rotations_.edge(first);
    const DirectedEdge bc = rotations_.edge(second);
    const bool isStale =
        !rotations_.isAlive(first) || !rotations_.isAlive(second) || rotations_.adjacentAfter(ab) != second;
    if (isStale && !observer_) return;
    const auto disc = threeTouchDisc(circles_[at(ab.a)], circles_[at(bc.b)], circles_[at(ab.b)]);
    if (isStale) {
      tell({TraceKind::threeTouchDiscStale, disc->disc, {ab.a, ab.b, bc.b}, kNone, {first, second}});
      return;
    }
    const int vertex = static_cast<int>(result_.topology.vertexCircles.size());
    result_.topology.vertexCircles.push_back({ab.a, bc.b, ab.b});
    tell({TraceKind::branchDisc, disc->disc, {ab.a, ab.b, bc.b}, vertex, {first, second}});

    const auto& [toA, toC, toB] = disc->toCenter;
    int third = rotations_.adjacentAfter(bc);
    if (third != kNoEdge) {
      // DE(c,a) closes the triangle only if it faces both others; another DE between c and a belongs to another
      // branch point.
      const DirectedEdge& ca = rotations_.edge(third);
      if (ca.b != ab.a || rotations_.adjacentAfter(ca) != first || !isForward(ca, toC, toA)) third = kNoEdge;
    }
    finish(first, vertex, disc->disc);
    finish(second, vertex, disc->disc);
    if (third != kNoEdge) {
      finish(third, vertex, disc->disc);
      return;
    }
    const int edge = static_cast<int>(result_.topology.edges.size());
    result_.topology.edges.push_back({bc.b, ab.a, vertex, kNone});
    const int placed = rotations_.place({ab.a, bc.b, ab.slotA, bc.slotB, edge, true, toA, toC});
    tell({TraceKind::directedEdgePlaced, disc->disc, {ab.a, bc.b, kNone}, kNone, {placed, kNone}});
    formThreeTouchDiscs(placed);
  }

  /// The segment of a DE ends at a vertex, and the DE with it.
  void finish(int index, int vertex, const Vertex& disc) {
    const DirectedEdge& edge = rotations_.edge(index);
    Edge& voronoi = result_.topology.edges[at(edge.edge)];
    (edge.isEnd ? voronoi.end : voronoi.start) = vertex;
    tell({TraceKind::segmentFinished, disc, {edge.a, edge.b, kNone}, vertex, {index, kNone}});
    rotations_.remove(index);
    tell({TraceKind::directedEdgeDeleted, disc, {edge.a, edge.b, kNone}, kNone, {index, kNone}});
  }

  /// The leftover DEs run counter-clockwise along the hull, with the outside to their right.
  void collectHull() {
    auto& hull = result_.topology.hull;
    if (circles_.size() == 1) hull.push_back(0);
    for (const std::vector<int>& cycle : rotations_.cycles()) {
      ++result_.leftoverCycles;
      hull.insert(hull.end(), cycle.begin(), cycle.end());
    }
  }

  void tell(const TraceEvent& event) const {
    if (observer_) observer_(event);
  }

  std::span<const Circle> circles_;
  const Observer& observer_;
  RotationSystem rotations_;
  std::vector<bool> touched_;

  std::vector<AntipodalDisc> discs_;  ///< sorted by radius
  std::priority_queue<Candidate> queue_;
  TouchResult result_;
};

}  // namespace

TouchResult touch(std::span<const Circle> circles, std::span<const Pair> pairs, const Observer& observer,
                  const ProgressCallback& progress) {
  return Touch(circles, pairs, observer).run(progress);
}

}  // namespace circle_voronoi
