// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "edit_state.h"

namespace circle_voronoi {

/// The state of a formerly certified diagram after a step.
enum class StepVerdict {
  right,
  wrong,
  broken,  ///< the faces do not even fit together
};

/// Judges the changes that a step made to a certified diagram, by the theorem of judge.h. The conditions on a face, an
/// edge or a circle still hold where nothing has changed. The counts (turns of each region and of the hull, faces,
/// circles) change only by the contributions of the changed edges. So the whole diagram is certified again, by
/// induction.
class StepJudge {
 public:
  /// Judges a step. Computes the discs of all changed faces, too, and updates the proof of their edges.
  ///
  /// `moved` is the slot of a circle that has changed, or kNone.
  StepVerdict judge(EditState& state, int moved);

  /// Returns a half-edge of each changed edge of length zero that does not follow the rule for ties (settle_ties.h).
  /// Valid after a step that is right.
  std::span<const int> unsettled() const { return unsettled_; }

 private:
  using StepProver = Prover<FaceDiscs>;

  StepVerdict judgeFaces(EditState& state, int moved, StepProver& prover);
  bool areEdgesRight(EditState& state, StepProver& prover);
  bool areCirclesRight(EditState& state, int moved) const;
  bool areTurnsRight(const EditState& state);
  void addTurns(int around, int neighbor, int count);

  std::vector<int> turns_;    ///< for each slot, the change of its turns; zero between judgments
  std::vector<int> touched_;  ///< the slots whose turns may have changed
  int hullTurns_ = 0;
  std::vector<int> unsettled_;
};

}  // namespace circle_voronoi
