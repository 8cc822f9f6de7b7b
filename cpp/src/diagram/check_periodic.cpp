// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "at.h"
#include "box_area.h"
#include "circle_voronoi/periodic_diagram.h"
#include "guarded.h"
#include "mix.h"
#include "three_touch_disc.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

bool fits(const PeriodicDiagram& periodic) {
  const Diagram& diagram = periodic.diagram;
  const std::size_t count = diagram.circles.size();
  if (periodic.circleCount < 0 || at(periodic.circleCount) > count || periodic.circleOf.size() != count ||
      periodic.shiftOf.size() != count || diagram.vertices.size() != diagram.vertexCircles.size()) {
    return false;
  }
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) {
    if (periodic.circleOf[at(i)] != i) return false;
  }
  const auto isBelow = [](std::int32_t index, std::size_t end) { return index >= 0 && at(index) < end; };
  const auto isGiven = [&](CircleIndex i) { return isBelow(i, at(periodic.circleCount)); };
  const auto isCircle = [&](CircleIndex i) { return isBelow(i, count); };
  const auto isEnd = [&](VertexIndex v) { return v == kNone || isBelow(v, diagram.vertices.size()); };
  const auto isVertex = [&](const auto& triple) { return std::all_of(triple.begin(), triple.end(), isCircle); };
  const auto isEdge = [&](const Edge& e) {
    return isCircle(e.left) && isCircle(e.right) && isEnd(e.start) && isEnd(e.end);
  };
  const auto isHidden = [&](const HiddenCircle& h) { return isCircle(h.circle) && isCircle(h.by); };
  const auto all = [](const auto& items, auto is) { return std::all_of(items.begin(), items.end(), is); };
  return all(periodic.circleOf, isGiven) && all(diagram.edges, isEdge) && all(diagram.vertexCircles, isVertex) &&
         all(diagram.hidden, isHidden);
}

/// A number for a few small numbers. Two lists have the same one with a probability of about 2^-64.
template <std::size_t kCount>
std::uint64_t mixed(const std::array<std::int64_t, kCount>& numbers) {
  constexpr std::uint64_t kFactors[] = {0x9e3779b97f4a7c15u, 0xbf58476d1ce4e5b9u, 0x94d049bb133111ebu,
                                        0xd6e8feb86659fd93u, 0xa0761d6478bd642fu, 0xe7037ed1a0b428dbu,
                                        0x8ebc6af09c88c6e3u};
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < kCount; ++k) sum += kFactors[k] * static_cast<std::uint64_t>(numbers[k]);
  return mix(sum);
}

/// Adds up numbers of 64 bits that stand for the parts of cells. Parts that belong together add up to zero; others do
/// so with a probability of 2^-64.
class FoldCheck {
 public:
  explicit FoldCheck(const PeriodicDiagram& periodic)
      : periodic_(periodic), diagram_(periodic.diagram), balance_(at(periodic.circleCount)) {}

  std::optional<Error> run() {
    addImages();
    for (const HiddenCircle& h : diagram_.hidden) addHidden(h);
    for (const Edge& e : diagram_.edges) {
      addSide(e.left, e.right, e.start, e.end);
      addSide(e.right, e.left, e.end, e.start);
    }
    for (const auto& triple : diagram_.vertexCircles) addCorners(triple);
    const auto unbalanced = std::find_if(balance_.begin(), balance_.end(), [](std::uint64_t sum) { return sum != 0; });
    if (unbalanced != balance_.end()) {
      refuse(static_cast<std::int32_t>(unbalanced - balance_.begin()), "The borders of its cell have no twins.");
    }
    // V - E + F with V = corners / 3 and E = sides / 2.
    if (2 * corners_ - 3 * sides_ + 6 * cells_ != 0)
      refuse(kNone, "Vertices, edges and cells contradict Euler's formula.");
    const double box = boxArea(periodic_.lattice);
    // Not >, which is false for NaN.
    if (periodic_.circleCount > 0 && !(std::abs(area_ - box) <= 0x1p-30 * box + rounding_)) {
      refuse(kNone, "The areas of the cells do not sum to that of the box.");
    }
    return std::move(error_);
  }

 private:
  bool isGiven(CircleIndex circle) const { return circle < periodic_.circleCount; }

  void refuse(CircleIndex circle, const char* why) {
    if (!error_) error_ = Error{ErrorCode::notCertified, circle, why};
  }

  /// Images lie where their shifts say, and have the radius of their circle.
  void addImages() {
    const Lattice& lattice = periodic_.lattice;
    for (std::size_t i = 0; i < diagram_.circles.size(); ++i) {
      const CircleIndex own = periodic_.circleOf[i];
      const Shift shift = periodic_.imageFrom(own, static_cast<std::int32_t>(i)).shift;
      const Circle& image = diagram_.circles[i];
      const Circle& given = diagram_.circles[at(own)];
      const auto isAt = [&](double x, double from, double byA, double byB) {
        const double size = std::abs(from) + std::abs(shift[0] * byA) + std::abs(shift[1] * byB);
        return std::abs(from + shift[0] * byA + shift[1] * byB - x) <= 0x1p-45 * size;
      };
      if (!isAt(image.x, given.x, lattice.a.x, lattice.b.x) || !isAt(image.y, given.y, lattice.a.y, lattice.b.y) ||
          image.r != given.r) {
        refuse(own, "An image does not lie where its shift says.");
      }
    }
    cells_ = periodic_.circleCount;
  }

