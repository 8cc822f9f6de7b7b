// SPDX-License-Identifier: GPL-3.0-or-later
// The judge judged: right diagrams are certified, and no corrupted one is unless it is still right (a tie). For each
// kind of corruption the named flaw is an expected one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "compare.h"
#include "dual_edits.h"
#include "report.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

using CircleSpan = std::span<const Circle>;

template <class Item>
Item& pick(std::vector<Item>& items, Random& random) {
  return items[random.below(items.size())];
}

std::int32_t anyCircle(CircleSpan circles, Random& random) {
  return static_cast<std::int32_t>(random.below(circles.size()));
}

// Each corrupts a diagram; false: there is nothing in it that could be corrupted this way.

bool flipEdges(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.edges.empty()) return false;
  Dual dual = test::dualOf(diagram, circles.size());
  if (test::flipRandomEdges(dual, 1 + static_cast<int>(random.below(6)), random) == 0) return false;
  test::replaceTopology(diagram, dual, circles);
  return true;
}

bool replaceCircleOfVertex(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.vertices.empty()) return false;
  CircleIndex& index = pick(diagram.vertexCircles, random)[random.below(3)];
  const std::int32_t other = anyCircle(circles, random);
  return other != std::exchange(index, other);
}

bool turnTripleRound(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.vertices.empty()) return false;
  const std::size_t vertex = random.below(diagram.vertices.size());
  auto& [i, j, k] = diagram.vertexCircles[vertex];
  std::swap(j, k);
  diagram.vertices[vertex] = vertexOf(circles[i], circles[j], circles[k]).value_or(Vertex{});
  return true;
}

bool indexOutOfRange(Diagram& diagram, CircleSpan circles, Random& random) {
  const std::int32_t index = random.below(2) == 0 ? -7 : static_cast<std::int32_t>(circles.size());
  std::vector<CircleIndex*> all;
  for (auto& triple : diagram.vertexCircles) {
    for (CircleIndex& i : triple) all.push_back(&i);
  }
  for (Edge& edge : diagram.edges) all.insert(all.end(), {&edge.left, &edge.right});
  for (HiddenCircle& hidden : diagram.hidden) all.insert(all.end(), {&hidden.circle, &hidden.by});
  for (CircleIndex& i : diagram.hull) all.push_back(&i);
  *pick(all, random) = index;
  return true;
}

bool vertexOutOfRange(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  Edge& edge = pick(diagram.edges, random);
  (random.below(2) == 0 ? edge.start : edge.end) = static_cast<std::int32_t>(diagram.vertices.size());
  return true;
}

bool forgetHidden(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.hidden.empty()) return false;
  diagram.hidden.erase(diagram.hidden.begin() + static_cast<std::ptrdiff_t>(random.below(diagram.hidden.size())));
  return true;
}

bool hideTwice(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.hidden.empty()) return false;
  diagram.hidden.push_back(pick(diagram.hidden, random));
  return true;
}

bool replaceHider(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.hidden.empty()) return false;
  HiddenCircle& hidden = pick(diagram.hidden, random);
  const std::int32_t other = anyCircle(circles, random);
  return other != hidden.circle && other != std::exchange(hidden.by, other);
}

bool hideVisible(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  const Edge& edge = pick(diagram.edges, random);
  diagram.hidden.push_back({edge.left, edge.right});
  return true;
}

/// Takes a hidden circle from the list and gives it a cell between others.
bool showHidden(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.hidden.empty() || diagram.edges.empty()) return false;
  const std::size_t place = random.below(diagram.hidden.size());
  const auto [circle, by] = diagram.hidden[place];
  diagram.hidden.erase(diagram.hidden.begin() + static_cast<std::ptrdiff_t>(place));
  Dual dual = test::dualOf(diagram, circles.size());
  // At random, or where it is most credible: next to its hider.
  std::vector<int> places;
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    if (random.below(2) == 0 || dual.origin[h] == by) places.push_back(h);
  }
  const int h = places.empty() ? 0 : pick(places, random);
  if (random.below(2) == 0) {
    test::insertInFace(dual, h / 3, circle);
  } else {
    test::insertOnEdge(dual, h, circle);
  }
  test::replaceTopology(diagram, dual, circles);
  return true;
}

