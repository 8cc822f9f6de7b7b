// SPDX-License-Identifier: GPL-3.0-or-later
// The diagram does not depend on how it was made, also where more than three circles touch a disc. order_test.cpp tests
// other orders of the circles.
#include "settle_ties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/compute.h"
#include "compare.h"
#include "found_sites.h"
#include "insert.h"
#include "judge.h"
#include "order.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"
#include "topology.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

Circles withoutTwins(const Circles& circles) {
  std::set<std::tuple<double, double, double>> seen;
  Circles result;
  for (const Circle& c : circles) {
    if (seen.insert({c.x, c.y, c.r}).second) result.push_back(c);
  }
  return result;
}

/// The diagram without hidden circles: of several equal hiders the first is named, in whatever order they come.
Diagram visible(Diagram diagram) {
  diagram.hidden.clear();
  return diagram;
}

/// The number of edges of length zero in a diagram of visible circles, and whether all are settled: neither end is the
/// greatest of the four circles around the edge (settle_ties.h).
struct Ties {
  int count = 0;
  bool areSettled = true;
};

Ties tiesOf(const Circles& circles, const Diagram& diagram) {
  EXPECT_TRUE(diagram.hidden.empty());
  const auto dual =
      std::get<Dual>(dualOf({diagram.vertexCircles, diagram.edges, diagram.hull}, static_cast<int>(circles.size())));
  Predicates predicates(circles);
  const Verdict verdict = judge(circles, dual, predicates);
  EXPECT_TRUE(verdict.isRight());
  const auto center = [&](int i) { return std::pair(circles[at(i)].x, circles[at(i)].y); };
  Ties ties;
  for (const int h : verdict.ties) {
    const int t = dual.twin[at(h)];
    const auto ends = std::max(center(dual.origin[at(h)]), center(dual.origin[at(t)]));
    const auto beside =
        std::max(center(dual.origin[at(Dual::previous(h))]), center(dual.origin[at(Dual::previous(t))]));
    ++ties.count;
    ties.areSettled = ties.areSettled && ends < beside;
  }
  return ties;
}

// A proof stays that of its dual.
TEST(SettleTies, LeaveTheProofOfTheDualThatTheyMake) {
  const std::uint64_t seed = test::seedOr(1);
  int changed = 0;
  test::forEachTie(seed, 60, [&](const Circles& circles, std::string_view kind) {
    SCOPED_TRACE(kind);
    const Circles visible = test::foundSites(order(validate(circles).value())).sites.circles;
    Predicates predicates(visible);
    Dual dual = insertAll(visible, predicates).value().dual;
    const Dual before = dual;
    Verdict verdict = judge(visible, dual, predicates);
    if (!verdict.isRight()) return;
    settleTies(dual, verdict, visible, predicates);
    const Verdict own = judge(visible, dual, predicates);
    EXPECT_TRUE(own.isRight());
    EXPECT_EQ(verdict.proof.discs, own.proof.discs);
    EXPECT_EQ(verdict.proof.halfEdges, own.proof.halfEdges);
    changed += dual.origin != before.origin;
  });
  EXPECT_GT(changed, 5);
}

TEST(SettleTies, TheDiagramDoesNotDependOnTheMethod) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int flips = 0;
  int touchingDiscs = 0;
  for (const test::TieKind& kind : test::tieKinds()) {
    for (int trial = 0; trial < 60; ++trial) {
      const Circles circles = withoutTwins(kind.make(4 + random.below(60), random));
      const Diagram diagram = visible(compute(circles).value());
      for (const Method method : {Method::flip, Method::touchingDisc}) {
        Options options;
        options.method = method;
        const Diagram other = visible(compute(circles, options).value());
        if (!other.certificate.certified()) continue;
        ++(method == Method::flip ? flips : touchingDiscs);
        ASSERT_EQ(test::difference(other, diagram), "") << kind.name << '\n' << test::describe(circles);
      }
    }
  }
  EXPECT_GT(flips, 200);
  EXPECT_GT(touchingDiscs, 100);
}

TEST(SettleTies, PartOfTheCirclesThatTouchADiscHasPartOfItsFaces) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int kept = 0;
  for (const test::TieKind& kind : test::tieKinds()) {
    for (int trial = 0; trial < 60; ++trial) {
      Circles circles = kind.make(5 + random.below(30), random);
      const auto hidden = compute(circles).value().hidden;
      for (std::size_t k = hidden.size(); k > 0; --k) circles.erase(circles.begin() + hidden[k - 1].circle);
      const Diagram diagram = compute(circles).value();
      // One circle leaves; the faces that did not have it stay.
      const auto leaving = static_cast<std::int32_t>(random.below(circles.size()));
      Circles fewer = circles;
      fewer.erase(fewer.begin() + leaving);
      const Diagram rest = compute(fewer).value();
      std::set<std::array<CircleIndex, 3>> triples;
      const auto fromLeast = [](std::array<CircleIndex, 3> triple) {
        std::rotate(triple.begin(), std::ranges::min_element(triple), triple.end());
        return triple;
      };
      for (auto triple : rest.vertexCircles) {
        for (CircleIndex& i : triple) i = i + (i >= leaving ? 1 : 0);
        triples.insert(fromLeast(triple));
      }
      for (const auto& triple : diagram.vertexCircles) {
        if (std::ranges::count(triple, leaving) > 0) continue;
        ++kept;
        ASSERT_TRUE(triples.contains(fromLeast(triple))) << kind.name << '\n' << test::describe(circles);
      }
    }
  }
  EXPECT_GT(kept, 1000);
}

TEST(SettleTies, ThousandsOfCirclesMayTouchOneDisc) {
  // Circles through the origin with their centers at (m m - n n, 2 m n), which is m m + n n away.
  Circles circles;
  for (int m = 1; m <= 60; ++m) {
    for (int n = 1; n < m; ++n) {
      if (std::gcd(m, n) > 1) continue;
      const double x = m * m - n * n;
      const double y = 2 * m * n;
      const double r = m * m + n * n;
      circles.push_back({x, y, r});
      circles.push_back({-y, x, r});
      circles.push_back({-x, -y, r});
      circles.push_back({y, -x, r});
    }
  }
  circles = withoutTwins(circles);
  std::set<std::pair<double, double>> directions;
  std::erase_if(circles, [&](const Circle& c) { return !directions.insert({c.x / c.r, c.y / c.r}).second; });
  const Diagram diagram = compute(circles).value();
  const Ties ties = tiesOf(circles, diagram);
  EXPECT_GT(ties.count, 2000);
  EXPECT_TRUE(ties.areSettled);
}

}  // namespace
}  // namespace circle_voronoi
