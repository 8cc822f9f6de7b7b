// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of a predicate is that of integer arithmetic, whichever stage decides.
#include "predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "brute_force.h"
#include "exact.h"
#include "face_discs.h"
#include "found_sites.h"
#include "report.h"
#include "tie_inputs.h"
#include "triangulate.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

using Triple = Predicates::Triple;

bool shareAnEdge(const Triple& a, const Triple& b) {
  return std::count_if(a.begin(), a.end(), [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); }) >= 2;
}

/// Compares all predicates of a few circles, none of which hides another, with exact arithmetic.
class Comparison {
 public:
  explicit Comparison(std::span<const Circle> circles)
      : circles_(circles), count_(static_cast<int>(circles.size())), predicates_(circles) {}

  void run() {
    compareContains();
    compareTangentSides();
    findFaces();
    compareHalves();
    compareTurns();
    compareEdgeOrders();
  }

  const FilterCounts& counts() const { return predicates_.counts(); }

 private:
  struct Face {
    Triple triple;
    exact::Face circles;
    FaceDisc disc;
  };

  const Circle* at(int i) const { return i == kPointAtInfinity ? nullptr : &circles_[i]; }

  void compareContains() {
    for (const Circle& outer : circles_) {
      for (const Circle& inner : circles_) EXPECT_EQ(predicates_.contains(outer, inner), exact::contains(outer, inner));
    }
  }

  void compareTangentSides() {
    for (int a = 0; a < count_; ++a) {
      for (int b = 0; b < count_; ++b) {
        for (int c = 0; c < count_; ++c) {
          if (a == b || b == c || c == a) continue;
          EXPECT_EQ(predicates_.tangentSide(a, b, c), exact::tangentSide(circles_[a], circles_[b], circles_[c]))
              << a << ", " << b << ", " << c;
        }
      }
    }
  }

  /// All ordered triples, infinity last, whose disc exists.
  void findFaces() {
    for (int a = 0; a < count_; ++a) {
      for (int b = 0; b < count_; ++b) {
        for (int c = kPointAtInfinity; c < count_; ++c) {
          if (a == b || b == c || c == a) continue;
          const Triple triple = {a, b, c};
          const exact::Face circles = {at(a), at(b), at(c)};
          const FaceDisc disc = predicates_.disc(triple);
          EXPECT_EQ(disc.exists, exact::hasDisc(circles)) << a << ", " << b << ", " << c;
          if (disc.exists) faces_[triple] = {triple, circles, disc};
        }
      }
    }
  }

  void compareHalves() {
    for (const auto& [triple, face] : faces_) {
      const int x = exact::directionSign(face.circles, circles_[triple[0]], 0);
      const int y = exact::directionSign(face.circles, circles_[triple[0]], 1);
      EXPECT_EQ(predicates_.isLower(triple[0], face.triple, predicates_.direction(triple[0], face.disc)),
                y < 0 || (y == 0 && x < 0));
    }
  }

  void compareTurns() {
    for (const auto& [first, f] : faces_) {
      for (const auto& [second, g] : faces_) {
        if (first[0] != second[0] || !shareAnEdge(first, second)) continue;
        const int from = first[0];
        const int sign = exact::crossSign(f.circles, g.circles, circles_[from]);
        const int filtered =
            predicates_.filteredCross(predicates_.direction(from, f.disc), predicates_.direction(from, g.disc));
        EXPECT_TRUE(filtered == 0 || filtered == sign) << filtered << " for " << sign;
        EXPECT_EQ(predicates_.exactCross(from, first, second), sign);
      }
    }
  }

  void compareEdgeOrders() {
    for (const auto& [abc, f] : faces_) {
      const auto [a, b, c] = abc;
      for (int d = 0; d < count_; ++d) {
        const auto bad = faces_.find({b, a, d});
        if (d == c || c == kPointAtInfinity || bad == faces_.end()) continue;
        // Seen from the larger circle; of equal ones from either.
        const int order = circles_[a].r >= circles_[b].r
                              ? exact::crossSign(bad->second.circles, f.circles, circles_[a])
                              : exact::crossSign(f.circles, bad->second.circles, circles_[b]);
        EXPECT_EQ(predicates_.looksFromFirst(a, b) ? predicates_.exactEdgeOrder(a, b, c, d)
                                                   : predicates_.exactEdgeOrder(b, a, d, c),
                  order)
            << a << b << c << d;
        const Dual dual{{a, b, c, b, a, d}, {3, kNone, kNone, 0, kNone, kNone}};
        const Flaw flaw = order < 0 ? Flaw::edgeOutOfOrder : Flaw::none;
        EXPECT_EQ(FaceDiscs(circles_, dual, predicates_).flawOf(0), flaw) << a << b << c << d;
      }
    }
  }

