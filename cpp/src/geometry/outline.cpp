// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "arc_measure.h"
#include "cell_limits.h"
#include "circle_arc.h"
#include "circle_voronoi/cells.h"
#include "clip.h"
#include "guarded.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

constexpr std::array<Vector, 4> kAxes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
/// Where there is no side to say how far outside is far, as a multiple of the distance of the region.
constexpr double kFarOut = 64;
/// Tolerance for the crossings of a line and a curve, relative to the size of the part that is clipped. If the two are
/// nearly tangent, a rounding error moves the crossing by the square root of that error.
constexpr double kSlack = 0x1p-20;
/// Largest angle between two directions whose order rounding may exchange on a narrow branch, in radians.
constexpr double kNear = 0x1p-20;

/// A piece of a loop. The pieces of an edge follow its direction, so that both cells of the edge cut it alike, to the
/// bit.
struct CutPiece {
  CurvePart part;             ///< of a segment or an arc of a circle only the ends count
  SideIndex side = {};        ///< kNone: a segment, or an arc
  double r = 0;               ///< of an arc
  std::int32_t line = kNone;  ///< the side of the region on whose line a segment lies; kNone: far outside

  bool isSegment() const { return side == kNone && r == 0; }
  bool isAgainst() const { return side != kNone && side % 2 == 1; }
  Point start() const { return isAgainst() ? part.curve.end : part.curve.start; }
  Point end() const { return isAgainst() ? part.curve.start : part.curve.end; }
  std::int32_t cutStart() const { return isAgainst() ? part.cutTo : part.cutFrom; }
  std::int32_t cutEnd() const { return isAgainst() ? part.cutFrom : part.cutTo; }
  bool isPoint() const { return part.isPoint() || (isSegment() && start() == end()); }
};

using CutLoop = std::vector<CutPiece>;

CutPiece pieceBetween(Point start, Point end, double r, std::int32_t line) {
  CutPiece piece;
  piece.part.curve.start = start;
  piece.part.curve.end = end;
  piece.r = r;
  piece.line = line;
  return piece;
}

/// The part of a loop in a half-plane from where it comes in to where it goes out.
struct Chain {
  CutLoop pieces;
  Point entry;
  Point exit;
};

/// The approximate extent of the chains from the line of a side.
double extentOf(const std::vector<Chain>& chains, const HalfPlane& half) {
  double extent = 0;
  for (const Chain& chain : chains) {
    for (const CutPiece& piece : chain.pieces)
      extent = std::max(extent, largestOf(vectorTo(half.from(), piece.start())));
  }
  return extent;
}

/// The turn from u to v as a difference of pseudo-angles, of which four are a full turn. It may be slightly below 0.
double sweep(Vector u, Vector v) {
  const double difference = pseudoAngle(v) - pseudoAngle(u);
  return difference <= -1 ? difference + 4 : difference > 3 ? difference - 4 : difference;
}

/// A cell as a loop, cut by one line after the other. Every step is continuous: whatever rounding does to a point moves
/// the result by as little.
class LoopCutter {
 public:
  /// `disc`: the disc around the circle's center to which the cell is cut, if the limits have a distance.
  LoopCutter(const Diagram& diagram, CircleIndex circle, const Limits& limits, const std::optional<Circle>& disc)
      : diagram_(diagram), circle_(circle), limits_(limits), disc_(disc) {
    if (limits.region != nullptr) halves_ = halfPlanesOf(*limits.region);
  }

  Outline run() {
    begin();
    for (std::size_t h = 0; h < halves_.size() && !loops_.empty(); ++h) cut(h);
    Outline outline;
    for (CutLoop& loop : loops_) {
      std::vector<OutlinePiece> pieces = finished(loop);
      if (!pieces.empty()) outline.push_back(std::move(pieces));
    }
    return outline;
  }

  /// Returns whether entries and exits have alternated along each line, and nothing far outside is left.
  bool isSound() const { return isSound_; }

