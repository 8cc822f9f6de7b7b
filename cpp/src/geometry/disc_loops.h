// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "arc_within.h"
#include "circle_voronoi/cells.h"
#include "distance_signs.h"

namespace circle_voronoi {

/// The loops of the part of a cell in its disc. Holes come last.
struct LoopsWithin {
  Outline outline;
  std::vector<std::uint8_t> isHole;
  /// Whether entries and exits alternate around the rim. Otherwise the loops are not those of a diagram.
  bool isSound = true;
};

/// Cuts the loops of a cell at the rim of its disc.
///
/// The pieces of each loop are added in order, with the places where it comes into the disc and where it leaves it.
/// Around the rim, exits and entries alternate in their exact order, and the border goes on from each exit along the
/// rim to the entry that follows counter-clockwise.
class DiscLoops {
 public:
  DiscLoops(const DistanceSigns& signs, CircleIndex cell) : signs_(signs), cell_(cell) {}

  /// Begins a loop, which starts inside the disc or outside of it.
  void beginLoop(bool isHole, bool isInside);
  /// Adds a piece inside the disc.
  void add(OutlinePiece piece) { pieces_.push_back(std::move(piece)); }
  void enter(const RimPoint& point);
  void leave(const RimPoint& point);
  void endLoop();

  /// Returns whether no loop meets the rim.
  bool isRimClear() const { return chains_.empty(); }
  /// Returns whether the disc has a loop that does not meet its rim.
  bool hasLoops() const { return !closed_.empty() || !holes_.empty(); }
  /// Returns the loops. If no loop meets the rim, `isWhole` says whether the rim lies inside the loops.
  LoopsWithin finish(bool isWhole);

 private:
  /// Pieces of a loop between an entry and an exit.
  struct Chain {
    std::vector<OutlinePiece> pieces;
    RimPoint entry;
    RimPoint exit;
  };

  void addArc(std::vector<OutlinePiece>& loop, const RimPoint& from, const RimPoint& to, bool isWrapped) const;
  void addSteps(std::vector<OutlinePiece>& loop, Point start, Point end, double from, double to) const;
  Point pointAt(double place) const;
  Point center() const;
  void join(LoopsWithin& result);

  const DistanceSigns& signs_;
  CircleIndex cell_;
  std::vector<Chain> chains_;
  Outline closed_;  ///< the loops inside the disc, except holes
  Outline holes_;

  // The loop that is being added.
  bool isHole_ = false;
  bool startsInside_ = false;
  bool isCut_ = false;
  std::size_t firstChain_ = 0;
  std::vector<OutlinePiece> pieces_;  ///< since the last entry
  std::vector<OutlinePiece> before_;  ///< before the first exit, if the loop starts inside
  RimPoint entry_;
  RimPoint firstExit_;
};

/// Adds a side of the cell, or a part of it: its part in the disc, and where it meets the rim. `curve` is in the
/// direction of the edge, from `start` to `end`.
void addArcWithin(DiscLoops& loops, const DistanceSigns& signs, const Diagram& diagram, SideIndex side,
                  const EdgeCurve& curve, const ArcEnd& start, const ArcEnd& end);

}  // namespace circle_voronoi
