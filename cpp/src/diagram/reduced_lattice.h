// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "circle_voronoi/point.h"
#include "vectors.h"

namespace circle_voronoi {

/// The shortest periods of a lattice, and their coefficients in the given periods.
struct ReducedLattice {
  Vector a;  ///< the shorter one; zero if the given periods are parallel
  Vector b;  ///< to the left of a
  std::array<double, 2> ofA = {1, 0};
  std::array<double, 2> ofB = {0, 1};

  /// Returns how far p lies along each period, from the origin: p = u a + v b.
  Vector placeOf(Vector p) const {
    const double area = cross(a, b);
    return {cross(p, b) / area, cross(a, p) / area};
  }
};

/// Reduces a lattice (Lagrange, Gauss): subtracts the shorter period from the longer one while that makes it shorter.
///
/// Precondition: the coordinates are integers of at most 51 bits. Then the periods are exact, because no multiple of
/// the shorter one is longer than about the longer one. Parallel periods end with a period of zero, as in Euclid's
/// algorithm. The numbers of given periods are exact below 2^53.
inline ReducedLattice reduce(Vector a, Vector b) {
  ReducedLattice reduced = {a, b};
  auto& [shorter, longer, ofShorter, ofLonger] = reduced;
  for (;;) {
    if (dot(longer, longer) < dot(shorter, shorter)) {
      std::swap(shorter, longer);
      std::swap(ofShorter, ofLonger);
    }
    const double square = dot(shorter, shorter);
    if (square == 0) return reduced;
    const double ratio = dot(shorter, longer) / square;
    const double times = std::floor(std::abs(ratio) + 0.5) * (ratio < 0 ? -1 : 1);
    const Vector next = {longer.x - times * shorter.x, longer.y - times * shorter.y};
    if (!(dot(next, next) < dot(longer, longer))) break;
    longer = next;
    ofLonger = {ofLonger[0] - times * ofShorter[0], ofLonger[1] - times * ofShorter[1]};
  }
  if (cross(shorter, longer) < 0) {
    longer = {-longer.x, -longer.y};
    ofLonger = {-ofLonger[0], -ofLonger[1]};
  }
  return reduced;
}

}  // namespace circle_voronoi