bool duplicateVertex(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.vertices.empty()) return false;
  const std::size_t vertex = random.below(diagram.vertices.size());
  diagram.vertices.push_back(Vertex(diagram.vertices[vertex]));
  diagram.vertexCircles.push_back(std::array(diagram.vertexCircles[vertex]));
  return true;
}

bool dropVertex(Diagram& diagram, CircleSpan, Random&) {
  if (diagram.vertices.empty()) return false;
  diagram.vertices.pop_back();
  return true;
}

bool crossEdges(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.size() < 2) return false;
  VertexIndex& i = pick(diagram.edges, random).end;
  VertexIndex& j = pick(diagram.edges, random).end;
  if (i == j) return false;
  std::swap(i, j);
  return true;
}

bool dropEdge(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  diagram.edges.erase(diagram.edges.begin() + static_cast<std::ptrdiff_t>(random.below(diagram.edges.size())));
  return true;
}

bool repeatEdge(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  diagram.edges.push_back(Edge(pick(diagram.edges, random)));
  return true;
}

bool swapEnds(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  Edge& edge = pick(diagram.edges, random);
  std::swap(edge.start, edge.end);
  return edge.start != edge.end;
}

bool swapSides(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  Edge& edge = pick(diagram.edges, random);
  std::swap(edge.left, edge.right);
  return edge.start != edge.end;
}

bool reverseHull(Diagram& diagram, CircleSpan, Random&) {
  if (diagram.hull.size() < 3) return false;
  std::ranges::reverse(diagram.hull);
  return true;
}

bool dropFromHull(Diagram& diagram, CircleSpan, Random& random) {
  diagram.hull.erase(diagram.hull.begin() + static_cast<std::ptrdiff_t>(random.below(diagram.hull.size())));
  return true;
}

bool swapInHull(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.hull.size() < 3) return false;
  std::swap(pick(diagram.hull, random), pick(diagram.hull, random));
  return true;
}

/// If a circle is on the hull three times, swaps the parts of the hull between its visits. The steps of the hull do not
/// change.
bool swapLoopsOfHull(Diagram& diagram, CircleSpan, Random&) {
  std::map<std::int32_t, std::vector<std::ptrdiff_t>> visits;
  for (std::size_t i = 0; i < diagram.hull.size(); ++i)
    visits[diagram.hull[i]].push_back(static_cast<std::ptrdiff_t>(i));
  for (const auto& [circle, places] : visits) {
    if (places.size() < 3) continue;
    const auto begin = diagram.hull.begin();
    std::rotate(begin + places[0], begin + places[1], begin + places[2]);
    return true;
  }
  return false;
}

bool moveVertex(Diagram& diagram, CircleSpan circles, Random& random) {
  if (diagram.vertices.empty()) return false;
  const std::size_t vertex = random.below(diagram.vertices.size());
  Vertex& v = diagram.vertices[vertex];
  const Circle& c = circles[diagram.vertexCircles[vertex][0]];
  const double reach = length({v.x - c.x, v.y - c.y}) + std::abs(c.x) + std::abs(c.y) + c.r;
  const Vector direction = random.direction();
  v.x += 1e-6 * reach * direction.x;
  v.y += 1e-6 * reach * direction.y;
  return true;
}

bool changeRadius(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.vertices.empty()) return false;
  Vertex& v = pick(diagram.vertices, random);
  v.r = v.r == 0 ? 1 : -v.r;
  return true;
}

