// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dual.h"
#include "face_discs.h"

namespace circle_voronoi {

/// Repairs a dual where it is visibly wrong: takes the circles at the wrong faces out (shrink_cell.h), which leaves the
/// right dual of the others if only these were in its way, and inserts them again (insert_cell.h); then the same
/// where it is still wrong around them, a few times. The rest of the dual stays as it is, and is not looked at. The
/// result is to be judged.
///
/// `discs` are all the discs of `dual`, before and after; `wrong` are its wrong faces (wrong_faces.h).
/// Returns the number of circles inserted again; nothing if that did not go well, and then the dual is of no use.
std::optional<std::int64_t> repair(Dual& dual, FaceDiscs& discs, std::vector<int> wrong);

}  // namespace circle_voronoi
