// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "prefetch.h"

namespace circle_voronoi {

/// Visits 0 to count - 1 in order, and before that calls `early` and then `late` with indices ahead. Cells in the order
/// of the input lie all over the memory: these two ask for what a cell needs, `late` by what `early` asked for, so that
/// the visit does not wait.
template <class Early, class Late, class Visit>
void visitAhead(std::int32_t count, Early early, Late late, Visit visit) {
  constexpr std::int32_t kAhead = 3;
  for (std::int32_t i = 0; i < count; ++i) {
    if (count - i > 2 * kAhead) early(i + 2 * kAhead);
    if (count - i > kAhead) late(i + kAhead);
    visit(i);
  }
}

}  // namespace circle_voronoi
