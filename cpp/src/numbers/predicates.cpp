// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "at.h"
#include "exact.h"
#include "homogeneous_disc.h"
#include "in_circle.h"
#include "portable.h"
#include "refined.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

using Triple = Predicates::Triple;

/// Returns the circles of a face, rotated so that a point at infinity comes last.
exact::Face facing(std::span<const Circle> circles, const Triple& face) {
  const auto circleAt = [&](int i) { return i == kPointAtInfinity ? nullptr : &circles[at(i)]; };
  if (face[0] == kPointAtInfinity) return {circleAt(face[1]), circleAt(face[2]), nullptr};
  if (face[1] == kPointAtInfinity) return {circleAt(face[2]), circleAt(face[0]), nullptr};
  return {circleAt(face[0]), circleAt(face[1]), circleAt(face[2])};
}

/// Returns the sign of the distance of the disc's center from that of the smallest circle of its face, or 0 if rounding
/// hides it. The disc exists if the sign is positive.
int filteredExistence(const exact::Face& face, const CornerDisc& placed) {
  return distanceOf(*exact::smallestOf(face), placed.disc, *face[at(placed.corner)]).sign();
}

/// Returns the exact disc at infinity of two circles, one of which nearly contains the other. This case is rare, so the
/// function is not inlined.
CIRCLE_VORONOI_COLD HomogeneousDisc exactDiscAtInfinity(const Circle& a, const Circle& b) {
  const auto normal = exact::tangentNormal(a, b);
  if (!normal) return {};
  return {normal->x, normal->y, 0, 0, 0x1p-48};
}

/// Returns the disc of a face by exact arithmetic: for a disc that is nearly a tangent line, or for circles whose
/// common tangents are lost to rounding.
CornerDisc exactDisc(const exact::Face& face) {
  const auto point = exact::discPoint(face);
  if (!point) return {};
  const Circle& o = *exact::smallestOf(face);
  double farthest = 0;
  for (const Circle* c : face) farthest = std::max({farthest, std::abs(c->x - o.x), std::abs(c->y - o.y)});
  // A direction from another circle adds w times the difference of the centers.
  const double error = 0x1p-45 * (1 + point->w * farthest);
  const auto corner = std::find(face.begin(), face.end(), &o) - face.begin();
  return {{point->v.x, point->v.y, point->w, 1, error}, static_cast<int>(corner)};
}

}  // namespace

FaceDisc Predicates::disc(const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  if (circles[2] == nullptr) {
    HomogeneousDisc line = discAtInfinity(*circles[0], *circles[1]);
    if (line.error == kUnknownError) [[unlikely]]
      line = exactDiscAtInfinity(*circles[0], *circles[1]);
    return faceDisc(circles, {line, 0}, true);
  }
  const CornerDisc placed = discOf(*circles[0], *circles[1], *circles[2]);
  if (const int sign = filteredExistence(circles, placed); sign != 0) {
    ++counts_.filtered;
    return faceDisc(circles, placed, sign > 0, true);
  }
  return nearTie(circles);
}

/// Computes the disc where rounding hides whether it exists.
FaceDisc Predicates::nearTie(const exact::Face& circles) {
  const CornerDisc refined = refinedDiscOf(*circles[0], *circles[1], *circles[2]);
  if (const int sign = filteredExistence(circles, refined); sign != 0) {
    ++counts_.refined;
    return faceDisc(circles, refined, sign > 0);
  }
  ++counts_.exact;
  if (!exact::hasDisc(circles)) return faceDisc(circles, refined, false);
  return faceDisc(circles, refined.disc.error < kUnknownError ? refined : exactDisc(circles), true);
}

FaceDisc Predicates::faceDisc(const exact::Face& face, const CornerDisc& placed, bool exists, bool isFiltered) const {
  const HomogeneousDisc& disc = placed.disc;
  const auto origin = static_cast<int>(face[at(placed.corner)] - circles_.data());
  return {{disc.x, disc.y}, disc.w, disc.rho, disc.error, origin, exists, isFiltered};
}

std::optional<Vertex> Predicates::vertex(const Triple& face, const FaceDisc& disc) const {
  const auto& [i, j, k] = face;
  if (disc.isFiltered) {
    const int corner = disc.origin == i ? 0 : disc.origin == j ? 1 : 2;
    const CornerDisc placed = {{disc.v.x, disc.v.y, disc.w, disc.rho, disc.error}, corner};
    if (const auto vertex = vertexAt(placed, {&circles_[at(i)], &circles_[at(j)], &circles_[at(k)]})) return vertex;
    return refinedVertexOf(circles_[at(i)], circles_[at(j)], circles_[at(k)]);
  }
  return vertexOf(circles_[at(i)], circles_[at(j)], circles_[at(k)]);
}

int Predicates::exactCross(int from, const Triple& first, const Triple& second) {
  const exact::Face one = facing(circles_, first);
  const exact::Face other = facing(circles_, second);
  const Circle& seenFrom = circles_[at(from)];
  const RefinedTurn turn = refinedTurn(one, other, seenFrom);
  if (const int sign = turn.sign(); sign != 0) {
    ++counts_.refined;
    return sign;
  }
  ++counts_.exact;
  if (turn.left.sign() <= 0) return exact::crossSign(one, other, seenFrom);
  const int factor = turn.factor.sign();
  return turn.side * (factor != 0 ? factor * exact::touchSign(one, turn.added, seenFrom)
                                  : exact::overlapSign(one, turn.added, seenFrom));
}

int Predicates::exactEdgeOrder(int a, int b, int c, int d) {
  const double r = circles_[at(a)].r;
  if (circles_[at(b)].r == r && circles_[at(c)].r == r && circles_[at(d)].r == r) {
    ++counts_.inCircle;
    return -inCircle(center(a), center(b), center(c), center(d));
  }
  return exactCross(a, {b, a, d}, {a, b, c});
}

bool Predicates::isLowerExactly(int from, const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  ++counts_.exact;
  const int sign = exact::directionSign(circles, circles_[at(from)], 1);
  return sign < 0 || (sign == 0 && exact::directionSign(circles, circles_[at(from)], 0) < 0);
}

bool Predicates::contains(const Circle& outer, const Circle& inner) {
  if (outer.r < inner.r) return false;
  if (const int sign = tangentLengthSquared(outer, inner).sign(); sign != 0) {
    ++counts_.filtered;
    return sign < 0;
  }
  ++counts_.exact;
  return exact::contains(outer, inner);
}

int Predicates::tangentSide(int a, int b, int c) {
  if (const int sign = reachBeyond(circles_[at(a)], circles_[at(b)], circles_[at(c)]).sign(); sign != 0) {
    ++counts_.filtered;
    return sign;
  }
  if (const int sign = refinedReach(circles_[at(a)], circles_[at(b)], circles_[at(c)]).sign(); sign != 0) {
    ++counts_.refined;
    return sign;
  }
  ++counts_.exact;
  return exact::tangentSide(circles_[at(a)], circles_[at(b)], circles_[at(c)]);
}

}  // namespace circle_voronoi
