// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi::test {

/// A region and its description.
struct RegionShape {
  std::string name;
  Region region;
};

/// A star-shaped ring around a point with random distances between `least` and `most`.
Region::Ring starRing(std::mt19937_64& random, Point center, double least, double most, std::size_t corners);

/// A coastline: a circle whose sides are divided again and again, each time at a random distance, without crossings.
Region::Ring coastRing(std::mt19937_64& random, Point center, double radius, std::size_t corners);

/// A comb of teeth, as high as the box.
Region::Ring combRing(const Box& box, std::size_t teeth);

/// A spiral corridor inside a box.
Region::Ring spiralRing(const Box& box, std::size_t turns);

/// Regions of all kinds that are hard for a diagram: corners on its vertices and edges, sides along its edges, holes
/// around its cells and inside them, regions smaller than a cell and far outside.
std::vector<RegionShape> hardRegions(const Diagram& diagram, std::mt19937_64& random);

}  // namespace circle_voronoi::test
