// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are called final stay, whatever lies outside.
#include "circle_voronoi/final_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;
using Triple = std::array<CircleIndex, 3>;
using Bits = std::array<std::uint64_t, 3>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Box kPlane = {-kInfinite, -kInfinite, kInfinite, kInfinite};

double inside(const Box& box, double x, double y) {
  return std::min({x - box.minX, box.maxX - x, y - box.minY, box.maxY - y});
}

/// Whether a circle may lie outside.
bool mayBeOutside(const MissingCircles& known, const Circle& c) {
  return inside(known.box, c.x, c.y) + c.r <= known.maxRadius;
}

/// A set of circles divided into known ones and others.
struct Split {
  Circles known;
  std::vector<std::int32_t> ids;  ///< of the known ones their indices in the set
  std::vector<std::int32_t> outside;
};

Split split(const Circles& circles, const MissingCircles& known) {
  Split result;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (mayBeOutside(known, circles[i])) {
      result.outside.push_back(static_cast<std::int32_t>(i));
    } else {
      result.known.push_back(circles[i]);
      result.ids.push_back(static_cast<std::int32_t>(i));
    }
  }
  return result;
}

/// The parts of a diagram by ids, for comparison.
class Parts {
 public:
  Parts(const Diagram& diagram, const std::vector<std::int32_t>& ids) {
    const auto id = [&](CircleIndex i) { return i == kNone ? i : CircleIndex(ids[at(i)]); };
    const auto tripleOf = [&](std::int32_t v) {
      Triple triple = diagram.vertexCircles[at(v)];
      for (CircleIndex& i : triple) i = id(i);
      std::rotate(triple.begin(), std::ranges::min_element(triple), triple.end());
      return triple;
    };
    const auto endOf = [&](std::int32_t v) { return v == kNone ? Triple{kNone, kNone, kNone} : tripleOf(v); };
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(diagram.vertices.size()); ++v) {
      const auto& [x, y, radius] = diagram.vertices[at(v)];
      const Bits bits = {std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y),
                         std::bit_cast<std::uint64_t>(radius)};
      vertices_.push_back({tripleOf(v), bits});
    }
    for (const Edge& e : diagram.edges) {
      const std::int32_t left = id(e.left);
      const std::int32_t right = id(e.right);
      edges_.push_back(left < right ? Side{left, right, endOf(e.start), endOf(e.end)}
                                    : Side{right, left, endOf(e.end), endOf(e.start)});
      cells_[left].insert(edges_.back());
      cells_[right].insert(edges_.back());
    }
    allVertices_.insert(vertices_.begin(), vertices_.end());
    allEdges_.insert(edges_.begin(), edges_.end());
    for (const auto& [circle, by] : diagram.hidden) hiders_[id(circle)] = id(by);
  }

  /// Whether another diagram has a vertex, an edge or a cell of this, by its index here.
  bool hasVertex(const Parts& other, std::size_t v) const { return other.allVertices_.contains(vertices_[v]); }
  bool hasEdge(const Parts& other, std::size_t e) const { return other.allEdges_.contains(edges_[e]); }
  bool hasCell(const Parts& other, std::int32_t id) const {
    return find(cells_, id) == find(other.cells_, id) && find(hiders_, id) == find(other.hiders_, id);
  }

 private:
  using Side = std::tuple<std::int32_t, std::int32_t, Triple, Triple>;

  template <class Value>
  static Value find(const std::map<std::int32_t, Value>& map, std::int32_t id) {
    const auto found = map.find(id);
    return found == map.end() ? Value{} : found->second;
  }

  std::vector<std::pair<Triple, Bits>> vertices_;
  std::vector<Side> edges_;
  std::set<std::pair<Triple, Bits>> allVertices_;
  std::set<Side> allEdges_;
  std::map<std::int32_t, std::set<Side>> cells_;
  std::map<std::int32_t, std::int32_t> hiders_;
};

