// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "geometry.h"
#include "homogeneous_disc.h"

namespace circle_voronoi {

/// How often each stage of a predicate decided.
struct FilterCounts {
  std::int64_t filtered = 0;  ///< floating point with an error bound
  std::int64_t refined = 0;   ///< double-double arithmetic with an error bound
  std::int64_t inCircle = 0;  ///< exact, reduced to the in-circle test of the centres (equal radii)
  std::int64_t exact = 0;     ///< exact, in full
};

/// The disc of a face of the dual, or its tangent line, with an error bound: the homogeneous point (v : w), w >= 0,
/// relative to the centre of circle `origin`. Seen from any circle c of the face, the direction to the centre of the
/// disc is v + w (origin - c); each component is right within `error`.
struct FaceDisc {
  Vector v;
  double w = 0;
  double error = 0;
  int origin = kInfinity;
  bool exists = false;
};

/// The signs that the construction and the certificate rest on. Each is exact: double arithmetic with a proven error
/// bound first, double-double if that does not decide, then integers (exact.h). A zero is a tie.
class Predicates {
 public:
  /// `circles` must outlive the predicates and must not hide one another.
  explicit Predicates(std::span<const Circle> circles) : circles_(circles) {}

  using Triple = std::array<int, 3>;

  /// The disc of three circles counter-clockwise; one of them may be kInfinity.
  FaceDisc disc(const Triple& face);

  /// The sign of the cross product of the directions to two discs, seen from circle `from`, a corner of both faces.
  int cross(int from, const Triple& first, const FaceDisc& firstDisc, const Triple& second, const FaceDisc& secondDisc);

  /// For faces (a, b, c) and (b, a, d) that have discs: 1 if the discs lie in order along the bisector, that of (b, a,
  /// d) first when going with a on the left; 0 if they are the same; -1 if they are out of order. An end at infinity is
  /// always in order. a and b are finite.
  int edgeOrder(int a, int b, int c, int d, const FaceDisc& abc, const FaceDisc& bad);

  /// The quadrant, 0 to 3 counter-clockwise, of the direction from a corner to the disc, in a fixed frame.
  int quadrant(int from, const Triple& face, const FaceDisc& disc);

  bool contains(const Circle& outer, const Circle& inner);

  /// 1 if circle c crosses the tangent line to the left of a -> b, 0 if it touches it, -1 if it is clear of it.
  int tangentSide(int a, int b, int c);

  const FilterCounts& counts() const { return counts_; }

 private:
  Direction<double> direction(int from, const FaceDisc& disc) const;
  Point centre(int i) const { return {circles_[i].x, circles_[i].y}; }

  std::span<const Circle> circles_;
  FilterCounts counts_;
};

}  // namespace circle_voronoi
