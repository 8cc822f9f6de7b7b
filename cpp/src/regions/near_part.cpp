// SPDX-License-Identifier: GPL-3.0-or-later
#include "near_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "at.h"
#include "cell_limits.h"
#include "in_outline.h"
#include "scale.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// A part of a segment.
struct Chord {
  Point from;
  Point to;
  bool isCutFrom = false;
  bool isCutTo = false;
};

/// Returns the part of a segment inside a disc. Whether the ends of the segment are inside has been decided.
std::optional<Chord> chordOf(Point from, Point to, bool hasFrom, bool hasTo, const Circle& disc) {
  Chord chord = {from, to};
  if (hasFrom && hasTo) return chord;
  const double size = lengthOf(vectorTo(from, to));
  const Vector along = measuredIn(size, vectorTo(from, to));
  const Vector toCenter = vectorTo(from, Point{disc.x, disc.y});
  const double foot = dot(along, toCenter);
  const double height = cross(along, toCenter);
  const double r = disc.r;
  const double half = std::sqrt(std::max((r - std::abs(height)) * (r + std::abs(height)), 0.0));
  const auto isCutAt = [&](double place) { return 0 < place && place < size; };
  // Seen from the center, since the ends may be far away.
  const auto pointAt = [&](double beside) {
    const Vector v = {beside * along.x + height * along.y, beside * along.y - height * along.x};
    return Point{from.x == to.x ? from.x : disc.x + v.x, from.y == to.y ? from.y : disc.y + v.y};
  };
  if (!hasFrom) {
    if (foot - half >= size) chord.from = to;
    chord.isCutFrom = isCutAt(foot - half);
    if (chord.isCutFrom) chord.from = pointAt(-half);
  }
  if (!hasTo) {
    if (foot + half <= 0) chord.to = from;
    chord.isCutTo = isCutAt(foot + half);
    if (chord.isCutTo) chord.to = pointAt(half);
  }
  // With no end inside it may pass the disc by.
  if (!hasFrom && !hasTo && !(std::abs(height) < r && half > 0 && foot - half < size && foot + half > 0)) {
    return std::nullopt;
  }
  return chord;
}

/// The circle around a disc. A place on it is a pseudo-angle: from 0 to 4.
class Rim {
 public:
  static constexpr double kTotal = 4;

  explicit Rim(const Circle& disc) : disc_(disc) {}

  double placeNear(Point p) const {
    const Vector v = vectorTo({disc_.x, disc_.y}, p);
    return pseudoAngle(v);
  }
  Point at(double place) const {
    const double quarter = std::floor(place);
    const double share = place - quarter;
    const Vector u = axis(quarter);
    const Vector w = axis(quarter + 1);
    const Vector v = {(1 - share) * u.x + share * w.x, (1 - share) * u.y + share * w.y};
    const double factor = disc_.r / std::sqrt(dot(v, v));
    return {disc_.x + factor * v.x, disc_.y + factor * v.y};
  }

  /// Adds the arc from one point to another, in quarters at most, to a loop. `to` may be more than a turn.
  void addArc(std::vector<OutlinePiece>& loop, Point start, Point end, double from, double to) const {
    const auto add = [&](Point p) {
      if (start != p) loop.push_back({segment(start, p), kNone, kNone, disc_.r});
      start = p;
    };
    for (double quarter = std::floor(from) + 1; quarter < to; ++quarter) add(at(quarter));
    add(end);
  }
  std::vector<OutlinePiece> whole() const {
    std::vector<OutlinePiece> loop;
    addArc(loop, at(0), at(0), 0, kTotal);
    return loop;
  }

 private:
  static Vector axis(double quarter) {
    constexpr std::array<Vector, 4> kAxes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return kAxes[static_cast<std::size_t>(quarter) % kAxes.size()];
  }

  Circle disc_;
};

/// Pieces of an outline inside the disc that follow each other without a gap, and the places on the circle where they
/// begin and end.
struct Chain {
  std::vector<OutlinePiece> pieces;
  double entry = 0;
  double exit = 0;
};

/// A part of a piece of a loop inside the disc.
struct DiscPart {
  OutlinePiece piece;
  bool isCutFrom = false;  ///< whether it begins on the circle
  bool isCutTo = false;
};

class DiscClipper {
 public:
  DiscClipper(const ClippedDiagram::Parts& parts, CircleIndex circle, const Loops& loops, const Circle& disc)
      : parts_(parts), circle_(circle), loops_(loops), disc_(disc), rim_(disc) {}

