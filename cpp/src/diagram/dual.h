// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "infinity.h"

namespace circle_voronoi {

/// A triangulation of the sphere (the plane and the point at infinity) in half-edges; the dual of a Voronoi diagram.
///
/// Half-edge h runs from corner origin[h] to corner origin[next(h)] with face h / 3 on its left; twin[h] runs the
/// other way with the neighbouring face on its left. Corners are circle indices or kPointAtInfinity. Two corners may
/// share several edges. With m >= 2 corners besides infinity there are 2 m - 2 faces, collinear centres included
/// (Euler, m + 1 vertices on the sphere).
struct Dual {
  std::vector<int> origin;
  std::vector<int> twin;

  int faceCount() const { return static_cast<int>(origin.size() / 3); }
  int halfEdgeCount() const { return static_cast<int>(origin.size()); }
  int target(int h) const { return origin[next(h)]; }
  bool isFinite(int face) const {
    return origin[3 * face] != kPointAtInfinity && origin[3 * face + 1] != kPointAtInfinity &&
           origin[3 * face + 2] != kPointAtInfinity;
  }

  void link(int h, int t) {
    twin[h] = t;
    twin[t] = h;
  }

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

/// The corners of the face of half-edge h, its origin first.
inline std::array<int, 3> cornersOf(const Dual& dual, int h) {
  return {dual.origin[h], dual.target(h), dual.origin[Dual::previous(h)]};
}

}  // namespace circle_voronoi
