// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_within.h"

#include "circle_voronoi/cells.h"

namespace circle_voronoi {

const char* faultOf(const LoopsWithin& loops, const AreaBounds& bounds, double rounding) {
  constexpr const char* kOpen = "The part of a cell within the maximum distance does not close.";
  constexpr const char* kArea = "The area of the part of a cell within the maximum distance is impossible.";
  if (!loops.isSound || loops.isHole.size() != loops.outline.size()) return kOpen;
  double sum = 0;
  for (std::size_t k = 0; k < loops.outline.size(); ++k) {
    const auto& loop = loops.outline[k];
    if (loop.empty()) return kOpen;
    for (std::size_t p = 0; p < loop.size(); ++p) {
      if (loop[p].curve.end != loop[p + 1 == loop.size() ? 0 : p + 1].curve.start) return kOpen;
    }
    const double its = area({loop});
    if (!((loops.isHole[k] != 0 ? -its : its) >= -rounding)) return kArea;
    sum += its;
  }
  return sum >= bounds.least - rounding && sum <= bounds.most + rounding ? nullptr : kArea;
}

}  // namespace circle_voronoi
