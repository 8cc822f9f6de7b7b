// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "at.h"
#include "infinity.h"

namespace circle_voronoi {

/// A triangulation of the sphere (the plane and the point at infinity) in half-edges; the dual of a Voronoi diagram.
///
/// Half-edge h runs from corner origin[h] to corner origin[next(h)] with face h / 3 on its left; twin[h] runs the
/// other way with the neighboring face on its left. Corners are circle indices or kPointAtInfinity. Two corners may
/// share several edges. With m >= 2 corners besides infinity there are 2 m - 2 faces, collinear centers included
/// (Euler, m + 1 vertices on the sphere).
struct Dual {
  std::vector<int> origin;
  std::vector<int> twin;

  int faceCount() const { return static_cast<int>(origin.size() / 3); }
  int halfEdgeCount() const { return static_cast<int>(origin.size()); }
  int target(int h) const { return origin[at(next(h))]; }
  bool isFinite(int face) const {
    return origin[at(3 * face)] != kPointAtInfinity && origin[at(3 * face + 1)] != kPointAtInfinity &&
           origin[at(3 * face + 2)] != kPointAtInfinity;
  }

  /// The next half-edge around the origin of one, counter-clockwise.
  int around(int h) const { return twin[at(previous(h))]; }

  /// Returns the next half-edge around the origin of one, clockwise.
  int aroundClockwise(int h) const { return next(twin[at(h)]); }

  /// Returns whether a half-edge and its twin fit together, between two faces and two corners.
  bool fits(int h) const {
    const int t = twin[at(h)];
    return t >= 0 && t < halfEdgeCount() && twin[at(t)] == h && t / 3 != h / 3 && origin[at(t)] == target(h) &&
           target(t) == origin[at(h)] && origin[at(h)] != origin[at(t)];
  }

  void link(int h, int t) {
    twin[at(h)] = t;
    twin[at(t)] = h;
  }

  /// Flips an edge: faces (a, b, c) and (b, a, d), of half-edges h = (a, b) and its twin, become (a, d, c) and
  /// (b, c, d).
  void flip(int h) {
    const int t = twin[at(h)];
    const int bc = next(h);
    const int ad = next(t);
    link(h, twin[at(ad)]);
    link(t, twin[at(bc)]);
    origin[at(bc)] = origin[at(previous(t))];
    origin[at(ad)] = origin[at(previous(h))];
    link(bc, ad);
  }

  // The processor would often predict branches wrongly here.
  static int next(int h) { return h + 1 - 3 * static_cast<int>(h % 3 == 2); }
  static int previous(int h) { return h - 1 + 3 * static_cast<int>(h % 3 == 0); }
};

/// The corners of the face of half-edge h, its origin first.
inline std::array<int, 3> cornersOf(const Dual& dual, int h) {
  return {dual.origin[at(h)], dual.target(h), dual.origin[at(Dual::previous(h))]};
}

}  // namespace circle_voronoi