 private:
  Point center() const {
    const Circle& c = diagram_.circles[static_cast<std::size_t>(circle_)];
    return {c.x, c.y};
  }

  /// The cell within the disc; without one, as far as its sides are bounded, and around the region from where they go
  /// to infinity.
  void begin() {
    CutLoop sides;
    for (const SideIndex side : diagram_.sides(circle_)) {
      const EdgeIndex edge = Diagram::edgeOf(side);
      if (auto part = partAtDistance(diagram_, edge, limits_)) sides.push_back({*std::move(part), side});
    }
    if (sides.empty()) {
      const double r = disc_ ? disc_->r : kFarOut * reachFrom(center(), *limits_.region);
      CutLoop loop;
      Point last = onAxis(center(), r, 0);
      for (const std::size_t k : {1U, 2U, 3U, 0U}) addStep(loop, last, onAxis(center(), r, k));
      loops_.push_back(std::move(loop));
      return;
    }
    closeGaps(sides);
  }

  /// Joins the ends that are cut off to the next ones, counter-clockwise around the center.
  void closeGaps(const CutLoop& sides) {
    struct Gap {
      Vector from;
      Vector to;
      bool isOpen = false;
      bool isNear = false;  ///< of a full turn or of none, but for rounding
      double sweep = 0;
    };
    std::vector<Gap> gaps(sides.size());
    double total = 0;
    double radius = 0;
    Gap* nearest = nullptr;
    const Point middle = pointIn(sides);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const CutPiece& piece = sides[k];
      const CutPiece& next = sides[(k + 1) % sides.size()];
      total += sweepOf(piece);
      Gap& gap = gaps[k];
      gap.isOpen = piece.cutEnd() != kNone || next.cutStart() != kNone || piece.end() != next.start();
      if (!gap.isOpen) continue;
      gap.from = vectorTo(middle, piece.end());
      gap.to = vectorTo(middle, next.start());
      radius = std::max({radius, lengthOf(gap.from), lengthOf(gap.to)});
      // From any point of a cell of the power diagram, these directions stay in the cell: it is convex.
      if (diagram_.metric == Metric::power) {
        gap.from = piece.isAgainst() ? negative(piece.part.curve.bisector.across) : piece.part.curve.bisector.across;
        gap.to = next.isAgainst() ? next.part.curve.bisector.across : negative(next.part.curve.bisector.across);
      }
      const double unit = unitFor(std::max(largestOf(gap.from), largestOf(gap.to)));
      const Vector u = measuredIn(unit, gap.from);
      const Vector v = measuredIn(unit, gap.to);
      gap.isNear = dot(u, v) > 0 && std::abs(cross(u, v)) <= kNear * dot(u, v);
      gap.sweep = sweep(u, v);
      if (!gap.isNear && gap.sweep < 0) gap.sweep += 4;
      total += gap.sweep;
      if (gap.isNear && (nearest == nullptr || gap.sweep < nearest->sweep)) nearest = &gap;
    }
    if (disc_) radius = disc_->r;
    // Together they go around the center once. On a branch that folds up, directions are but rounding.
    Gap* full = nullptr;
    if (nearest != nullptr && total < 2 && diagram_.metric != Metric::power) {
      const double share = radius / lengthOf(nearest->from);
      const Point opposite = {center().x - share * nearest->from.x, center().y - share * nearest->from.y};
      if (contains(diagram_, circle_, opposite)) full = nearest;
    }
    CutLoop loop;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      loop.push_back(sides[k]);
      const Gap& gap = gaps[k];
      if (!gap.isOpen) continue;
      Point last = sides[k].end();
      std::size_t quarter = quarterOf(gap.from);
      const std::size_t lastQuarter = quarterOf(gap.to);
      const bool isOneQuarter = quarter == lastQuarter && turn(gap.from, gap.to) >= 0;
      if (&gap == full || (!gap.isNear && !isOneQuarter)) {
        do {
          quarter = (quarter + 1) % kAxes.size();
          addStep(loop, last, onAxis(middle, radius, quarter));
        } while (quarter != lastQuarter);
      }
      addStep(loop, last, sides[(k + 1) % sides.size()].start());
    }
    loops_.push_back(std::move(loop));
  }

  /// The angle that a side covers around the center. From the apex of a branch that bends around it, it turns by less
  /// than half a turn to either side.
  double sweepOf(const CutPiece& piece) const {
    const auto& [bisector, from, to, start, end] = piece.part.curve;
    const Vector u = vectorTo(center(), piece.start());
    const Vector v = vectorTo(center(), piece.end());
    if (!(from < 1 && 1 < to) || bisector.origin != center()) return sweep(u, v);
    return sweep(u, bisector.along) + sweep(bisector.along, v);
  }

  void addStep(CutLoop& loop, Point& last, Point next) const {
    if (last != next) loop.push_back(pieceBetween(last, next, disc_ ? disc_->r : 0, kNone));
    last = next;
  }

  static Vector negative(Vector v) { return {-v.x, -v.y}; }
  static Point onAxis(Point middle, double r, std::size_t k) {
    return {middle.x + r * kAxes[k].x, middle.y + r * kAxes[k].y};
  }

  /// A point of the cell: the center, but for the power diagram the nearest end of a side, since a cell need not
  /// contain its center.
  Point pointIn(const CutLoop& sides) const {
    if (diagram_.metric != Metric::power) return center();
    Point nearest = sides.front().start();
    for (const CutPiece& piece : sides) {
      for (const Point p : {piece.start(), piece.end()}) {
        if (lengthOf(vectorTo(center(), p)) < lengthOf(vectorTo(center(), nearest))) nearest = p;
      }
    }
    return nearest;
  }

  /// The quarter of the circle in which a direction lies: from an axis to before the next.
  static std::size_t quarterOf(Vector v) {
    if (v.y >= 0) return v.x > 0 ? 0 : v.y > 0 ? 1 : 2;
    return v.x < 0 ? 2 : 3;
  }

  /// Along the line, from left to right as seen from outside, exits and entries alternate, and the part inside begins
  /// at an exit. Hence the k-th exit goes on to the k-th entry, even if rounding changes the order of exits and entries
  /// at one place.
  void cut(std::size_t h) {
    const HalfPlane& half = halves_[h];
    std::vector<CutLoop> loops;
    std::vector<Chain> chains;
    for (CutLoop& loop : loops_) cutLoop(h, loop, loops, chains);
    loops_ = std::move(loops);
    if (chains.empty()) return;

    const std::size_t count = chains.size();
    std::vector<double> exits;
    std::vector<double> entries;
    for (const Chain& chain : chains) {
      exits.push_back(half.place(chain.exit));
      entries.push_back(half.place(chain.entry));
    }
    std::vector<std::size_t> byExit(count);
    for (std::size_t i = 0; i < count; ++i) byExit[i] = i;
    std::vector<std::size_t> byEntry = byExit;
    std::ranges::stable_sort(byExit, {}, [&](std::size_t i) { return exits[i]; });
    std::ranges::stable_sort(byEntry, {}, [&](std::size_t i) { return entries[i]; });
    std::vector<std::size_t> next(count);
    const double rounding =
        kRounding * std::max(largestOf({center().x, center().y}), largestOf({half.from().x, half.from().y}));
    const double slack = kSlack * extentOf(chains, half) + rounding;
    for (std::size_t k = 0; k < count; ++k) {
      next[byExit[k]] = byEntry[k];
      const bool isAhead = exits[byExit[k]] <= entries[byEntry[k]] + slack;
      const bool isBeforeNext = k + 1 == count || entries[byEntry[k]] <= exits[byExit[k + 1]] + slack;
      if (!isAhead || !isBeforeNext) isSound_ = false;
    }
    std::vector<bool> isDone(count, false);
    for (std::size_t i = 0; i < count; ++i) {
      if (isDone[i]) continue;
      CutLoop loop;
      for (std::size_t j = i; !isDone[j]; j = next[j]) {
        isDone[j] = true;
        std::ranges::move(chains[j].pieces, std::back_inserter(loop));
        const Point to = chains[next[j]].entry;
        if (chains[j].exit != to) loop.push_back(pieceBetween(chains[j].exit, to, 0, half.side()));
      }
      loops_.push_back(std::move(loop));
    }
  }

  /// Adds a loop to `loops` if it is all inside, otherwise its parts to `chains`.
  void cutLoop(std::size_t h, CutLoop& loop, std::vector<CutLoop>& loops, std::vector<Chain>& chains) const {
    const std::int32_t side = halves_[h].side();
    const std::size_t first = chains.size();
    bool isLinked = false;       // whether the last chain goes on with the next piece
    bool firstIsLinked = false;  // whether the first chain goes on from the last piece
    std::array<CutPiece, 2> kept;
    for (const CutPiece& piece : loop) {
      const std::size_t count = cutPiece(h, piece, kept);
      if (count == 0) isLinked = false;
      for (std::size_t k = 0; k < count; ++k) {
        const bool isCut = kept[k].cutStart() == side;
        if (isCut || !isLinked) {
          firstIsLinked = firstIsLinked || !isCut;
          chains.emplace_back().entry = kept[k].start();
        }
        isLinked = kept[k].cutEnd() != side;
        chains.back().exit = kept[k].end();
        if (!kept[k].isPoint()) chains.back().pieces.push_back(std::move(kept[k]));
      }
    }
    if (isLinked && firstIsLinked) {
      if (chains.size() == first + 1) {
        chains.pop_back();
        loops.push_back(std::move(loop));
        return;
      }
      Chain& last = chains.back();
      last.exit = chains[first].exit;
      std::ranges::move(chains[first].pieces, std::back_inserter(last.pieces));
      chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(first));
    }
    // Where a loop only touches the line from outside, a point is left.
    std::erase_if(chains, [](const Chain& chain) { return chain.pieces.empty(); });
  }

  /// The parts of a piece in a half-plane, in the order of the loop.
  std::size_t cutPiece(std::size_t h, const CutPiece& piece, std::array<CutPiece, 2>& kept) const {
    if (piece.side != kNone) {
      std::array<CurvePart, 2> parts;
      const std::size_t count = cutPart(piece.part, halves_[h], parts);
      for (std::size_t k = 0; k < count; ++k) {
        kept[k] = piece;
        kept[k].part = parts[piece.isAgainst() ? count - 1 - k : k];
      }
      return count;
    }
    const HalfPlane& half = halves_[h];
    const bool hasStart = half.height(piece.start()) >= 0;
    const bool hasEnd = half.height(piece.end()) >= 0;
    kept[0] = piece;
    const auto endAt = [&](std::size_t k, Point p) {
      kept[k].part.curve.end = p;
      kept[k].part.cutTo = half.side();
    };
    const auto startAt = [&](std::size_t k, Point p) {
      kept[k].part.curve.start = p;
      kept[k].part.cutFrom = half.side();
    };
    if (piece.isSegment()) {
      if (hasStart == hasEnd) return hasStart ? 1 : 0;
      const Point p = crossingOf(h, piece);
      if (hasStart) {
        endAt(0, p);
      } else {
        startAt(0, p);
      }
      return 1;
    }
    const double size = lengthOf(half.along());
    const Vector along = measuredIn(size, half.along());
    const double depth = half.height(center()) / size;
    const Vector toMiddle = hasStart ? Vector{along.y, -along.x} : Vector{-along.y, along.x};
    if (hasStart == hasEnd) {
      const bool turnsBack = turn(vectorTo(center(), piece.start()), toMiddle) > 0 &&
                             turn(toMiddle, vectorTo(center(), piece.end())) > 0 && std::abs(depth) < disc_->r;
      if (!turnsBack) return hasStart ? 1 : 0;
    }
    const Point foot = half.nearest(center());
    const double reach = std::sqrt(std::max(disc_->r - depth, 0.0)) * std::sqrt(std::max(disc_->r + depth, 0.0));
    const Point exit = {foot.x - reach * along.x, foot.y - reach * along.y};
    const Point entry = {foot.x + reach * along.x, foot.y + reach * along.y};
    if (hasStart && hasEnd) {
      kept[1] = piece;
      endAt(0, exit);
      startAt(1, entry);
      return 2;
    }
    if (!hasStart) startAt(0, entry);
    if (!hasEnd) endAt(0, exit);
    return 1;
  }

  /// Where a segment crosses the line: on that of a side beside it in the corner, to the bit.
  Point crossingOf(std::size_t h, const CutPiece& piece) const {
    const HalfPlane& half = halves_[h];
    const Point start = piece.start();
    const Vector whole = vectorTo(start, piece.end());
    const std::size_t count = halves_.size();
    for (const auto& [other, corner] :
         {std::pair{(h + count - 1) % count, half.from()}, {(h + 1) % count, half.to()}}) {
      if (piece.line != halves_[other].side()) continue;
      const double ahead = facing(vectorTo(start, corner), whole);
      const double rest = facing(vectorTo(corner, piece.end()), whole);
      return ahead <= 0 ? start : rest <= 0 ? piece.end() : corner;
    }
    const double first = half.height(start);
    const double share = first / (first - half.height(piece.end()));
    return half.nearest({start.x + share * whole.x, start.y + share * whole.y});
  }

  /// Returns whether a loop lies along a line, or touches it, from outside but for rounding.
  bool isSliver(const std::vector<OutlinePiece>& loop) const;
  /// A loop as pieces of an outline. Empty if it is a sliver.
  std::vector<OutlinePiece> finished(CutLoop& loop);

  const Diagram& diagram_;
  CircleIndex circle_;
  Limits limits_;
  std::optional<Circle> disc_;
  std::vector<HalfPlane> halves_;
  std::vector<CutLoop> loops_;
  bool isSound_ = true;
};