/// The disc that touches the same circles clockwise.
bool moveVertexToOtherDisc(Diagram& diagram, CircleSpan circles, Random& random) {
  std::vector<std::pair<std::size_t, Vertex>> others;
  for (std::size_t vertex = 0; vertex < diagram.vertices.size(); ++vertex) {
    const auto& [i, j, k] = diagram.vertexCircles[vertex];
    if (const auto disc = threeTouchDisc(circles[i], circles[k], circles[j])) others.push_back({vertex, disc->disc});
  }
  if (others.empty()) return false;
  const auto& [vertex, disc] = pick(others, random);
  diagram.vertices[vertex] = disc;
  return true;
}

bool makeVertexInfinite(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.vertices.empty()) return false;
  Vertex& v = pick(diagram.vertices, random);
  double* const numbers[] = {&v.x, &v.y, &v.r};
  constexpr double kWrong[] = {NAN, HUGE_VAL, -HUGE_VAL};
  *numbers[random.below(3)] = kWrong[random.below(3)];
  return true;
}

bool exchangeNextSides(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  SideIndex& i = pick(diagram.links.nextSide, random);
  SideIndex& j = pick(diagram.links.nextSide, random);
  if (i == j) return false;
  std::swap(i, j);
  return true;
}

bool turnSidesOfVertex(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.vertices.empty()) return false;
  auto& sides = pick(diagram.links.vertexSides, random);
  std::rotate(sides.begin(), sides.begin() + 1, sides.end());
  return true;
}

bool replaceFirstSide(Diagram& diagram, CircleSpan, Random& random) {
  if (diagram.edges.empty()) return false;
  SideIndex& first = pick(diagram.links.firstSide, random);
  const SideIndex other = static_cast<std::int32_t>(random.below(2 * diagram.edges.size()));
  return other != std::exchange(first, other);
}

bool forgetSides(Diagram& diagram, CircleSpan, Random&) {
  if (diagram.edges.empty()) return false;
  diagram.links.nextSide.clear();
  diagram.links.vertexSides.clear();
  diagram.links.firstSide.clear();
  return true;
}

struct Corruption {
  std::string_view name;
  bool (*apply)(Diagram&, CircleSpan, Random&);
  std::set<Flaw> expected;
  bool isOfSides = false;  ///< of how they are linked; after others they are linked anew, as far as they can be
};

const std::vector<Corruption> kCorruptions = {
    {"edges flipped",
     flipEdges,
     {Flaw::vertexWithoutDisc, Flaw::edgeOutOfOrder, Flaw::cellNotClosed, Flaw::hullNotClosed}},
    {"circle of a vertex replaced", replaceCircleOfVertex, {Flaw::badIndex, Flaw::adjacency}},
    {"vertex turned round", turnTripleRound, {Flaw::adjacency}},
    {"circle out of range", indexOutOfRange, {Flaw::badIndex}},
    {"end of an edge out of range", vertexOutOfRange, {Flaw::adjacency}},
    {"hidden circle forgotten", forgetHidden, {Flaw::eulerCount}},
    {"hidden circle listed twice", hideTwice, {Flaw::badIndex}},
    {"other hider", replaceHider, {Flaw::hiddenWithoutHider}},
    {"visible circle hidden", hideVisible, {Flaw::hiddenWithoutHider}},
    {"cell for a hidden circle", showHidden, {Flaw::cellNotClosed, Flaw::vertexWithoutDisc, Flaw::edgeOutOfOrder}},
    {"vertex twice", duplicateVertex, {Flaw::adjacency}},
    {"vertex without place", dropVertex, {Flaw::vertexMisplaced}},
    {"ends of two edges exchanged", crossEdges, {Flaw::adjacency, Flaw::edgeOutOfOrder, Flaw::cellNotClosed}},
    {"edge dropped", dropEdge, {Flaw::adjacency}},
    {"edge twice", repeatEdge, {Flaw::adjacency}},
    {"ends of an edge swapped", swapEnds, {Flaw::adjacency}},
    {"sides of an edge swapped", swapSides, {Flaw::adjacency}},
    {"hull reversed", reverseHull, {Flaw::adjacency, Flaw::cellNotClosed}},
    {"circle dropped from the hull", dropFromHull, {Flaw::adjacency, Flaw::badIndex, Flaw::eulerCount}},
    {"circles of the hull swapped", swapInHull, {Flaw::adjacency, Flaw::badIndex, Flaw::cellNotClosed}},
    {"loops of the hull swapped", swapLoopsOfHull, {Flaw::cellNotClosed}},
    {"vertex moved", moveVertex, {Flaw::vertexMisplaced}},
    {"radius of a vertex changed", changeRadius, {Flaw::vertexMisplaced}},
    {"clockwise disc", moveVertexToOtherDisc, {Flaw::vertexMisplaced}},
    {"vertex at infinity", makeVertexInfinite, {Flaw::vertexMisplaced}},
    {"next sides exchanged", exchangeNextSides, {Flaw::adjacency}, true},
    {"sides of a vertex turned", turnSidesOfVertex, {Flaw::adjacency}, true},
    {"other first side", replaceFirstSide, {Flaw::adjacency}, true},
    {"sides not linked", forgetSides, {Flaw::adjacency}, true},
};