  std::span<const Circle> circles_;
  int count_;
  Predicates predicates_;
  std::map<Triple, Face> faces_;
};

/// Compares all predicates of circles that may hide one another. Returns how often each stage decided.
FilterCounts compare(std::span<const Circle> circles) {
  const auto rounded = validate(circles);
  EXPECT_TRUE(rounded.ok());
  if (!rounded) return {};
  const Sites sites = triangulate(test::foundSites(order(rounded.value())).sites);
  Comparison comparison(sites.circles);
  comparison.run();
  return comparison.counts();
}

/// Compares all predicates of circles and of a point among them that is far away, each circle multiplied by a power of
/// two of its own or all by the same one. Circles that another one contains are left out.
FilterCounts compareAtScales(std::vector<Circle> circles, Random& random) {
  const bool isCommon = random.below(2) == 0;
  const auto exponent = [&] { return 15 - static_cast<int>(random.below(111)); };
  const int common = exponent();
  for (Circle& c : circles) {
    const int scaling = isCommon ? common : exponent();
    c = rounded(Circle{std::ldexp(c.x, scaling), std::ldexp(c.y, scaling), std::ldexp(c.r, scaling)});
  }
  if (random.below(2) == 0) {
    const Vector far = random.direction();
    circles.push_back({0x1p95 * far.x, 0x1p95 * far.y, 0});
  }
  const auto hidden = test::hiddenByDefinition(circles);
  std::vector<Circle> visible;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto isThis = [&](const HiddenCircle& h) { return h.circle == static_cast<std::int32_t>(i); };
    if (std::ranges::none_of(hidden, isThis)) visible.push_back(circles[i]);
  }
  Comparison comparison(visible);
  comparison.run();
  return comparison.counts();
}

struct Decided {
  std::int64_t filtered = 0;
  std::int64_t later = 0;
};

TEST(Predicates, AgreeWithExactArithmeticInAndNearTies) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (int disturbance = 0; disturbance < test::kDisturbances; ++disturbance) {
      Decided decided;
      for (std::uint64_t trial = 0; trial < 20; ++trial) {
        Random random(seed * 1'000'003 + trial * 64 + static_cast<std::uint64_t>(disturbance));
        auto circles = kind.make(5, random);
        test::disturb(circles, test::Disturbance{disturbance}, random);
        const FilterCounts counts = compare(circles);
        decided.filtered += counts.filtered;
        decided.later += counts.inCircle + counts.exact;
        if (testing::Test::HasFailure())
          FAIL() << kind.name << ", disturbance " << disturbance << test::describe(circles);
      }
      // The inputs are worth nothing if they never come near a tie.
      EXPECT_GT(decided.filtered, 0) << kind.name << ", disturbance " << disturbance;
      EXPECT_GT(decided.later, 0) << kind.name << ", disturbance " << disturbance;
    }
  }
}

TEST(Predicates, AgreeWithExactArithmeticOnRandomCircles) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 80; ++trial) {
    Random random(seed * 1'000'003 + trial);
    std::vector<Circle> circles;
    for (int i = 0; i < 6; ++i) {
      const double size = trial % 2 == 0 ? 1 : random.logUniform(-20, 20);
      circles.push_back({size * random.uniform(-1, 1), size * random.uniform(-1, 1), size * random.uniform(0, 0.7)});
    }
    compare(circles);
    if (testing::Test::HasFailure()) FAIL() << "trial " << trial << test::describe(circles);
  }
}

/// Circles inside the first one, but for 1e-15 of its radius: common tangents are too short for a filter of doubles.
std::vector<Circle> barelyOut(std::size_t count, Random& random) {
  const double radius = random.logUniform(-3, 3);
  std::vector<Circle> circles = {{0, 0, radius}};
  while (circles.size() < count) {
    const double r = radius * random.unit();
    const Vector direction = random.direction();
    const double distance = (radius - r) * (1 + 1e-15);
    circles.push_back({distance * direction.x, distance * direction.y, r});
  }
  return circles;
}

TEST(Predicates, AgreeWithExactArithmeticOnCirclesThatBarelyStickOut) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 60; ++trial) {
    const auto circles = barelyOut(5, random);
    compare(circles);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << test::describe(circles);
  }
}

