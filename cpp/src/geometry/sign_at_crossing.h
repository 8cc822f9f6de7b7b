// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs at the crossing of a side of a region and a bisector, in integers or in polynomials of the shift.
#pragma once

#include "relative_circle.h"
#include "shift_polynomial.h"

namespace circle_voronoi {

template <class Number>
Number twice(const Number& value) {
  return value + value;
}

/// Returns the sign of p + q sqrt(d), given the sign of p^2 - q^2 d. It is 0 if p and d are 0, or p and q are.
template <class P, class Q>
int signOfRoot(int norm, const P& p, const Q& q) {
  const int own = p.sign();
  if (norm == 0 && own == 0) return 0;
  return exact::signOf(
      norm, [&] { return own; }, [&] { return q.sign(); });
}

/// Returns the sign of a linear function where a line comes out of the cell of circle o into that of `other`: of
/// `lambda` + `mu` t at the share t of the line, which is a root of a t^2 + 2 b t + c.
///
/// With x the vector from the middle of the centers and D that between them, the branches of the hyperbola are where
/// 4 (x . D)^2 - 4 s^2 x . x = s^2 (D . D - s^2), and the left side is the larger one on the inner side of each branch.
/// If s is 0, the bisector is the line 2 x . D + `lift` = 0.
template <class View, class SeenCircle, class Lift, class Lambda, class Mu>
int signAtCrossing(View view, const SeenCircle& other, const Lift& lift, const SeenCircle& from, const SeenCircle& to,
                   const Lambda& lambda, const Mu& mu) {
  const auto d = view.fixed(other.v);
  const auto start = view.moved(from.v);
  const auto direction = view.fixed(to.v - from.v);
  const auto s = view.number(other.v.s);
  const PlaneVector toMiddle = {d.x - twice(start.x), d.y - twice(start.y)};  // twice
  const auto along = dot(direction, d);
  const auto height = dot(toMiddle, d);
  if (s.sign() == 0) {
    const auto way = twice(along);
    return (lambda * way + mu * (height - view.number(lift))).sign() * way.sign();
  }
  const auto ss = s * s;
  const auto a = twice(twice(along * along - ss * dot(direction, direction)));
  const auto b = twice(ss * dot(toMiddle, direction) - height * along);
  const auto c = height * height - ss * (dot(toMiddle, toMiddle) + dot(d, d) - ss);
  if (a.sign() == 0) return (twice(lambda * b) - mu * c).sign() * b.sign();
  const auto norm = a * (lambda * lambda) - twice(b * (lambda * mu)) + c * (mu * mu);
  // The root of a line that goes into the inner side of the branch has the plus sign.
  const auto p = lambda * a - mu * b;
  return a.sign() * signOfRoot(a.sign() * norm.sign(), p, s.sign() < 0 ? mu : -mu);
}

}  // namespace circle_voronoi
