// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hide.h"
#include "journal.h"
#include "predicates.h"
#include "proof.h"

namespace circle_voronoi {

/// A dual that insertion constructed and the judge accepted.
struct InsertedDual {
  Dual dual;
  Proof proof;
  std::int64_t flips = 0;
  FilterCounts signs;  ///< the signs computed for the dual and its proof
};

/// Sites, and either the triangulation of their centers or the dual that insertion left when it found the hidden
/// circles.
struct FoundSites {
  Sites sites;
  std::optional<InsertedDual> inserted;
};

/// The limit of the search for hiders, in steps per circle. Ordinary circles take ten to twenty.
inline constexpr std::int64_t kMostStepsACircle = 30;

/// Removes the hidden circles (hide.h), and triangulates the centers of the others. If the search takes more than 1000
/// steps plus `mostStepsACircle` for each circle, the construction of the Voronoi diagram finds the hidden circles
/// instead (insert.h): its insertion and its judge are stages of their own.
FoundSites findSites(OrderedCircles ordered, Journal& journal, Threads threads = Threads(),
                     std::int64_t mostStepsACircle = kMostStepsACircle);

}  // namespace circle_voronoi