/// The outcome of one kind of corruption.
struct Outcome {
  int refused = 0;
  int stillRight = 0;
  std::map<Flaw, int> flaws;
};

std::string whatIsWrong(const Diagram& diagram, const Diagram& right, CircleSpan circles, bool isDegenerate) {
  std::string problem = test::structureProblem(diagram, circles.size());
  if (!problem.empty()) return problem;
  return isDegenerate ? test::differenceAfterMerging(diagram, right, circles) : test::difference(diagram, right);
}

void print(const std::vector<Outcome>& outcomes) {
  int total = 0;
  for (std::size_t kind = 0; kind < outcomes.size(); ++kind) {
    const auto& [refused, stillRight, flaws] = outcomes[kind];
    std::cout << std::setw(32) << kCorruptions[kind].name << ": " << refused << " refused, " << stillRight
              << " still right;";
    for (const auto& [flaw, count] : flaws) std::cout << ' ' << flawName(flaw) << ' ' << count;
    std::cout << '\n';
    total += refused + stillRight;
  }
  std::cout << total << " corrupted diagrams\n";
}

TEST(CertificateMutation, AcceptsNoDiagramThatDiffers) {
  const std::uint64_t seed = test::seedOr(1);
  std::vector<Outcome> outcomes(kCorruptions.size());
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 300; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const auto circles = generate(family.family, 2 + random.below(30), random.next());
      const auto right = compute(circles);
      ASSERT_TRUE(right.ok()) << right.error().message << test::describe(circles);
      ASSERT_TRUE(certify(right.value()).value().certified()) << test::describe(circles);
      for (std::size_t kind = 0; kind < kCorruptions.size(); ++kind) {
        const Corruption& corruption = kCorruptions[kind];
        Diagram diagram = right.value();
        if (!corruption.apply(diagram, circles, random)) continue;
        if (!corruption.isOfSides) linkSides(diagram);
        const auto certificate = certify(diagram);
        ASSERT_TRUE(certificate.ok());
        const Flaw flaw = certificate.value().flaw;
        const auto about = [&] {
          return std::string(corruption.name) + ", " + std::string(family.name) + ", trial " + std::to_string(trial) +
                 ": " + std::string(flawName(flaw)) + test::describe(circles);
        };
        ++outcomes[kind].flaws[flaw];
        if (flaw == Flaw::none) {
          ++outcomes[kind].stillRight;
          EXPECT_EQ(whatIsWrong(diagram, right.value(), circles, family.isDegenerate), "") << about();
        } else {
          ++outcomes[kind].refused;
          EXPECT_TRUE(corruption.expected.contains(flaw)) << about();
          EXPECT_NE(certificate.value().message, "") << about();
        }
      }
    }
  }
  print(outcomes);
  for (std::size_t kind = 0; kind < outcomes.size(); ++kind)
    EXPECT_GT(outcomes[kind].refused, 0) << kCorruptions[kind].name;
}

}  // namespace
}  // namespace circle_voronoi
