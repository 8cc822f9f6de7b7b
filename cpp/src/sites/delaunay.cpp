// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divide and conquer (L. Guibas, J. Stolfi, "Primitives for the manipulation of general subdivisions and the
// computation of Voronoi diagrams", 1985), with cuts across the longer side of each part (R. A. Dwyer, "A faster
// divide-and-conquer algorithm for constructing Delaunay triangulations", 1987), on triangles with a corner at infinity
// beyond each side of the hull (J. R. Shewchuk, "Triangle", 1996). Two parts are merged by joining them with one edge
// and then flipping edges.
#include "delaunay.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "at.h"
#include "circle_voronoi/index.h"
#include "in_circle.h"
#include "mix.h"
#include "perturbed_circle.h"
#include "threads.h"

namespace circle_voronoi {
namespace {

enum class Axis { x, y };

/// Returns whether a comes before b along an axis: by x, then y; or by y, then -x, which is the same order turned by a
/// right angle.
template <Axis axis>
bool isBefore(Point a, Point b) {
  // Without branches, which would often be predicted wrongly.
  if constexpr (axis == Axis::x) return (a.x < b.x) | ((a.x == b.x) & (a.y < b.y));
  return (a.y < b.y) | ((a.y == b.y) & (a.x > b.x));
}

/// Up to this many sites are sorted, instead of cut at the median of a sample.
constexpr std::size_t kFew = 12;

struct Site {
  Point point;
  int index;
};

struct Box {
  Point low, high;
};

/// Sorts items by insertion.
template <class Item, class Before>
void sortFew(std::span<Item> items, Before before) {
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Item item = items[i];
    std::size_t place = i;
    for (; place > 0 && before(item, items[place - 1]); --place) items[place] = items[place - 1];
    items[place] = item;
  }
}

/// Returns about the median of sites along an axis: the median of a sample.
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
  std::size_t count;  ///< the number of sites before the cut
  Point at;
};

/// Moves the sites before some pivot to the front or, if there are none, the sites up to the pivot. These are all sites
/// only if all are equal.
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

/// The place where a part of the sites is cut in two. It is not cut if all sites are equal.
struct Division {
  Axis axis;
  std::size_t count;  ///< the number of sites before the cut
  Box before, after;
};

Division divide(std::span<Site> sites, const Box& box) {
  const bool isWide = box.high.x - box.low.x > box.high.y - box.low.y;
  Division division = {isWide ? Axis::x : Axis::y, 0, box, box};
  const Cut at = isWide ? cut<Axis::x>(sites) : cut<Axis::y>(sites);
  division.count = at.count;
  (isWide ? division.before.high.x : division.before.high.y) = isWide ? at.at.x : at.at.y;
  (isWide ? division.after.low.x : division.after.low.y) = isWide ? at.at.x : at.at.y;
  return division;
}

struct HalfEdge {
  int origin;  ///< index of a corner, or kPointAtInfinity
  int twin;    ///< kNone if the face is not in use
};

/// A triangulation of some of the points, given by its first and last corner along each axis.
struct Part {
  int left, right, bottom, top;
};

/// Allocates memory for items that are set before they are read.
template <class Item>
std::unique_ptr<Item[]> roomFor(std::size_t count) {
  return std::unique_ptr<Item[]>(new Item[count]);
}

/// A triangulation in progress. A part of n sites has the corners with the numbers of its sites, and 2 n - 2 faces in
/// succession: the faces of its first half, the faces of its second half, and two faces that join the halves. Equal
/// sites leave some numbers free. So parts that have no site in common share no memory.
struct Triangulation {
  explicit Triangulation(std::size_t count)
      : corners(roomFor<Point>(count)),
        indices(roomFor<int>(count)),
        toInfinity(roomFor<int>(count)),
        halfEdges(roomFor<HalfEdge>(halfEdgeCount(count))),
        representative(count) {}

  static std::size_t faceCount(std::size_t siteCount) { return 2 * std::max(siteCount, std::size_t{1}) - 2; }
  static std::size_t halfEdgeCount(std::size_t siteCount) { return 3 * faceCount(siteCount); }
  std::size_t halfEdgeCount() const { return halfEdgeCount(representative.size()); }

  std::unique_ptr<Point[]> corners;
  std::unique_ptr<int[]> indices;  ///< the index of the point at each corner
  /// For each first or last corner of a part, its half-edge to infinity with the side of the hull that begins there on
  /// the left; kNone if the corner is a part by itself.
  std::unique_ptr<int[]> toInfinity;
  std::unique_ptr<HalfEdge[]> halfEdges;
  std::vector<int> representative;  ///< of each point (Delaunay::representative)
};