/// An area of less than this share of the square around it is but rounding.
constexpr double kRoundingOfArea = 0x1p-44;
/// The error bound of a vertex (vertexOf, radicalCenter), as a share of the distances from its circles.
constexpr double kRoundingOfVertices = 0x1p-34;
constexpr double kRoundingOfPowerVertices = 0x1p-18;
/// The error bound of a point on the boundary of the region, as a share of coordinates and distances.
constexpr double kRoundingOfBoundary = 0x1p-44;
/// Rounding of coordinates, as a share of the largest.
constexpr double kRoundingOfSliver = 0x1p-48;

/// The start of the first piece: moments are taken relative to it.
Point referenceOf(const Outline& outline) { return outline.front().front().curve.start; }

Point middleOf(const EdgeCurve& curve) { return pointAt(curve.bisector, std::sqrt(curve.from) * std::sqrt(curve.to)); }

/// Returns about the largest distance of two of its points. The middle of a curved piece may be much farther away than
/// its ends.
double extentOf(const Outline& outline) {
  const Point reference = referenceOf(outline);
  double extent = 0;
  const auto take = [&](Point p) { extent = std::max(extent, largestOf({p.x - reference.x, p.y - reference.y})); };
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const EdgeCurve& curve = piece.curve;
      take(curve.start);
      if (!curve.isStraight()) take(middleOf(curve));
    }
  }
  return extent;
}