TEST(Predicates, KnowTheNormalOfATangentHoweverShortItIs) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto circles = validate(barelyOut(2, random)).value();
    if (exact::contains(circles[0], circles[1])) continue;
    Predicates predicates(circles);
    const FaceDisc line = predicates.disc({0, 1, kPointAtInfinity});
    EXPECT_LE(line.error, 1e-6 * (std::abs(line.v.x) + std::abs(line.v.y))) << test::describe(circles);
  }
}

TEST(Predicates, AgreeWithExactArithmeticAtEveryScale) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (std::uint64_t trial = 0; trial < 8; ++trial) {
      Random random(seed * 1'000'003 + trial);
      auto circles = validate(kind.make(4, random)).value();
      test::disturb(circles, test::Disturbance{static_cast<int>(trial % 2)}, random);
      compareAtScales(circles, random);
      if (testing::Test::HasFailure()) FAIL() << kind.name << ", trial " << trial << test::describe(circles);
    }
  }
  FilterCounts counts;
  for (std::uint64_t trial = 0; trial < 60; ++trial) {
    Random random(seed * 1'000'003 + trial);
    std::vector<Circle> circles;
    for (int i = 0; i < 5; ++i) {
      circles.push_back(
          {0x1p80 * random.uniform(-1, 1), 0x1p80 * random.uniform(-1, 1), 0x1p79 * random.unit() * random.unit()});
    }
    counts += compareAtScales(circles, random);
    if (testing::Test::HasFailure()) FAIL() << "trial " << trial << test::describe(circles);
  }
  EXPECT_GT(counts.filtered, 0);
}

// A filter that measures in units of the whole decides nothing among circles that are near one another.
TEST(Predicates, OfCirclesNearOneAnotherAreFilteredAsThoseOfTheWhole) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    Random random(seed * 1'000'003 + trial);
    std::vector<Circle> circles;
    for (int i = 0; i < 5; ++i) {
      circles.push_back({0x1p70 * (i + 0.5 * random.unit()), 0x1p70 * random.uniform(0, 5), 0x1p69 * random.unit()});
    }
    const auto countsOf = [](std::span<const Circle> some) {
      Comparison comparison(some);
      comparison.run();
      return comparison.counts();
    };
    const FilterCounts counts = countsOf(circles);
    for (const int scaling : {20, -20, -70, -100, -113}) {
      std::vector<Circle> scaled;
      for (const Circle& c : circles) {
        scaled.push_back({std::ldexp(c.x, scaling), std::ldexp(c.y, scaling), std::ldexp(c.r, scaling)});
      }
      const FilterCounts scaledCounts = countsOf(scaled);
      EXPECT_EQ(scaledCounts.filtered, counts.filtered) << "trial " << trial << test::describe(scaled);
      EXPECT_EQ(scaledCounts.exact, counts.exact) << "trial " << trial << test::describe(scaled);
    }
  }
}

// Directions are told apart by an axis that no short numbers lie along; these do.
TEST(Predicates, AgreeWithExactArithmeticAlongTheAxisItself) {
  for (const double r : {0.0, 1.0}) {
    std::vector<Circle> circles;
    for (const double step : {-1.0, 0.0, 2.0}) circles.push_back({step * exact::kAxisY, -step * exact::kAxisX, r});
    const exact::Face above = {&circles[0], &circles[1], nullptr};
    const exact::Face below = {&circles[1], &circles[0], nullptr};
    ASSERT_EQ(exact::directionSign(above, circles[0], 1), 0);
    ASSERT_EQ(exact::directionSign(above, circles[0], 0), -exact::directionSign(below, circles[0], 0));
    compare(circles);
    // Not along it, for the half-planes to turn at it.
    circles.push_back({exact::kAxisX, exact::kAxisY, r});
    compare(circles);
  }
}

TEST(Predicates, TangentSideIsExactWhereDistancesDifferMost) {
  Random random(test::seedOr(1));
  for (int trial = 0; trial < 2000; ++trial) {
    const double near = std::ldexp(1 + random.unit(), -14 - static_cast<int>(random.below(30)));
    const Vector far = random.direction();
    const Vector v = random.direction();
    const double r = 4 * near;
    // The third circle nearly touches the tangent line of the others, at 1e-42 to 1e-33 of their distance.
    const std::array<Circle, 3> circles = {{{0, 0, r},
                                            {0x1p95 * far.x, 0x1p95 * far.y, r},
                                            rounded(Circle{near * v.x, near * v.y, r - near * cross(far, v)})}};
    Predicates predicates(circles);
    EXPECT_EQ(predicates.tangentSide(0, 1, 2), exact::tangentSide(circles[0], circles[1], circles[2]));
  }
}

}  // namespace
}  // namespace circle_voronoi
