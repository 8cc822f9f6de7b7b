// SPDX-License-Identifier: GPL-3.0-or-later
// Power diagrams, compared with CGAL's regular triangulation in exact numbers, and their judge on diagrams that were
// made wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/region.h"
#include "oracle.h"
#include "random.h"
#include "report.h"
#include "rounded.h"
#include "tie_inputs.h"

namespace circle_voronoi::power_test {
namespace {

using Number = boost::multiprecision::cpp_rational;
using ExactPoint = std::pair<Number, Number>;

Options powerOptions(bool weights = false) {
  Options options;
  options.metric = Metric::power;
  options.weights = weights;
  return options;
}

Number weightOf(const Circle& c, bool weights) { return weights ? Number(c.r) : Number(c.r) * Number(c.r); }

/// The point of equal power to three circles.
ExactPoint centerOf(const Circle& a, const Circle& b, const Circle& c, bool weights) {
  const Number ux = Number(b.x) - Number(a.x);
  const Number uy = Number(b.y) - Number(a.y);
  const Number vx = Number(c.x) - Number(a.x);
  const Number vy = Number(c.y) - Number(a.y);
  const Number ku = (ux * ux + uy * uy + weightOf(a, weights) - weightOf(b, weights)) / 2;
  const Number kv = (vx * vx + vy * vy + weightOf(a, weights) - weightOf(c, weights)) / 2;
  const Number determinant = ux * vy - uy * vx;
  return {Number(a.x) + (ku * vy - kv * uy) / determinant, Number(a.y) + (kv * ux - ku * vx) / determinant};
}

/// The vertices of a power diagram as places, whatever way a face with many corners is divided.
template <class Triples>
std::set<ExactPoint> placesOf(const Triples& triples, const std::vector<Circle>& circles, bool weights) {
  std::set<ExactPoint> places;
  for (const auto& [i, j, k] : triples) {
    places.insert(centerOf(circles[at(i)], circles[at(j)], circles[at(k)], weights));
  }
  return places;
}

struct Input {
  std::string name;
  std::vector<Circle> circles;
  bool weights = false;
};

std::vector<Circle> roundedAll(std::vector<Circle> circles) {
  for (Circle& c : circles) c = rounded(c);
  return circles;
}

/// Families of ties, and of circles that are far apart in place or size.
void forEachInput(const std::function<void(const Input&)>& use) {
  test::forEachTie(test::seedOr(1), 30, [&](const std::vector<Circle>& circles, std::string_view kind) {
    use({std::string(kind), roundedAll(circles), false});
    std::vector<Circle> weighted = circles;
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i].r *= i % 3 == 0 ? -1 : 1;
    use({std::string(kind) + ", weights of any sign", roundedAll(weighted), true});
  });
  Random random(test::seedOr(1));
  for (int trial = 0; trial < 40; ++trial) {
    const double size = std::ldexp(1.0, trial % 8);
    std::vector<Circle> circles;
    for (int i = 0; i < 12; ++i) {
      const auto x = static_cast<double>(i % 4);
      const auto y = static_cast<double>(i / 4);
      circles.push_back({x, y, size * random.unit()});
    }
    use({"a grid with radii", circles, false});
    for (Circle& c : circles) c.r = 2;
    use({"a grid of equal circles", circles, false});
    // Weights that lift all sites into one plane, but for one that is just above or below.
    for (Circle& c : circles) c.r = c.x * c.x + c.y * c.y - 3 * c.x + 2 * c.y;
    use({"in one plane", circles, true});
    circles[5].r += std::ldexp(trial % 2 == 0 ? 1.0 : -1.0, -40);
    use({"one beside a plane", circles, true});
  }
  use({"none", {}, false});
  use({"one", {{1, 2, 3}}, false});
  use({"two", {{1, 2, 3}, {5, 2, 1}}, false});
  use({"of one center", {{1, 2, 3}, {1, 2, 3}, {1, 2, 4}, {1, 2, 1}}, false});
  use({"collinear, one hidden by both neighbors", {{0, 0, 3}, {2, 0, 0.1}, {4, 0, 3}, {9, 0, 1}, {2, 0, 0.05}}, false});
  use({"hidden by several", {{0, 0, 2}, {3, 0, 2}, {1.5, 2, 2}, {1.5, 0.8, 0.5}, {1.5, 0.8, 0.25}}, false});
  use({"a center outside its cell", {{0, 0, 5}, {1, 0, 5.5}, {-4, 0, 0}, {0, 9, 1}, {0, -9, 1}}, false});
  use({"large weights", {{0, 0, 1e50}, {1, 0, 1e50}, {0, 1, -1e50}, {3, 3, 0}}, true});
  use({"tiny weights", {{0, 0, 1e-40}, {1e-15, 0, 0}, {0, 1e-15, -1e-40}, {1e-15, 1e-15, 1e-50}}, true});
}

TEST(PowerDiagram, IsRight) {
  forEachInput([](const Input& input) {
    SCOPED_TRACE(input.name + test::describe(input.circles));
    const auto diagram = compute(input.circles, powerOptions(input.weights));
    ASSERT_TRUE(diagram) << diagram.error().message;
    EXPECT_TRUE(diagram->certificate.certified());
    EXPECT_EQ(certify(*diagram).value().message, "");
    const auto faces = oracle::regularFaces(input.circles, input.weights);
    EXPECT_EQ(placesOf(diagram->vertexCircles, input.circles, input.weights),
              placesOf(faces, input.circles, input.weights));
    for (std::size_t v = 0; v < diagram->vertices.size(); ++v) {
      const auto& [i, j, k] = diagram->vertexCircles[v];
      const auto [x, y] = centerOf(input.circles[at(i)], input.circles[at(j)], input.circles[at(k)], input.weights);
      const Vertex& vertex = diagram->vertices[v];
      const Circle& c = input.circles[at(i)];
      const Number reach =
          abs(x - Number(c.x)) + abs(y - Number(c.y)) + abs(x) * Number(0x1p-10) + abs(y) * Number(0x1p-10);
      EXPECT_LE(abs(Number(vertex.x) - x) + abs(Number(vertex.y) - y), reach * Number(0x1p-36));
      const Number dx = x - Number(c.x);
      const Number dy = y - Number(c.y);
      const Number power = dx * dx + dy * dy - weightOf(c, input.weights);
      EXPECT_LE(abs(Number(vertex.r) * abs(Number(vertex.r)) - power), abs(power) * Number(0x1p-36));
    }
    if (testing::Test::HasFailure()) GTEST_FAIL();
  });
}

TEST(PowerDiagram, IsTheSameInAnyOrder) {
  forEachInput([](const Input& input) {
    SCOPED_TRACE(input.name + test::describe(input.circles));
    Random random(7);
    std::vector<int> order;
    for (std::size_t i = 0; i < input.circles.size(); ++i) order.push_back(static_cast<int>(i));
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    std::vector<Circle> circles;
    for (const int i : order) circles.push_back(input.circles[at(i)]);
    const auto first = compute(input.circles, powerOptions(input.weights));
    const auto second = compute(circles, powerOptions(input.weights));
    ASSERT_TRUE(first && second);
    ASSERT_EQ(first->vertices.size(), second->vertices.size());
    for (std::size_t v = 0; v < first->vertices.size(); ++v) {
      EXPECT_TRUE(first->vertices[v] == second->vertices[v]);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(std::ranges::any_of(second->vertexCircles[v], [&](CircleIndex i) {
          return circles[at(i)] == input.circles[at(first->vertexCircles[v][k])];
        }));
      }
    }
    EXPECT_EQ(first->hidden.size(), second->hidden.size());
  });
}

