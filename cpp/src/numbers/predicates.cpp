// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.h"

#include <cmath>

#include "exact.h"
#include "homogeneous_disc.h"
#include "in_circle.h"

namespace circle_voronoi {
namespace {

/// The sign of a value that is known within `error`; 0 if that does not decide.
int signWithin(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

using Triple = Predicates::Triple;

/// The circles of a face, rotated so that a point at infinity comes last.
exact::Face facing(std::span<const Circle> circles, const Triple& face) {
  const auto at = [&](int i) { return i == kInfinity ? nullptr : &circles[i]; };
  if (face[0] == kInfinity) return {at(face[1]), at(face[2]), nullptr};
  if (face[1] == kInfinity) return {at(face[2]), at(face[0]), nullptr};
  return {at(face[0]), at(face[1]), at(face[2])};
}

template <class Real>
CornerDisc<Real> discOf(const exact::Face& face) {
  if (face[2] == nullptr) return {discAtInfinity<Real>(*face[0], *face[1]), 0};
  return discOf<Real>(*face[0], *face[1], *face[2]);
}

/// From circle `from` to the disc of a face, in double-double arithmetic.
Direction<DoubleDouble> refined(const Circle& from, const exact::Face& face) {
  const auto [disc, corner] = discOf<DoubleDouble>(face);
  return seenFrom(from, disc, *face[corner]);
}

/// 1 if a disc is at a positive distance from the smallest circle of its face, -1 if at a negative one, 0 if unknown.
template <class Real>
int filteredExistence(const exact::Face& face, const CornerDisc<Real>& placed) {
  const Circle* smallest = face[0]->r <= face[1]->r ? face[0] : face[1];
  if (face[2]->r < smallest->r) smallest = face[2];
  const Difference<Real> shift(*smallest, *face[placed.corner]);
  return signWithin(high(placed.disc.rho + placed.disc.w * shift.s), placed.disc.error);
}

}  // namespace

FaceDisc Predicates::disc(const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  const auto placed = discOf<double>(circles);
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
  } else if (const int refinedSign = filteredExistence(circles, discOf<DoubleDouble>(circles)); refinedSign != 0) {
    ++counts_.refined;
    result.exists = refinedSign > 0;
  } else {
    ++counts_.exact;
    result.exists = exact::hasDisc(circles);
  }
  return result;
}

int Predicates::refinedCross(int from, const Triple& first, const Triple& second) {
  const Circle& circle = circles_[from];
  const exact::Face firstFace = facing(circles_, first);
  const exact::Face secondFace = facing(circles_, second);
  const int sign = circle_voronoi::filteredCross(refined(circle, firstFace), refined(circle, secondFace));
  ++(sign != 0 ? counts_.refined : counts_.exact);
  return sign != 0 ? sign : exact::crossSign(firstFace, secondFace, circle);
}

int Predicates::refinedEdgeOrder(int a, int b, int c, int d) {
  const double r = circles_[a].r;
  if (circles_[b].r == r && circles_[c].r == r && circles_[d].r == r) {
    ++counts_.inCircle;
    return -inCircle(centre(a), centre(b), centre(c), centre(d));
  }
  return refinedCross(a, {b, a, d}, {a, b, c});
}

bool Predicates::isLowerRefined(int from, const Triple& face) {
  const exact::Face circles = facing(circles_, face);
  const auto [x, y, error] = refined(circles_[from], circles);
  const double height = high(exact::kAxisX * y - exact::kAxisY * x);
  const double bound = (error + 3 * kUnitRoundoff<DoubleDouble> * (std::abs(high(x)) + std::abs(high(y)))) * 2048;
  if (std::abs(height) > bound) {
    ++counts_.refined;
    return height < 0;
  }
  ++counts_.exact;
  const int sign = exact::directionSign(circles, circles_[from], 1);
  return sign < 0 || (sign == 0 && exact::directionSign(circles, circles_[from], 0) < 0);
}

bool Predicates::contains(const Circle& outer, const Circle& inner) {
  if (outer.r < inner.r) return false;
  const Difference<double> d(outer, inner);
  const double l = size(d);
  if (const int sign = signWithin(cone(d, d), 8 * kUnitRoundoff<double> * l * l + kTiny); sign != 0) {
    ++counts_.filtered;
    return sign < 0;
  }
  ++counts_.exact;
  return exact::contains(outer, inner);
}

int Predicates::tangentSide(int a, int b, int c) {
  const Difference<double> d(circles_[b], circles_[a]);
  const Difference<double> e(circles_[c], circles_[a]);
  // With l = |d|, m = |e|: four products of at most l^2 m, and sqrt(g) within 6 u l^2 / sqrt(g).
  constexpr double u = kUnitRoundoff<double>;
  const double g = cone(d, d);
  const double l = size(d);
  if (g > 12 * u * l * l) {
    const double root = std::sqrt(g);
    const double value = e.s * (d.x * d.x + d.y * d.y) - d.s * (d.x * e.x + d.y * e.y) + (d.x * e.y - d.y * e.x) * root;
    if (const int sign = signWithin(value, 60 * u * l * l * size(e) * (l / root) + kTiny); sign != 0) {
      ++counts_.filtered;
      return sign;
    }
  }
  ++counts_.exact;
  return exact::tangentSide(circles_[a], circles_[b], circles_[c]);
}

}  // namespace circle_voronoi
