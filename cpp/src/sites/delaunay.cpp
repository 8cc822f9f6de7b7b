// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divide and conquer (L. Guibas, J. Stolfi, "Primitives for the manipulation of general subdivisions and the
// computation of Voronoi diagrams", 1985), with cuts across the longer side of each part (R. A. Dwyer, "A faster
// divide-and-conquer algorithm for constructing Delaunay triangulations", 1987), on triangles with a corner at infinity
// beyond each side of the hull (J. R. Shewchuk, "Triangle", 1996). To merge two parts is to join them by one edge and
// then to flip.
#include "delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "circle_voronoi/index.h"
#include "in_circle.h"
#include "mix.h"
#include "perturbed_circle.h"

namespace circle_voronoi {
namespace {

enum class Axis { x, y };

/// The order along an axis: by x, then y; or by y, then -x, which is the same turned by a right angle.
template <Axis axis>
bool isBefore(Point a, Point b) {
  // Without branches, which would often be predicted wrongly.
  if constexpr (axis == Axis::x) return (a.x < b.x) | ((a.x == b.x) & (a.y < b.y));
  return (a.y < b.y) | ((a.y == b.y) & (a.x > b.x));
}

/// Up to so many sites are sorted rather than cut at a sample's median.
constexpr std::size_t kFew = 12;

struct Site {
  Point point;
  int index;
};

struct Box {
  Point low, high;
};

/// Sorts by insertion.
template <class Item, class Before>
void sortFew(std::span<Item> items, Before before) {
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Item item = items[i];
    std::size_t place = i;
    for (; place > 0 && before(item, items[place - 1]); --place) items[place] = items[place - 1];
    items[place] = item;
  }
}

/// About the median of sites along an axis: that of a sample.
template <Axis axis>
Point pivotOf(std::span<const Site> sites) {
  std::array<Point, 27> sample;
  const std::size_t size = sites.size() < 64 ? 3 : sites.size() < 1024 ? 9 : sample.size();
  for (std::size_t i = 0; i < size; ++i) sample[i] = sites[(mix(i) >> 32) * sites.size() >> 32].point;
  sortFew(std::span(sample).first(size), isBefore<axis>);
  return sample[size / 2];
}

/// Moves the sites for which a condition holds to the front and returns their number.
template <class Condition>
std::size_t bringToFront(std::span<Site> sites, Condition condition) {
  std::size_t count = 0;
  for (Site& site : sites) {
    const Site moved = site;
    site = sites[count];
    sites[count] = moved;
    count += condition(moved.point);
  }
  return count;
}

struct Cut {
  std::size_t count;  ///< of the sites before it
  Point at;
};

/// Brings the sites before some pivot to the front, or those up to it if there are none: all of them only if all are
/// equal.
template <Axis axis>
Cut cut(std::span<Site> sites) {
  Point pivot;
  std::size_t count = 0;
  if (sites.size() <= kFew) {
    sortFew(sites, [](const Site& a, const Site& b) { return isBefore<axis>(a.point, b.point); });
    count = sites.size() / 2;
    pivot = sites[count].point;
    while (count > 0 && sites[count - 1].point == pivot) --count;
  } else {
    pivot = pivotOf<axis>(sites);
    count = bringToFront(sites, [pivot](Point p) { return isBefore<axis>(p, pivot); });
  }
  if (count == 0) count = bringToFront(sites, [pivot](Point p) { return !isBefore<axis>(pivot, p); });
  return {count, pivot};
}

class Triangulator {
 public:
  explicit Triangulator(std::span<const Point> points, Done progress = {})
      : progress_(std::move(progress)), representative_(points.size()) {
    if (points.empty()) return;
    std::vector<Site> sites;
    sites.reserve(points.size());
    first_ = sites.data();
    Box box = {points[0], points[0]};
    for (const Point& p : points) {
      sites.push_back({p, static_cast<int>(sites.size())});
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    corners_.reserve(points.size());
    indices_.reserve(points.size());
    toInfinity_.reserve(points.size());
    halfEdges_.reserve(6 * points.size());
    build(sites, box);
  }

  Dual takeDual();
  std::vector<std::array<int, 2>> edges(const Done& progress) const;
  std::vector<int> takeRepresentative() { return std::move(representative_); }
  std::int64_t steps() const { return steps_; }

 private:
  struct HalfEdge {
    int origin;  ///< index into corners_, or kPointAtInfinity
    int twin;
  };

  /// A triangulation of some of the points, by its first and last corner along each axis.
  struct Part {
    int left, right, bottom, top;
  };

  Part build(std::span<Site> sites, const Box& box);
  template <Axis axis>
  Part buildHalves(std::span<Site> sites, const Box& box);
  Part buildFew(std::span<Site> sites);
  Part addCorner(std::span<const Site> sites);
  template <Axis axis>
  Part merge(const Part& a, const Part& b);
  void join(int left, int right);

  /// Tells, if there has been much to do since it was last told, that the sites before these are triangulated.
  void tell(std::span<const Site> sites) {
    if (steps_ < stepsToTell_) return;
    stepsToTell_ = steps_ + kStepsPerReport;
    if (progress_) {
      progress_(static_cast<double>(sites.data() - first_) / static_cast<double>(representative_.size()));
    }
  }

  int addFace(int a, int b, int c) {
    const int h = static_cast<int>(halfEdges_.size());
    halfEdges_.insert(halfEdges_.end(), {{a, kNone}, {b, kNone}, {c, kNone}});
    return h;
  }
  void link(int h, int t) {
    halfEdges_[h].twin = t;
    halfEdges_[t].twin = h;
  }
  int originOf(int h) const { return halfEdges_[h].origin; }
  int twinOf(int h) const { return halfEdges_[h].twin; }

  int orientation(int i, int j, int k) {
    const Point a = corners_[i], b = corners_[j], c = corners_[k];
    const int sign = orientationOf(a, b, c).sign();
    return sign != 0 ? sign : circle_voronoi::orientation(a, b, c);
  }

  /// A corner relative to an origin, and its distance from it, squared.
  struct Lifted {
    double x, y, square;
  };
  static Lifted lift(Point p, Point origin) {
    const double x = p.x - origin.x;
    const double y = p.y - origin.y;
    return {x, y, x * x + y * y};
  }

  /// Whether corners i, j, k are counter-clockwise; b and c are the latter two relative to the first.
  bool isLeftTurn(int i, int j, int k, const Lifted& b, const Lifted& c) {
    const double left = b.x * c.y;
    const double right = b.y * c.x;
    const double error = kOrientationError * (std::abs(left) + std::abs(right)) + kUnderflowError;
    if (left - right > error) return true;
    if (left - right < -error) return false;
    return circle_voronoi::orientation(corners_[i], corners_[j], corners_[k]) > 0;
  }

  /// Whether corner l lies inside the circle through i, j, k, which are counter-clockwise; b, c and d are the latter
  /// three relative to the first.
  bool isInCircle(int i, int j, int k, int l, const Lifted& b, const Lifted& c, const Lifted& d) {
    const double determinant =
        c.square * (b.x * d.y - b.y * d.x) - b.square * (c.x * d.y - c.y * d.x) - d.square * (b.x * c.y - b.y * c.x);
    const double size = b.square + c.square + d.square;
    const double error = kInCircleError * size * size + kUnderflowError;
    if (determinant > error) return true;
    if (determinant < -error) return false;
    return isInPerturbedCircle(corners_[i], corners_[j], corners_[k], corners_[l]);
  }

  static constexpr std::int64_t kStepsPerReport = 1 << 20;

  Done progress_;
  const Site* first_ = nullptr;
  std::int64_t stepsToTell_ = kStepsPerReport;
  std::vector<Point> corners_;   ///< the points without repetitions, those of each part in succession
  std::vector<int> indices_;     ///< of each corner, into the points
  std::vector<int> toInfinity_;  ///< of each first or last corner of a part: its half-edge to infinity, with the hull's
                                 ///< side that begins there on the left; kNone if it is a part by itself
  std::vector<HalfEdge> halfEdges_;
  std::vector<int> representative_;
  std::int64_t steps_ = 0;
};

/// A corner for sites that are all equal.
Triangulator::Part Triangulator::addCorner(std::span<const Site> sites) {
  const int corner = static_cast<int>(corners_.size());
  int first = sites[0].index;
  for (const Site& site : sites) first = std::min(first, site.index);
  for (const Site& site : sites) representative_[site.index] = first;
  corners_.push_back(sites[0].point);
  indices_.push_back(first);
  toInfinity_.push_back(kNone);
  return {corner, corner, corner, corner};
}

/// Adds the sites one by one.
Triangulator::Part Triangulator::buildFew(std::span<Site> sites) {
  sortFew(sites, [](const Site& a, const Site& b) { return isBefore<Axis::x>(a.point, b.point); });
  Part all{};
  for (std::size_t begin = 0, end = 0; begin < sites.size(); begin = end) {
    while (end < sites.size() && sites[end].point == sites[begin].point) ++end;
    const Part corner = addCorner(sites.subspan(begin, end - begin));
    all = begin == 0 ? corner : merge<Axis::x>(all, corner);
  }
  return all;
}

Triangulator::Part Triangulator::build(std::span<Site> sites, const Box& box) {
  if (sites.size() <= 3) return buildFew(sites);
  const bool isWide = box.high.x - box.low.x > box.high.y - box.low.y;
  return isWide ? buildHalves<Axis::x>(sites, box) : buildHalves<Axis::y>(sites, box);
}

template <Axis axis>
Triangulator::Part Triangulator::buildHalves(std::span<Site> sites, const Box& box) {
  const auto [count, border] = cut<axis>(sites);
  steps_ += static_cast<std::int64_t>(sites.size());
  if (count == sites.size()) return addCorner(sites);
  tell(sites);
  Box before = box;
  Box after = box;
  (axis == Axis::x ? before.high.x : before.high.y) = axis == Axis::x ? border.x : border.y;
  (axis == Axis::x ? after.low.x : after.low.y) = axis == Axis::x ? border.x : border.y;
  const Part a = build(sites.first(count), before);
  return merge<axis>(a, build(sites.subspan(count), after));
}

/// Merges two parts, of which the one comes before the other along an axis.
template <Axis axis>
Triangulator::Part Triangulator::merge(const Part& a, const Part& b) {
  if constexpr (axis == Axis::x) {
    join(a.right, b.left);
    return {a.left, b.right, isBefore<Axis::y>(corners_[a.bottom], corners_[b.bottom]) ? a.bottom : b.bottom,
            isBefore<Axis::y>(corners_[a.top], corners_[b.top]) ? b.top : a.top};
  } else {
    join(a.top, b.bottom);
    return {isBefore<Axis::x>(corners_[a.left], corners_[b.left]) ? a.left : b.left,
            isBefore<Axis::x>(corners_[a.right], corners_[b.right]) ? b.right : a.right, a.bottom, b.top};
  }
}

/// Joins two parts at their seam, given the last corner of the one and the first of the other along the axis that the
/// cut between them divides. In the names here that axis goes from left to right, and so the seam is closed from below
/// to above.
void Triangulator::join(int left, int right) {
  constexpr auto next = &Dual::next;
  constexpr auto previous = &Dual::previous;

  // Down along both hulls to the tangent below both parts.
  int atLeft = toInfinity_[left];
  int atRight = toInfinity_[right];
  for (bool isBelow = false; !isBelow;) {
    isBelow = true;
    while (atLeft != kNone) {
      const int before = previous(twinOf(atLeft));
      if (orientation(left, right, originOf(before)) >= 0) break;
      ++steps_;
      atLeft = before;
      left = originOf(before);
    }
    while (atRight != kNone) {
      const int after = originOf(previous(atRight));
      if (orientation(left, right, after) >= 0) break;
      ++steps_;
      atRight = twinOf(next(atRight));
      right = after;
      isBelow = false;
    }
  }

  // The tangent joins the parts, with infinity on both of its sides.
  const int above = addFace(left, right, kPointAtInfinity);
  const int below = addFace(right, left, kPointAtInfinity);
  link(above, below);
  toInfinity_[left] = below + 1;
  if (atLeft == kNone) {
    link(above + 2, below + 1);
  } else {
    link(below + 1, twinOf(atLeft));
    link(above + 2, atLeft);
  }
  if (atRight == kNone) {
    link(above + 1, below + 2);
  } else {
    link(above + 1, twinOf(atRight));
    link(below + 2, atRight);
  }

  // Up the seam: its end is the face (left, right, infinity), `above`, between `seam` below, (u, left, infinity) on the
  // left and (right, w, infinity) on the right. It is linked to them at last.
  int seam = below;
  int atU = twinOf(above + 2);
  int atW = twinOf(above + 1);
  for (;;) {
    ++steps_;
    const Point origin = corners_[left];
    const Lifted r = lift(corners_[right], origin);
    // On the left, while u makes no empty disc with the seam's end, the hull's side from left to u is flipped away.
    int u = originOf(previous(atU));
    Lifted liftedU = lift(corners_[u], origin);
    const bool isLeftOpen = u != right && isLeftTurn(left, right, u, r, liftedU);
    while (isLeftOpen) {
      const int outer = previous(atU);
      const int inner = twinOf(outer);
      const int a = originOf(previous(inner));
      if (a == kPointAtInfinity) break;
      const Lifted liftedA = lift(corners_[a], origin);
      if (!isInCircle(left, right, u, a, r, liftedU, liftedA)) break;
      ++steps_;
      link(outer, twinOf(previous(inner)));
      link(inner, twinOf(next(atU)));
      link(next(atU), previous(inner));
      halfEdges_[outer].origin = a;
      halfEdges_[inner].origin = kPointAtInfinity;
      u = a;
      liftedU = liftedA;
    }
    // On the right likewise.
    int w = originOf(previous(atW));
    Lifted liftedW = lift(corners_[w], origin);
    const bool isRightOpen = w != left && isLeftTurn(left, right, w, r, liftedW);
    while (isRightOpen) {
      const int outer = next(atW);
      const int inner = twinOf(outer);
      const int a = originOf(previous(inner));
      if (a == kPointAtInfinity) break;
      const Lifted liftedA = lift(corners_[a], origin);
      if (!isInCircle(left, right, w, a, r, liftedW, liftedA)) break;
      ++steps_;
      link(outer, twinOf(next(inner)));
      link(inner, twinOf(previous(atW)));
      link(previous(atW), next(inner));
      halfEdges_[previous(atW)].origin = a;
      halfEdges_[next(inner)].origin = kPointAtInfinity;
      w = a;
      liftedW = liftedA;
    }
    if (!isLeftOpen && !isRightOpen) break;
    // Of the edges from left and from right to infinity one is flipped, and the seam ends higher.
    if (!isRightOpen || (isLeftOpen && !isInCircle(left, right, u, w, r, liftedU, liftedW))) {
      const int top = next(atU);
      link(atU, seam);
      halfEdges_[top].origin = right;
      seam = top;
      atU = twinOf(top);
      left = u;
    } else {
      const int top = previous(atW);
      link(atW, seam);
      halfEdges_[atW].origin = left;
      seam = top;
      atW = twinOf(top);
      right = w;
    }
  }
  halfEdges_[above].origin = left;
  halfEdges_[above + 1].origin = right;
  link(above, seam);
  link(above + 1, atW);
  link(above + 2, atU);
  toInfinity_[right] = above + 1;
}

Dual Triangulator::takeDual() {
  corners_ = {};
  toInfinity_ = {};
  const auto indexOf = [&](int h) {
    return originOf(h) == kPointAtInfinity ? kPointAtInfinity : indices_[originOf(h)];
  };
  // Number the faces by their smallest corner, so that the faces around a circle are near in memory.
  const std::size_t faceCount = halfEdges_.size() / 3;
  std::vector<int> first(representative_.size() + 2, 0);
  std::vector<int> placeOf(faceCount);
  for (std::size_t face = 0; face < faceCount; ++face) {
    const int h = static_cast<int>(3 * face);
    placeOf[face] = std::min({indexOf(h), indexOf(h + 1), indexOf(h + 2)}) + 1;
    ++first[placeOf[face] + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  for (int& place : placeOf) place = first[place]++;
  Dual dual;
  dual.origin.resize(halfEdges_.size());
  dual.twin.resize(halfEdges_.size());
  for (std::size_t face = 0; face < faceCount; ++face) {
    for (int i = 0; i < 3; ++i) {
      const int h = static_cast<int>(3 * face) + i;
      const int t = twinOf(h);
      dual.origin[3 * placeOf[face] + i] = indexOf(h);
      dual.twin[3 * placeOf[face] + i] = 3 * placeOf[t / 3] + t % 3;
    }
  }
  return dual;
}

std::vector<std::array<int, 2>> Triangulator::edges(const Done& progress) const {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(halfEdges_.size() / 2);
  forEachIndex(halfEdges_.size(), progress, [&](std::size_t i) {
    const HalfEdge& h = halfEdges_[i];
    // Both halves have different origins unless the edge goes to infinity.
    const int a = h.origin;
    const int b = originOf(h.twin);
    if (a != kPointAtInfinity && a < b) edges.push_back({indices_[a], indices_[b]});
  });
  return edges;
}

}  // namespace

Delaunay delaunay(std::span<const Point> points) {
  Triangulator triangulator(points);
  return {triangulator.takeDual(), triangulator.takeRepresentative(), triangulator.steps()};
}

DelaunayEdges delaunayEdges(std::span<const Point> points, const Done& progress) {
  constexpr double kTriangulated = 0.9;  // of the time, about
  Triangulator triangulator(points, partOf(progress, 0, kTriangulated));
  return {triangulator.edges(partOf(progress, kTriangulated, 1)), triangulator.takeRepresentative()};
}

}  // namespace circle_voronoi
