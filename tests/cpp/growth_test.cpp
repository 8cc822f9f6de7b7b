// SPDX-License-Identifier: GPL-3.0-or-later
// Counts replace times: signs and flips grow as n log n on every family, and on each with an outlier, with duplicates
// and in two distant clusters. CIRCLE_VORONOI_SEED chooses other inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>

#include "circle_voronoi/compute.h"
#include "report.h"
#include "variants.h"

namespace circle_voronoi {
namespace {

constexpr std::size_t kFew = 1000;
constexpr std::size_t kMany = 4 * kFew;

/// The factor of n log n between the two sizes is 4.8; random inputs vary by more than that leaves.
constexpr double kMostGrowth = 6;
/// The signs, discs and flips of a circle, of which uniform circles take 19; and the number of signs in integers.
struct Limits {
  double steps;
  double exact;
};
constexpr Limits kGeneral = {60, 40};
constexpr Limits kDegenerate = {300, 80};

struct Work {
  double steps = 0;
  double exact = 0;
  Way way = Way::flip;
};

Work workOn(const std::vector<Circle>& circles) {
  const auto diagram = compute(circles);
  EXPECT_TRUE(diagram.ok());
  const Counts& counts = diagram.value().stats.counts;
  const std::int64_t signs = counts.filtered + counts.refined + counts.inCircle + counts.exact;
  const std::int64_t discs = counts.samples + counts.antipodalDiscs + counts.threeTouchDiscs + counts.events;
  return {static_cast<double>(signs + discs + counts.flips), static_cast<double>(counts.exact),
          diagram.value().stats.way.value()};
}

TEST(Growth, OfEveryFamilyIsThatOfNLogN) {
  const std::uint64_t seed = test::seedOr(1);
  std::cout << "seed " << seed << "\nsteps and exact signs a circle, growth from " << kFew << " to " << kMany << '\n'
            << std::fixed << std::setprecision(1);
  for (const FamilyInfo& family : families()) {
    for (const Variant& variant : variants()) {
      const std::string name = std::string(family.name) + std::string(variant.name);
      SCOPED_TRACE(name);
      const Work few = workOn(variant.make(family.family, kFew, seed));
      const Work many = workOn(variant.make(family.family, kMany, seed));
      // If nearly all circles are hidden, there may be next to nothing to do.
      const double growth = many.steps / std::max(few.steps, static_cast<double>(kFew));
      const double steps = many.steps / kMany;
      const double exact = many.exact / kMany;
      std::cout << std::setw(40) << std::left << name << std::right << std::setw(8) << steps << std::setw(8) << exact
                << std::setw(8) << growth << "  " << wayName(many.way) << '\n';
      const Limits& limits = family.isDegenerate ? kDegenerate : kGeneral;
      // The work of the search for hidden circles, from which insertion takes over, is not counted.
      if (few.way == many.way) {
        EXPECT_LE(growth, kMostGrowth);
      }
      EXPECT_LE(steps, limits.steps);
      EXPECT_LE(exact, limits.exact);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