Moments momentsOf(const Outline& outline, double unit) {
  const Point reference = referenceOf(outline);
  const auto toPoint = [&](Point p) { return measuredIn(unit, {p.x - reference.x, p.y - reference.y}); };
  Moments sum;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const Vector u = toPoint(piece.curve.start);
      const Vector v = toPoint(piece.curve.end);
      const double triangle = cross(u, v) / 2;
      const Moments beyond = piece.isOnCircle() ? momentsOverChord(circleArc(piece), reference, unit)
                                                : momentsOverChord(piece.curve, reference, unit);
      sum.area += triangle + beyond.area;
      sum.x += triangle * (u.x + v.x) / 3 + beyond.x;
      sum.y += triangle * (u.y + v.y) / 3 + beyond.y;
    }
  }
  return sum;
}

bool LoopCutter::isSliver(const std::vector<OutlinePiece>& loop) const {
  if (loop.empty()) return true;
  const Outline outline = {loop};
  const double extent = extentOf(outline);
  const double unit = unitFor(extent);
  const Point reference = referenceOf(outline);
  const double size = std::max({extent, largestOf({reference.x, reference.y}), largestOf({center().x, center().y})});
  const double rounding = kRoundingOfSliver * size;
  if (momentsOf(outline, unit).area > (rounding / unit) * (extent / unit)) return false;
  return std::ranges::any_of(halves_, [&](const HalfPlane& half) {
    return std::ranges::all_of(loop, [&](const OutlinePiece& piece) {
      return half.height(piece.curve.start) <= rounding &&
             (piece.isOnCircle() || half.height(middleOf(piece.curve)) <= rounding);
    });
  });
}

