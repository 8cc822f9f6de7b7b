// SPDX-License-Identifier: GPL-3.0-or-later
// The same circles in another order give the same diagram with the same bits: vertices, edges and cells in the same
// places of their arrays.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi_families/families.h"
#include "compare.h"
#include "regions.h"
#include "report.h"
#include "three_touch_disc.h"
#include "tie_inputs.h"
#include "validate.h"
#include "variants.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

/// Circles in another order: `names` has the index of each before.
struct Shuffled {
  Circles circles;
  std::vector<std::int32_t> names;

  Shuffled(const Circles& original, Random& random) : names(original.size()) {
    std::iota(names.begin(), names.end(), 0);
    random.shuffle(names);
    for (const std::int32_t i : names) circles.push_back(original[static_cast<std::size_t>(i)]);
  }
};

/// Names each circle by the first of those that are identical to it.
std::vector<std::int32_t> firstOfIdentical(const Circles& circles) {
  std::map<std::tuple<double, double, double>, std::int32_t> firsts;
  std::vector<std::int32_t> names;
  for (const Circle& c : circles) {
    const auto index = static_cast<std::int32_t>(names.size());
    names.push_back(firsts.emplace(std::tuple(c.x, c.y, c.r), index).first->second);
  }
  return names;
}

/// Renames the circles of a diagram. Lists that begin with the first of some circles begin with the first new name.
Diagram inOrder(const Diagram& given, const std::vector<std::int32_t>& names) {
  Diagram diagram = test::renamed(given, names);
  for (auto& triple : diagram.vertexCircles) std::ranges::rotate(triple, std::ranges::min_element(triple));
  std::ranges::sort(diagram.hidden, {}, &HiddenCircle::circle);
  if (!diagram.hull.empty()) {
    // A circle may recur on the hull.
    std::vector<CircleIndex> least = diagram.hull;
    for (std::size_t k = 0; k < diagram.hull.size(); ++k) {
      std::ranges::rotate(diagram.hull, diagram.hull.begin() + 1);
      least = std::min(least, diagram.hull);
    }
    diagram.hull = least;
  }
  return diagram;
}

/// Returns each hidden circle with the radius of its hider, without copies. The order of the circles decides which of
/// identical circles is hidden, and names the hider among equal radii.
std::vector<std::pair<CircleIndex, double>> hiddenBelow(const Diagram& diagram, const Circles& circles) {
  std::vector<std::pair<CircleIndex, double>> radii;
  for (const auto& [circle, by] : diagram.hidden) {
    if (circle != by) radii.emplace_back(circle, circles[static_cast<std::size_t>(by)].r);
  }
  return radii;
}

std::vector<double> areasOf(const Diagram& diagram, const std::vector<std::int32_t>& names, const Region& box) {
  std::vector<double> areas(diagram.circles.size(), 0);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto circle = static_cast<std::int32_t>(i);
    if (diagram.hasCell(circle)) areas[static_cast<std::size_t>(names[i])] = area(outline(diagram, circle, box));
  }
  return areas;
}

std::string differenceInOrder(const Circles& circles, Random& random) {
  const auto computed = compute(circles);
  if (!computed) return {};
  Diagram expected = computed.value();
  const Shuffled shuffled(circles, random);
  Diagram actual = compute(shuffled.circles).value();
  const auto firsts = firstOfIdentical(expected.circles);
  std::vector<std::int32_t> names;
  for (const std::int32_t i : shuffled.names) names.push_back(firsts[static_cast<std::size_t>(i)]);
  if (actual.vertices != expected.vertices) return "vertices";
  if (actual.links.nextSide != expected.links.nextSide) return "links";
  if (expected.certificate.certified() && circles.size() <= 100) {
    const Region box = test::regionOf(exportBox(expected.circles));
    if (areasOf(actual, names, box) != areasOf(expected, firsts, box)) return "areas";
  }
  expected = inOrder(expected, firsts);
  actual = inOrder(actual, names);
  if (actual.vertexCircles != expected.vertexCircles) return "circles of vertices";
  if (actual.edges != expected.edges) return "edges";
  if (hiddenBelow(actual, circles) != hiddenBelow(expected, circles)) return "hidden circles";
  return actual.hull != expected.hull ? "hull" : "";
}

