// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/region.h"

// Tests of the costs that headers promise. Each row names a function, the header that promises its cost, and an input
// family on which the cost is measured in steps (steps.h) at two sizes.
namespace circle_voronoi::test {

/// An input of a given size: circles, and polygons for a region.
struct GrowthInput {
  std::vector<Circle> circles;
  std::vector<std::vector<Region::Ring>> polygons;

  [[nodiscard]] Region region() const;
};

/// A family of inputs by size. Circles and corners of the region together grow in proportion to the size.
struct GrowthFamily {
  std::string_view name;
  GrowthInput (*make)(std::size_t size);
};

/// Points on a circle around the origin, turned by a part of a step.
std::vector<Point> around(double radius, std::size_t count, double turn = 0);

/// Random circles in a region with random corners.
extern const GrowthFamily kUniform;
/// A large circle with points around it, and a zigzag between: one cell has all the others as neighbors, and the
/// boundary crosses each border.
extern const GrowthFamily kHub;
/// Circles in a few long rows, and thin diagonal strips whose bounding boxes all overlap.
extern const GrowthFamily kStrips;
/// Random circles, and a comb of long teeth.
extern const GrowthFamily kComb;
/// Random circles, and a spiral corridor.
extern const GrowthFamily kSpiral;
/// One circle in a polygon with many holes.
extern const GrowthFamily kHoles;
/// All of the above.
std::span<const GrowthFamily> growthFamilies();
/// All of the above with many circles.
std::span<const GrowthFamily> circleFamilies();

/// 4 n log(4 n) is 4.8 times n log n at the default size.
constexpr double kGrowthOfNLogN = 5;

/// A promised cost: by default n log n steps in the size of input and output.
struct Promise {
  std::string_view function;
  std::string_view header;
  /// Prepares an input without being counted, and returns the work to count.
  std::function<std::function<void()>(const GrowthInput&)> prepare;
  std::span<const GrowthFamily> families = growthFamilies();
  std::size_t size = 1000;
  double mostGrowth = kGrowthOfNLogN;
};

std::ostream& operator<<(std::ostream& out, const Promise& promise);

/// Expects that four times the size takes at most `mostGrowth` times the steps, on each family of the promise. Prints
/// the steps of each unit of size, and their growth.
void expectGrowth(const Promise& promise);

/// Expects the same of steps that a function counts for a size.
void expectGrowth(std::string_view input, std::size_t size, const std::function<double(std::size_t size)>& stepsAt,
                  double mostGrowth = kGrowthOfNLogN);

/// A value that lives as long as the work that uses it.
template <class Value>
std::shared_ptr<Value> kept(Value value) {
  return std::make_shared<Value>(std::move(value));
}

/// The preparation of a promise of a function of a diagram.
template <class Use>
auto ofDiagram(Use use) {
  return [use](const GrowthInput& input) {
    const auto diagram = kept(compute(input.circles).value());
    return [diagram, use] { use(*diagram); };
  };
}

}  // namespace circle_voronoi::test
