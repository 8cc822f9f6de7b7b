// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "circle_voronoi/progress.h"
#include "find_sites.h"
#include "journal.h"

namespace circle_voronoi::test {

/// Returns the result of findSites, which nobody follows.
inline FoundSites foundSites(OrderedCircles ordered, Threads threads = Threads(),
                             std::int64_t mostStepsACircle = kMostStepsACircle) {
  const Progress silent;
  Journal journal(silent);
  return findSites(std::move(ordered), journal, threads, mostStepsACircle);
}

}  // namespace circle_voronoi::test