std::vector<std::int32_t> numbered(const Circles& circles) {
  std::vector<std::int32_t> ids(circles.size());
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

struct Extent {
  Circles circles;
  Point low;
  Point high;

  explicit Extent(Circles all) : circles(std::move(all)), low{kInfinite, kInfinite}, high{-kInfinite, -kInfinite} {
    for (const Circle& c : circles) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
  }

  double size() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// A box around a part of the circles: some sides at random, some so that the disc of a vertex, widened by the radius
/// of the circles outside, touches them but for next to nothing, and some infinitely far away.
MissingCircles randomMissing(const Extent& extent, Random& random, const Diagram* diagram = nullptr) {
  MissingCircles known;
  const auto& circles = extent.circles;
  known.maxRadius = random.below(2) == 0 ? 0 : circles[random.below(circles.size())].r;
  const double x = random.uniform(extent.low.x, extent.high.x);
  const double y = random.uniform(extent.low.y, extent.high.y);
  const double least = 1e-3 * (std::abs(x) + std::abs(y)) + 1e-290;
  const auto reach = [&] { return std::max(extent.size(), least) * random.uniform(0.05, 0.7); };
  known.box = {x - reach(), y - reach(), x + reach(), y + reach()};
  if (diagram != nullptr && !diagram->vertices.empty() && random.below(4) != 0) {
    static constexpr std::array kNudges = {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-9, -1e-9};
    const auto& [vx, vy, radius] = diagram->vertices[random.below(diagram->vertices.size())];
    const auto far = [&] { return (radius + known.maxRadius) * (1 + kNudges[random.below(kNudges.size())]); };
    Box touching = {vx - far(), vy - far(), vx + far(), vy + far()};
    if (random.below(2) == 0) touching.minX = known.box.minX;
    if (random.below(2) == 0) touching.minY = known.box.minY;
    if (random.below(2) == 0) touching.maxX = known.box.maxX;
    if (random.below(2) == 0) touching.maxY = known.box.maxY;
    if (touching.minX < touching.maxX && touching.minY < touching.maxY) known.box = touching;
  }
  for (double* side : {&known.box.minX, &known.box.minY}) {
    if (random.below(12) == 0) *side = -kInfinite;
  }
  for (double* side : {&known.box.maxX, &known.box.maxY}) {
    if (random.below(12) == 0) *side = kInfinite;
  }
  return known;
}

/// The circle outside that comes nearest to a point, going straight out across the nearest side.
std::optional<Circle> nearestOutside(const MissingCircles& known, Point p) {
  const Box& box = known.box;
  const double depth = inside(box, p.x, p.y);
  if (std::isinf(depth)) return std::nullopt;
  const double way = std::max(0.0, depth - known.maxRadius);
  Circle c = {p.x, p.y, std::max(0.0, known.maxRadius - (depth - way))};
  if (p.x - box.minX == depth) {
    c.x -= way;
  } else if (box.maxX - p.x == depth) {
    c.x += way;
  } else if (p.y - box.minY == depth) {
    c.y -= way;
  } else {
    c.y += way;
  }
  return std::max({std::abs(c.x), std::abs(c.y), c.r}) <= kCoordinateLimit ? std::optional(c) : std::nullopt;
}

Circles randomCircles(std::size_t trial, Random& random) {
  const std::size_t count = 3 + random.below(40);
  const std::size_t kinds = families().size() + test::tieKinds().size();
  const std::size_t kind = trial % kinds;
  if (kind < families().size()) return generate(families()[kind].family, count, random.next());
  return test::tieKinds()[kind - families().size()].make(count, random);
}

/// Whether the known part of a set of circles is an input: circles that are all small are none.
bool isInput(const Circles& all, const MissingCircles& known) {
  const auto diagram = compute(split(all, known).known);
  return diagram.ok() || diagram.error().code != ErrorCode::coordinateTooSmall;
}

/// A part of a set of circles with its diagram and what of that is final.
struct Part {
  MissingCircles known;
  Split circles;
  Diagram diagram;
  FinalCells cells;

  Part(const Circles& all, const MissingCircles& known_)
      : known(known_),
        circles(split(all, known)),
        diagram(compute(circles.known).value()),
        cells(finalCells(diagram, known).value()) {}
};

/// The first circle, vertex or edge that is called final and is not as in the whole; empty if there is none.
std::string wrong(const Part& part, const Parts& whole) {
  const auto& ids = part.circles.ids;
  const Parts parts(part.diagram, ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (part.cells.isFinal(static_cast<std::int32_t>(i)) && !parts.hasCell(whole, ids[i]))
      return "circle " + std::to_string(ids[i]);
  }
  for (std::size_t v = 0; v < part.diagram.vertices.size(); ++v) {
    if (part.cells.vertices[v] != 0 && !parts.hasVertex(whole, v)) return "vertex " + std::to_string(v);
  }
  for (std::size_t e = 0; e < part.diagram.edges.size(); ++e) {
    if (part.cells.edges[e] != 0 && !parts.hasEdge(whole, e)) return "edge " + std::to_string(e);
  }
  return "";
}

TEST(FinalCells, CirclesOutsideDoNotChangeFinalParts) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  std::int64_t finalCount = 0;
  std::int64_t openCount = 0;
  int refused = 0;
  for (std::size_t trial = 0; trial < 10'000; ++trial) {
    Circles circles = randomCircles(trial, random);
    const Diagram whole = compute(circles).value();
    const MissingCircles known = randomMissing(Extent(circles), random, &whole);
    if (!isInput(circles, known)) continue;
    // Beside the circles of the family that are outside, some at the places that are worst for a vertex.
    const Part before(circles, known);
    for (int k = 0; k < 6 && !before.diagram.vertices.empty(); ++k) {
      const Vertex& v = before.diagram.vertices[random.below(before.diagram.vertices.size())];
      auto c = nearestOutside(known, {v.x, v.y});
      if (!c) continue;
      c->r *= 1 - std::array{0.0, 1e-16, 1e-12, 0.1}[random.below(4)];
      const auto place = circles.begin() + static_cast<std::ptrdiff_t>(random.below(circles.size() + 1));
      if (mayBeOutside(known, *c)) circles.insert(place, *c);
    }
    const auto after = compute(circles);
    if (!after) {
      ASSERT_EQ(after.error().code, ErrorCode::coordinateTooLarge) << after.error().message;
      ++refused;
      continue;
    }
    const Part part(circles, known);
    const std::string problem = wrong(part, Parts(after.value(), numbered(circles)));
    ASSERT_EQ(problem, "") << "trial " << trial << '\n' << test::describe(circles);
    for (const double halo : part.cells.neededHalo) ++(halo == 0 ? finalCount : openCount);
  }
  std::printf("%lld cells final, %lld not\n", static_cast<long long>(finalCount), static_cast<long long>(openCount));
  EXPECT_GT(finalCount, 20'000);
  EXPECT_GT(openCount, 20'000);
  EXPECT_LT(refused, 100);
}

TEST(FinalCells, NearlyAllFinalCellsAreRecognized) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int tried = 0;
  int missed = 0;
  for (std::size_t trial = 0; trial < 3'000; ++trial) {
    const Circles circles = randomCircles(trial, random);
    const MissingCircles drawn = randomMissing(Extent(circles), random);
    if (!isInput(circles, drawn)) continue;
    const Part part(circles, drawn);
    const auto& [known, inner, diagram, cells] = part;
    const Parts parts(diagram, numbered(inner.known));
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(inner.known.size()); ++i) {
      if (cells.isFinal(i) || std::isinf(cells.neededHalo[at(i)])) continue;
      // A circle outside at the vertex of the cell that reaches farthest out changes the cell.
      double farthest = -kInfinite;
      Point worst;
      for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
        const auto& [x, y, radius] = diagram.vertices[v];
        const double excess = radius - inside(known.box, x, y);
        if (std::ranges::count(diagram.vertexCircles[v], i) == 0 || excess <= farthest) continue;
        farthest = excess;
        worst = {x, y};
      }
      const auto c = farthest == -kInfinite ? std::nullopt : nearestOutside(known, worst);
      if (!c) continue;
      Circles more = inner.known;
      more.push_back(*c);
      const auto changed = compute(more);
      if (!changed) continue;
      ++tried;
      missed += parts.hasCell(Parts(changed.value(), numbered(more)), i);
    }
  }
  std::printf("%d of %d bounded cells that are not called final are not changed by the worst circle outside\n", missed,
              tried);
  EXPECT_GT(tried, 2'000);
  EXPECT_LE(missed, tried / 1000);
}

TEST(FinalCells, TheHaloThatACellNeedsIsEnough) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int widened = 0;
  for (std::size_t trial = 0; trial < 3'000; ++trial) {
    const Circles circles = randomCircles(trial, random);
    const Diagram whole = compute(circles).value();
    const MissingCircles known = randomMissing(Extent(circles), random, &whole);
    if (!isInput(circles, known)) continue;
    const Part part(circles, known);
    for (std::size_t i = 0; i < part.circles.known.size(); ++i) {
      const double halo = part.cells.neededHalo[i] * (1 + 1e-9);
      if (halo == 0 || std::isinf(halo) || random.below(4) != 0) continue;
      MissingCircles wider = known;
      const auto rounding = [&](double side) { return std::isinf(side) ? 0 : 1e-9 * std::abs(side); };
      wider.box.minX -= halo + rounding(known.box.minX);
      wider.box.minY -= halo + rounding(known.box.minY);
      wider.box.maxX += halo + rounding(known.box.maxX);
      wider.box.maxY += halo + rounding(known.box.maxY);
      const Part more(circles, wider);
      const auto place = std::ranges::find(more.circles.ids, part.circles.ids[i]);
      ASSERT_NE(place, more.circles.ids.end());
      ++widened;
      ASSERT_TRUE(more.cells.isFinal(static_cast<std::int32_t>(place - more.circles.ids.begin())))
          << "trial " << trial << ", halo " << halo << '\n'
          << test::describe(circles);
    }
  }
  EXPECT_GT(widened, 1'000);
}

TEST(FinalCells, AnEdgeIsNowhereFartherOutThanAtItsEnds) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  int edges = 0;
  for (std::size_t trial = 0; trial < 400; ++trial) {
    const Circles circles = generate(families()[trial % 20].family, 30, random.next());
    const Diagram diagram = compute(circles).value();
    const Box box = {0, 0, 1, 1};
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
      const Edge& edge = diagram.edges[at(e)];
      if (edge.start == kNone || edge.end == kNone) continue;
      const EdgeCurve curve = edgeCurve(diagram, e);
      const Circle& left = circles[at(edge.left)];
      const auto excess = [&](Point p) {
        return std::hypot(p.x - left.x, p.y - left.y) - left.r - inside(box, p.x, p.y);
      };
      const double ends = std::max(excess(curve.start), excess(curve.end));
      const double size =
          std::abs(curve.start.x) + std::abs(curve.start.y) + std::abs(curve.end.x) + std::abs(curve.end.y) + left.r;
      ++edges;
      for (double share = 0.05; share < 1; share += 0.05) {
        const double s = std::pow(curve.from, 1 - share) * std::pow(curve.to, share);
        const Point p = pointAt(curve.bisector, s);
        ASSERT_LE(excess(p), ends + 1e-7 * (size + std::abs(p.x) + std::abs(p.y))) << trial << " " << e;
      }
    }
  }
  EXPECT_GT(edges, 10'000);
}

