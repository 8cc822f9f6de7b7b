// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "circle_voronoi/compute.h"
#include "find_sites.h"
#include "journal.h"
#include "judge.h"
#include "topology.h"
#include "triangulate.h"

namespace circle_voronoi {

/// A topology over sites that is not that of a triangulated sphere, and where.
struct FlawedTopology {
  Topology topology;
  TopologyFlaw flaw;
};

/// A dual over sites with the verdict of the judge, or a topology that forms no dual.
struct Construction {
  Dual dual;
  Verdict verdict;
  std::optional<FlawedTopology> flawed = {};

  bool isRight() const { return !flawed && verdict.isRight(); }
};

/// Runs the touching disc method on the candidates of `options` and judges the result. With `options.resample`, tries
/// again with more samples around the flaw. Events go to `observer`, in sites and scaled units.
Construction constructByTouchingDisc(const Sites& sites, const Options& options, const Observer& observer,
                                     Journal& journal, Threads threads);

/// Flips from the Delaunay triangulation of the centers, judged.
Construction constructByFlips(Sites& sites, const Observer& observer, Journal& journal, Threads threads);

/// Returns the certified dual of a few circles, none of which hides another, built by insertion. Returns nothing if
/// there are too many circles, or if the judge rejects the dual.
std::optional<Dual> solveLocally(std::span<const Circle> circles, Counts& counts);

/// Returns the first certified dual, made by flips, by local repair if the flips leave few wrong faces, or by
/// insertion. If none is certified, returns the last one, with its verdict. Uses up the triangulation of the sites,
/// because flips change it in place. A dual that insertion made is certified already.
Construction constructAutomatically(FoundSites& found, const Observer& observer, Journal& journal,
                                    Threads threads = Threads());

}  // namespace circle_voronoi
