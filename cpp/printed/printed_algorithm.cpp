// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_algorithm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "angle.h"
#include "circle_voronoi/curve.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

/// A full turn of `pseudoAngle`, and the largest difference at which two angles or lengths count as equal.
constexpr double kTurn = 4;
constexpr double kNear = 0x1p-30;
constexpr int kNothing = -1;

/// The counter-clockwise angle from `from` to `angle`: at least 0, less than a full turn, and 0 if the two are equal.
double turnTo(double from, double angle) {
  double turn = angle - from;
  if (turn < 0) turn += kTurn;
  return turn > kTurn - kNear || turn < kNear ? 0 : turn;
}

Vector minus(Vector v) { return {-v.x, -v.y}; }

/// A disc of the list L: an antipodal disc of circles 0 and 1, or the three-touch disc of directed edges 0 to 1, 1 to 2
/// and 2 to 0.
struct Listed {
  Vertex disc;
  std::array<int, 3> circles = {kNothing, kNothing, kNothing};
  std::array<int, 3> edges = {kNothing, kNothing, kNothing};  ///< the edges from which a three-touch disc was formed
  std::int64_t order = 0;

  friend bool operator<(const Listed& u, const Listed& v) {  // the queue serves the largest first
    return u.disc.r != v.disc.r ? u.disc.r > v.disc.r : u.order > v.order;
  }
};

class Printed {
 public:
  Printed(std::span<const Circle> circles, std::span<const Pair> pairs, const AsPrinted& rules)
      : circles_(circles), rules_(rules), used_(circles.size()), around_(circles.size()) {
    for (const auto& [a, b] : pairs) listAntipodalDisc(a, b);
  }

  PrintedResult run() {
    while (!list_.empty()) {
      const Listed first = list_.top();
      list_.pop();
      if (first.circles[2] == kNothing) {
        processAntipodalDisc(first);
      } else {
        processThreeTouchDisc(first);
      }
    }
    finishLeftover();
    return std::move(result_);
  }

 private:
  /// An arc of a circle that is used for the diagram, counter-clockwise.
  struct Arc {
    double from = 0;
    double size = 0;
  };

  const Circle& circle(int i) const { return circles_[i]; }
  PrintedEdge& edge(int index) { return edges_[index]; }

  void list(Listed disc) {
    disc.order = next_++;
    list_.push(disc);
  }

  // --- Algorithm 2 ---

  void listAntipodalDisc(int a, int b) {
    const Vector v = between(circle(a), circle(b));
    const double distance = length(v);
    if (distance == 0) return;  // concentric circles have no line of centers
    const double radius = (distance - circle(a).r - circle(b).r) / 2;
    const double part = (circle(a).r + radius) / distance;
    list({{circle(a).x + part * v.x, circle(a).y + part * v.y, radius}, {a, b, kNothing}});
  }

  bool isUsed(int i, Vector direction) const {
    const double angle = pseudoAngle(direction);
    return std::ranges::any_of(used_[i], [&](const Arc& arc) { return turnTo(arc.from, angle) <= arc.size + kNear; });
  }

  /// The directed edges next to a direction on circle i, one way or the other.
  std::vector<int> closeTo(int i, Vector direction, int except) {
    const double angle = pseudoAngle(direction);
    struct Near {
      int index;
      double forth;
      double back;
    };
    std::vector<Near> near;
    double leastForth = kTurn;
    double leastBack = kTurn;
    for (const int index : around_[i]) {
      const PrintedEdge& other = edge(index);
      if (!other.isAlive || (except != kNothing && other.voronoiEdge == edge(except).voronoiEdge)) continue;
      const double its = pseudoAngle(other.a == i ? other.fromA : other.fromB);
      near.push_back({index, turnTo(angle, its), turnTo(its, angle)});
      leastForth = std::min(leastForth, near.back().forth);
      leastBack = std::min(leastBack, near.back().back);
    }
    std::vector<int> close;
    for (const auto& [index, forth, back] : near) {
      if (forth <= leastForth + kNear || back <= leastBack + kNear) close.push_back(index);
    }
    return close;
  }

