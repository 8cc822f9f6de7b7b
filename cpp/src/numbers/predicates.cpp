// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.h"

#include "exact.h"
#include "homogeneous_disc.h"
#include "in_circle.h"

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

CornerDisc discOf(const exact::Face& face) {
  if (face[2] == nullptr) return {discAtInfinity(*face[0], *face[1]), 0};
  return discOf(*face[0], *face[1], *face[2]);
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
  const auto placed = discOf(circles);
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
    ++counts_.exact;
    result.exists = exact::hasDisc(circles);
  }
  return result;
}

int Predicates::exactCross(int from, const Triple& first, const Triple& second) {
  ++counts_.exact;
  return exact::crossSign(facing(circles_, first), facing(circles_, second), circles_[from]);
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
