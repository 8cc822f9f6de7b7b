// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "at.h"
#include "circle_voronoi/circle.h"
#include "dual.h"
#include "dual_keeper.h"
#include "estimate.h"
#include "face_discs.h"
#include "predicates.h"
#include "vectors.h"

namespace circle_voronoi {

inline Point centerOf(const Circle& c) { return {c.x, c.y}; }

/// Returns the signed distance of a circle from a point.
inline double distanceFrom(Point p, const Circle& c) { return length({c.x - p.x, c.y - p.y}) - c.r; }

/// Returns how much nearer circle b is to a point than circle a is. The result is accurate even where the circles lie
/// close together, seen from the point: |v| - |w| = (v - w) . (v + w) / (|v| + |w|), and v - w is the difference of the
/// centers.
///
/// Error: let l be the sum of the differences in x, y and r. Each component of the quotient is at most 1 and within
/// 8 u; the differences, the products and the sums add 5 u.
inline Estimate leadOf(Point p, const Circle& a, const Circle& b) {
  const Vector v = {a.x - p.x, a.y - p.y};
  const Vector w = {b.x - p.x, b.y - p.y};
  const double both = length(v) + length(w);
  if (both == 0) return {b.r - a.r, 0};
  const Vector middle = {(v.x + w.x) / both, (v.y + w.y) / both};
  const Vector apart = between(b, a);
  const double slack = a.r - b.r;
  const double l = std::abs(apart.x) + std::abs(apart.y) + std::abs(slack);
  return {dot(apart, middle) - slack, 16 * kUnitRoundoff * l};
}

/// The dual of a Voronoi diagram of two circles or more, with the data that insertion maintains circle by circle.
struct LiveDual {
  Dual& dual;
  FaceDiscs& discs;             ///< of its faces
  std::vector<int>& edgeOf;     ///< of each circle in the dual a half-edge that starts from it
  std::vector<char>& isHidden;  ///< of each circle whether another one hides it
  DualKeeper& keeper;
};

/// Inserts circles into a dual. A new circle cuts an edge of the cell that its center lies in, and flips take the edges
/// away that its cell has all of. Circles that it hides lose their cells.
///
/// Where more than three circles touch one disc, or nearly, a circle may come to a wrong place: the result is to be
/// judged.
class CellInserter {
 public:
  /// The arguments must outlive this object.
  explicit CellInserter(const LiveDual& live)
      : dual_(live.dual),
        discs_(live.discs),
        predicates_(live.discs.predicates()),
        edgeOf_(live.edgeOf),
        isHidden_(live.isHidden),
        keeper_(live.keeper) {}

  enum class Outcome {
    inserted,
    hidden,  ///< another circle hides it, and nothing has changed
    astray,  ///< a circle that it hides did not let itself be taken away
  };

  /// Inserts circle i. Its center most likely lies in the sector of half-edge `likely`: between the rays from the
  /// center of its origin to the ends of its bisector.
  Outcome insert(int i, int likely);

  /// Returns the circle that hides the last circle passed to `insert`.
  int hider() const { return hider_; }
  /// Returns the circles that the last circle passed to `insert` hides.
  std::span<const int> hidden() const { return hidden_; }

  std::int64_t flips() const { return flips_; }

 private:
  /// The part of an edge of the old diagram that the cell of a new circle covers: whether it covers any of it, and
  /// whether it covers the start or the end. If it covers both, only the start is used. The insertion finds the other
  /// end on its way around the new cell.
  struct Cut {
    bool isCut = false;
    bool hasStart = false;
    bool hasEnd = false;
  };

  struct CutEdge {
    int h = kPointAtInfinity;
    Cut cut;
  };

  struct Disc {
    Predicates::Triple corners;
    FaceDisc disc;
  };

  /// A half-edge opposite the new circle. Its bisector, with its origin on the left, comes from the disc of the old
  /// face beyond it, leaves the old cells at that of its own face, and comes to `near` in the new cell: in this order,
  /// otherwise the new cell covers the whole bisector.
  struct Link {
    int h;
    bool isWithin;  ///< the last two are known to be out of order
    Disc near;      ///< of an old face that is gone; without corners if it was on no disc that the new cell came in
  };

