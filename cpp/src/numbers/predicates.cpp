// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.h"

#include "exact.h"
#include "homogeneous_disc.h"
#include "in_circle.h"
#include "refined_disc.h"

namespace circle_voronoi {
namespace {

using Triple = Predicates::Triple;

/// The circles of a face, rotated so that a point at infinity comes last.
exact::Face facing(std::span<const Circle> circles, const Triple& face) {
  const auto at = [&](int i) { return i == kInfinity ? nullptr : &circles[i]; };
  if (face[0] == kInfinity) return {at(face[1]), at(face[2]), nullptr};
  if (face[1] == kInfinity) return {at(face[2]), at(face[0]), nullptr};
  return {at(face[0]), at(face[1]), at(face[2])};
}

using Find = CornerDisc (*)(const Circle&, const Circle&, const Circle&);

/// The disc of a face; as `find` has it, if it is no tangent line.
template <Find find>
CornerDisc discAt(const exact::Face& face) {
  if (face[2] == nullptr) return {discAtInfinity(*face[0], *face[1]), 0};
  return find(*face[0], *face[1], *face[2]);
}

/// The direction from a circle of a face to its disc.
Direction refinedDirection(const exact::Face& face, const Circle& from) {
  const auto [disc, corner] = discAt<refinedDiscOf>(face);
  const Circle& o = *face[corner];
  return {disc.x + disc.w * (o.x - from.x), disc.y + disc.w * (o.y - from.y), disc.error};
}

/// Of the distance of a disc from the smallest circle of its face.
int filteredExistence(const exact::Face& face, const CornerDisc& placed) {
  const Circle* smallest = face[0]->r <= face[1]->r ? face[0] : face[1];
  if (face[2]->r < smallest->r) smallest = face[2];
  return distanceOf(*smallest, placed.disc, *face[placed.corner]).sign();
}

}  // namespace

FaceDisc Predicates::disc(const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  const auto placed = discAt<discOf>(circles);
  FaceDisc result;
  result.v = {placed.disc.x, placed.disc.y};
  result.w = placed.disc.w;
  result.error = placed.disc.error;
  result.origin = static_cast<int>(circles[placed.corner] - circles_.data());
  if (circles[2] == nullptr) {
    result.exists = true;
  } else if (const int sign = filteredExistence(circles, placed); sign != 0) {
    ++counts_.filtered;
    result.exists = sign > 0;
  } else {
    result.exists = hasDisc(circles);
  }
  return result;
}

bool Predicates::hasDisc(const exact::Face& face) {
  if (const int sign = filteredExistence(face, discAt<refinedDiscOf>(face)); sign != 0) {
    ++counts_.filtered;
    return sign > 0;
  }
  ++counts_.exact;
  return exact::hasDisc(face);
}

int Predicates::exactCross(int from, const Triple& first, const Triple& second) {
  const exact::Face one = facing(circles_, first);
  const exact::Face other = facing(circles_, second);
  const Circle& seenFrom = circles_[from];
  if (const int sign = crossOf(refinedDirection(one, seenFrom), refinedDirection(other, seenFrom)).sign(); sign != 0) {
    ++counts_.filtered;
    return sign;
  }
  ++counts_.exact;
  return exact::crossSign(one, other, seenFrom);
}

int Predicates::exactEdgeOrder(int a, int b, int c, int d) {
  const double r = circles_[a].r;
  if (circles_[b].r == r && circles_[c].r == r && circles_[d].r == r) {
    ++counts_.inCircle;
    return -inCircle(centre(a), centre(b), centre(c), centre(d));
  }
  return exactCross(a, {b, a, d}, {a, b, c});
}

bool Predicates::isLowerExactly(int from, const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  ++counts_.exact;
  const int sign = exact::directionSign(circles, circles_[from], 1);
  return sign < 0 || (sign == 0 && exact::directionSign(circles, circles_[from], 0) < 0);
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
  if (const int sign = reachBeyond(circles_[a], circles_[b], circles_[c]).sign(); sign != 0) {
    ++counts_.filtered;
    return sign;
  }
  ++counts_.exact;
  return exact::tangentSide(circles_[a], circles_[b], circles_[c]);
}

}  // namespace circle_voronoi