  Outline run() {
    for (std::size_t k = 0; k < loops_.isHole.size(); ++k) collectChains(k);
    Outline outer;
    if (!chains_.empty()) {
      outer = joined();
    } else if (depth(clearestPoint()) > 0) {
      outer = {rim_.whole()};
    }
    std::ranges::move(closed_, std::back_inserter(outer));
    // Each hole comes after the loop around it.
    std::vector<std::vector<std::size_t>> holesOf(outer.size());
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      const Point p = holes_[h].front().curve.start;
      std::size_t around = 0;
      while (around + 1 < outer.size() && !hasInLoop(outer[around], p)) ++around;
      if (around < outer.size()) holesOf[around].push_back(h);
    }
    Outline outline;
    for (std::size_t k = 0; k < outer.size(); ++k) {
      outline.push_back(std::move(outer[k]));
      for (const std::size_t h : holesOf[k]) outline.push_back(std::move(holes_[h]));
    }
    return outline;
  }

 private:
  void collectChains(std::size_t index) {
    const auto loop = loops_.loop(index);
    std::vector<Chain> chains;
    bool linked = false;           // whether the last chain goes on with the next piece
    bool firstIsAtOrigin = false;  // whether the first chain begins where the loop does
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto part = partOf(loop, k);
      if (!part) {
        linked = false;
        continue;
      }
      if (!linked || part->isCutFrom) {
        if (chains.empty()) firstIsAtOrigin = k == 0 && !part->isCutFrom;
        chains.emplace_back().entry = rim_.placeNear(part->piece.curve.start);
      }
      chains.back().pieces.push_back(part->piece);
      chains.back().exit = rim_.placeNear(part->piece.curve.end);
      linked = !part->isCutTo;
    }
    if (linked && firstIsAtOrigin) {
      if (chains.size() == 1) {
        (loops_.isHole[index] != 0 ? holes_ : closed_).push_back(std::move(chains.front().pieces));
        return;
      }
      Chain& last = chains.back();
      last.exit = chains.front().exit;
      std::ranges::move(chains.front().pieces, std::back_inserter(last.pieces));
      chains.erase(chains.begin());
    }
    std::ranges::move(chains, std::back_inserter(chains_));
  }

  std::optional<DiscPart> partOf(std::span<const LoopPiece> loop, std::size_t k) const {
    const LoopPiece& piece = loop[k];
    const Point end = loop[k + 1 == loop.size() ? 0 : k + 1].start;
    if (piece.side == kNone) return partOfSegment(piece, end);
    const EdgeIndex edge = Diagram::edgeOf(piece.side);
    const EdgeCurve curve =
        piece.arc == kNone ? parts_.curveOf(edge) : parts_.curveOf(parts_.arcs.all()[at(piece.arc)]);
    auto part = nearPart(parts_.diagram, edge, curve, *parts_.maxDistance);
    if (!part) return std::nullopt;
    if (piece.side % 2 != 0) {
      part->curve = reversed(part->curve);
      std::swap(part->cutFrom, part->cutTo);
    }
    return DiscPart{
        {part->curve, piece.side, parts_.diagram.neighborOf(piece.side)}, part->cutFrom != kNone, part->cutTo != kNone};
  }

  std::optional<DiscPart> partOfSegment(const LoopPiece& piece, Point end) const {
    const auto chord = chordOf(piece.start, end, isInDisc(piece.start), isInDisc(end), disc_);
    if (!chord) return std::nullopt;
    if (chord->from == chord->to) return std::nullopt;
    return DiscPart{
        {segment(chord->from, chord->to), kNone, kNone, 0, piece.regionSide}, chord->isCutFrom, chord->isCutTo};
  }

  bool isInDisc(Point p) const { return lengthOf(vectorTo({disc_.x, disc_.y}, p)) <= disc_.r; }

  /// The approximate depth of a point of the circle inside the part of the cell in the region; negative outside.
  double depth(Point p) const {
    double least = kInfinite;
    for (const SideIndex side : parts_.diagram.sides(circle_)) {
      least = std::min(least, lead(parts_.diagram, circle_, parts_.diagram.neighborOf(side), p));
    }
    const bool isInside = least > 0 && parts_.region.contains(p);
    double size = std::abs(least);
    for (std::size_t k = 0; k < loops_.isHole.size(); ++k) {
      const auto loop = loops_.loop(k);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i].side != kNone) continue;
        const Point start = loop[i].start;
        const Vector along = vectorTo(start, loop[i + 1 == loop.size() ? 0 : i + 1].start);
        const double length = lengthOf(along);
        const double share = std::clamp(dot(vectorTo(start, p), measuredIn(length, along)) / length, 0.0, 1.0);
        size = std::min(size, lengthOf(vectorTo({start.x + share * along.x, start.y + share * along.y}, p)));
      }
    }
    return isInside ? size : -size;
  }

  /// The point farthest from the borders, out of a few points of the circle.
  Point clearestPoint() const {
    Point best = rim_.at(0);
    for (double place = 0.5; place < Rim::kTotal; place += 0.5) {
      const Point p = rim_.at(place);
      if (std::abs(depth(p)) > std::abs(depth(best))) best = p;
    }
    return best;
  }

  /// Returns a place far inside or outside: the best of several places in the largest gaps between entries and exits.
  /// The largest gap alone is not enough: it may lie on the boundary of both the ring and the cut shape. Gaps as short
  /// as rounding are left out, because a place there may be on either side of the entry or exit.
  double clearPlace() const {
    struct Gap {
      double size;
      double start;
    };
    std::vector<double> places;
    for (const Chain& chain : chains_) places.insert(places.end(), {chain.entry, chain.exit});
    std::ranges::sort(places);
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double next = i + 1 < places.size() ? places[i + 1] : places.front() + Rim::kTotal;
      gaps.push_back({next - places[i], places[i]});
    }
    constexpr std::size_t kTried = 4;
    const auto tried = gaps.begin() + static_cast<std::ptrdiff_t>(std::min(kTried, gaps.size()));
    std::ranges::partial_sort(gaps, tried, std::ranges::greater(), &Gap::size);
    double best = -1;
    double place = 0;
    for (auto gap = gaps.begin(); gap != tried && (gap == gaps.begin() || gap->size > kRounding * Rim::kTotal); ++gap) {
      for (const double share : {0.5, 0.3, 0.8}) {
        const double ahead = gap->start + share * gap->size;
        const double candidate = ahead < Rim::kTotal ? ahead : ahead - Rim::kTotal;
        const double difference = std::abs(depth(rim_.at(candidate)));
        if (difference > best) {
          best = difference;
          place = candidate;
        }
      }
    }
    return place;
  }

  /// Joins the chains to loops, along the circle. There is at least one chain.
  ///
  /// Along the circle exits and entries alternate. Pairing the k-th exit with the k-th entry, or with the next one, is
  /// correct even if rounding swaps an exit and an entry next to each other. The pairing starts at a place between them
  /// that is known to be inside or outside.
  Outline joined() {
    const double begin = clearPlace();
    const bool beginsInside = depth(rim_.at(begin)) > 0;
    const auto ahead = [&](double place) { return place < begin ? place + Rim::kTotal : place; };
    const std::size_t count = chains_.size();
    std::vector<std::size_t> byExit(count);
    for (std::size_t i = 0; i < count; ++i) byExit[i] = i;
    std::vector<std::size_t> byEntry = byExit;
    std::ranges::sort(byExit, {}, [&](std::size_t i) { return ahead(chains_[i].exit); });
    std::ranges::sort(byEntry, {}, [&](std::size_t i) { return ahead(chains_[i].entry); });

    std::vector<std::size_t> next(count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = byExit[k];
      const std::size_t j = byEntry[beginsInside ? (k + 1) % count : k];
      next[i] = j;
      const double from = ahead(chains_[i].exit);
      const double to = ahead(chains_[j].entry) + (beginsInside && k + 1 == count ? Rim::kTotal : 0);
      const Point start = chains_[i].pieces.back().curve.end;
      const Point end = chains_[j].pieces.front().curve.start;
      rim_.addArc(chains_[i].pieces, start, end, from, to);
    }

    Outline outline;
    std::vector<bool> isDone(count, false);
    for (std::size_t i = 0; i < count; ++i) {
      if (isDone[i]) continue;
      auto& loop = outline.emplace_back();
      for (std::size_t j = i; !isDone[j]; j = next[j]) {
        isDone[j] = true;
        std::ranges::move(chains_[j].pieces, std::back_inserter(loop));
      }
    }
    return outline;
  }

  const ClippedDiagram::Parts& parts_;
  CircleIndex circle_;
  const Loops& loops_;
  Circle disc_;
  Rim rim_;
  std::vector<Chain> chains_;
  Outline closed_;  ///< loops inside the disc, except holes
  Outline holes_;
};

}  // namespace

std::optional<CurvePart> nearPart(const Diagram& diagram, EdgeIndex edge, const EdgeCurve& curve, double maxDistance) {
  const Limits limits = {nullptr, maxDistance};
  const Edge& between = diagram.edges[at(edge)];
  return partNear(curve, std::min(limits.reachFrom(diagram, between.left), limits.reachFrom(diagram, between.right)));
}

Outline nearOutline(const ClippedDiagram::Parts& parts, CircleIndex circle, const Loops& loops) {
  if (loops.isHole.empty()) return {};
  const Circle& c = parts.diagram.circles[at(circle)];
  const Circle disc = {c.x, c.y, Limits{nullptr, parts.maxDistance}.reachFrom(parts.diagram, circle)};
  if (!(disc.r > 0)) return {};
  return DiscClipper(parts, circle, loops, disc).run();
}

}  // namespace circle_voronoi
