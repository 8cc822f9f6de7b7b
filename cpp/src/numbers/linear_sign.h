// SPDX-License-Identifier: GPL-3.0-or-later
//
// With the letters of exact.cpp: seen from a circle o, the vertex of (o, u, v) is the homogeneous point (e |D|^2 : 2 t
// |D|^2) at the distance |D|^2 / (2 t |D|^2) from o. So what is linear in the vertex and its distance, alpha x + beta y
// + gamma rho + delta, has the sign of p + q sqrt(d), d = g_u g_v g_uv, with
//   p = -D.s (alpha D.x + beta D.y) + gamma |D|^2 + 2 delta (N.x D.y - N.y D.x),
//   q = beta D.x - alpha D.y + 2 delta N.s.
// At infinity N is 0, and what is left is the sign for the direction of the asymptote.
#pragma once

#include <type_traits>

#include "relative_circle.h"

namespace circle_voronoi {

/// Stands for a coefficient that is 0.
struct None {};

/// Returns the sign of alpha x + beta y + gamma rho + delta at the vertex of a circle and two others that it sees.
template <class Number, class Alpha, class Beta, class Gamma, class Delta>
int linearSign(const exact::RelativeCircle<Number>& u, const exact::RelativeCircle<Number>& v, const Alpha& alpha,
               const Beta& beta, const Gamma& gamma, const Delta& delta) {
  const auto d = exact::axisOf(u, v);
  auto p = -(d.s * (alpha * d.x + beta * d.y));
  auto q = beta * d.x - alpha * d.y;
  if constexpr (!std::is_same_v<Gamma, None>) p = p + gamma * exact::planeDot(d, d);
  if constexpr (!std::is_same_v<Delta, None>) {
    const auto n = exact::cross(u.v, v.v);
    const auto twice = delta + delta;
    p = p + twice * exact::planeCross(n, d);
    q = q + twice * n.s;
  }
  const auto square = u.g * v.g * exact::tangentSquare(u, v);
  return exact::signOf((p * p - q * q * square).sign(), [&] { return p.sign(); }, [&] { return q.sign(); });
}

}  // namespace circle_voronoi