std::vector<OutlinePiece> LoopCutter::finished(CutLoop& loop) {
  bool isCut = false;
  for (CutPiece& piece : loop) {
    if (!piece.isSegment()) moveOntoSides(piece.part, halves_);
    isCut = isCut || piece.isSegment() || piece.part.cutFrom >= 0 || piece.part.cutTo >= 0;
    if (piece.isSegment() && piece.line == kNone) isSound_ = false;
  }
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    const CutPiece& before = loop[(k + count - 1) % count];
    const CutPiece& after = loop[(k + 1) % count];
    if (!loop[k].isSegment()) continue;
    if (!before.isSegment()) loop[k].part.curve.start = before.end();
    if (!after.isSegment()) loop[k].part.curve.end = after.start();
  }
  std::vector<OutlinePiece> pieces;
  for (CutPiece& piece : loop) {
    if (piece.isPoint()) continue;
    if (piece.side == kNone) {
      pieces.push_back({segment(piece.start(), piece.end()), kNone, kNone, piece.r});
    } else {
      const EdgeCurve& curve = piece.part.curve;
      pieces.push_back({piece.isAgainst() ? reversed(curve) : curve, piece.side, diagram_.neighborOf(piece.side)});
    }
  }
  return isCut && isSliver(pieces) ? std::vector<OutlinePiece>{} : pieces;
}

}  // namespace

