// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What is known of the circles that a diagram has not been told of: their centres are outside the box, and their radii
/// are at most maxRadius. More generally, with inside(p) the least of the signed distances of p from the lines of the
/// box's sides, positive on the side of the box, each of these circles has
///
///     inside(centre) + radius <= maxRadius,
///
/// as one has, however large, that reaches no farther than maxRadius across the line of some side. So if the diagram
/// has all circles whose squares around them meet the box, maxRadius is 0.
struct Known {
  /// Sides may be infinite: with all four, nothing is outside.
  Box box;
  double maxRadius = 0;
};

/// Which parts of a diagram are those of the whole diagram, whatever lies outside.
struct FinalCells {
  /// Of each circle, by how much the box has to be widened on all sides (with the diagram computed anew from the
  /// circles in it) until what the diagram says of it, its cell or what hides it, is sure to be final. 0: it is final.
  /// Infinite for an unbounded cell.
  std::vector<double> neededHalo;
  /// Of each vertex and of each edge whether it is final.
  std::vector<std::uint8_t> vertices;
  std::vector<std::uint8_t> edges;

  bool isFinal(CircleIndex circle) const { return neededHalo[static_cast<std::size_t>(circle)] == 0; }
};

/// Tells in linear time what of a certified diagram of `circles` is final.
///
/// Let f(p) be the distance of p from the nearest circle of the diagram, and R = maxRadius.
///
/// Theorem. Where f(p) < inside(p) - R, no circle outside is as near to p as one of the diagram.
/// Proof. inside is the least of four functions that change by at most the distance gone, so it is such a function. For
/// a circle outside, with centre c and radius r, |p - c| - r >= inside(p) - inside(c) - r >= inside(p) - R.
/// Converse. Where f(p) > inside(p) - R, a circle may lie outside that is nearer to p: go from p straight out across
/// the nearest side, to a point c with inside(c) <= R; with the radius R - inside(c) its distance is inside(p) - R.
///
/// A vertex is final if its disc (v, rho) has rho < inside(v) - R: the disc widened by R lies within the box.
/// An edge is final if both its ends are.
/// Proof. Let p(t) run along the bisector as in curve.h, with s = e^t and c half the distance of the foci: its distance
/// from the smaller circle's centre is c cosh t - |a|, so f is that less a radius. A coordinate of p(t) in any
/// direction n is -|a| (n . along) cosh t + b (n . across) sinh t and a constant. So f less a side's distance is A cosh
/// t + B sinh t and a constant, with A = c + |a| (n . along) and |B| = b |n . across|; A >= 0, and A^2 - B^2 = (c (n .
/// along) + |a|)^2 >= 0. So it is convex in t, and largest at an end: the disc of every point of an edge lies in the
/// convex hull of the discs of its ends. (A circle may cut an edge between its ends all the same, but not one that
/// stays beyond a line that both discs keep away from.) A cell is final if it is bounded and all its vertices are.
/// Proof. Were a circle outside nearer to a point p of cell i, it would be nearer still, if anything, to the point b
/// where the ray from c_i through p leaves the cell: its distance grows by |b - p| at most, that from i by as much.
///
/// What is final has the same circles, and each vertex the same bits, in the diagram of all circles, as `compute` makes
/// both: by their lowest index, and where more than three circles touch a disc by the places of their centres alone. So
/// the circles have to be in the same order in both.
/// A wider box makes no final part one that is not. That `neededHalo` is enough: with more circles f is nowhere larger,
/// so a cell only shrinks; d_i less a side's distance is convex along lines, so in a bounded cell it is largest at a
/// vertex.
///
/// The discs are found anew from the circles; what their rounding might decide is not called final. Of the converse it
/// takes a part of 2^-30 of a disc and of the coordinates.
///
/// Errors: those of `validate` (nonFinite, negativeRadius unless the diagram is one of weights, coordinateTooLarge,
/// tooManyCircles); badOption, if the box is empty or maxRadius negative or not finite; badInput, if the diagram names
/// circles or vertices that are not there.
Result<FinalCells> finalCells(const Diagram& diagram, const Known& known);

}  // namespace circle_voronoi
