// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/editor.h"
#include "edit_state.h"
#include "insert_cell.h"
#include "judge_step.h"
#include "locate.h"
#include "shrink_cell.h"

namespace circle_voronoi {

/// Applies edits, one after the other, to a given state. Circles are rounded (limits.h).
class Stepper {
 public:
  /// The arguments must outlive this object.
  Stepper(EditState& state, Locator& locator) : state_(state), locator_(locator), inserter_(state.live()) {}

  // Each function returns how the edit was certified. It returns nothing if the whole diagram must be computed. Then
  // the caller must take the state back.
  std::optional<EditWay> insert(const Circle& circle, CircleId id, int hint);
  std::optional<EditWay> remove(int slot);
  std::optional<EditWay> replace(int slot, const Circle& circle);

 private:
  EditState::Mark begin();
  void reportCircle(TraceKind kind, int slot, const Circle& circle);
  bool put(int slot, int hint);
  bool putBefore(int slot, int identical);
  bool takeOut(int slot);
  void mendForInsertion();
  bool putWaiting(int hint);
  int hiderBy(int slot) const;
  bool releaseHidden(int slot, int hider);
  bool coversMany(const Circle& circle) const;
  int neighborOf(int slot) const;
  bool staysNear(int slot, const Circle& circle) const;
  bool move(int slot, const Circle& circle);
  std::optional<EditWay> certify(int moved);
  bool isRight(int moved);
  std::span<const int> changedEdges();
  std::vector<int> changedWrongFaces();
  void flipChanged();
  bool patch(int moved);

  EditState& state_;
  Locator& locator_;
  CellInserter inserter_;
  CellShrinker shrinker_;
  StepJudge judge_;
  bool isBroken_ = false;
  std::vector<int> waiting_;  ///< hidden circles whose hider is gone
  std::vector<int> edges_;
};

}  // namespace circle_voronoi
