// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/periodic_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "at.h"
#include "cell_limits.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/periodic_diagram.h"
#include "guarded.h"
#include "reduced_lattice.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Reduces a lattice in a unit that makes its coordinates integers (computePeriodic).
ReducedLattice reduced(const Lattice& lattice, int& exponent) {
  constexpr int kBits = 50;
  const auto& [a, b] = lattice;
  std::frexp(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}), &exponent);
  exponent -= kBits;
  const auto scaled = [&](Vector v) { return Vector{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)}; };
  return reduce(scaled(a), scaled(b));
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr const char* kTooFar = "The point is not finite, or 2^30 periods away or more.";

/// Returns whether a shift has less than 2^30 of each period; false for NaN.
bool isNear(const std::array<double, 2>& shift) { return std::abs(shift[0]) < 0x1p30 && std::abs(shift[1]) < 0x1p30; }

}  // namespace

std::vector<CircleImage> neighbors(const PeriodicDiagram& periodic, CircleIndex circle) {
  std::vector<CircleImage> result;
  for (const SideIndex side : periodic.diagram.sides(circle)) {
    result.push_back(periodic.imageFrom(circle, periodic.diagram.neighborOf(side)));
  }
  return result;
}

PeriodicFinder::PeriodicFinder(const PeriodicDiagram& periodic) : periodic_(&periodic), finder_(periodic.diagram) {
  int exponent = 0;
  const auto [a, b, ofA, ofB] = reduced(periodic.lattice, exponent);
  const auto inInput = [&](Vector v) { return Vector{std::ldexp(v.x, exponent), std::ldexp(v.y, exponent)}; };
  shortest_ = {inInput(a), inInput(b)};
  ofGiven_ = {Vector{ofA[0], ofA[1]}, Vector{ofB[0], ofB[1]}};
}

// A point beside the given circles is nearest to some image. Moved by the shift of this image, it lies beside the given
// circle and no farther from the nearest one, so this ends at a given circle, whose cell is right.
Result<CircleImage> PeriodicFinder::find(Point p) const {
  const Diagram& diagram = periodic_->diagram;
  if (periodic_->circleCount == 0) return CircleImage{kNone, {}};
  const auto& [a, b] = shortest_;
  const Vector place = ReducedLattice{a, b}.placeOf({p.x - diagram.circles[0].x, p.y - diagram.circles[0].y});
  const Vector steps = {std::floor(place.x + 0.5), std::floor(place.y + 0.5)};
  p = {p.x - steps.x * a.x - steps.y * b.x, p.y - steps.x * a.y - steps.y * b.y};
  std::array<double, 2> shift = {steps.x * ofGiven_[0].x + steps.y * ofGiven_[1].x,
                                 steps.x * ofGiven_[0].y + steps.y * ofGiven_[1].y};
  if (!isNear(shift)) return errorWith(ErrorCode::badInput, kTooFar);
  CircleIndex found = finder_.find(p);
  // Rounding may lead around in circles, among images that are equally near.
  for (int tries = 0; tries < 100 && found >= periodic_->circleCount; ++tries) {
    const CircleIndex given = periodic_->circleOf[at(found)];
    const Circle& from = diagram.circles[at(found)];
    const Circle& to = diagram.circles[at(given)];
    p = {p.x + (to.x - from.x), p.y + (to.y - from.y)};
    const auto [k, l] = periodic_->imageFrom(given, found).shift;
    shift = {shift[0] + k, shift[1] + l};
    found = finder_.find(p, given);
  }
  const Shift& own = periodic_->shiftOf[at(found)];
  shift = {shift[0] + own[0], shift[1] + own[1]};
  if (!isNear(shift)) return errorWith(ErrorCode::badInput, kTooFar);
  return CircleImage{periodic_->circleOf[at(found)],
                     {static_cast<std::int32_t>(shift[0]), static_cast<std::int32_t>(shift[1])}};
}

ContactTable contactTable(const PeriodicDiagram& periodic) {
  const Diagram& diagram = periodic.diagram;
  const std::size_t count = at(periodic.circleCount);
  ContactTable table;
  table.areas.assign(count, 0);
  table.packingFractions.assign(count, 0);
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) {
    const Outline cell = outline(diagram, i);
    if (cell.empty()) continue;
    const Circle& c = diagram.circles[at(i)];
    const double r = radiusOf(diagram, c);
    std::map<std::array<std::int32_t, 3>, std::size_t> met;
    double least = kInfinite;
    for (const OutlinePiece& piece : cell.front()) {
      const CircleImage neighbor = periodic.imageFrom(i, piece.neighbor);
      const double length = arcLength(edgeCurve(diagram, Diagram::edgeOf(piece.side)));
      const auto [place, isNew] =
          met.try_emplace({neighbor.circle, neighbor.shift[0], neighbor.shift[1]}, table.contacts.size());
      if (!isNew) {
        table.contacts[place->second].length += length;
        continue;
      }
      const Circle& d = diagram.circles[at(piece.neighbor)];
      table.contacts.push_back({i, neighbor, length, lengthOf(between(c, d)) - r - radiusOf(diagram, d)});
      least = std::min(least, table.contacts.back().gap);
    }
    const double whole = area(cell);
    table.areas[at(i)] = whole;
    if (!(r > 0)) continue;
    double covered = std::numbers::pi * r * r;
    if (least < 0) covered = diagram.metric == Metric::circles ? area(outlineWithin(diagram, i, 0)) : kNan;
    // A cell without an area, up to rounding, is covered.
    table.packingFractions[at(i)] = whole > 0 ? std::min(covered / whole, 1.0) : 1;
  }
  return table;
}

}  // namespace circle_voronoi