std::optional<CurvePart> partAtDistance(const Diagram& diagram, EdgeIndex edge, const Limits& limits) {
  const EdgeCurve curve = edgeCurve(diagram, edge);
  if (!limits.maxDistance) return boundedPart(curve, *limits.region);
  const Edge& between = diagram.edges[static_cast<std::size_t>(edge)];
  return partNear(curve, std::min(limits.reachFrom(diagram, between.left), limits.reachFrom(diagram, between.right)));
}

std::vector<CurvePart> keptParts(const Diagram& diagram, EdgeIndex edge, const Limits& limits) {
  const auto part = partAtDistance(diagram, edge, limits);
  if (!part) return {};
  return limits.region == nullptr ? std::vector<CurvePart>{*part} : partsInside(*part, *limits.region);
}

Result<Outline> checkedOutline(const Diagram& diagram, CircleIndex circle, const Limits& limits) {
  if (!diagram.hasCell(circle)) return Outline();
  std::optional<Circle> disc;
  if (limits.maxDistance) {
    const Circle& c = diagram.circles[static_cast<std::size_t>(circle)];
    disc = {c.x, c.y, limits.reachFrom(diagram, circle)};
    if (!(disc->r > 0)) return Outline();
  }
  LoopCutter cutter(diagram, circle, limits, disc);
  Outline outline = cutter.run();
  if (cutter.isSound()) return outline;
  return Error{ErrorCode::notCertified, circle, "The outline of a cell does not close. Certify the diagram."};
}

