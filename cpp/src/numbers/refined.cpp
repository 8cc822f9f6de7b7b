// SPDX-License-Identifier: GPL-3.0-or-later
//
// As in exact.cpp, whose letters are used here, circles are seen from a circle o, and discs are tangent lines. The line
// of (o, p, q) has the axis D = P g_q - Q g_p and, with d = g_p g_q g_pq, the direction
//   e |D|^2 = -D.s (D.x, D.y) + sqrt(d) (-D.y, D.x)
// and, with N = P x Q, the offset t |D|^2 = D.y N.x - D.x N.y + N.s sqrt(d). Its first two terms, the third component
// of N x D, are alpha P.s + beta Q.s with alpha = g_q (g_p - <P, Q>), beta = g_p (g_q - <P, Q>), as 2 <P, Q> = g_p +
// g_q - g_pq.
//
// The order of two discs, of (o, p, q) and of o, n and p or q, is simple if the first direction lies to the left of the
// axis E of the second disc. Then it follows from how far W_n reaches beyond the tangent line with the axis D,
//   a + b sqrt(d),  a = M.x D.y - M.y D.x,  b = M.s,  M = g_n (Q x P) + g_q (P x N) + g_p (N x Q).
// In a near tie this sum cancels, but a - b sqrt(d) does not. Their product is |D|^2 <M, M>, so the sign of the sum is
// that of <M, M> times that of a - b sqrt(d). The norm <M, M> cancels too, but no more than the circles' doubles let
// it: in the form of exact.cpp it needs nothing but tangent lengths.
//
// g is 0 or between 2^-192 and 2^196, and D is below 2^295 (homogeneous_disc.h). The norm is below 2^(8 + 196 * 4), and
// its terms are multiples of 2^-768, so that nothing overflows or underflows. Only the cross product of two directions
// e |D|^2 would be beyond the doubles: it has twelve factors. That is why directions are divided by a power of two.
#include "refined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <tuple>

#include "at.h"
#include "bit_cast.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

constexpr double u = kUnitRoundoff;

/// A positive number and a bound on its relative error.
struct Relative {
  TwoPart number = {1, 0};
  double error = 0;
};

Relative operator*(const Relative& a, const Relative& b) {
  return {product(a.number, b.number), (a.error + b.error) * (1 + 0x1p-40) + 9 * u * u};
}

/// Returns g of two circles, or 1 if one is the point at infinity. The error is unknown unless the value alone
/// is right within 2 u.
Relative tangentSquareOf(const Circle* a, const Circle* b) {
  if (a == nullptr || b == nullptr) return {};
  const TangentSquare g = tangentSquare(*a, *b);
  const bool isRight = g.error <= u / 2 * g.square.value;
  return {g.square, isRight ? g.error / g.square.value : kUnknownError};
}

/// A circle as seen from another: U, the length of U, and g. For the point at infinity, U is 0 and g is 1.
struct RelativeCircle {
  Difference v = {0, 0, 0};
  double size = 0;
  Relative square;

  RelativeCircle(const Circle* circle, const Circle& from) {
    if (circle == nullptr) return;
    v = Difference(*circle, from);
    size = circle_voronoi::size(v);
    square = tangentSquareOf(circle, &from);
  }
  double g() const { return square.number.value; }
};

bool areKnown(std::initializer_list<Relative> squares) {
  return std::all_of(squares.begin(), squares.end(),
                     [](const Relative& square) { return square.error < kUnknownError; });
}

/// The axis D of the disc of (o, p, q), and `root`, which is sqrt(d). The length of D is at most `size`, and `root` is
/// at most that length. Each number is within 6 u of `size`.
struct Axis {
  double x, y, s;
  double root;
  double size;

  /// `square` is g of p and q, seen from each other.
  Axis(const RelativeCircle& p, const RelativeCircle& q, const Relative& square)
      : x(p.v.x * q.g() - q.v.x * p.g()),
        y(p.v.y * q.g() - q.v.y * p.g()),
        s(p.v.s * q.g() - q.v.s * p.g()),
        root(std::sqrt(p.g() * q.g() * square.number.value)),
        size(p.size * q.g() + q.size * p.g()) {}

  /// Directions are divided by this. The division changes no bit, because directions lie between 2^(-96 * 6 - 53) and
  /// 2^(295 + 2).
  double magnitude() const { return leadingBit(size); }

  /// Returns e |D|^2 / magnitude().
  ///
  /// Error: let l = |D| and k be `size`. Each component is a sum of two products, of factors that are together at most
  /// (sqrt(3) + 1) l: within 6 u k times that, 17 u k l. The products and the sum add 3 u l^2, and l <= k. The computed
  /// l may be 14 u k too small.
  Direction direction() const {
    const double length = std::sqrt(x * x + y * y + s * s);
    const double error = 20 * u * size * (length + 20 * u * size);
    return {(-s * x - root * y) / magnitude(), (-s * y + root * x) / magnitude(),
            error / magnitude() + kUnderflowError};
  }
};

