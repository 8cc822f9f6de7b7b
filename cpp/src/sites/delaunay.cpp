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

#include "circle_voronoi/none.h"
#include "perturbed_tests.h"

namespace circle_voronoi {
namespace {

// Filters by J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997,
// section 4, as in in_circle.cpp.
constexpr double kTiny = 0x1p-500;
constexpr double kOrientationError = 3.01 * 0x1p-53;
constexpr double kInCircleError = 10.01 * 0x1p-53;

enum class Axis { x, y };

/// The order along an axis: by x, then y; or by y, then -x, which is the same turned by a right angle.
template <Axis axis>
bool isBefore(Point a, Point b) {
  // Without branches, which would often be predicted wrongly.
  if constexpr (axis == Axis::x) return (a.x < b.x) | ((a.x == b.x) & (a.y < b.y));
  return (a.y < b.y) | ((a.y == b.y) & (a.x > b.x));
}

struct Site {
  Point point;
  int index;
};

struct Box {
  Point low, high;
};

/// A fixed mixing of a number (splitmix64), in place of a random one.
std::uint64_t mix(std::uint64_t i) {
  i += 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return i ^ (i >> 31);
}

/// About the median along an axis: that of some sites, or of all if there are few.
template <Axis axis>
Point pivotOf(std::span<const Site> sites) {
  std::array<Point, 27> sample;
  const std::size_t size = sites.size() < 10 ? sites.size() : sites.size() < 200 ? 9 : sample.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Point p = sites[sites.size() == size ? i : mix(i) % sites.size()].point;
    std::size_t place = i;
    for (; place > 0 && isBefore<axis>(p, sample[place - 1]); --place) sample[place] = sample[place - 1];
    sample[place] = p;
  }
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

/// Brings the sites before a pivot to the front, or those up to it if there are none, and returns their number.
template <Axis axis>
std::size_t cut(std::span<Site> sites, Point pivot) {
  const std::size_t before = bringToFront(sites, [pivot](Point p) { return isBefore<axis>(p, pivot); });
  return before > 0 ? before : bringToFront(sites, [pivot](Point p) { return !isBefore<axis>(pivot, p); });
}

class Triangulator {
 public:
  explicit Triangulator(std::span<const Point> points) : tests_(points), representative_(points.size()) {
    if (points.empty()) return;
    std::vector<Site> sites;
    sites.reserve(points.size());
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

  Dual dual() const;
  std::vector<std::array<int, 2>> edges() const;
  std::vector<int> takeRepresentative() { return std::move(representative_); }
  std::int64_t steps() const { return steps_; }

 private:
  struct HalfEdge {
    int origin;  ///< index into corners_, or kInfinity
    int twin;
  };

  /// A triangulation of some of the points, by its first and last corner along each axis.
  struct Part {
    int left, right, bottom, top;
  };

  Part build(std::span<Site> sites, const Box& box);
  template <Axis axis>
  Part buildHalves(std::span<Site> sites, const Box& box);
  Part addCorner(std::span<Site> sites);
  void merge(int left, int right);

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
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    const double error = kOrientationError * (std::abs(left) + std::abs(right)) + kTiny;
    if (determinant > error) return 1;
    if (determinant < -error) return -1;
    return tests_.orientation(a, b, c);
  }

  /// Whether corner l lies inside the circle through i, j, k, which are counter-clockwise.
  bool isInCircle(int i, int j, int k, int l) {
    const Point a = corners_[i], b = corners_[j], c = corners_[k], d = corners_[l];
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay;
    const double bb = bx * bx + by * by;
    const double cc = cx * cx + cy * cy;
    const double determinant = aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
    const double size = aa + bb + cc;
    const double error = kInCircleError * size * size + kTiny;
    if (determinant > error) return true;
    if (determinant < -error) return false;
    return tests_.isInCircle(a, b, c, d);
  }

