// SPDX-License-Identifier: GPL-3.0-or-later
#include "three_touch_disc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "at.h"
#include "estimate.h"
#include "exact.h"
#include "homogeneous_disc.h"
#include "refined.h"

namespace circle_voronoi {
namespace {

/// Rotates three circles so that the one with the smallest center, by x and then y, comes first.
exact::Face fromLeast(exact::Face circles) {
  const auto isLess = [](const Circle* a, const Circle* b) { return std::pair(a->x, a->y) < std::pair(b->x, b->y); };
  std::rotate(circles.begin(), std::min_element(circles.begin(), circles.end(), isLess), circles.end());
  return circles;
}

}  // namespace

std::optional<Vertex> vertexAt(const CornerDisc& placed, const exact::Face& circles) {
  const auto& [disc, corner] = placed;
  const Circle& o = *circles[at(corner)];
  // The bound includes the error of w times the longer side, so w has at least this relative accuracy, too.
  const Vector u = between(o, *circles[at((corner + 1) % 3)]);
  const Vector v = between(o, *circles[at((corner + 2) % 3)]);
  if (!(disc.error * disc.error <= 0x1p-72 * disc.w * disc.w * std::max(dot(u, u), dot(v, v)))) return std::nullopt;
  return Vertex{o.x + disc.x / disc.w, o.y + disc.y / disc.w, disc.rho / disc.w - o.r};
}

std::optional<ThreeTouchDisc> threeTouchDisc(const Circle& a, const Circle& b, const Circle& c) {
  const exact::Face circles = {&a, &b, &c};
  const auto isLess = [](const Circle* i, const Circle* j) {
    return std::tuple(i->r, i->x, i->y) < std::tuple(j->r, j->x, j->y);
  };
  const auto io = static_cast<std::size_t>(std::min_element(circles.begin(), circles.end(), isLess) - circles.begin());
  const std::size_t iu = (io + 1) % 3;
  const std::size_t iv = (io + 2) % 3;
  const Circle& o = *circles[io];

  const Difference u(*circles[iu], o);
  const Difference v(*circles[iv], o);
  const Difference w(*circles[iv], *circles[iu]);
  const double uu = lorentzDot(u, u);
  const double vv = lorentzDot(v, v);
  const Difference n = cross(u, v);
  const Difference vn = cross(v, n);
  const Difference nu = cross(n, u);
  // The point of the planes' common line nearest the origin; the line runs along n.
  const double scale = 1 / (2 * (n.x * n.x + n.y * n.y + n.s * n.s));
  const Difference base(scale * (uu * vn.x + vv * nu.x), scale * (uu * vn.y + vv * nu.y),
                        scale * (uu * vn.s + vv * nu.s));
  const double qa = lorentzDot(n, n);
  const double qb = lorentzDot(base, n);
  const double qc = lorentzDot(base, base);
  // qb^2 - qa qc is a quarter of the product of the squared tangent lengths, which do not cancel and are positive
  // unless one circle hides another.
  const double discriminant = uu * vv * lorentzDot(w, w);
  if (!(discriminant >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant) / 2;
  // Both forms are the root (-qb - root) / qa; each is used where it does not cancel.
  const double t = qb > 0 ? (-qb - root) / qa : qc / (-qb + root);
  const Vector center = {base.x + t * n.x, base.y + t * n.y};
  const double rho = base.s + t * n.s;
  if (!(rho >= 0) || !std::isfinite(rho)) return std::nullopt;

  ThreeTouchDisc result;
  result.disc = {o.x + center.x, o.y + center.y, rho - o.r};
  result.toCenter[io] = center;
  result.toCenter[iu] = {center.x - u.x, center.y - u.y};
  result.toCenter[iv] = {center.x - v.x, center.y - v.y};
  return result;
}

std::optional<Vertex> vertexOf(const Circle& a, const Circle& b, const Circle& c) {
  if (const auto vertex = vertexAt(discOf(a, b, c), {&a, &b, &c})) return vertex;
  return refinedVertexOf(a, b, c);
}

std::optional<Vertex> refinedVertexOf(const Circle& a, const Circle& b, const Circle& c) {
  // Of equal radii, the disc is seen from the first.
  const exact::Face circles = fromLeast({&a, &b, &c});
  if (const auto vertex = vertexAt(refinedDiscOf(*circles[0], *circles[1], *circles[2]), circles)) return vertex;
  return exact::disc(circles);
}

}  // namespace circle_voronoi