TEST(FinalCells, ACircleMayReachFarThatIsKnown) {
  // Nine points on a grid, and a huge circle whose center is far outside: known or not, it cuts cells.
  Circles circles;
  for (int i = 0; i < 25; ++i) circles.push_back({static_cast<double>(i % 5), static_cast<double>(i / 5), 0});
  const MissingCircles known = {{-3, -3, 7, 7}, 0};
  const auto isFinal = [&](std::int32_t i) {
    const Diagram diagram = compute(circles).value();
    return finalCells(diagram, known).value().isFinal(i);
  };
  EXPECT_TRUE(isFinal(12));
  EXPECT_FALSE(isFinal(0)) << "unbounded";
  circles.push_back({1000, 2, 995.5});
  EXPECT_TRUE(isFinal(12));
  EXPECT_FALSE(isFinal(25)) << "the cell of the huge circle goes beyond the box";
}

TEST(FinalCells, EverythingIsFinalIfNothingIsOutside) {
  for (const std::size_t count : {0, 1, 2, 3, 100}) {
    const Circles circles = generate(Family::hidden, count, 1);
    const Diagram diagram = compute(circles).value();
    const FinalCells cells = finalCells(diagram, {kPlane, 7}).value();
    EXPECT_EQ(cells.neededHalo, std::vector<double>(count, 0));
    EXPECT_EQ(cells.vertices, std::vector<std::uint8_t>(diagram.vertices.size(), 1));
    EXPECT_EQ(cells.edges, std::vector<std::uint8_t>(diagram.edges.size(), 1));
  }
}

