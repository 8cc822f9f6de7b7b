// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/options.h"
#include "find_sites.h"
#include "journal.h"
#include "judge.h"
#include "report_faces.h"
#include "triangulate.h"

namespace circle_voronoi {

/// The sites of some circles, a dual over them, and the verdict of the judge with its proof.
struct State {
  Sites sites;
  Dual dual;
  Verdict verdict;
};

/// Runs Method::automatic or Method::flip on valid circles. With Method::automatic, the dual is the first certified
/// one, made by flips, by local repair if the flips leave few wrong faces, or by insertion; if none is certified, the
/// last one. Events go to the observer of `options`, in indices of the circles. Throws the error of `refusalOfHidden`.
State construct(std::vector<Circle> circles, const Options& options, Journal& journal);

/// Flips the dual of a state from the Delaunay triangulation of the centers, which it uses up, and judges it.
void constructByFlips(State& state, const Observer& observer, Journal& journal, Threads threads);

/// Returns the certified dual of a few circles, none of which hides another, built by insertion. Returns nothing if
/// there are too many circles, or if the judge rejects the dual.
std::optional<Dual> solveLocally(std::span<const Circle> circles, Counts& counts);

// The parts of a construction, for all methods.

/// Orders valid circles and finds their sites. Without `mayInsert`, these have the triangulation of their centers in
/// any case. Throws the error of `refusalOfHidden`.
FoundSites sitesOf(std::vector<Circle> circles, bool mayInsert, Journal& journal, Threads threads);

/// Translates the events of visible circles to those of the input. Both arguments must outlive the result.
Observer observerOfInput(const Observer& observer, const std::vector<int>& visible);

/// Tells the observer the edges of the triangulation of the centers.
void reportOfCenters(const Dual& centers, const Observer& observer);

/// Judges a dual, given the known part of its proof, settles its ties, and tells the observer what they change.
Verdict judged(Dual& dual, Proof proof, const Sites& sites, FaceReporter& reporter, Journal& journal, Threads threads);

/// Flips a dual, repairs it if `mayRepair`, and judges it, as above. The dual is not judged if too much is left to
/// repair.
Verdict flippedAndJudged(Dual& dual, const Sites& sites, bool mayRepair, FaceReporter& reporter, Journal& journal,
                         Threads threads);

}  // namespace circle_voronoi