TEST(PowerDiagram, WithWeightsIsThatOfRadiiWhoseSquaresTheyAre) {
  test::forEachTie(test::seedOr(1), 50, [](const std::vector<Circle>& circles, std::string_view) {
    std::vector<Circle> weighted = test::onDyadicGrid(circles);
    const std::vector<Circle> given = weighted;
    for (Circle& c : weighted) c.r = c.r * c.r - 5;
    const Diagram first = compute(given, powerOptions()).value();
    const Diagram second = compute(weighted, powerOptions(true)).value();
    EXPECT_EQ(first.edges, second.edges);
    EXPECT_EQ(first.vertexCircles, second.vertexCircles);
    EXPECT_EQ(first.hidden, second.hidden);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto index = static_cast<std::int32_t>(i);
      if (!first.hasCell(index)) continue;
      for (const CircleIndex j : neighbors(first, index)) {
        const Point p = {0.3 * given[i].x + 0.7 * given[at(j)].y, given[i].y};
        const double size = 1 + std::abs(distanceFrom(first, index, p));
        EXPECT_NEAR(distanceFrom(second, index, p) - 5, distanceFrom(first, index, p), 1e-9 * size);
        EXPECT_EQ(distanceDifference(first, index, j, p) > 0, distanceDifference(second, index, j, p) > 0);
      }
    }
  });
}