  void addHidden(const HiddenCircle& hidden) {
    if (!isGiven(hidden.circle)) return;
    --cells_;
    const CircleIndex hider = periodic_.circleOf[at(hidden.by)];
    const auto isBefore = [](const HiddenCircle& h, std::int32_t circle) { return h.circle < circle; };
    const auto found = std::lower_bound(diagram_.hidden.begin(), diagram_.hidden.end(), hider, isBefore);
    if (found != diagram_.hidden.end() && found->circle == hider) refuse(hidden.circle, "A hidden circle hides it.");
  }

  /// The side of a cell, and its twin: one of the two is added, the other subtracted.
  void addSide(CircleIndex circle, CircleIndex other, VertexIndex start, VertexIndex end) {
    if (!isGiven(circle)) return;
    if (start == kNone || end == kNone) return refuse(circle, "Its cell is not bounded.");
    if (!isBetween(start, other, circle) || !isBetween(end, circle, other)) {
      return refuse(circle, "A border of its cell does not fit a vertex.");
    }
    ++sides_;
    addTriangle(diagram_.circles[at(circle)], diagram_.vertices[at(start)], diagram_.vertices[at(end)]);
    // Its twin is the other side of the edge, and the two cancel.
    if (isGiven(other)) return;
    const auto [j, shift] = periodic_.imageFrom(circle, other);
    const auto [k, l] = shift;
    const bool isFirst = std::array<std::int64_t, 3>{circle, 0, 0} < std::array<std::int64_t, 3>{j, k, l};
    const std::uint64_t sum = isFirst ? mixed(std::array<std::int64_t, 4>{circle, j, k, l})
                                      : mixed(std::array<std::int64_t, 4>{j, circle, -k, -l});
    balance_[at(std::min(circle, j))] += isFirst ? sum : 0 - sum;
  }

  /// Whether the cells of two circles follow each other around a vertex, counter-clockwise.
  bool isBetween(VertexIndex vertex, CircleIndex circle, CircleIndex next) const {
    const auto& [i, j, k] = diagram_.vertexCircles[at(vertex)];
    const auto is = [&](CircleIndex u, CircleIndex v) { return u == circle && v == next; };
    return is(i, j) || is(j, k) || is(k, i);
  }

  /// The triangle of a center and a side.
  void addTriangle(const Circle& c, const Vertex& start, const Vertex& end) {
    const Vector u = {start.x - c.x, start.y - c.y};
    const Vector v = {end.x - c.x, end.y - c.y};
    area_ += cross(u, v) / 2;
    const double size = std::abs(u.x) + std::abs(u.y) + std::abs(v.x) + std::abs(v.y);
    rounding_ += size * (kVertexRounding * size + 0x1p-50 * (std::abs(c.x) + std::abs(c.y)));
  }

  /// The corners of the three cells around a vertex, seen from the smallest of its circles. Their weights add up to
  /// zero, so that each of the three must occur equally often.
  void addCorners(const std::array<CircleIndex, 3>& triple) {
    constexpr std::uint64_t kWeights[] = {1, 0x9e3779b97f4a7c15u, 0 - 0x9e3779b97f4a7c16u};
    const int count = isGiven(triple[0]) + isGiven(triple[1]) + isGiven(triple[2]);
    corners_ += count;
    // All three cancel.
    if (count == 0 || count == 3) return;
    const auto given = [&](std::size_t k) { return periodic_.circleOf[at(triple[k % 3])]; };
    const auto seenFrom = [&](std::size_t turn) {
      const CircleImage second = periodic_.imageFrom(triple[turn], triple[(turn + 1) % 3]);
      const CircleImage third = periodic_.imageFrom(triple[turn], triple[(turn + 2) % 3]);
      return std::array<std::int64_t, 7>{given(turn),     second.circle,  third.circle,  second.shift[0],
                                         second.shift[1], third.shift[0], third.shift[1]};
    };
    std::size_t first = 0;
    for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {
      const bool isTie = given(turn) == given(first);
      if (isTie ? seenFrom(turn) < seenFrom(first) : given(turn) < given(first)) first = turn;
    }
    const std::array<std::int64_t, 7> best = seenFrom(first);
    const std::uint64_t sum = mixed(best);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!isGiven(triple[k])) continue;
      balance_[static_cast<std::size_t>(best[0])] += kWeights[(k + 3 - first) % 3] * sum;
    }
  }

  const PeriodicDiagram& periodic_;
  const Diagram& diagram_;
  std::vector<std::uint64_t> balance_;  ///< of the parts that the circle is the smallest of
  std::int64_t corners_ = 0;
  std::int64_t sides_ = 0;
  std::int64_t cells_ = 0;
  double area_ = 0;
  double rounding_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<void> checkPeriodic(const PeriodicDiagram& periodic) {
  return guarded([&]() -> Result<void> {
    if (!fits(periodic)) return errorWith(ErrorCode::badInput, "The parts of the diagram do not fit together.");
    if (auto error = FoldCheck(periodic).run()) return *std::move(error);
    return {};
  });
}

}  // namespace circle_voronoi