TEST(Order, OfCirclesOfEachFamilyChangesNoBit) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (const Variant& variant : variants()) {
      for (std::uint64_t trial = 0; trial < 4; ++trial) {
        Random random(seed * 1'000'003 + trial);
        const Circles circles = variant.make(family.family, 2 + random.below(200), random.next());
        ASSERT_EQ(differenceInOrder(circles, random), "")
            << family.name << variant.name << ", trial " << trial << test::describe(circles);
      }
    }
  }
}

TEST(Order, OfCirclesInAndNearTiesChangesNoBit) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  test::forEachTie(seed, 4 * test::kDisturbances, [&](const Circles& circles, std::string_view kind) {
    EXPECT_EQ(differenceInOrder(circles, random), "") << kind << test::describe(circles);
  });
}

/// Equal circles whose centers are thirds, nearly on lines: their far vertices need more than double arithmetic.
Circles thirdsNearlyOnLines(std::size_t count, Random& random) {
  const double r = random.below(2) == 0 ? 0 : 0.1;
  Circles circles;
  for (std::size_t i = 0; i < count; ++i) {
    double y = static_cast<double>(random.below(2)) + 1.0 / 3;
    for (std::uint64_t steps = random.below(4); steps > 0; --steps) y = std::nextafter(y, 4);
    circles.push_back({static_cast<double>(random.below(9)) / 3, y, r});
  }
  return circles;
}

TEST(Order, OfCirclesNearlyOnALineChangesNoBit) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 10'000; ++trial) {
    const Circles circles = thirdsNearlyOnLines(3 + random.below(6), random);
    ASSERT_EQ(differenceInOrder(circles, random), "") << "seed " << seed << test::describe(circles);
  }
}

/// Three circles that bend from a line by a few ulps to 2^-10, with equal radii, two equal radii, or others.
std::array<Circle, 3> nearlyOnALine(Random& random) {
  const double bend = std::ldexp(random.uniform(-1, 1), -10 - static_cast<int>(random.below(50)));
  const double slope = random.uniform(-2, 2);
  const double x = random.uniform(-10, 10);
  const double y = random.uniform(-10, 10);
  const double r = random.below(2) == 0 ? 0 : random.uniform(0, 0.1);
  std::array<Circle, 3> circles;
  for (Circle& c : circles) {
    const double t = random.uniform(-1, 1);
    c = {x + t, y + slope * t + bend * t * t, r};
  }
  if (random.below(3) == 0) circles[random.below(3)].r = random.uniform(0, 0.1);
  return circles;
}

TEST(Order, OfThreeCirclesChangesNoBitOfTheirVertex) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int beyondDoubles = 0;
  for (int trial = 0; trial < 300'000; ++trial) {
    auto c = nearlyOnALine(random);
    for (Circle& circle : c) circle = rounded(circle);
    const auto abc = vertexOf(c[0], c[1], c[2]);
    beyondDoubles += static_cast<int>(!vertexAt(discOf(c[0], c[1], c[2]), {&c[0], &c[1], &c[2]}));
    ASSERT_EQ(vertexOf(c[1], c[2], c[0]), abc) << "seed " << seed << ", trial " << trial;
    ASSERT_EQ(vertexOf(c[2], c[0], c[1]), abc) << "seed " << seed << ", trial " << trial;
  }
  EXPECT_GT(beyondDoubles, 100'000);
}

/// An edited diagram has the vertices of a computed one, with its bits.
TEST(Order, OfEditsChangesNoBitOfAVertex) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  const auto sorted = [](const Diagram& diagram) {
    std::vector<std::tuple<double, double, double>> vertices;
    for (const auto& [x, y, r] : diagram.vertices) vertices.emplace_back(x, y, r);
    std::ranges::sort(vertices);
    return vertices;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const Circles circles = thirdsNearlyOnLines(3 + random.below(6), random);
    const Shuffled shuffled(circles, random);
    DiagramEditor editor = DiagramEditor::from({}).value();
    for (const Circle& c : shuffled.circles) ASSERT_TRUE(editor.insert(c).ok());
    ASSERT_EQ(sorted(editor.snapshot().value()), sorted(compute(circles).value()))
        << "seed " << seed << test::describe(circles);
  }
}

}  // namespace
}  // namespace circle_voronoi
