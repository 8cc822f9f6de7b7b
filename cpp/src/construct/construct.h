// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "circle_voronoi/compute.h"
#include "journal.h"
#include "topology.h"
#include "triangulate.h"

namespace circle_voronoi {

/// A topology over sites, and what a judge says of it.
struct Construction {
  Topology topology;
  Certificate certificate;  ///< by the indices of sites, vertices and edges of `topology`
};

/// The touching disc method on the candidates of `options`, judged; with `options.resample`, again with more samples
/// around what was wrong. Events go to `observer`, in sites and scaled units.
Construction constructByTouchingDisc(const Sites& sites, const Options& options, const Observer& observer,
                                     Journal& journal);

/// Flips from the Delaunay triangulation of the centres, judged.
Construction constructByFlips(Sites& sites, const Observer& observer, Journal& journal);

/// The certified dual of those of a few circles that are visible: by the touching disc method on all pairs if they are
/// very few, else by insertion, and if that is not certified by CGAL. Nothing if they are too many, or it is not
/// certified either.
std::optional<Dual> solveLocally(std::span<const Circle> circles, Journal& journal);

/// The first that leads to a certified topology: flips, with local repair where they leave little wrong; insertion;
/// CGAL's Apollonius graph. If none does, the last one, with its certificate. Uses up the triangulation of the sites,
/// which flips change in place.
Construction constructAutomatically(Sites& sites, const Observer& observer, Journal& journal);

}  // namespace circle_voronoi