/// Returns 4 <M, M>, given A, B and C (touchSign in exact.cpp).
///
/// Error: let e be the largest relative error of A, B, C, P their sum, S = A + C - B.
/// - The sums are exact in two parts but for the roundings of the rests: A.rest + C.rest within u of u P, less B.rest
///   within u of u P, the rests of both sums within u of 2 u P, all within u of 3 u P: 7 u^2 P. With the errors of A,
///   B, C, S is within (e + 7 u^2) P.
///   Hence S^2 is within this bound times the sum of the bound and 2 |S|.
/// - S's own rest is at most u |S|: 2 u S^2 rounded, its square left out, 3 u S^2 rounded: 6 u^2 S^2.
/// - 4 A C within 2 e and 9 u^2 of itself.
/// - The difference of the rests, at most 3 u S^2 + 4 u A C, is rounded, as is its sum with that of the values' sum, 1
///   u (S^2 + 4 A C) more: 7 u^2 S^2 + 9 u^2 4 A C at most.
/// The products of e and u^2 are below 2^-50 of the products before.
Estimate normOf(const Relative& a, const Relative& b, const Relative& c) {
  const double e = std::max({a.error, b.error, c.error});
  const double whole = a.number.value + b.number.value + c.number.value;
  const TwoPart ac = sum(a.number.value, c.number.value);
  const TwoPart acb = sum(ac.value, -b.number.value);
  const TwoPart s = sum(acb.value, (a.number.rest + c.number.rest - b.number.rest) + (ac.rest + acb.rest));
  const TwoPart ss = square(s.value);
  const TwoPart product4 = product({4 * a.number.value, 4 * a.number.rest}, c.number);
  const TwoPart difference = sum(ss.value, -product4.value);
  const double rest = difference.rest + ((ss.rest + 2 * s.value * s.rest) - product4.rest);
  const double sError = whole * (e + 8 * u * u);
  const double error =
      (sError * (2 * std::abs(s.value) + sError) + 14 * u * u * ss.value + product4.value * (2 * e + 20 * u * u)) *
      (1 + 0x1p-40);
  return {difference.value + rest, error + kUnderflowError};
}

/// Returns a - b sqrt(d).
///
/// Error: with T = g_n |P| |Q| + g_q |P| |N| + g_p |N| |Q| each component of M is at most T and within 9 u T: the cross
/// products within 4 u, times g within 3 u more, and two sums. So with k, the axis's size, a is within 15 sqrt(2)
/// u + 2 u of T k, and b sqrt(d) within 16 u; the sum adds 2 u: 42 u in all.
Estimate factorOf(const RelativeCircle& p, const RelativeCircle& q, const RelativeCircle& n, const Axis& d) {
  const Difference qp = cross(q.v, p.v);
  const Difference pn = cross(p.v, n.v);
  const Difference nq = cross(n.v, q.v);
  const Difference m(n.g() * qp.x + q.g() * pn.x + p.g() * nq.x, n.g() * qp.y + q.g() * pn.y + p.g() * nq.y,
                     n.g() * qp.s + q.g() * pn.s + p.g() * nq.s);
  const double whole = n.g() * p.size * q.size + q.g() * p.size * n.size + p.g() * n.size * q.size;
  return {m.x * d.y - m.y * d.x - m.s * d.root, 42 * u * whole * d.size + kUnderflowError};
}

}  // namespace