// Weights are areas: they have more digits behind the point than lengths.
TEST(PowerDiagram, OfWeightsIsCutToRegionsAtAnyScale) {
  const std::vector<Circle> circles = {
      {0.125, 0.25, 0.0625}, {0.75, 0.3125, 0.015625}, {0.375, 0.875, 0.03125}, {0.8125, 0.8125, -0.015625}};
  std::vector<double> expected;
  for (int exponent = 0; exponent >= -50; exponent -= 10) {
    const double size = std::ldexp(1.0, exponent);
    std::vector<Circle> scaled;
    for (const Circle& c : circles) scaled.push_back({c.x * size, c.y * size, c.r * size * size});
    const Diagram diagram = compute(scaled, powerOptions(true)).value();
    const Region square = Region::from(Box{0, 0, size, size}).value();
    std::vector<double> areas = ClippedDiagram::from(diagram, square).value().areas();
    for (double& area : areas) area /= size * size;
    if (expected.empty()) expected = areas;
    EXPECT_EQ(areas, expected) << exponent;
  }
}

TEST(PowerDiagram, IsRefusedWithTheCircle) {
  const auto errorOf = [](const std::vector<Circle>& circles, const Options& options) {
    const auto diagram = compute(circles, options);
    return diagram ? std::pair(ErrorCode::internal, std::int64_t{-2})
                   : std::pair(diagram.error().code, diagram.error().circle);
  };
  EXPECT_EQ(errorOf({{0, 0, 1}, {1, 0, -1}}, powerOptions()), std::pair(ErrorCode::negativeRadius, std::int64_t{1}));
  EXPECT_EQ(errorOf({{0, 0, NAN}}, powerOptions(true)), std::pair(ErrorCode::nonFinite, std::int64_t{0}));
  EXPECT_EQ(errorOf({{0, 0, 0}, {1, 0, -1e58}}, powerOptions(true)),
            std::pair(ErrorCode::coordinateTooLarge, std::int64_t{1}));
  EXPECT_EQ(errorOf({{0, 0, 0}, {1e-20, 0, 1e-40}}, powerOptions(true)),
            std::pair(ErrorCode::coordinateTooSmall, std::int64_t{kNone}));
  Options options = powerOptions();
  options.method = Method::touchingDisc;
  EXPECT_EQ(errorOf({}, options).first, ErrorCode::badOption);
  options = powerOptions();
  options.observer = [](const TraceEvent&) {};
  EXPECT_EQ(errorOf({}, options).first, ErrorCode::badOption);
}

/// A change that makes a diagram wrong.
struct Corruption {
  const char* name;
  void (*apply)(Diagram& diagram, Random& random);
};

template <class List>
auto& anyOf(List& list, Random& random) {
  return list[random.below(list.size())];
}