  bool isEmpty(const Listed& antipodal, Vector v) {
    if (rules_.crossing && antipodal.disc.r < 0) return true;
    const double reach = antipodal.disc.r - kNear * std::abs(antipodal.disc.r);
    for (const auto& [i, direction] : {std::pair{antipodal.circles[0], v}, std::pair{antipodal.circles[1], minus(v)}}) {
      for (const int index : closeTo(i, direction, kNothing)) {
        const int near = edge(index).a == i ? edge(index).b : edge(index).a;
        if (near == antipodal.circles[0] || near == antipodal.circles[1]) continue;
        const double distance = length({antipodal.disc.x - circle(near).x, antipodal.disc.y - circle(near).y});
        if (distance - circle(near).r < reach) return false;
      }
    }
    return true;
  }

  void processAntipodalDisc(const Listed& antipodal) {
    const auto [a, b, none] = antipodal.circles;
    const Vector v = between(circle(a), circle(b));
    if (isUsed(a, v) || isUsed(b, minus(v)) || !isEmpty(antipodal, v)) return;
    const int voronoi = static_cast<int>(result_.diagram.edges.size());
    result_.diagram.edges.push_back({b, a, kNone, kNone});
    const int forth = place({a, b, antipodal.disc, v, minus(v), true, voronoi, true});
    const int back = place({b, a, antipodal.disc, minus(v), v, true, voronoi, false});
    formThreeTouchDiscs(forth);
    formThreeTouchDiscs(back);
  }

  // --- Algorithm 3 ---

  int place(const PrintedEdge& placed) {
    const int index = static_cast<int>(edges_.size());
    edges_.push_back(placed);
    around_[placed.a].push_back(index);
    around_[placed.b].push_back(index);
    return index;
  }

  Point foot(int i, Vector direction) const {
    const double size = length(direction);
    const double part = size == 0 ? 0 : circle(i).r / size;
    return {circle(i).x + part * direction.x, circle(i).y + part * direction.y};
  }

  /// "The center lies at the right side of the directed edge."
  bool isRight(const PrintedEdge& de, const Vertex& disc) const {
    const Point start = de.isAntipodal ? Point{circle(de.a).x, circle(de.a).y} : foot(de.a, de.fromA);
    const Point end = de.isAntipodal ? Point{circle(de.b).x, circle(de.b).y} : foot(de.b, de.fromB);
    const Vector along = {end.x - start.x, end.y - start.y};
    const Vector to = {disc.x - start.x, disc.y - start.y};
    return cross(along, to) <= kNear * length(along) * length(to);
  }

  /// Returns the position of a disc's center along the border right of a directed edge.
  double along(const PrintedEdge& de, const Vertex& disc) const {
    return parameterAt(bisector(circle(de.b), circle(de.a)), {disc.x, disc.y});
  }

  bool isAhead(const PrintedEdge& de, const Vertex& disc) const {
    return along(de, disc) >= along(de, de.disc) * (1 - kNear);
  }

  bool continues(const PrintedEdge& de, const Vertex& disc) const {
    return rules_.side ? isRight(de, disc) : isAhead(de, disc);
  }

  void formThreeTouchDiscs(int index) {
    const PrintedEdge placed = edge(index);
    for (const int close : closeTo(placed.b, placed.fromB, index)) {
      if (edge(close).a == placed.b) formThreeTouchDisc(index, close);
    }
    for (const int close : closeTo(placed.a, placed.fromA, index)) {
      if (edge(close).b == placed.a) formThreeTouchDisc(close, index);
    }
  }

  void formThreeTouchDisc(int first, int second) {
    const auto [a, b, c] = std::array{edge(first).a, edge(first).b, edge(second).b};
    if (c == a) return;
    const auto disc = threeTouchDisc(circle(a), circle(c), circle(b));
    if (!disc || (rules_.inside && disc->disc.r < 0)) return;
    if (continues(edge(first), disc->disc) && continues(edge(second), disc->disc)) {
      list({disc->disc, {a, b, c}, {first, second, kNothing}});
    }
  }

  /// Returns a directed edge from circle a to circle b: the preferred one if it exists, otherwise any.
  int find(int preferred, int a, int b) {
    if (preferred != kNothing && edge(preferred).isAlive) return preferred;
    for (const int index : around_[a]) {
      if (edge(index).isAlive && edge(index).a == a && edge(index).b == b) return index;
    }
    return kNothing;
  }

  /// Returns the directed edge from circle a to circle b whose border reaches a disc first.
  int findBehind(int a, int b, const Vertex& disc) {
    int last = kNothing;
    for (const int index : around_[a]) {
      const PrintedEdge& de = edge(index);
      if (!de.isAlive || de.a != a || de.b != b || !isAhead(de, disc)) continue;
      if (last == kNothing || along(de, de.disc) > along(de, edge(last).disc)) last = index;
    }
    return last;
  }