  const Circle& circle(int i) const { return discs_.circles()[at(i)]; }
  bool hides(int i, int j) const { return circle(i).r >= circle(j).r && predicates_.contains(circle(i), circle(j)); }
  /// Returns how much nearer circle b is to the center of circle i than circle a is.
  Estimate leadAt(int i, int a, int b) const { return leadOf(centerOf(circle(i)), circle(a), circle(b)); }

  /// Returns an edge of the old diagram that the cell of circle i cuts, or nothing if another circle hides i. The edge
  /// bounds the cell in which the center of i lies, and is most often `likely`. If rounding has led to a wrong cell,
  /// the search walks from cell to cell until no neighbor is nearer, and then extends to the cells around.
  std::optional<CutEdge> cutEdge(int likely, int i);

  /// Searches the cells around that of the origin of half-edge `start` for such an edge, breadth first. Rounding may
  /// hide which of many cells has the center. Some cell has a cut edge, and exact signs find it.
  std::optional<CutEdge> cutEdgeBeyond(int start, int i);

  /// Returns the half-edge, from the origin of `start`, to the neighbor that is nearest to the center of circle i.
  int nearestAround(int start, int i);

  /// Searches for a cut edge around one cell, in both directions from the edge `likely`.
  std::optional<CutEdge> cutEdgeAround(int likely, int i);

  Disc faceDisc(const Predicates::Triple& corners) const;
  Disc discAt(int h) const;
  static bool isTangentLine(const Disc& disc);

  /// Returns 1 if a disc comes before another along the bisector of a and b with a on the left, 0 if they are equal.
  int orderAlongEdge(int a, int b, const Disc& first, const Disc& second) const;

  Cut cutOf(int h, int i) const;

  /// Returns whether circle c touches a common tangent line of circles a and b between them. All three touch it.
  bool touchesBetween(int a, int b, int c) const { return exact::touchesBetween(circle(a), circle(b), circle(c)); }

  /// Finds the disc of a face that has the new circle as a corner. The face has no disc if the new circle hides one of
  /// its other circles.
  void renewDisc(int face, int i);

  /// Inserts circle i between the circles of an edge, which becomes two edges.
  void split(const CutEdge& edge, int i);

  /// Returns whether the new circle removes an edge.
  bool isLost(const Link& link, int i) const;

  /// Returns whether the new circle removes an edge to infinity: the tangent lines of its circle turn all around it, so
  /// only the order of three tangent lines decides.
  bool isHullLost(const Link& link) const;

  /// Returns a positive number if three discs follow one another counter-clockwise around a circle, a negative number
  /// if clockwise, and 0 if two are in the same direction.
  int turns(int from, const Disc& first, const Disc& second, const Disc& third) const;

  bool isAtInfinity(int h) const;

  /// Returns the sign of the turn around a circle from one disc to another.
  int turn(int from, const Disc& first, const Disc& second) const;

  /// Flips an edge: faces (a, b, i) and (b, a, d) become (a, d, i) and (b, i, d).
  void flipEdge(int h, int i);

  /// Returns whether the new cell, which contains the given disc, contains all of the bisector on this side of the
  /// disc.
  bool isWithin(int h, const Disc& lost) const;

  /// Removes the circles that the new circle hides, each of which has only two edges left. Returns whether it removed
  /// them all.
  bool removeLost();

  /// Removes a circle with two edges: faces (circle, p, q) and (circle, q, p) vanish. Returns whether the circle had
  /// two edges.
  bool remove(int circle);

  void noteEdge(int h) {
    if (dual_.origin[at(h)] != kPointAtInfinity) edgeOf_[at(dual_.origin[at(h)])] = h;
  }

  Dual& dual_;
  FaceDiscs& discs_;
  Predicates& predicates_;
  std::vector<int>& edgeOf_;
  std::vector<char>& isHidden_;
  DualKeeper& keeper_;
  std::vector<Link> stack_;
  std::vector<int> hidden_;  ///< the circles that the new one hides
  std::vector<int> lost_;    ///< the hidden circles that still have a cell
  int hider_ = kPointAtInfinity;
  std::int64_t flips_ = 0;
};

}  // namespace circle_voronoi