/// Triangulates parts, one after the other.
class Triangulator {
 public:
  /// The arguments must outlive this object.
  Triangulator(Triangulation& triangulation, const Site* sites, ProgressCallback progress = {})
      : corners_(triangulation.corners.get()),
        indices_(triangulation.indices.get()),
        toInfinity_(triangulation.toInfinity.get()),
        halfEdges_(triangulation.halfEdges.get()),
        representative_(triangulation.representative),
        first_(sites),
        progress_(std::move(progress)) {}

  /// Triangulates sites in a box, with the faces from `face` on.
  Part build(std::span<Site> sites, const Box& box, int face);
  /// Adds one corner for sites that are all equal, and leaves their faces from `face` on free.
  Part addCorner(std::span<const Site> sites, int face);
  /// Merges two parts, of which `a` comes before `b` along an axis, by two faces from `face` on.
  Part merge(Axis axis, const Part& a, const Part& b, int face);

  std::int64_t steps() const { return steps_; }

 private:
  Part buildFew(std::span<Site> sites, int face);
  template <Axis axis>
  Part mergeAlong(const Part& a, const Part& b, int face);
  void join(int left, int right, int face);
  void leaveFree(int from, int to) {
    for (int h = 3 * from; h < 3 * to; ++h) halfEdges_[h] = {kPointAtInfinity, kNone};
  }

  /// Reports that the sites before these are triangulated, if there were many steps since the last report.
  void tell(std::span<const Site> sites) {
    if (steps_ < stepsToTell_) return;
    stepsToTell_ = steps_ + kStepsPerReport;
    if (progress_) {
      progress_(static_cast<double>(sites.data() - first_) / static_cast<double>(representative_.size()));
    }
  }

