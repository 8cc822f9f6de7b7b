// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "at.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/vertex.h"
#include "exact.h"
#include "homogeneous_disc.h"
#include "infinity.h"
#include "portable.h"
#include "threads.h"
#include "vectors.h"

namespace circle_voronoi {

/// The number of decisions by each stage of a predicate.
struct FilterCounts {
  std::int64_t filtered = 0;  ///< by floating point with an error bound
  std::int64_t refined = 0;   ///< by floating point with twice the digits (refined.h)
  std::int64_t inCircle = 0;  ///< exactly, by the in-circle test of the centers (equal radii)
  std::int64_t exact = 0;     ///< exactly, by integers

  FilterCounts& operator+=(const FilterCounts& other) {
    filtered += other.filtered;
    refined += other.refined;
    inCircle += other.inCircle;
    exact += other.exact;
    return *this;
  }
};

/// The disc of a face of the dual, or its tangent line, with an error bound: the homogeneous point (v : w), w >= 0,
/// relative to the center of circle `origin`. Seen from any circle c of the face, the direction to the center of the
/// disc is v + w (origin - c); each component is right within `error`.
struct FaceDisc {
  Vector v;
  double w = 0;
  double rho = 0;  ///< w times the distance between the centers of the disc and of `origin`; 0 at infinity
  double error = 0;
  int origin = kPointAtInfinity;
  bool exists = false;
  /// True if double arithmetic decided whether the disc exists. Then vertexOf tries these numbers first.
  bool isFiltered = false;

  friend bool operator==(const FaceDisc& a, const FaceDisc& b) {
    return a.v.x == b.v.x && a.v.y == b.v.y && a.w == b.w && a.rho == b.rho && a.error == b.error &&
           a.origin == b.origin && a.exists == b.exists && a.isFiltered == b.isFiltered;
  }
};

/// The signs that the construction and the certificate rest on. Each sign is exact. Double arithmetic with a proven
/// error bound is tried first, then arithmetic with more digits (refined.h), then integers (exact.h). A zero is a tie.
///
/// Laws, beside those of exact.h (laws_test.cpp):
///   disc(i, j, k) == disc(j, k, i), to the bit, where double arithmetic decides whether the disc exists
///   (FaceDisc::isFiltered). Otherwise both exist or none does.
///   turn(o, f, g) == -turn(o, g, f), and 0 for f == g.
///   exactEdgeOrder(a, b, c, d) == exactEdgeOrder(b, a, d, c) for circles a and b of equal radius.
///   hiddenOf(a, b) == hiddenOf(b, a) unless the circles are equal.
class Predicates {
 public:
  /// `circles` must outlive the predicates and must not hide one another.
  explicit Predicates(std::span<const Circle> circles) : circles_(circles) {}

  /// Sets the circles again after they have moved in memory or more were added.
  void setCircles(std::span<const Circle> circles) { circles_ = circles; }

  using Triple = std::array<int, 3>;

  /// Computes the disc of three circles in counter-clockwise order. One circle may be kPointAtInfinity.
  FaceDisc disc(const Triple& face);

  /// Returns the vertex of a face of circles that has this disc, with the same bits as vertexOf.
  std::optional<Vertex> vertex(const Triple& face, const FaceDisc& disc) const;

  /// Returns the direction to a disc from circle `from`, a corner of its face.
  Direction direction(int from, const FaceDisc& disc) const {
    const Circle& o = circles_[at(disc.origin)];
    const Circle& c = circles_[at(from)];
    return {disc.v.x + disc.w * (o.x - c.x), disc.v.y + disc.w * (o.y - c.y), disc.error};
  }

  /// Returns the sign of the cross product u x v of two directions, or 0 if their error bounds do not decide.
  int filteredCross(const Direction& u, const Direction& v) {
    const int sign = crossOf(u, v).sign();
    counts_.filtered += sign != 0;
    return sign;
  }

  /// Returns the sign of the cross product of the directions to the discs of two faces that share an edge, seen from a
  /// corner of both. Use it where the filter did not decide: it tries refined discs, then integers.
  int exactCross(int from, const Triple& first, const Triple& second);

  /// Returns the sign of the cross product of the directions to the discs of two faces that share an edge, seen from a
  /// corner of both.
  int turn(int from, const Triple& first, const FaceDisc& firstDisc, const Triple& second, const FaceDisc& secondDisc) {
    const int sign = filteredCross(direction(from, firstDisc), direction(from, secondDisc));
    return sign != 0 ? sign : exactCross(from, first, second);
  }

  /// Returns 1 if the discs of (a, b, c) and (b, a, d) are in order along the bisector of a and b: the disc of (b, a,
  /// d) comes first when going with a on the left. Returns 0 if they are equal, -1 if they are out of order. This is
  /// the sign of the cross product of the directions to them from a. The filter is not tried.
  /// Precondition: both are faces of circles and have discs, and looksFromFirst(a, b).
  int exactEdgeOrder(int a, int b, int c, int d);

  /// Returns whether the bisector of a and b is ordered as seen from a. Circle a must not be the smaller one: then the
  /// bisector spans less than half a turn, so that a cross product orders it.
  bool looksFromFirst(int a, int b) const { return circles_[at(a)].r >= circles_[at(b)].r; }

  /// Returns whether the direction from a corner of a face to its disc lies in the lower half of a fixed frame, which
  /// begins with the half-axis at 180 degrees and ends before the one at 360.
  bool isLower(int from, const Triple& face, const Direction& toDisc) {
    // The processor would often predict a branch on the sign wrongly.
    if (const auto [height, error] = heightOf(toDisc); std::abs(height) > error) {
      ++counts_.filtered;
      return height < 0;
    }
    return isLowerExactly(from, face);
  }

  bool contains(const Circle& outer, const Circle& inner);

  /// Returns the circle that the other one contains, or kPointAtInfinity.
  int hiddenOf(int a, int b) {
    const Circle& one = circles_[at(a)];
    const Circle& other = circles_[at(b)];
    if (isLonger(between(one, other), std::abs(one.r - other.r))) return kPointAtInfinity;
    return contains(one, other) ? b : contains(other, one) ? a : kPointAtInfinity;
  }

  /// Returns 1 if circle c crosses the tangent line to the left of a -> b, 0 if it touches the line, -1 if it is clear
  /// of the line.
  int tangentSide(int a, int b, int c);

  const FilterCounts& counts() const { return counts_; }

  /// Calls function(begin, end, range, predicates) for ranges of the items (Threads::forRanges). Each range has
  /// predicates of its own, whose counts are added to the counts of this object.
  template <class Function>
  void forRanges(Threads threads, std::size_t items, Function function) {
    std::vector<FilterCounts> counts(threads.rangesOf(items));
    threads.forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t range) {
      Predicates own(circles_);
      function(begin, end, range, own);
      counts[range] = own.counts_;
    });
    for (const FilterCounts& of : counts) counts_ += of;
  }

 private:
  CIRCLE_VORONOI_NEVER_INLINE FaceDisc nearTie(const exact::Face& circles);
  FaceDisc faceDisc(const exact::Face& face, const CornerDisc& placed, bool exists, bool isFiltered = false) const;
  bool isLowerExactly(int from, const Triple& face);
  Point center(int i) const { return {circles_[at(i)].x, circles_[at(i)].y}; }

  std::span<const Circle> circles_;
  FilterCounts counts_;
};

}  // namespace circle_voronoi
