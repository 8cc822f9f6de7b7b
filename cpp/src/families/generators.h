// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "circle_voronoi/circle.h"
#include "random.h"

namespace circle_voronoi {

// One function for each family; see `families.h`.
using Generator = std::vector<Circle> (*)(std::size_t count, Random& random);

std::vector<Circle> generateUniform(std::size_t count, Random& random);
std::vector<Circle> generateLogUniform(std::size_t count, Random& random);
std::vector<Circle> generatePoints(std::size_t count, Random& random);
std::vector<Circle> generateMixed(std::size_t count, Random& random);
std::vector<Circle> generateDense(std::size_t count, Random& random);
std::vector<Circle> generateClustered(std::size_t count, Random& random);
std::vector<Circle> generateSpiral(std::size_t count, Random& random);
std::vector<Circle> generateChaosDisjoint(std::size_t count, Random& random);
std::vector<Circle> generateFarFromOrigin(std::size_t count, Random& random);
std::vector<Circle> generateTiny(std::size_t count, Random& random);

std::vector<Circle> generateOneHuge(std::size_t count, Random& random);
std::vector<Circle> generateTwoHuge(std::size_t count, Random& random);
std::vector<Circle> generateRing(std::size_t count, Random& random);
std::vector<Circle> generateRingVaried(std::size_t count, Random& random);
std::vector<Circle> generateRows(std::size_t count, Random& random);
std::vector<Circle> generateExtreme(std::size_t count, Random& random);

std::vector<Circle> generateLightlyIntersecting(std::size_t count, Random& random);
std::vector<Circle> generateIntersecting(std::size_t count, Random& random);
std::vector<Circle> generateHidden(std::size_t count, Random& random);
std::vector<Circle> generateDuplicates(std::size_t count, Random& random);
std::vector<Circle> generateChaos(std::size_t count, Random& random);

std::vector<Circle> generateCollinear(std::size_t count, Random& random);
std::vector<Circle> generateCollinearVaried(std::size_t count, Random& random);
std::vector<Circle> generateNearCollinear(std::size_t count, Random& random);
std::vector<Circle> generateGrid(std::size_t count, Random& random);
std::vector<Circle> generateGridTangent(std::size_t count, Random& random);
std::vector<Circle> generateGridColumns(std::size_t count, Random& random);
std::vector<Circle> generateHexagonal(std::size_t count, Random& random);
std::vector<Circle> generateCocircularVaried(std::size_t count, Random& random);
std::vector<Circle> generateCocircularEqual(std::size_t count, Random& random);

std::vector<Circle> generateTwoClusters(std::size_t count, Random& random);
std::vector<Circle> generateFarClusters(std::size_t count, Random& random);
std::vector<Circle> generateOutlier(std::size_t count, Random& random);
std::vector<Circle> generateLineAndHuge(std::size_t count, Random& random);
std::vector<Circle> generateFarOutlier(std::size_t count, Random& random);
std::vector<Circle> generateLongSpiral(std::size_t count, Random& random);
std::vector<Circle> generateGrowingLine(std::size_t count, Random& random);
std::vector<Circle> generateTangentChain(std::size_t count, Random& random);

std::vector<Circle> generateTangentInside(std::size_t count, Random& random);
std::vector<Circle> generateTangentOutside(std::size_t count, Random& random);
std::vector<Circle> generateTangentLine(std::size_t count, Random& random);
std::vector<Circle> generateCommonPoint(std::size_t count, Random& random);
std::vector<Circle> generateNearNested(std::size_t count, Random& random);
std::vector<Circle> generateNestedTangent(std::size_t count, Random& random);
std::vector<Circle> generateConcentric(std::size_t count, Random& random);
std::vector<Circle> generateCocircularLarge(std::size_t count, Random& random);
std::vector<Circle> generateOnRim(std::size_t count, Random& random);
std::vector<Circle> generateWedge(std::size_t count, Random& random);
std::vector<Circle> generateTwoCommonPoints(std::size_t count, Random& random);
std::vector<Circle> generateBarelyOut(std::size_t count, Random& random);

}  // namespace circle_voronoi