  bool isInsideUsed(int i, Vector direction) const {
    const double angle = pseudoAngle(direction);
    return std::ranges::any_of(used_[i], [&](const Arc& arc) {
      const double turn = turnTo(arc.from, angle);
      return turn > kNear && turn < arc.size - kNear;
    });
  }

  bool isCovered(const PrintedEdge& de) const { return isInsideUsed(de.a, de.fromA) || isInsideUsed(de.b, de.fromB); }

  Vector toCenter(int i, const Vertex& disc) const { return {disc.x - circle(i).x, disc.y - circle(i).y}; }

  void use(int i, Vector from, Vector to) {
    const double start = pseudoAngle(from);
    const double size = turnTo(start, pseudoAngle(to));
    if (size > 0) used_[i].push_back({start, size});
  }

  void finish(int index, int vertex, const Vertex& disc) {
    PrintedEdge& de = edge(index);
    use(de.a, toCenter(de.a, disc), de.fromA);
    use(de.b, de.fromB, toCenter(de.b, disc));
    Edge& voronoi = result_.diagram.edges[de.voronoiEdge];
    (de.isEnd ? voronoi.end : voronoi.start) = vertex;
    result_.segments.push_back({de.a, de.b, de.disc, disc});
    de.isAlive = false;
  }

  void processThreeTouchDisc(const Listed& listed) {
    const auto [a, b, c] = listed.circles;
    const int third = rules_.third ? find(kNothing, c, a) : findBehind(c, a, listed.disc);
    std::array<int, 3> own = {find(listed.edges[0], a, b), find(listed.edges[1], b, c), third};
    for (int& index : own) {
      if (index == kNothing || !isCovered(edge(index))) continue;
      edge(index).isAlive = false;
      index = kNothing;
    }
    if (std::ranges::count(own, kNothing) > 1) return;
    const int vertex = static_cast<int>(result_.diagram.vertices.size());
    result_.diagram.vertices.push_back(listed.disc);
    result_.diagram.vertexCircles.push_back({a, c, b});
    for (const int index : own) {
      if (index != kNothing) finish(index, vertex, listed.disc);
    }
    const auto missing = std::ranges::find(own, kNothing);
    if (missing == own.end()) return;
    // The directed edge with the same circles in the other direction.
    const std::size_t k = static_cast<std::size_t>(missing - own.begin());
    const int to = listed.circles[k];
    const int from = listed.circles[(k + 1) % 3];
    const int voronoi = static_cast<int>(result_.diagram.edges.size());
    result_.diagram.edges.push_back({to, from, vertex, kNone});
    formThreeTouchDiscs(
        place({from, to, listed.disc, toCenter(from, listed.disc), toCenter(to, listed.disc), false, voronoi, true}));
  }

  /// Directed edges that are covered have no Voronoi edges: they were placed, but have no segment.
  void finishLeftover() {
    auto& voronoi = result_.diagram.edges;
    std::vector<int> segments(voronoi.size(), 0);
    for (const PrintedEdge& de : edges_) {
      const Edge& its = voronoi[de.voronoiEdge];
      const bool isFinished = (de.isEnd ? its.end : its.start) != kNone;
      const bool isLeft = de.isAlive && !isCovered(de);
      if (isFinished || isLeft) ++segments[de.voronoiEdge];
      if (isLeft) result_.leftover.push_back(de);
    }
    std::vector<Edge> kept;
    for (std::size_t e = 0; e < voronoi.size(); ++e) {
      if (segments[e] > 0) kept.push_back(voronoi[e]);
    }
    voronoi = std::move(kept);
  }

  std::span<const Circle> circles_;
  AsPrinted rules_;
  std::vector<std::vector<Arc>> used_;
  std::vector<std::vector<int>> around_;  ///< the directed edges that were placed at each circle
  std::vector<PrintedEdge> edges_;
  std::priority_queue<Listed> list_;
  std::int64_t next_ = 0;
  PrintedResult result_;
};

}  // namespace

PrintedResult runPrinted(std::span<const Circle> circles, std::span<const Pair> pairs, const AsPrinted& rules) {
  return Printed(circles, pairs, rules).run();
}

}  // namespace circle_voronoi
