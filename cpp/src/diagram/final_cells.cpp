// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/final_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "estimate.h"
#include "guarded.h"
#include "infinity.h"
#include "three_touch_disc.h"
#include "validate.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// The points p with normal . p >= offset.
struct HalfPlane {
  Vector normal;
  double offset = 0;
};

/// The known properties.
class Outside {
 public:
  explicit Outside(const MissingCircles& missing) : reach_(missing.maxRadius) {
    const auto& [minX, minY, maxX, maxY] = missing.box;
    // Lines so far away that sums could overflow are moved nearer, which only makes fewer parts final.
    constexpr double kFarthest = 0x1p1000;
    const HalfPlane sides[] = {{{1, 0}, minX}, {{-1, 0}, -maxX}, {{0, 1}, minY}, {{0, -1}, -maxY}};
    for (const auto& [normal, offset] : sides) {
      if (!std::isinf(offset)) sides_.push_back({normal, std::clamp(offset, -kFarthest, kFarthest)});
    }
  }

  /// Returns whether nothing is outside.
  bool isNothing() const { return sides_.empty(); }

  /// Returns how much farther out the lines would have to be for a disc to be final, or more: below 0 if it is. `error`
  /// is that of each number of the disc.
  double excess(const Vertex& disc, double error) const {
    const double size = std::abs(disc.x) + std::abs(disc.y) + std::abs(disc.r) + std::abs(reach_);
    double excess = -kInfinite;
    for (const auto& [normal, offset] : sides_) {
      // Seven roundings, two of them of the normal, of numbers that are no larger than the sum of all.
      const double rounding = 8 * kUnitRoundoff * (size + std::abs(offset)) + kUnderflowError;
      const double inside = dot(normal, {disc.x, disc.y}) - offset;
      const double value = disc.r + reach_ - inside + (2 * error + rounding);
      // Not std::max, which passes over NaN.
      if (!(value <= excess)) excess = value;
    }
    return std::isnan(excess) ? kInfinite : excess;
  }

 private:
  std::vector<HalfPlane> sides_;
  double reach_;
};

/// Returns how much farther out the lines would have to be for a vertex to be final, or more.
///
/// vertexOf is right to 36 bits of the distances of the circles from each other and from the disc's center. These are
/// at most twice the farthest of the three from it, and each is computed within a part of 2^-30.
double excessOf(const Outside& outside, const std::array<const Circle*, 3>& circles,
                const std::optional<Vertex>& disc) {
  if (!disc) return outside.isNothing() ? -kInfinite : kInfinite;
  double farthest = 0;
  double size = 0;
  for (const Circle* c : circles) {
    farthest = std::max(farthest, length({disc->x - c->x, disc->y - c->y}));
    size = std::max(size, std::abs(c->x) + std::abs(c->y) + std::abs(c->r));
  }
  return outside.excess(*disc, 0x1p-33 * farthest + 4 * kUnitRoundoff * (size + farthest));
}

std::optional<Error> checkMissing(const MissingCircles& missing) {
  const auto& [minX, minY, maxX, maxY] = missing.box;
  if (!(minX < maxX) || !(minY < maxY)) return errorWith(ErrorCode::badOption, "The box of what is known is empty.");
  if (!(missing.maxRadius >= 0) || std::isinf(missing.maxRadius)) {
    return errorWith(ErrorCode::badOption, "The largest radius of what is not known is no finite number from 0.");
  }
  return std::nullopt;
}

bool fits(const Diagram& diagram) {
  const auto isCircle = [&](CircleIndex i) { return i >= 0 && static_cast<std::size_t>(i) < diagram.circles.size(); };
  const auto isEnd = [&](VertexIndex v) {
    return v == kNone || (v >= 0 && static_cast<std::size_t>(v) < diagram.vertexCircles.size());
  };
  const auto isVertex = [&](const auto& triple) { return std::all_of(triple.begin(), triple.end(), isCircle); };
  const auto isEdge = [&](const Edge& edge) { return isEnd(edge.start) && isEnd(edge.end); };
  const auto isHidden = [&](const HiddenCircle& hidden) { return isCircle(hidden.circle); };
  const auto all = [](const auto& items, auto is) { return std::all_of(items.begin(), items.end(), is); };
  return all(diagram.vertexCircles, isVertex) && all(diagram.edges, isEdge) && all(diagram.hidden, isHidden) &&
         all(diagram.hull, isCircle);
}

FinalCells finalCellsOf(std::span<const Circle> circles, const Diagram& diagram, const Outside& outside) {
  FinalCells result;
  result.neededHalo.assign(circles.size(), 0);
  const auto need = [&](CircleIndex circle, double excess) {
    if (excess < 0) return;
    // A step more where it is 0 or too small for a number.
    const double halo = std::max(excess * (1 + 0x1p-40), std::numeric_limits<double>::min());
    double& needed = result.neededHalo[static_cast<std::size_t>(circle)];
    needed = std::max(needed, halo);
  };

  result.vertices.reserve(diagram.vertexCircles.size());
  for (std::size_t v = 0; v < diagram.vertexCircles.size(); ++v) {
    auto triple = diagram.vertexCircles[v];
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
    const auto circle = [&](std::size_t k) { return &circles[static_cast<std::size_t>(triple[k])]; };
    const auto disc = vertexOf(*circle(0), *circle(1), *circle(2));
    const double excess = excessOf(outside, {circle(0), circle(1), circle(2)}, disc);
    result.vertices.push_back(excess < 0);
    for (const CircleIndex i : triple) need(i, excess);
  }
  result.edges.reserve(diagram.edges.size());
  for (const Edge& edge : diagram.edges) {
    const auto isFinal = [&](VertexIndex v) {
      return v == kNone ? outside.isNothing() : result.vertices[static_cast<std::size_t>(v)] != 0;
    };
    result.edges.push_back(isFinal(edge.start) && isFinal(edge.end));
  }
  for (const CircleIndex i : diagram.hull) need(i, outside.isNothing() ? -kInfinite : kInfinite);
  // A circle that hides circle i has a signed distance of at most -r_i at its center.
  for (const HiddenCircle& hidden : diagram.hidden) {
    const Circle& c = circles[static_cast<std::size_t>(hidden.circle)];
    need(hidden.circle, outside.excess({c.x, c.y, -c.r}, 0));
  }
  return result;
}

}  // namespace

Result<FinalCells> finalCells(const Diagram& diagram, const MissingCircles& missing) {
  return guarded([&]() -> Result<FinalCells> {
    if (auto error = checkMissing(missing)) return *std::move(error);
    if (!fits(diagram)) {
      return errorWith(ErrorCode::badInput, "The diagram names circles or vertices that are not there.");
    }
    if (diagram.metric == Metric::power) {
      return errorWith(ErrorCode::badInput, "The final cells of a power diagram are not known.");
    }
    auto circles = validate(diagram.circles, diagram.weights);
    if (!circles) return circles.error();
    if (diagram.metric == Metric::circles) return finalCellsOf(circles.value(), diagram, Outside(missing));
    MissingCircles points = missing;
    points.maxRadius = 0;
    return finalCellsOf(pointsOf(circles.value()), diagram, Outside(points));
  });
}

}  // namespace circle_voronoi
