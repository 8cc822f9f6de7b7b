// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// The state of a fit after a step.
struct AreaFitStep {
  int step = 0;                     ///< the number of steps of all fits until now
  double error = 0;                 ///< the largest relative error of an area
  std::span<const double> weights;  ///< the weight of each site; valid during the call only
};

struct AreaFitOptions {
  /// The distance less whose weights the cells are made: `circles` for borders that are arcs of hyperbolas, or `power`
  /// for straight ones, with weights that are areas.
  Metric metric = Metric::circles;
  /// Whether the areas are shares of the area of the region or box: they are multiplied so that they sum to it.
  bool shares = false;
  /// The largest relative error of each area, above 0 and below 1. Larger errors, below 1, remain only where a change
  /// of the last bits of a weight does not make them smaller, as for a cell that is a sliver behind a close neighbor,
  /// or where the last bits of coordinates allow no better areas: 2^-52 of the largest coordinate moves a border by
  /// more than the tolerance. The result has the tolerance that was allowed.
  double tolerance = 1e-9;
  /// The largest number of steps, 1 or more.
  int maxSteps = 500;
  /// The number of times that all sites move to the centers of mass of their cells, after which the areas are fitted
  /// again. Cells become rounder each time. The diagram of the result has the sites where they have come to.
  int relax = 0;
  /// Called before the first step, after each one, and after sites have moved. To cancel, throw: the exception passes
  /// through `fitAreas`. The callback may call any function of the library.
  std::function<void(const AreaFitStep&)> onStep = {};
};

struct AreaFit {
  std::vector<double> weights;  ///< the weight of each site; the least one is 0
  Diagram diagram;              ///< the certified diagram of the sites with these weights
  std::vector<double> areas;    ///< the area of each cell inside the region
  double error = 0;             ///< the largest relative error of an area
  int steps = 0;                ///< the number of Newton steps, of all fits
  double tolerance = 0;         ///< the error that was allowed: that of the options, or more if bits allow no less
};

/// Finds weights for which each site's cell has a given area inside a region. A point belongs to the site with the
/// smallest distance minus weight, or with Metric::power to that with the smallest squared distance minus weight. The
/// weights exist for all positive areas that sum to that of the region, and are unique up to a common constant if the
/// interior of the region is connected. Otherwise some of them may have a range, as where parts of the region touch in
/// corners only.
///
/// A region far from the origin is fitted as if it were there, if the differences of coordinates are exact. Areas are
/// those of exact cells then: vertices of the diagram have the digits of coordinates only, and areas measured with them
/// differ by more.
///
/// This is semi-discrete optimal transport with the distance or its square as cost. The weights maximize a concave
/// function. Its gradient is what the areas lack, and its second derivative is the graph Laplacian of the edges, each a
/// spring. Newton's method with damping finds them (V. Hartmann, D. Schuhmacher, doi:10.1007/s00186-020-00703-z; J.
/// Kitagawa, Q. Mérigot, B. Thibert, arXiv:1603.05579).
///
/// The centers of `sites` are the sites, and their radii the weights to start from, which may be negative. Weights of
/// an earlier fit make a fit after a small change take few steps. Sites may lie outside the region. The same input
/// gives the same bits on every platform.
///
/// A step computes and clips the diagram, more than once if the step is too long, and solves a sparse system in about
/// n^1.5 steps for n sites. The number of Newton's steps depends on the areas: some tens for most.
///
/// Numbers are at most 2^96 (7.9e28) in absolute value. Each is rounded once to a multiple of 2^-96 (1.3e-29), as every
/// number from 2^-44 (5.7e-14) up already is. If the largest number is not 0 and below 2^-56 (1.4e-17), there is an
/// error.
///
/// Errors: nonFinite, coordinateTooLarge (both name the site), coordinateTooSmall, badInput (the numbers of areas and
/// sites differ, an area is not positive and finite, two sites are equal, the areas do not sum to the region's, their
/// sum exceeds the largest number, an area is so small or the region so large that a fit leaves the range of numbers),
/// badOption (also Metric::centers, which has no weights), tooManyCircles (also if memory runs out), notConverged (the
/// message gives the number of steps and the error reached; the last call of `onStep` got the best weights).
CIRCLE_VORONOI_API Result<AreaFit> fitAreas(std::span<const Circle> sites, std::span<const double> areas,
                                            const Region& region, const AreaFitOptions& options = {});

/// The result of a fit in the box of a lattice.
struct PeriodicAreaFit {
  std::vector<double> weights;  ///< the weight of each site; the least one is 0
  PeriodicDiagram periodic;     ///< the certified diagram of the sites with these weights
  std::vector<double> areas;    ///< the area of each cell
  double error = 0;             ///< the largest relative error of an area
  int steps = 0;                ///< the number of Newton steps, of all fits
  double tolerance = 0;         ///< the error that was allowed: that of the options, or more if bits allow no less
};

/// Finds weights for which each site's cell has a given area in a plane that repeats with two periods. The areas sum to
/// that of the box, and such weights always exist. Each fit starts with the radii of the sites, like the fit in a
/// region.
///
/// Sites may lie in any box. With `relax`, a site moves out of its box if its cell does.
///
/// Errors: see `computePeriodic` and the fit in a region. Sites that differ by whole periods are equal.
CIRCLE_VORONOI_API Result<PeriodicAreaFit> fitAreas(std::span<const Circle> sites, std::span<const double> areas,
                                                    const Lattice& lattice, const AreaFitOptions& options = {});

}  // namespace circle_voronoi
