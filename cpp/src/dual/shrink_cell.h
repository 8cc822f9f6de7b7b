// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/index.h"
#include "insert_cell.h"

namespace circle_voronoi {

/// Takes circles out of a dual. While a circle shrinks, its cell loses one edge after the other, each when the disc of
/// three successive neighbours comes to touch it, and with the last but two the cell itself: d log d steps for a cell
/// of d edges. Discs are in floating point, so that ties may mislead: the result is to be judged.
class CellShrinker {
 public:
  /// What is given must outlive this.
  explicit CellShrinker(const LiveDual& live)
      : dual_(live.dual), discs_(live.discs), edgeOf_(live.edgeOf), keeper_(live.keeper) {}

  /// Takes out a visible circle, not the last but one. Whether that went well; if not, its cell may have lost some
  /// edges.
  bool takeOut(int circle);

 private:
  /// A half-edge from the circle, between its neighbours in the ring of those that are left.
  struct Spoke {
    int halfEdge;
    int before;
    int after;
    FaceDisc disc;  ///< of the neighbours before, at and after
    int turn = 0;   ///< counts its events; those before the last are outdated
  };
  /// When an edge vanishes: at which radius of the circle.
  struct Event {
    double r;
    int spoke;
    int turn;

    bool operator<(const Event& other) const { return r != other.r ? r < other.r : spoke > other.spoke; }
  };

  /// Finds the event at a spoke anew.
  void look(int spoke);
  /// The spoke of the next event, or kNone.
  int nextToVanish();
  /// Notes the edges of the faces that the cell had, but for two that vanish, or none.
  void noteEdges(int vanishing, int other);
  void noteEdge(int h) {
    if (dual_.origin[h] != kPointAtInfinity) edgeOf_[dual_.origin[h]] = h;
  }

  Dual& dual_;
  FaceDiscs& discs_;
  std::vector<int>& edgeOf_;
  DualKeeper& keeper_;
  std::vector<Spoke> spokes_;
  std::vector<Event> events_;
};

}  // namespace circle_voronoi
