// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi::test {

/// Circles, a region and a metric.
struct ClipInput {
  std::vector<Circle> circles;
  std::vector<Region::Ring> rings;
  Metric metric = Metric::circles;
};

/// Returns whether polygons are promised (docs/regions.md): the region is at most 1e6 times as large as the distance of
/// the circles from the origin.
bool hasPolygons(const ClipInput& input);

/// Returns the larger one of width and height.
double extentOf(const Region& region);

/// Returns the largest coordinate or radius.
double farthestOf(const ClipInput& input);

/// Returns the radius of a circle in the metric of an input.
double radiusOf(const ClipInput& input, const Circle& circle);

/// Returns the distance at which the disc of a circle has a radius.
double distanceOfReach(const ClipInput& input, const Circle& circle, double reach);

/// Returns a distance at which the disc of a circle meets a corner, a side, a vertex, or another disc, up to rounding,
/// or something else.
double anyDistance(const ClipInput& input, std::mt19937_64& random);

/// Returns the polygons of a cell, as a region is made from.
std::vector<std::vector<Region::Ring>> polygonsOf(const ClippedPolygons& all, std::size_t cell);

/// Inputs where the boundary of a region meets vertices and edges of a diagram exactly.
struct ClipFamily {
  const char* name;
  ClipInput (*make)(std::mt19937_64& random);
};

const std::vector<ClipFamily>& clipFamilies();

}  // namespace circle_voronoi::test
