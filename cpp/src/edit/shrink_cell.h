// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/index.h"
#include "edit_state.h"

namespace circle_voronoi {

/// Takes circles out of a dual. While a circle shrinks, its cell loses one edge after another: each when the circle
/// comes to touch the disc of three successive neighbors. When two edges are left, the cell itself vanishes. This takes
/// d log d steps for a cell of d edges. Discs are in floating point and ties may mislead, so the caller must judge the
/// result.
class CellShrinker {
 public:
  /// Takes out a visible circle, but not one of the last two. Returns true on success; otherwise the dual is of no use.
  bool takeOut(EditState& state, int slot);

 private:
  /// A half-edge from the circle, linked to the previous and the next remaining spoke.
  struct Spoke {
    int halfEdge;
    int before;
    int after;
    FaceDisc disc;  ///< of the neighbors at the spoke before, at this one and at the one after
    int turn = 0;   ///< the number of its latest event; earlier ones are outdated
  };
  /// An edge vanishes when the circle has shrunk to radius `r`.
  struct Event {
    double r;
    int spoke;
    int turn;

    bool operator<(const Event& other) const { return r != other.r ? r < other.r : spoke > other.spoke; }
  };

  /// Computes the event at a spoke again.
  void look(EditState& state, int spoke);
  /// Removes the next event and returns its spoke, or kNone if there is none.
  int nextToVanish();
  /// Returns a spoke that may vanish without leaving a loop, or kNone. If rounding has mixed up events, no spoke may be
  /// left that has one. Flips then repair the few faces. `from` is a spoke that is left.
  int anyToVanish(const Dual& dual, int from) const;

  std::vector<Spoke> spokes_;
  std::vector<Event> events_;
};

}  // namespace circle_voronoi
