// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rings. Every candidate pair {a, b} has a slot on a and a slot on b. The slots of a circle are sorted once,
// counter-clockwise, by the direction to the partner, and a directed edge (DE) never leaves the slots of the circles it
// joins: where a three-touch disc replaces DE(a,b) and DE(b,c) by DE(a,c), the latter starts in the slot where DE(a,b)
// started and ends in the slot where DE(b,c) ended. So ties of angles cannot disturb the order of a ring.
//
// A slot holds at most one DE that starts there ("out") and one that ends there ("in"). Seen from the circle, a DE that
// starts looks clockwise for its disc of R_max, one that ends looks counter-clockwise:
//
//              in ──►  unused arc  ◄── out|in ──►  unused arc  ◄── out      (counter-clockwise)
//
// Between an out and the next in lies an arc that is used up (or nothing, where an antipodal disc placed both).
// Two DEs that face each other across an unused arc are parametrically adjacent and may form a three-touch disc.
#include "touch.h"

#include <algorithm>
#include <cstddef>
#include <queue>

#include "angle.h"
#include "slot_set.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

constexpr int kNoEdge = -1;

/// A multiple of the rounding error of a distance, relative to the numbers that it comes from.
constexpr double kRounding = 0x1p-46;

struct AntipodalDisc {
  double radius = 0;
  int a = 0;
  int b = 0;
  int slotA = 0;
  int slotB = 0;
};

/// The DEs that start and end in a slot.
struct Slot {
  int out = kNoEdge;
  int in = kNoEdge;
};

/// A directed edge from circle a to circle b; its Voronoi segment lies to its right (paper, section 2.1).
struct DirectedEdge {
  int a = 0;
  int b = 0;
  int slotA = 0;
  int slotB = 0;
  int edge = 0;        ///< the Voronoi edge that its segment belongs to
  bool isEnd = false;  ///< whether the segment leads to the end of that edge, or to its start
  Vector fromA;        ///< from the centre of a to the centre of the disc of R_min
  Vector fromB;
};

/// A three-touch disc in the queue: DE(a,b) and DE(b,c), parametrically adjacent on b when it was formed.
struct Candidate {
  double radius = 0;
  int first = kNoEdge;
  int second = kNoEdge;

  friend bool operator<(const Candidate& u, const Candidate& v) {  // the queue serves the largest first
    if (u.radius != v.radius) return u.radius > v.radius;
    return u.first != v.first ? u.first > v.first : u.second > v.second;
  }
};

class Touch {
 public:
  Touch(std::span<const Circle> circles, std::span<const Pair> pairs, const Observer& observer)
      : circles_(circles),
        observer_(observer),
        occupied_(2 * pairs.size()),
        slots_(2 * pairs.size()),
        touched_(circles.size(), false) {
    makeSlots(pairs);
    edges_.reserve(2 * pairs.size());
    result_.topology.edges.reserve(3 * circles.size());
    result_.topology.vertexCircles.reserve(2 * circles.size());
  }

