// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/options.h"
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

/// The sites of some circles, and a construction over them.
struct State {
  Sites sites;
  Construction construction;
};

/// Runs the method of `options` on valid circles. With Method::automatic, the construction is the first certified dual,
/// made by flips, by local repair if the flips leave few wrong faces, or by insertion; if none is certified, the last
/// one. Events go to the observer of `options`, in indices of the circles. Throws the error of `refusalOfHidden`.
State construct(std::vector<Circle> circles, const Options& options, Journal& journal);

/// Returns the number of samples that the touching disc method takes.
int sampleCountOf(const Options& options);

/// Flips from the Delaunay triangulation of the centers, judged.
Construction constructByFlips(Sites& sites, const Observer& observer, Journal& journal, Threads threads);

/// Returns the certified dual of a few circles, none of which hides another, built by insertion. Returns nothing if
/// there are too many circles, or if the judge rejects the dual.
std::optional<Dual> solveLocally(std::span<const Circle> circles, Counts& counts);

}  // namespace circle_voronoi
