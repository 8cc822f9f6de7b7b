// SPDX-License-Identifier: GPL-3.0-or-later
#include "near_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "at.h"
#include "cell_limits.h"
#include "chains.h"
#include "in_outline.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// A part of a piece of a loop inside the disc.
struct DiscPart {
  OutlinePiece piece;
  bool isCutFrom = false;  ///< whether it begins on the circle
  bool isCutTo = false;
};

class DiscClipper {
 public:
  DiscClipper(const ClippedDiagram::Parts& parts, CircleIndex circle, const Loops& loops, const Circle& disc)
      : parts_(parts), circle_(circle), loops_(loops), disc_(disc), ring_(nullptr, disc) {}

  Outline run() {
    for (std::size_t k = 0; k < loops_.isHole.size(); ++k) collectChains(k);
    Outline outer;
    if (!chains_.empty()) {
      outer = joined(ring_, std::move(chains_), [&](Point p) { return depth(p); });
    } else if (depth(clearestPoint()) > 0) {
      outer = {wholeLoop(ring_)};
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
        chains.emplace_back().entry = ring_.placeNear(part->piece.curve.start);
      }
      chains.back().pieces.push_back(part->piece);
      chains.back().exit = ring_.placeNear(part->piece.curve.end);
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
    const Vector along = vectorTo(piece.start, end);
    const auto pointAt = [&](double share) {
      return Point{piece.start.x + share * along.x, piece.start.y + share * along.y};
    };
    const Point from = chord->from == 0 ? piece.start : pointAt(chord->from);
    const Point to = chord->to == 1 ? end : pointAt(chord->to);
    if (from == to) return std::nullopt;
    return DiscPart{{segment(from, to), kNone, kNone, 0, piece.regionSide}, chord->from != 0, chord->to != 1};
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

  /// The point of the circle that is farthest from the borders, of a few.
  Point clearestPoint() const {
    Point best = ring_.at(0);
    constexpr int kTried = 8;
    for (int k = 1; k < kTried; ++k) {
      const Point p = ring_.at(ring_.total() * k / kTried);
      if (std::abs(depth(p)) > std::abs(depth(best))) best = p;
    }
    return best;
  }

  const ClippedDiagram::Parts& parts_;
  CircleIndex circle_;
  const Loops& loops_;
  Circle disc_;
  Ring ring_;
  std::vector<Chain> chains_;
  Outline closed_;  ///< loops inside the disc that are no holes
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