  TouchResult run(const std::function<void(double)>& progress) {
    constexpr std::size_t kDiscsPerReport = 1 << 14;
    std::size_t next = 0;
    while (next < discs_.size() || !queue_.empty()) {
      ++result_.events;
      if (next < discs_.size() && (queue_.empty() || discs_[next].radius < queue_.top().radius)) {
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
    __builtin_prefetch(&circles_[disc.a]);
    __builtin_prefetch(&circles_[disc.b]);
    __builtin_prefetch(&slots_[disc.slotA]);
    __builtin_prefetch(&slots_[disc.slotB]);
  }

  void prepare(const Candidate& candidate) const {
    __builtin_prefetch(&edges_[candidate.first]);
    __builtin_prefetch(&edges_[candidate.second]);
  }

  // --- slots and rings ---

  void makeSlots(std::span<const Pair> pairs) {
    const int n = static_cast<int>(circles_.size());
    firstSlot_.assign(n + 1, 0);
    for (const auto& [a, b] : pairs) {
      ++firstSlot_[a + 1];
      ++firstSlot_[b + 1];
    }
    for (int i = 0; i < n; ++i) firstSlot_[i + 1] += firstSlot_[i];

    struct Spoke {
      double angle;
      int disc;
      bool atB;
    };
    std::vector<Spoke> spokes(2 * pairs.size());
    std::vector<int> fill(firstSlot_.begin(), firstSlot_.end() - 1);
    discs_.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const Vector v = between(circles_[a], circles_[b]);
      discs_[i] = {(length(v) - circles_[a].r - circles_[b].r) / 2, a, b, 0, 0};
      spokes[fill[a]++] = {pseudoAngle(v), static_cast<int>(i), false};
      spokes[fill[b]++] = {pseudoAngle({-v.x, -v.y}), static_cast<int>(i), true};
    }
    for (int i = 0; i < n; ++i) {
      std::sort(spokes.begin() + firstSlot_[i], spokes.begin() + firstSlot_[i + 1], [](const Spoke& s, const Spoke& t) {
        return s.angle != t.angle ? s.angle < t.angle : s.disc < t.disc;
      });
    }
    for (std::size_t slot = 0; slot < spokes.size(); ++slot) {
      AntipodalDisc& disc = discs_[spokes[slot].disc];
      (spokes[slot].atB ? disc.slotB : disc.slotA) = static_cast<int>(slot);
    }
    std::sort(discs_.begin(), discs_.end(), [](const AntipodalDisc& s, const AntipodalDisc& t) {
      if (s.radius != t.radius) return s.radius < t.radius;
      return s.a != t.a ? s.a < t.a : s.b < t.b;
    });
  }

  /// The occupied slot of circle i that follows `slot` counter-clockwise, `slot` itself last; SlotSet::kNoSlot if none.
  std::ptrdiff_t slotAfter(int i, int slot) const {
    const std::ptrdiff_t found = occupied_.firstIn(slot + 1, firstSlot_[i + 1]);
    return found != SlotSet::kNoSlot ? found : occupied_.firstIn(firstSlot_[i], slot + 1);
  }

  std::ptrdiff_t slotBefore(int i, int slot) const {
    const std::ptrdiff_t found = occupied_.lastIn(firstSlot_[i], slot);
    return found != SlotSet::kNoSlot ? found : occupied_.lastIn(slot, firstSlot_[i + 1]);
  }

  /// The DE that faces the end of `edge` across the unused arc of circle b, kNoEdge if there is none.
  int adjacentAfter(const DirectedEdge& edge) const { return slots_[slotAfter(edge.b, edge.slotB)].out; }

  /// The DE that faces the start of `edge` across the unused arc of circle a.
  int adjacentBefore(const DirectedEdge& edge) const { return slots_[slotBefore(edge.a, edge.slotA)].in; }

  bool isAlive(int edge) const { return slots_[edges_[edge].slotA].out == edge; }

  int place(const DirectedEdge& edge) {
    const int index = static_cast<int>(edges_.size());
    edges_.push_back(edge);
    slots_[edge.slotA].out = index;
    slots_[edge.slotB].in = index;
    occupied_.insert(edge.slotA);
    occupied_.insert(edge.slotB);
    return index;
  }

  void remove(int index) {
    const DirectedEdge& edge = edges_[index];
    slots_[edge.slotA].out = kNoEdge;
    slots_[edge.slotB].in = kNoEdge;
    for (const int slot : {edge.slotA, edge.slotB}) {
      if (slots_[slot].out == kNoEdge && slots_[slot].in == kNoEdge) occupied_.erase(slot);
    }
  }

  // --- antipodal discs (Algorithm 2) ---

  Vertex discOf(const AntipodalDisc& disc) const {
    const Circle& a = circles_[disc.a];
    const Vector v = between(a, circles_[disc.b]);
    const double part = (a.r + disc.radius) / length(v);
    return {a.x + part * v.x, a.y + part * v.y, disc.radius};
  }

  /// Whether the arc of circle i at `slot`, in the given direction to its partner, is already used for the diagram.
  bool isUsed(int i, int slot, int partner, Vector direction) const {
    if (!touched_[i]) return false;
    const std::ptrdiff_t before = slotBefore(i, slot);
    if (before == SlotSet::kNoSlot) return true;
    const std::ptrdiff_t after = slotAfter(i, slot);
    const int in = slots_[before].in;
    const int out = slots_[after].out;
    if (in == kNoEdge || out == kNoEdge) return true;
    // No disc on the bisector is smaller than the antipodal one: if a DE of the two circles is there before it, then
    // the two differ by rounding only, and that DE stands for both.
    if (edges_[in].a == partner || edges_[out].b == partner) return true;
    const Vector from = edges_[in].fromB;
    const Vector to = edges_[out].fromA;
    // The two DEs of one antipodal disc that is alone on the circle leave all of it unused but its footpoint.
    if (before == after && from.x == to.x && from.y == to.y)
      return cross(from, direction) == 0 && dot(from, direction) > 0;
    // A footpoint that touches a used arc counts as used.
    return !strictlyBetween(from, direction, to);
  }

  /// A circle next to the footpoint at `slot` of circle i that meets or touches the disc, or kNone (paper,
  /// section 3.3).
  ///
  /// A circle that touches an antipodal disc makes it a three-touch disc, which places the same DEs. Taking touching
  /// for meeting leaves ties to those: two antipodal discs of opposite circles around one disc would cross.
  int meetingCircle(int i, int slot, const Vertex& disc) const {
    if (!touched_[i]) return kNone;
    for (const int near : {edges_[slots_[slotBefore(i, slot)].in].a, edges_[slots_[slotAfter(i, slot)].out].b}) {
      const Circle& c = circles_[near];
      const Vector v = {disc.x - c.x, disc.y - c.y};
      const double distance = length(v);
      const double rounding = kRounding * (distance + c.r + std::abs(disc.x) + std::abs(disc.y));
      if (distance - c.r <= disc.radius + rounding) return near;
    }
    return kNone;
  }

  void processAntipodalDisc(const AntipodalDisc& antipodal) {
    const auto& [radius, a, b, slotA, slotB] = antipodal;
    const Vector v = between(circles_[a], circles_[b]);
    const Vector back = {-v.x, -v.y};
    const Vertex disc = discOf(antipodal);
    if (isUsed(a, slotA, b, v) || isUsed(b, slotB, a, back)) {
      tell({TraceKind::antipodalDiscUsed, disc, {a, b, kNone}});
      return;
    }
    int meeting = meetingCircle(a, slotA, disc);
    if (meeting == kNone) meeting = meetingCircle(b, slotB, disc);
    if (meeting != kNone) {
      tell({TraceKind::antipodalDiscNotEmpty, disc, {a, b, meeting}});
      return;
    }
    tell({TraceKind::antipodalDiscAccepted, disc, {a, b, kNone}});
    touched_[a] = true;
    touched_[b] = true;
    // Going along the segment of DE(a,b), b is on the left.
    const int edge = static_cast<int>(result_.topology.edges.size());
    result_.topology.edges.push_back({b, a, kNone, kNone});
    const int forth = place({a, b, slotA, slotB, edge, true, v, back});
    const int reverse = place({b, a, slotB, slotA, edge, false, back, v});
    for (const int placed : {forth, reverse}) {
      tell({TraceKind::directedEdgePlaced, disc, {edges_[placed].a, edges_[placed].b, kNone}});
    }
    for (const int placed : {forth, reverse}) formThreeTouchDiscs(placed);
  }

  // --- three-touch discs (Algorithm 3) ---

  /// Whether a disc lies ahead of the disc of R_min of `edge` on the bisector, or at it: forward, to the right of the
  /// DE. `toCentreA` and `toCentreB` lead from the centres of its circles to the centre of the disc.
  bool isForward(const DirectedEdge& edge, Vector toCentreA, Vector toCentreB) const {
    // The smaller circle sees the whole bisector within less than a full turn around the direction of the larger one.
    const Vector axis = between(circles_[edge.a], circles_[edge.b]);
    return circles_[edge.a].r <= circles_[edge.b].r ? compareAngles(axis, edge.fromA, toCentreA) <= 0
                                                    : compareAngles({-axis.x, -axis.y}, edge.fromB, toCentreB) >= 0;
  }

  void formThreeTouchDiscs(int index) {
    const int before = adjacentBefore(edges_[index]);
    const int after = adjacentAfter(edges_[index]);
    if (before != kNoEdge) formThreeTouchDisc(before, index);
    if (after != kNoEdge) formThreeTouchDisc(index, after);
  }

  void formThreeTouchDisc(int first, int second) {
    const DirectedEdge& ab = edges_[first];
    const DirectedEdge& bc = edges_[second];
    if (bc.b == ab.a) return;
    // The disc lies to the right of a -> b -> c: these are clockwise around it.
    const auto disc = threeTouchDisc(circles_[ab.a], circles_[bc.b], circles_[ab.b]);
    if (!disc) return;
    const auto& [toA, toC, toB] = disc->toCentre;
    if (!isForward(ab, toA, toB) || !isForward(bc, toB, toC)) return;
    ++result_.threeTouchDiscs;
    queue_.push({disc->disc.radius, first, second});
    tell({TraceKind::threeTouchDiscFormed, disc->disc, {ab.a, ab.b, bc.b}});
  }

  void processThreeTouchDisc(const Candidate& candidate) {
    const auto& [radius, first, second] = candidate;
    const DirectedEdge ab = edges_[first];
    const DirectedEdge bc = edges_[second];
    const bool isStale = !isAlive(first) || !isAlive(second) || adjacentAfter(ab) != second;
    if (isStale && !observer_) return;
    const auto disc = threeTouchDisc(circles_[ab.a], circles_[bc.b], circles_[ab.b]);
    if (isStale) {
      tell({TraceKind::threeTouchDiscStale, disc->disc, {ab.a, ab.b, bc.b}});
      return;
    }
    const int vertex = static_cast<int>(result_.topology.vertexCircles.size());
    result_.topology.vertexCircles.push_back({ab.a, bc.b, ab.b});
    tell({TraceKind::branchDisc, disc->disc, {ab.a, ab.b, bc.b}, vertex});

    const auto& [toA, toC, toB] = disc->toCentre;
    int third = adjacentAfter(bc);
    if (third != kNoEdge) {
      // DE(c,a) closes the triangle only if it faces both others; another DE between c and a belongs to another
      // branch point.
      const DirectedEdge& ca = edges_[third];
      if (ca.b != ab.a || adjacentAfter(ca) != first || !isForward(ca, toC, toA)) third = kNoEdge;
    }
    finish(first, vertex, disc->disc);
    finish(second, vertex, disc->disc);
    if (third != kNoEdge) {
      finish(third, vertex, disc->disc);
      return;
    }
    const int edge = static_cast<int>(result_.topology.edges.size());
    result_.topology.edges.push_back({bc.b, ab.a, vertex, kNone});
    const int placed = place({ab.a, bc.b, ab.slotA, bc.slotB, edge, true, toA, toC});
    tell({TraceKind::directedEdgePlaced, disc->disc, {ab.a, bc.b, kNone}});
    formThreeTouchDiscs(placed);
  }

  /// The segment of a DE ends at a vertex, and the DE with it.
  void finish(int index, int vertex, const Vertex& disc) {
    const DirectedEdge& edge = edges_[index];
    Edge& voronoi = result_.topology.edges[edge.edge];
    (edge.isEnd ? voronoi.end : voronoi.start) = vertex;
    tell({TraceKind::segmentFinished, disc, {edge.a, edge.b, kNone}, vertex});
    remove(index);
    tell({TraceKind::directedEdgeDeleted, disc, {edge.a, edge.b, kNone}});
  }

  // --- leftover directed edges ---

  /// The leftover DEs run counter-clockwise along the hull, with the outside to their right.
  void collectHull() {
    auto& hull = result_.topology.hull;
    if (circles_.size() == 1) hull.push_back(0);
    std::vector<bool> seen(edges_.size(), false);
    for (int i = 0; i < static_cast<int>(circles_.size()); ++i) {
      for (int slot = firstSlot_[i]; slot < firstSlot_[i + 1]; ++slot) {
        int index = slots_[slot].out;
        if (index == kNoEdge || seen[index]) continue;
        ++result_.leftoverCycles;
        while (index != kNoEdge && !seen[index]) {
          seen[index] = true;
          hull.push_back(edges_[index].a);
          index = adjacentAfter(edges_[index]);
        }
      }
    }
  }

  void tell(const TraceEvent& event) const {
    if (observer_) observer_(event);
  }

  std::span<const Circle> circles_;
  const Observer& observer_;

  std::vector<int> firstSlot_;  ///< of each circle; the slots of circle i end where those of i + 1 begin
  SlotSet occupied_;
  std::vector<Slot> slots_;
  std::vector<bool> touched_;

  std::vector<AntipodalDisc> discs_;  ///< sorted by radius
  std::priority_queue<Candidate> queue_;
  std::vector<DirectedEdge> edges_;
  TouchResult result_;
};

}  // namespace

TouchResult touch(std::span<const Circle> circles, std::span<const Pair> pairs, const Observer& observer,
                  const std::function<void(double)>& progress) {
  return Touch(circles, pairs, observer).run(progress);
}

}  // namespace circle_voronoi
