// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in regions take n log n steps in circles, sides and output.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

/// A diagram and a region.
struct Clipping {
  Diagram diagram;
  Region region;

  explicit Clipping(const GrowthInput& input) : diagram(compute(input.circles).value()), region(input.region()) {}
};

/// A promise of a function of a clipped diagram.
template <class Use>
auto ofClipped(Use use) {
  return [use](const GrowthInput& input) {
    const auto clipping = std::make_shared<Clipping>(input);
    const auto clipped = kept(ClippedDiagram::from(clipping->diagram, clipping->region).value());
    return [clipping, clipped, use] { use(*clipped); };
  };
}

TEST(GrowthOfClips, OfEdges) {
  expectGrowth({"ClippedDiagram::edges", "clipped_diagram.h",
                ofClipped([](const ClippedDiagram& clipped) { static_cast<void>(clipped.edges()); })});
}

}  // namespace
}  // namespace circle_voronoi::test