// The disc is seen from the smallest circle, which it touches if it touches any. With w = 2 t |D|^2,
// the point (e |D|^2 : w) has the distance |D|^2 / w. All three are divided by the magnitude of the axis.
//
// Error: let k be the axis's size, P the sum g_p + g_q + g_pq, `whole`.
// - Twice the differences of g_p and g_q from <P, Q> are sums of the three g, at most P and within 4 u P, so that alpha
//   and beta are at most g_q P / 2 and g_p P / 2, within 7 u; times P.s and Q.s within 9 u.
// - N.s is at most |P| |Q|, within 4 u, times the root within 10 u. The sums add 2 u to all.
// - |D|^2 is within 22 u k |D|, as is the direction. Seen from another corner, w times a difference of at most |P| or
//   |Q| is added: within that times the error of w and 2 u w, and the sum adds u (|D|^2 + w times it).
CornerDisc refinedDiscOf(const Circle& c0, const Circle& c1, const Circle& c2) {
  const std::array<const Circle*, 3> circles = {&c0, &c1, &c2};
  CornerDisc result;
  result.corner = c1.r < c0.r ? (c2.r < c1.r ? 2 : 1) : (c2.r < c0.r ? 2 : 0);
  const Circle& o = *circles[at(result.corner)];
  const Circle& first = *circles[at((result.corner + 1) % 3)];
  const Circle& second = *circles[at((result.corner + 2) % 3)];
  const RelativeCircle p(&first, o);
  const RelativeCircle q(&second, o);
  const Relative pq = tangentSquareOf(&first, &second);
  if (!areKnown({p.square, q.square, pq})) return result;
  const Axis d(p, q, pq);
  const double g = pq.number.value;
  const double whole = p.g() + q.g() + g;
  const double alpha = q.g() * (p.g() + g - q.g());
  const double beta = p.g() * (q.g() + g - p.g());
  const double ns = p.v.x * q.v.y - p.v.y * q.v.x;
  const Estimate w = {
      alpha * p.v.s + beta * q.v.s + 2 * ns * d.root,
      12 * u * ((std::abs(p.v.s) * q.g() + std::abs(q.v.s) * p.g()) * whole + 2 * p.size * q.size * d.root) +
          kUnderflowError};
  if (w.sign() == 0) return result;
  const Direction toDisc = d.direction();
  const double turn = w.sign();
  result.disc.x = turn * toDisc.x;
  result.disc.y = turn * toDisc.y;
  result.disc.rho = turn * (d.x * d.x + d.y * d.y) / d.magnitude();
  result.disc.error = 1.1 * toDisc.error +
                      std::max(p.size, q.size) * (w.error + 4 * u * std::abs(w.value)) / d.magnitude() +
                      kUnderflowError;
  result.disc.w = std::abs(w.value) / d.magnitude();
  return result;
}

// With d = b - a, e = c - a and the root of g_ab, the reach is e.s |d|^2 - d.s d.e + (d x e) root, with products in the
// plane. As |d|^2 = g_ab + d.s^2 and 2 <d, e> = g_ab + g_ac - g_bc, the first two terms are e.s g_ab - d.s <d, e>,
// which does not cancel where tangents are short.
//
// Error: let P be the sum of the three g, each within 2 u.
// - 2 e.s g_ab is within 4 u of itself.
// - The sum of the g is within 4 u P, times d.s within 6 u.
// - d x e is at most |d| |e|, within 4 u, its double times the root within 7 u of twice that.
// The sums add 2 u to all. One more u covers terms of higher order.
Estimate refinedReach(const Circle& a, const Circle& b, const Circle& c) {
  const RelativeCircle d(&b, a);
  const RelativeCircle e(&c, a);
  const Relative bc = tangentSquareOf(&b, &c);
  if (!areKnown({d.square, e.square, bc})) return {};
  const double root = std::sqrt(d.g());
  const double whole = d.g() + e.g() + bc.number.value;
  const double twice = d.g() + e.g() - bc.number.value;
  return {
      2 * e.v.s * d.g() - d.v.s * twice + 2 * (d.v.x * e.v.y - d.v.y * e.v.x) * root,
      u * (13 * std::abs(e.v.s) * d.g() + 9 * std::abs(d.v.s) * whole + 19 * d.size * e.size * root) + kUnderflowError};
}

RefinedTurn refinedTurn(const exact::Face& first, const exact::Face& second, const Circle& from) {
  const auto firstOthers = exact::othersOf(first, &from);
  const auto secondOthers = exact::othersOf(second, &from);
  const bool isSharedFirst = secondOthers[0] == firstOthers[0] || secondOthers[0] == firstOthers[1];
  const Circle* shared = secondOthers[isSharedFirst ? 0 : 1];
  const Circle* other = firstOthers[shared == firstOthers[0] ? 1 : 0];
  RefinedTurn result;
  result.added = secondOthers[isSharedFirst ? 1 : 0];
  result.side = isSharedFirst ? -1 : 1;

  const RelativeCircle p(firstOthers[0], from);
  const RelativeCircle q(firstOthers[1], from);
  const RelativeCircle n(result.added, from);
  const RelativeCircle& w = shared == firstOthers[0] ? p : q;
  const Relative pq = tangentSquareOf(firstOthers[0], firstOthers[1]);
  const Relative wn = tangentSquareOf(shared, result.added);
  if (!areKnown({p.square, q.square, n.square, pq, wn})) return result;

  const Axis d(p, q, pq);
  const Axis e = isSharedFirst ? Axis(w, n, wn) : Axis(n, w, wn);
  const Direction toFirst = d.direction();
  result.cross = crossOf(toFirst, e.direction());
  const Relative on = tangentSquareOf(other, result.added);
  if (!areKnown({on})) return result;
  result.left = crossOf({e.x, e.y, 6 * u * e.size}, toFirst);
  result.factor = factorOf(p, q, n, d);
  const auto& [pn, qn] = shared == firstOthers[0] ? std::tie(wn, on) : std::tie(on, wn);
  result.norm = normOf(pq * n.square, qn * p.square, pn * q.square);
  return result;
}

}  // namespace circle_voronoi
