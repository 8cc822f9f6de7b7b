// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/box.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// The known properties of the circles that are missing from a diagram: their centers lie outside the box, and their
/// radii are at most maxRadius. More generally, let inside(p) be the smallest signed distance of p from the lines of
/// the box's sides, positive on the side of the box. Then each missing circle has
///
///     inside(center) + radius <= maxRadius.
///
/// This also holds for any circle, however large, that reaches no farther than maxRadius across the line of some side.
/// So if the diagram has all circles whose bounding squares meet the box, maxRadius is 0.
struct MissingCircles {
  /// Sides may be infinite. If all four are, no circle is missing.
  Box box;
  double maxRadius = 0;
};

/// The parts of a diagram that are also parts of the whole diagram, whatever the missing circles are.
struct FinalCells {
  /// For each circle, by how much you must widen the box on all sides, and compute the diagram of the circles in it
  /// anew, until the circle's cell, or what hides it, is sure to be final. 0 means that it is final. Infinite for an
  /// unbounded cell.
  std::vector<double> neededHalo;
  std::vector<std::uint8_t> vertices;  ///< for each vertex whether it is final
  std::vector<std::uint8_t> edges;     ///< for each edge whether it is final

  [[nodiscard]] bool isFinal(CircleIndex circle) const { return neededHalo[static_cast<std::size_t>(circle)] == 0; }
};

/// Determines which parts of a certified diagram are final. Linear time.
///
/// Let f(p) be the distance of p from the nearest circle of the diagram, and R = maxRadius.
///
/// Theorem. If f(p) < inside(p) - R, no missing circle is as near to p as one of the diagram.
/// Proof. inside is the minimum of four 1-Lipschitz functions, so it is 1-Lipschitz. For a missing circle with center c
/// and radius r, |p - c| - r >= inside(p) - inside(c) - r >= inside(p) - R.
/// Converse. If f(p) > inside(p) - R, a missing circle may be nearer to p: go from p straight out across the nearest
/// side to a point c with inside(c) <= R. A circle around c with radius R - inside(c) is at distance inside(p) - R.
///
/// A vertex is final if its disc (v, rho) has rho < inside(v) - R: the disc widened by R lies within the box.
///
/// An edge is final if both its ends are.
/// Proof. Let p(t) run along the bisector as in curve.h, with s = e^t, and let c be half the distance of the foci. Its
/// distance from the center of the smaller circle is c cosh t - |a|, and f is that minus a radius. The coordinate of
/// p(t) in any direction n is -|a| (n . along) cosh t + b (n . across) sinh t plus a constant. So f minus the distance
/// from a side is A cosh t + B sinh t plus a constant, with A = c + |a| (n . along) and |B| = b |n . across|. Here
/// A >= 0 and A^2 - B^2 = (c (n . along) + |a|)^2 >= 0, so the function is convex in t, and largest at an end. In other
/// words, the disc of every point of an edge lies in the convex hull of the discs of its ends. (A circle may still cut
/// an edge between its ends, but not a circle beyond a line that both discs keep away from.)
///
/// A cell is final if it is bounded and all its vertices are final.
/// Proof. Suppose a missing circle is nearer to a point p of cell i. Let b be the point where the ray from c_i through
/// p leaves the cell. Then the missing circle is nearer to b, too: its distance grows by at most |b - p|, and that of
/// circle i grows by exactly that much.
///
/// Final parts have the same circles in the diagram of all circles, and each vertex has the same bits, because
/// `compute` makes a vertex from its three circles alone, and divides the faces of discs that more than three circles
/// touch by the positions of the centers alone. The circles may be in any order in both diagrams.
/// A wider box keeps final parts final. The `neededHalo` is enough: with more circles f is nowhere larger, so cells
/// only shrink. And d_i minus the distance from a side is convex along lines, so in a bounded cell it is largest at a
/// vertex.
///
/// The discs are computed anew from the circles. A part is not called final if rounding might decide it. Rounding is
/// accounted for with 2^-30 of the disc and of the coordinates.
///
/// Errors: nonFinite, negativeRadius (unless the radii are weights), coordinateTooLarge, coordinateTooSmall,
/// tooManyCircles, badArithmetic; badOption if the box is empty, or maxRadius is negative or not finite; badInput if
/// the diagram names circles or vertices that do not exist, or is a power diagram. With Metric::centers all circles are
/// points, also those outside.
CIRCLE_VORONOI_API Result<FinalCells> finalCells(const Diagram& diagram, const MissingCircles& missing);

}  // namespace circle_voronoi
