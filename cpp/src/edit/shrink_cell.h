// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/index.h"
#include "edit_state.h"

namespace circle_voronoi {

/// Takes circles out of a dual. While a circle shrinks, its cell loses one edge after the other, each when the disc of
/// three successive neighbors comes to touch it, and with the last but two the cell itself: d log d steps for a cell
/// of d edges. Discs are in floating point, so that ties may mislead: the result is to be judged.
class CellShrinker {
 public:
  /// Takes out a visible circle, not the last but one. Whether that went well; if not, the dual is of no use.
  bool takeOut(EditState& state, int slot);

 private:
  /// A half-edge from the circle, between its neighbors in the ring of those that are left.
  struct Spoke {
    int halfEdge;
    int before;
    int after;
    FaceDisc disc;  ///< of the neighbors before, at and after
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
  void look(EditState& state, int spoke);
  /// The spoke of the next event, or kNone.
  int nextToVanish();

  std::vector<Spoke> spokes_;
  std::vector<Event> events_;
};

}  // namespace circle_voronoi
