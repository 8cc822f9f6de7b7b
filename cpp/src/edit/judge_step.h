// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "edit_state.h"

namespace circle_voronoi {

/// What a step has made of a certified diagram.
enum class StepVerdict {
  right,
  wrong,
  broken,  ///< the faces do not even fit together
};

/// Judges what a step has changed in a certified diagram, by the theorem of judge.h. What that asks of a face, an edge
/// or a circle holds where nothing has changed; what it counts - the turns of each region and of the hull, faces and
/// circles - changes by what the changed edges had and have. So the whole is certified again, by induction.
class StepJudge {
 public:
  /// Finds the discs of all changed faces, too, and notes what the proof keeps of their edges.
  ///
  /// `moved`: the slot of a circle that has changed, or kNone.
  StepVerdict judge(EditState& state, int moved);

  /// Of a step that is right: a half-edge of each changed edge of length zero that is not as ties are to be settled.
  std::span<const int> unsettled() const { return unsettled_; }

 private:
  using StepProver = Prover<FaceDiscs>;

  StepVerdict judgeFaces(EditState& state, int moved, StepProver& prover);
  bool areEdgesRight(EditState& state, StepProver& prover);
  bool areCirclesRight(EditState& state, int moved) const;
  bool areTurnsRight(const EditState& state);
  void addTurns(int around, int neighbor, int count);

  std::vector<int> turns_;    ///< of each slot what its turns have grown by; zero between judgments
  std::vector<int> touched_;  ///< the slots that may have others
  int hullTurns_ = 0;
  std::vector<int> unsettled_;
};

}  // namespace circle_voronoi