TEST(FinalCells, AHiddenCircleIsFinalOnceAllItsHidersAreKnown) {
  const Circles circles = {{0, 0, 3}, {1, 0, 1}};
  const Diagram diagram = compute(circles).value();
  // A circle outside may hide the second one if it reaches 2 beyond its center.
  const auto needed = [&](double side, double maxRadius) {
    return finalCells(diagram, {{-side, -side, side, side}, maxRadius}).value().neededHalo[1];
  };
  EXPECT_EQ(needed(4, 0), 0);
  EXPECT_EQ(needed(4, 3.9), 0);
  EXPECT_NEAR(needed(4, 4.5), 0.5, 1e-12);
}

TEST(FinalCells, ADiscThatTouchesTheBorderIsNotFinal) {
  const Circles circles = {{0, 3, 0}, {-3, 0, 0}, {3, 0, 0}, {0, -3, 0}, {0, 0, 0}};
  const Diagram diagram = compute(circles).value();
  // The discs of the cell of the origin are those around (1.5, 1.5), ...
  const double out = 1.5 + 1.5 * std::sqrt(2.0);
  const auto isFinal = [&](double side, double maxRadius) {
    return finalCells(diagram, {{-side, -side, side, side}, maxRadius}).value().isFinal(4);
  };
  EXPECT_TRUE(isFinal(out * (1 + 1e-8), 0));
  EXPECT_FALSE(isFinal(out, 0));
  EXPECT_FALSE(isFinal(out * (1 - 1e-8), 0));
  EXPECT_TRUE(isFinal((out + 2) * (1 + 1e-8), 2));
  EXPECT_FALSE(isFinal((out + 2) * (1 - 1e-8), 2));
}

