// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hide.h"
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

struct FoundSites {
  Sites sites;
  std::optional<InsertedDual> inserted;  ///< the dual of the sites, if insertion found the hidden circles
};

/// The limit of the search for hiders, in steps per circle. Ordinary circles take ten to twenty.
inline constexpr std::int64_t kMostStepsACircle = 30;

/// Removes the hidden circles (hide.h). If the search takes more than 1000 steps plus `mostStepsACircle` for each
/// circle, the construction of the Voronoi diagram finds the hidden circles instead (insert.h).
FoundSites findSites(OrderedCircles ordered, std::int64_t mostStepsACircle = kMostStepsACircle,
                     Threads threads = Threads());

}  // namespace circle_voronoi
