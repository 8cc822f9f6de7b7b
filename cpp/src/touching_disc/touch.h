// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/trace.h"
#include "pair.h"
#include "progress_callback.h"
#include "topology.h"

namespace circle_voronoi {

struct TouchResult {
  Topology topology;
  std::int64_t threeTouchDiscs = 0;
  std::int64_t events = 0;
  std::int64_t leftoverCycles = 0;
};

/// The event loop of the touching disc method (paper, sections 3 and 6): takes antipodal and three-touch discs in the
/// order of their radii, and moves directed edges from each disc of R_min to its disc of R_max.
///
/// `circles` must not hide one another; `pairs` are the candidates. The result is the Voronoi diagram if `pairs` holds
/// every pair whose antipodal disc is empty and needed; it is a planar structure in any case, to be judged. The
/// leftover directed edges are the hull: one cycle if all went well (paper, Lemma 2). Reports the finished part of the
/// pairs to `progress` from time to time.
TouchResult touch(std::span<const Circle> circles, std::span<const Pair> pairs, const Observer& observer = {},
                  const ProgressCallback& progress = {});

}  // namespace circle_voronoi