constexpr Corruption kCorruptions[] = {
    {"two circles of a vertex change places",
     [](Diagram& d, Random& random) {
       auto& triple = anyOf(d.vertexCircles, random);
       std::swap(triple[0], triple[1]);
     }},
    {"a vertex moves", [](Diagram& d, Random& random) { anyOf(d.vertices, random).x += 0.1; }},
    {"a vertex has another radius", [](Diagram& d, Random& random) { anyOf(d.vertices, random).r *= 1.001; }},
    {"an edge has another circle",
     [](Diagram& d, Random& random) {
       Edge& edge = anyOf(d.edges, random);
       edge.left = (edge.left + 1) % static_cast<std::int32_t>(d.circles.size());
     }},
    {"an edge is turned around",
     [](Diagram& d, Random& random) {
       Edge& edge = anyOf(d.edges, random);
       std::swap(edge.start, edge.end);
     }},
    {"a circle of the hull is missing",
     [](Diagram& d, Random& random) {
       d.hull.erase(d.hull.begin() + static_cast<std::ptrdiff_t>(random.below(d.hull.size())));
     }},
    {"a hidden circle is missing", [](Diagram& d, Random&) { d.hidden.pop_back(); }},
    {"a visible circle is hidden, too",
     [](Diagram& d, Random& random) {
       const CircleIndex visible = d.hull[random.below(d.hull.size())];
       d.hidden.push_back({visible, d.hull[0] == visible ? d.hull[1] : d.hull[0]});
     }},
    {"a hidden circle is hidden by itself",
     [](Diagram& d, Random& random) {
       HiddenCircle& hidden = anyOf(d.hidden, random);
       hidden.by = hidden.circle;
     }},
    {"a hidden circle does not exist", [](Diagram& d, Random& random) { anyOf(d.hidden, random).circle = kNone; }},
    {"a hider does not exist", [](Diagram& d, Random& random) { anyOf(d.hidden, random).by = 1000; }},
    {"a hidden circle grows out",
     [](Diagram& d, Random& random) { d.circles[at(anyOf(d.hidden, random).circle)].r = 40; }},
    {"a visible circle shrinks and is hidden",
     [](Diagram& d, Random& random) {
       const Edge& edge = anyOf(d.edges, random);
       d.circles[at(edge.left)].r += 30;
     }},
    {"a link is wrong", [](Diagram& d, Random& random) { anyOf(d.links.nextSide, random) = 0; }},
};

TEST(PowerDiagram, IsNotCertifiedOnceItIsWrong) {
  Random random(test::seedOr(3));
  for (const Corruption& corruption : kCorruptions) {
    for (int trial = 0; trial < 40; ++trial) {
      std::vector<Circle> circles;
      for (int i = 0; i < 40; ++i) {
        circles.push_back({random.uniform(0, 100), random.uniform(0, 100), random.uniform(0, 12)});
      }
      circles.push_back({circles[0].x, circles[0].y, circles[0].r / 2});
      Diagram diagram = compute(circles, powerOptions()).value();
      ASSERT_TRUE(certify(diagram).value().certified());
      const Links links = diagram.links;
      corruption.apply(diagram, random);
      if (diagram.links == links && corruption.name == std::string_view("a link is wrong")) continue;
      EXPECT_FALSE(certify(diagram).value().certified()) << corruption.name << test::describe(circles);
    }
  }
}

// Each edge that two triangles share is exchanged for the other diagonal of their corners, in a diagram whose vertices
// and links are right for this.
TEST(PowerDiagram, WithAnotherDiagonalIsNotCertified) {
  Random random(test::seedOr(4));
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Circle> circles;
    for (int i = 0; i < 4; ++i) {
      const double angle = 1.5 * i + random.unit();
      circles.push_back({10 * std::cos(angle), 10 * std::sin(angle), random.uniform(0, 4)});
    }
    const Diagram right = compute(circles, powerOptions()).value();
    if (right.vertices.size() != 2 || right.hull.size() != 4) continue;
    // Weights for which the other diagonal is right, and the circles of before.
    std::vector<Circle> others = circles;
    Diagram other;
    for (int tries = 0; tries < 100; ++tries) {
      for (Circle& c : others) c.r = random.uniform(0, 4);
      other = compute(others, powerOptions()).value();
      if (other.vertices.size() == 2 && other.hull.size() == 4 && other.vertexCircles[0] != right.vertexCircles[0] &&
          other.vertexCircles[0] != right.vertexCircles[1]) {
        break;
      }
    }
    other.circles = circles;
    const auto certificate = certify(other).value();
    EXPECT_FALSE(certificate.certified());
    EXPECT_EQ(certificate.flaw, Flaw::edgeOutOfOrder);
  }
}

}  // namespace
}  // namespace circle_voronoi::power_test
