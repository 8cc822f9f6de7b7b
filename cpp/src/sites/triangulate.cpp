// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangulate.h"

#include <utility>

#include "centres.h"
#include "delaunay.h"

namespace circle_voronoi {

Sites triangulate(VisibleCircles visible, Threads threads) {
  Dual centres;
  if (visible.centres) {
    centres = *std::move(visible.centres);
  } else if (!visible.dual) {
    centres = delaunay(centresOf(visible.circles), threads).dual;
  }
  return {std::move(visible.circles),
          std::move(visible.indices),
          std::move(visible.hidden),
          std::move(centres),
          std::move(visible.dual),
          visible.flips,
          visible.signs};
}

}  // namespace circle_voronoi