Outline limitedOutline(const Diagram& diagram, CircleIndex circle, const Limits& limits) {
  auto outline = checkedOutline(diagram, circle, limits);
  return outline ? *std::move(outline) : Outline();
}

Result<std::vector<Outline>> outlines(const Diagram& diagram, const ConvexPolygon& region,
                                      std::optional<double> maxDistance) {
  return guarded([&]() -> Result<std::vector<Outline>> {
    if (auto checked = checkMaxDistance(maxDistance); !checked) return checked.error();
    std::vector<Outline> cells;
    const double whole = region.area();
    const double ofVertices = diagram.metric == Metric::power ? kRoundingOfPowerVertices : kRoundingOfVertices;
    double perimeter = 0;
    double reach = 0;
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Point corner = region.corners()[k];
      perimeter += lengthOf(vectorTo(corner, region.cornerAfter(k)));
      reach = std::max(reach, largestOf({corner.x, corner.y}));
    }
    double sum = 0;
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const auto circle = static_cast<std::int32_t>(i);
      auto cell = checkedOutline(diagram, circle, {&region, maxDistance});
      if (!cell) return cell.error();
      const double part = area(*cell);
      const Circle& c = diagram.circles[i];
      if (part != 0) reach = std::max(reach, reachFrom({c.x, c.y}, region));
      const double rounding = ofVertices * perimeter * reach;
      if (!(part >= -rounding && part <= whole + rounding)) {
        return Error{ErrorCode::notCertified, circle, "The area of a cell is not between 0 and that of the region."};
      }
      sum += part;
      cells.push_back(*std::move(cell));
    }
    // Both cells of an edge see its ends at the same places, however far vertices are off.
    const double rounding = kRoundingOfBoundary * perimeter * reach;
    if (!maxDistance && !diagram.hull.empty() && !(std::abs(sum - whole) <= rounding)) {
      return Error{ErrorCode::notCertified, kNone, "The areas of the cells do not sum to that of the region."};
    }
    return cells;
  });
}

Outline outline(const Diagram& diagram, CircleIndex circle) {
  std::vector<OutlinePiece> loop;
  for (const SideIndex side : diagram.sides(circle)) {
    loop.push_back({sideCurve(diagram, side), side, diagram.neighborOf(side)});
    if (!loop.back().curve.isBounded()) return {};
  }
  return loop.empty() ? Outline{} : Outline{std::move(loop)};
}

Outline outline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region) {
  return limitedOutline(diagram, circle, {&region});
}

Outline clippedBufferOutline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region,
                             double maxDistance) {
  return limitedOutline(diagram, circle, {&region, maxDistance});
}

double area(const Outline& outline) {
  if (outline.empty()) return 0;
  const double unit = unitFor(extentOf(outline));
  return momentsOf(outline, unit).area * unit * unit;
}

Point centroid(const Outline& outline) {
  if (outline.empty()) return {};
  const Point reference = referenceOf(outline);
  const double extent = extentOf(outline);
  const double unit = unitFor(extent);
  const Moments moments = momentsOf(outline, unit);
  if (extent > 0 && moments.area > kRoundingOfArea * (extent / unit) * (extent / unit)) {
    return {reference.x + unit * (moments.x / moments.area), reference.y + unit * (moments.y / moments.area)};
  }
  Vector sum;
  double count = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum.x += piece.curve.start.x - reference.x;
      sum.y += piece.curve.start.y - reference.y;
      ++count;
    }
  }
  return {reference.x + sum.x / count, reference.y + sum.y / count};
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum += piece.isOnCircle() ? arcLength(circleArc(piece)) : arcLength(piece.curve);
    }
  }
  return sum;
}

}  // namespace circle_voronoi
