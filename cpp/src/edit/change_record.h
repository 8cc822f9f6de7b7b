// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/editor.h"
#include "circle_voronoi/error.h"
#include "edit_state.h"

namespace circle_voronoi {

/// Records the changes of a diagram.
class ChangeRecorder {
 public:
  /// Returns the changes of a state since its last commit. Gives numbers to new edges.
  Result<Change> record(EditState& state, EditWay way);

  /// Returns the change from one state to another that was built anew, with numbers of its own.
  Result<Change> recordWhole(const EditState& before, const EditState& after);

 private:
  struct Mark {
    bool isListed = false;  ///< whether the slot is in `marked_`
    bool isMoved = false;
    bool hasCell = false;  ///< whether the circle is in Change::cells
  };

  Mark& markOf(int slot);
  void recordCircles(Change& change, const EditState& state);
  void recordVertices(Change& change, EditState& state);
  void recordEdges(Change& change, EditState& state);
  void recordHull(Change& change, const EditState& state);

  std::vector<Mark> marks_;  ///< for each slot
  std::vector<int> marked_;  ///< the slots with a mark
};

}  // namespace circle_voronoi