TEST(FinalCells, BoxesOfAnySizeAreOnTheSafeSide) {
  Circles circles = generate(Family::uniform, 50, 1);
  for (Circle& c : circles) c = {c.x * 1e-15, c.y * 1e-15, c.r * 1e-15};
  const Diagram diagram = compute(circles).value();
  const auto finalCount = [&](const MissingCircles& known) {
    const auto cells = finalCells(diagram, known).value();
    return std::ranges::count(cells.neededHalo, 0.0);
  };
  const double far = 1e300;
  EXPECT_GT(finalCount({{-far, -far, far, far}, 0}), 30);
  EXPECT_EQ(finalCount({{-far, -far, far, far}, 1e305}), 0);
  EXPECT_EQ(finalCount({{-1e-308, -1e-308, 1e-308, 1e-308}, 0}), 0);
}

TEST(FinalCells, OfCentersAreThoseOfPoints) {
  Circles circles = {{0, 0, 3}, {4, 0, 1}, {1, 5, 2}, {6, 6, 4}, {3, 3, 0}, {-2, 4, 5}};
  Options options;
  options.metric = Metric::centers;
  const Diagram ofCenters = compute(circles, options).value();
  const auto found = finalCells(ofCenters, {{-9, -9, 9, 9}, 5}).value();
  for (Circle& c : circles) c.r = 0;
  const auto expected = finalCells(compute(circles).value(), {{-9, -9, 9, 9}, 0}).value();
  EXPECT_EQ(found.vertices, expected.vertices);
  EXPECT_EQ(found.neededHalo, expected.neededHalo);
  options.metric = Metric::power;
  EXPECT_EQ(finalCells(compute(circles, options).value(), {{-9, -9, 9, 9}, 0}).error().code, ErrorCode::badInput);
}

TEST(FinalCells, RefusesInvalidBoxesRadiiAndDiagrams) {
  const Circles circles = generate(Family::uniform, 10, 1);
  Diagram diagram = compute(circles).value();
  const auto codeOf = [&](const MissingCircles& known) {
    const auto cells = finalCells(diagram, known);
    return cells ? "none" : std::string(errorCodeName(cells.error().code));
  };
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, 0}), "none");
  EXPECT_EQ(codeOf({{1, 0, 1, 1}, 0}), "badOption");
  EXPECT_EQ(codeOf({{0, 2, 1, 1}, 0}), "badOption");
  EXPECT_EQ(codeOf({{0, std::nan(""), 1, 1}, 0}), "badOption");
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, -1}), "badOption");
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, kInfinite}), "badOption");
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, std::nan("")}), "badOption");
  diagram.edges[0].start = static_cast<std::int32_t>(diagram.vertices.size());
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, 0}), "badInput");
  diagram.edges[0].start = kNone;
  diagram.vertexCircles[0][1] = 10;
  EXPECT_EQ(codeOf({{0, 0, 1, 1}, 0}), "badInput");
}

}  // namespace
}  // namespace circle_voronoi
