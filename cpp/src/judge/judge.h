// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "dual.h"
#include "predicates.h"
#include "proof.h"

namespace circle_voronoi {

/// The flaw of a dual, if any, and its place.
struct Verdict {
  Flaw flaw = Flaw::none;
  int circle = kNone;    ///< index into the circles judged
  int face = kNone;      ///< face of the dual
  int halfEdge = kNone;  ///< half-edge of the dual
  /// If the dual is right, a half-edge of each edge of length zero, where more than three circles touch one disc.
  std::vector<int> ties = {};
  /// The proof, if the dual is right, without the orders.
  Proof proof = {};

  bool isRight() const { return flaw == Flaw::none; }
};

/// Judges whether `dual` is the dual of the Voronoi diagram of `circles`, and no circle hides another. Linear time.
///
/// Theorem. Let the plane be covered by regions V_i, one for each circle, such that f(p) = d_i(p) for p in V_i is well
/// defined and continuous, and c_i lies in V_i. Then the V_i are the Voronoi cells.
/// Proof. f is 1-Lipschitz: it is continuous and piecewise a distance less a constant. f(c_j) = -r_j, so
/// f(p) <= |p - c_j| - r_j = d_j(p) for all p and j. As f(p) is one of the d_j(p), it is the smallest.
///
/// The judge checks the properties that make the faces of the dual such regions: adjacency, Euler's count, a disc at
/// every face, the ends of every edge in order along their bisector (so each region is a union of sectors around its
/// center, glued along common bisector arcs), and one full turn of every region around its center and of the hull.
/// These signs require that no circle contains a neighbor, which is checked for every edge. That no circle at all
/// contains another follows: by the theorem each center lies in the region of its circle. These checks suffice. Where
/// one sector ends at a bisector arc another begins, so all points of the plane lie in the same number of sectors, also
/// if only one connected part of the dual is counted. Far out that number is how often the hull turns: once for one
/// part and not at all for the others, which therefore have no sectors. Hence this part covers the plane once. It has
/// all m circles, for each has its full turn there, and infinity; a closed surface with m + 1 corners or more has 2 m -
/// 2 faces or more, and no more if and only if it is a sphere and each corner one fan of faces. As there are 2 m - 2
/// faces in all, there are no others.
///
/// A disc is a function of the corners of its face, and the order of the ends of an edge is one of its four circles.
/// `proof` may have discs and orders that Predicates found for this very dual: the judge rests on these. It finds
/// missing parts itself, such as those of faces that a builder has changed. With CIRCLE_VORONOI_CHECK_PROOFS it finds
/// everything, too, and compares.
Verdict judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, Proof proof = {},
              Threads threads = Threads());

/// Marks hidden circles among all. Returns the first of them that is repeated, or whose index or that of its hider is
/// out of range, if there is one.
std::optional<CircleIndex> markHidden(std::span<const HiddenCircle> hidden, std::span<std::uint8_t> isHidden);

/// Judges whether each hidden circle lies in a circle that is not hidden, and names each circle once. The verdict names
/// the first that does not.
Verdict judgeHidden(std::span<const Circle> circles, std::span<const HiddenCircle> hidden);

/// Returns the error if a hidden circle does not lie in the visible circle that is named for it. The error has the
/// index of the hidden circle.
std::optional<Error> refusalOfHidden(std::span<const Circle> circles, std::span<const HiddenCircle> hidden);

}  // namespace circle_voronoi