  int setFace(int face, int a, int b, int c) {
    const int h = 3 * face;
    halfEdges_[h].origin = a;
    halfEdges_[h + 1].origin = b;
    halfEdges_[h + 2].origin = c;
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

  /// A corner relative to an origin, and its squared distance from it.
  struct Lifted {
    double x, y, square;
  };
  static Lifted lift(Point p, Point origin) {
    const double x = p.x - origin.x;
    const double y = p.y - origin.y;
    return {x, y, x * x + y * y};
  }

  /// Returns whether corners i, j, k are counter-clockwise. `b` and `c` are corners j and k relative to i.
  bool isLeftTurn(int i, int j, int k, const Lifted& b, const Lifted& c) {
    const double left = b.x * c.y;
    const double right = b.y * c.x;
    const double error = kOrientationError * (std::abs(left) + std::abs(right)) + kUnderflowError;
    if (left - right > error) return true;
    if (left - right < -error) return false;
    return circle_voronoi::orientation(corners_[i], corners_[j], corners_[k]) > 0;
  }

  /// Returns whether corner l lies inside the circle through i, j, k, which are counter-clockwise. `b`, `c` and `d` are
  /// corners j, k and l relative to i.
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

  Point* corners_;
  int* indices_;
  int* toInfinity_;
  HalfEdge* halfEdges_;
  std::vector<int>& representative_;
  const Site* first_;
  ProgressCallback progress_;
  std::int64_t stepsToTell_ = kStepsPerReport;
  std::int64_t steps_ = 0;
};

Part Triangulator::addCorner(std::span<const Site> sites, int face) {
  const auto corner = static_cast<int>(sites.data() - first_);
  int first = sites[0].index;
  for (const Site& site : sites) first = std::min(first, site.index);
  for (const Site& site : sites) representative_[at(site.index)] = first;
  corners_[corner] = sites[0].point;
  indices_[corner] = first;
  toInfinity_[corner] = kNone;
  leaveFree(face, face + 2 * static_cast<int>(sites.size()) - 2);
  return {corner, corner, corner, corner};
}

/// Triangulates a few sites by adding corners one by one.
Part Triangulator::buildFew(std::span<Site> sites, int face) {
  sortFew(sites, [](const Site& a, const Site& b) { return isBefore<Axis::x>(a.point, b.point); });
  const int last = face + 2 * static_cast<int>(sites.size()) - 2;
  Part all{};
  for (std::size_t begin = 0, end = 0; begin < sites.size(); begin = end) {
    while (end < sites.size() && sites[end].point == sites[begin].point) ++end;
    const Part corner = addCorner(sites.subspan(begin, end - begin), face);
    if (begin > 0) {
      all = mergeAlong<Axis::x>(all, corner, face);
      face += 2;
    } else {
      all = corner;
    }
  }
  leaveFree(face, last);
  return all;
}

Part Triangulator::build(std::span<Site> sites, const Box& box, int face) {
  if (sites.size() <= 3) return buildFew(sites, face);
  const Division division = divide(sites, box);
  const std::size_t count = division.count;
  steps_ += static_cast<std::int64_t>(sites.size());
  if (count == sites.size()) return addCorner(sites, face);
  tell(sites);
  const int second = face + 2 * static_cast<int>(count) - 2;
  const int seam = face + 2 * static_cast<int>(sites.size()) - 4;
  const Part a = build(sites.first(count), division.before, face);
  return merge(division.axis, a, build(sites.subspan(count), division.after, second), seam);
}

Part Triangulator::merge(Axis axis, const Part& a, const Part& b, int face) {
  return axis == Axis::x ? mergeAlong<Axis::x>(a, b, face) : mergeAlong<Axis::y>(a, b, face);
}

template <Axis axis>
Part Triangulator::mergeAlong(const Part& a, const Part& b, int face) {
  if constexpr (axis == Axis::x) {
    join(a.right, b.left, face);
    return {a.left, b.right, isBefore<Axis::y>(corners_[a.bottom], corners_[b.bottom]) ? a.bottom : b.bottom,
            isBefore<Axis::y>(corners_[a.top], corners_[b.top]) ? b.top : a.top};
  } else {
    join(a.top, b.bottom, face);
    return {isBefore<Axis::x>(corners_[a.left], corners_[b.left]) ? a.left : b.left,
            isBefore<Axis::x>(corners_[a.right], corners_[b.right]) ? b.right : a.right, a.bottom, b.top};
  }
}

/// Joins two parts at their seam by two faces from `face` on. `left` is the last corner of the first part, along the
/// axis that the cut between them divides, and `right` is the first corner of the second part. In the names here this
/// axis goes from left to right, so the seam is closed from bottom to top.
void Triangulator::join(int left, int right, int face) {
  constexpr auto next = &Dual::next;
  constexpr auto previous = &Dual::previous;

  // Go down along both hulls to the tangent below both parts.
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
  const int above = setFace(face, left, right, kPointAtInfinity);
  const int below = setFace(face + 1, right, left, kPointAtInfinity);
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

  // Go up the seam. Its end is the face (left, right, infinity), `above`, between `seam` below, (u, left, infinity) on
  // the left and (right, w, infinity) on the right. It is linked to these faces after the loop.
  int seam = below;
  int atU = twinOf(above + 2);
  int atW = twinOf(above + 1);
  for (;;) {
    ++steps_;
    const Point origin = corners_[left];
    const Lifted r = lift(corners_[right], origin);
    // On the left, flip the side of the hull from left to u away while u has no empty disc with the seam's end.
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
    // Do the same on the right, for w.
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
    // Flip one of the edges from left and from right to infinity, so that the seam ends higher.
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

/// A part of the sites that one thread triangulates, or whose halves are merged.
struct Job {
  std::size_t begin, end;
  Box box;
  int face;
  Axis axis = Axis::x;
  std::size_t first = 0;  ///< the job of its first half, before the job of its second half; 0 if it is not divided
  Part part = {};
};

/// Triangulates all sites. One thread works recursively. Several threads make the same cuts first, then the parts, then
/// the seams. Returns the number of steps.
std::int64_t triangulate(Triangulation& triangulation, std::span<Site> sites, const Box& box, Threads threads,
                         const ProgressCallback& progress) {
  if (threads.rangesOf(sites.size()) == 1) {
    Triangulator triangulator(triangulation, sites.data(), progress);
    triangulator.build(sites, box, 0);
    return triangulator.steps();
  }
  constexpr std::size_t kFewSites = 1024;
  std::vector<Job> jobs = {{0, sites.size(), box, 0}};
  std::vector<std::size_t> levels = {0, 1};  // the first job of each level
  while (levels.back() - levels.end()[-2] < threads.rangesOf(sites.size()) && levels.back() != levels.end()[-2]) {
    const std::size_t from = levels.end()[-2];
    std::vector<Division> divisions(levels.back() - from);
    threads.run(divisions.size(), [&](std::size_t i) {
      const Job& job = jobs[from + i];
      const std::size_t size = job.end - job.begin;
      divisions[i].count = size;
      if (size > kFewSites) divisions[i] = divide(sites.subspan(job.begin, size), job.box);
    });
    for (std::size_t i = 0; i < divisions.size(); ++i) {
      const auto [axis, count, before, after] = divisions[i];
      const Job job = jobs[from + i];
      if (count == job.end - job.begin) continue;
      jobs[from + i].axis = axis;
      jobs[from + i].first = jobs.size();
      jobs.push_back({job.begin, job.begin + count, before, job.face});
      jobs.push_back({job.begin + count, job.end, after, job.face + 2 * static_cast<int>(count) - 2});
    }
    levels.push_back(jobs.size());
  }
  std::atomic<std::int64_t> steps = 0;
  for (std::size_t level = levels.size() - 1; level-- > 0;) {
    threads.run(levels[level + 1] - levels[level], [&](std::size_t i) {
      Job& job = jobs[levels[level] + i];
      Triangulator triangulator(triangulation, sites.data());
      const int size = static_cast<int>(job.end - job.begin);
      job.part = job.first == 0 ? triangulator.build(sites.subspan(job.begin, job.end - job.begin), job.box, job.face)
                                : triangulator.merge(job.axis, jobs[job.first].part, jobs[job.first + 1].part,
                                                     job.face + 2 * size - 4);
      steps += triangulator.steps() + (job.first == 0 ? 0 : size);
    });
  }
  return steps;
}

/// Returns the triangulation of points, and the number of steps that it took.
std::pair<Triangulation, std::int64_t> triangulationOf(std::span<const Point> points, Threads threads,
                                                       const ProgressCallback& progress) {
  Triangulation triangulation(points.size());
  if (points.empty()) return {std::move(triangulation), 0};
  std::vector<Site> sites;
  sites.reserve(points.size());
  Box box = {points[0], points[0]};
  for (const Point& p : points) {
    sites.push_back({p, static_cast<int>(sites.size())});
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  const std::int64_t steps = triangulate(triangulation, sites, box, threads, progress);
  return {std::move(triangulation), steps};
}

/// Makes a dual of a triangulation. Only the representatives of the triangulation are left afterwards.
Dual takeDual(Triangulation& triangulation, Threads threads) {
  triangulation.corners.reset();
  triangulation.toInfinity.reset();
  const HalfEdge* halfEdges = triangulation.halfEdges.get();
  const auto indexOf = [&](int h) {
    const int corner = halfEdges[h].origin;
    return corner == kPointAtInfinity ? kPointAtInfinity : triangulation.indices[at(corner)];
  };
  // Number the faces by their smallest corner, so that the faces around a circle are near in memory.
  const std::size_t siteCount = triangulation.representative.size();
  const std::size_t faceCount = Triangulation::faceCount(siteCount);
  std::vector<int> placeOf(faceCount);
  threads.forEach(faceCount, [&](std::size_t face) {
    const int h = 3 * static_cast<int>(face);
    placeOf[face] = halfEdges[h].twin == kNone ? kNone : std::min({indexOf(h), indexOf(h + 1), indexOf(h + 2)}) + 1;
  });
  std::vector<int> first(siteCount + 2, 0);
  for (const int place : placeOf) {
    if (place != kNone) ++first[at(place + 1)];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  Dual dual;
  dual.origin.resize(3 * static_cast<std::size_t>(first.back()));
  dual.twin.resize(dual.origin.size());
  for (int& place : placeOf) {
    if (place != kNone) place = first[at(place)]++;
  }
  threads.forEach(faceCount, [&](std::size_t face) {
    for (int i = 0; i < 3 && placeOf[face] != kNone; ++i) {
      const int h = 3 * static_cast<int>(face) + i;
      const int t = halfEdges[h].twin;
      dual.origin[at(3 * placeOf[face] + i)] = indexOf(h);
      dual.twin[at(3 * placeOf[face] + i)] = 3 * placeOf[at(t / 3)] + t % 3;
    }
  });
  return dual;
}

std::vector<std::array<int, 2>> edgesOf(const Triangulation& triangulation, const ProgressCallback& progress) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(triangulation.halfEdgeCount() / 2);
  forEachIndex(triangulation.halfEdgeCount(), progress, [&](std::size_t i) {
    const HalfEdge& h = triangulation.halfEdges[i];
    if (h.origin == kPointAtInfinity) return;
    // Take the half whose origin is lower. No edge to infinity has such a half here.
    const int a = h.origin;
    const int b = triangulation.halfEdges[at(h.twin)].origin;
    if (a < b) edges.push_back({triangulation.indices[at(a)], triangulation.indices[at(b)]});
  });
  return edges;
}

}  // namespace

Delaunay delaunay(std::span<const Point> points, Threads threads) {
  auto [triangulation, steps] = triangulationOf(points, threads, {});
  Dual dual = takeDual(triangulation, threads);
  return {std::move(dual), std::move(triangulation.representative), steps};
}

DelaunayEdges delaunayEdges(std::span<const Point> points, const ProgressCallback& progress) {
  constexpr double kTriangulated = 0.9;  // of the time, about
  const ProgressCallback telling = partOf(progress, 0, kTriangulated);
  auto [triangulation, steps] = triangulationOf(points, Threads(), telling);
  auto edges = edgesOf(triangulation, partOf(progress, kTriangulated, 1));
  return {std::move(edges), std::move(triangulation.representative)};
}

}  // namespace circle_voronoi