  PerturbedTests tests_;
  std::vector<Point> corners_;   ///< the points without repetitions, those of each part in succession
  std::vector<int> indices_;     ///< of each corner, into the points
  std::vector<int> toInfinity_;  ///< of each first or last corner of a part: its half-edge to infinity, with the hull's
                                 ///< side that begins there on the left; kNone if it is a part by itself
  std::vector<HalfEdge> halfEdges_;
  std::vector<int> representative_;
  std::int64_t steps_ = 0;
};

/// A corner for sites that are all equal.
Triangulator::Part Triangulator::addCorner(std::span<Site> sites) {
  const int corner = static_cast<int>(corners_.size());
  int first = sites[0].index;
  for (const Site& site : sites) first = std::min(first, site.index);
  for (const Site& site : sites) representative_[site.index] = first;
  corners_.push_back(sites[0].point);
  indices_.push_back(first);
  toInfinity_.push_back(kNone);
  return {corner, corner, corner, corner};
}

Triangulator::Part Triangulator::build(std::span<Site> sites, const Box& box) {
  if (sites.size() == 1) return addCorner(sites);
  const bool isWide = box.high.x - box.low.x > box.high.y - box.low.y;
  return isWide ? buildHalves<Axis::x>(sites, box) : buildHalves<Axis::y>(sites, box);
}

template <Axis axis>
Triangulator::Part Triangulator::buildHalves(std::span<Site> sites, const Box& box) {
  const Point pivot = pivotOf<axis>(sites);
  const std::size_t count = cut<axis>(sites, pivot);
  steps_ += static_cast<std::int64_t>(sites.size());
  if (count == sites.size()) return addCorner(sites);
  Box before = box;
  Box after = box;
  (axis == Axis::x ? before.high.x : before.high.y) = axis == Axis::x ? pivot.x : pivot.y;
  (axis == Axis::x ? after.low.x : after.low.y) = axis == Axis::x ? pivot.x : pivot.y;
  const Part a = build(sites.first(count), before);
  const Part b = build(sites.subspan(count), after);
  if constexpr (axis == Axis::x) {
    merge(a.right, b.left);
    return {a.left, b.right, isBefore<Axis::y>(corners_[a.bottom], corners_[b.bottom]) ? a.bottom : b.bottom,
            isBefore<Axis::y>(corners_[a.top], corners_[b.top]) ? b.top : a.top};
  } else {
    merge(a.top, b.bottom);
    return {isBefore<Axis::x>(corners_[a.left], corners_[b.left]) ? a.left : b.left,
            isBefore<Axis::x>(corners_[a.right], corners_[b.right]) ? b.right : a.right, a.bottom, b.top};
  }
}

/// Merges two parts, given the last corner of the one and the first of the other along the axis that the cut between
/// them divides. In the names here that axis goes from left to right, and so the seam is closed from below to above.
void Triangulator::merge(int left, int right) {
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
  const int above = addFace(left, right, kInfinity);
  const int below = addFace(right, left, kInfinity);
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

  // Up the seam, `above` is the face (left, right, infinity) at its end.
  for (;;) {
    ++steps_;
    // On the left: the face (u, left, infinity). While its corner u makes no empty disc with the seam's end, the hull's
    // side from left to u is flipped away.
    const int atU = twinOf(above + 2);
    int u = originOf(previous(atU));
    const bool isLeftOpen = u != right && orientation(left, right, u) > 0;
    if (isLeftOpen) {
      const int outer = previous(atU);
      for (;;) {
        const int inner = twinOf(outer);
        const int a = originOf(previous(inner));
        if (a == kInfinity || !isInCircle(left, right, u, a)) break;
        ++steps_;
        link(outer, twinOf(previous(inner)));
        link(inner, twinOf(next(atU)));
        link(next(atU), previous(inner));
        halfEdges_[outer].origin = a;
        halfEdges_[inner].origin = kInfinity;
        u = a;
      }
    }
    // On the right likewise: the face (right, w, infinity).
    const int atW = twinOf(above + 1);
    int w = originOf(previous(atW));
    const bool isRightOpen = w != left && orientation(left, right, w) > 0;
    if (isRightOpen) {
      const int outer = next(atW);
      for (;;) {
        const int inner = twinOf(outer);
        const int a = originOf(previous(inner));
        if (a == kInfinity || !isInCircle(left, right, w, a)) break;
        ++steps_;
        link(outer, twinOf(next(inner)));
        link(inner, twinOf(previous(atW)));
        link(previous(atW), next(inner));
        halfEdges_[previous(atW)].origin = a;
        halfEdges_[next(inner)].origin = kInfinity;
        if (toInfinity_[w] == previous(atW)) toInfinity_[w] = inner;
        w = a;
      }
    }
    if (!isLeftOpen && !isRightOpen) break;
    // Of the edges left to infinity and right to infinity one is flipped, and the seam ends higher.
    const int seam = twinOf(above);
    if (!isRightOpen || (isLeftOpen && !isInCircle(left, right, u, w))) {
      link(above + 2, twinOf(next(atU)));
      link(atU, seam);
      link(next(atU), above);
      halfEdges_[next(atU)].origin = right;
      halfEdges_[above].origin = u;
      left = u;
    } else {
      link(above + 1, twinOf(previous(atW)));
      link(atW, seam);
      link(previous(atW), above);
      halfEdges_[atW].origin = left;
      halfEdges_[above + 1].origin = w;
      right = w;
    }
  }
  toInfinity_[right] = above + 1;
}

Dual Triangulator::dual() const {
  const auto indexOf = [&](int h) { return originOf(h) == kInfinity ? kInfinity : indices_[originOf(h)]; };
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

std::vector<std::array<int, 2>> Triangulator::edges() const {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(halfEdges_.size() / 2);
  for (const HalfEdge& h : halfEdges_) {
    // Both halves have different origins unless the edge goes to infinity.
    const int a = h.origin;
    const int b = originOf(h.twin);
    if (a != kInfinity && a < b) edges.push_back({indices_[a], indices_[b]});
  }
  return edges;
}

}  // namespace

Delaunay delaunay(std::span<const Point> points) {
  Triangulator triangulator(points);
  return {triangulator.dual(), triangulator.takeRepresentative(), triangulator.steps()};
}

DelaunayEdges delaunayEdges(std::span<const Point> points) {
  Triangulator triangulator(points);
  return {triangulator.edges(), triangulator.takeRepresentative()};
}

}  // namespace circle_voronoi
