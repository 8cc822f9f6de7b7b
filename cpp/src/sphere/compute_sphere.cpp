// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arithmetic.h"
#include "at.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/sphere.h"
#include "construct.h"
#include "guarded.h"
#include "infinity.h"
#include "number_text.h"
#include "place.h"
#include "spatial_order.h"
#include "threads.h"
#include "topology.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

using sphere::HalfGrowth;
using sphere::Place;
using sphere::Places;
using sphere::View;

/// Caps that are nearer to N than this, as the square of the sine of half an angle, are at its place.
constexpr double kSamePlace = 0x1p-130;
/// The factor of planar coordinates. They are then below 2^96, and those that are taken for zero change places by less
/// than 2^-80.
constexpr double kScale = 0x1p24;
constexpr double kSmallest = 0x1p-56;

/// A rounding that needs no better N: half a micrometer on the Earth.
constexpr double kGoodRounding = 0x1p-44;
/// The number of caps among which N is chosen.
constexpr std::size_t kCandidates = 6;
/// The rounding of a circle in units of its numbers' rounding, and the least rounding of places.
constexpr double kRoundings = 16 * 0x1p-53;

std::optional<Error> errorOf(const Cap& cap, std::size_t index, const SphereOptions& options) {
  const auto error = [&](ErrorCode code, const std::string& what) {
    return Error{code, static_cast<std::int64_t>(index), "Cap " + std::to_string(index) + " " + what};
  };
  if (!std::isfinite(cap.longitude)) return error(ErrorCode::nonFinite, "has a longitude that is not a finite number.");
  if (!std::isfinite(cap.latitude)) return error(ErrorCode::nonFinite, "has a latitude that is not a finite number.");
  if (!std::isfinite(cap.r)) return error(ErrorCode::nonFinite, "has a radius that is not a finite number.");
  if (std::abs(cap.latitude) > 90) {
    return error(ErrorCode::coordinateTooLarge,
                 "has the latitude " + numberText(cap.latitude) + ", which is beyond 90 degrees.");
  }
  if (cap.r < 0 && !options.weights) return error(ErrorCode::negativeRadius, "has a negative radius.");
  if (std::abs(cap.r) < kPi * options.radius) return std::nullopt;
  return error(ErrorCode::coordinateTooLarge, "has the radius " + numberText(cap.r) +
                                                  ", which is not below half of the circumference, " +
                                                  numberText(kPi * options.radius) + ".");
}

std::optional<Error> errorOf(std::span<const Cap> caps, const SphereOptions& options) {
  if (!(options.radius >= 1e-20 && options.radius <= 1e20)) {
    return Error{
        ErrorCode::badOption, kNone,
        "The radius of the sphere must be a number from 1e-20 to 1e20 (got " + numberText(options.radius) + ")."};
  }
  if (auto error = Threads::refusalOf(options.threads)) return error;
  if (caps.size() > kMaxCircles) {
    return Error{ErrorCode::tooManyCircles, kNone,
                 "There are " + std::to_string(caps.size()) + " caps; at most " + std::to_string(kMaxCircles) +
                     " are possible."};
  }
  if (!isArithmeticStandard()) {
    return Error{ErrorCode::badArithmetic, kNone,
                 "Floating-point numbers are not rounded to nearest or tiny ones are taken for zero, as in a program "
                 "that is linked with -ffast-math."};
  }
  for (std::size_t i = 0; i < caps.size(); ++i) {
    if (auto error = errorOf(caps[i], i, options)) return error;
  }
  return std::nullopt;
}

/// The other caps as circles of the plane, seen from cap N.
struct Projection {
  CircleIndex pole;  ///< N
  std::vector<CircleIndex> rest;
  std::vector<Circle> circles;
  std::vector<CircleIndex> hidden;  ///< by N, in increasing order
  double rounding = kInfinite;      ///< the angle by which rounded circles differ from the given caps, at most
};

/// Projects all caps from one of them; nothing if another cap hides it.
std::optional<Projection> projectedFrom(CircleIndex pole, const SphereDiagram& diagram, const Places& places) {
  Projection result;
  result.pole = pole;
  result.rounding = kRoundings;
  result.rest.reserve(diagram.caps.size());
  result.circles.reserve(diagram.caps.size());
  const auto scaled = [](double x) { return std::abs(kScale * x) < kSmallest ? 0.0 : kScale * x; };
  for (CircleIndex i = 0; i < static_cast<std::int32_t>(diagram.caps.size()); ++i) {
    if (i == pole) continue;
    const View view = viewOf(places[pole], places[i]);
    const HalfGrowth growth = places.halfGrowth(pole, i);
    const double height = 2 * (view.squaredHalf - growth.sine * growth.sine);
    const double difference = places.growth(pole, i);
    if (view.squaredHalf <= kSamePlace || height <= 0x1p-50 * view.squaredHalf || std::abs(difference) >= kPi) {
      if (difference > 0) return std::nullopt;
      result.hidden.push_back(i);
      continue;
    }
    const sphere::Border border = sphere::borderOf(view.vector, height, growth);
    // Seen from the plane's side, the sphere is mirrored.
    result.rest.push_back(i);
    result.circles.push_back({scaled(border.vector.x), scaled(-border.vector.y), scaled(border.offset)});
    const double place = length(border.vector);
    const double near = place - std::abs(border.offset);
    const double rounding = kRoundings * (place + std::abs(border.offset)) / (1 + near * near);
    result.rounding = std::max(result.rounding, rounding);
  }
  return result;
}

/// Projects from the largest cap, which no other hides, or if much is lost to rounding there from another one. Among
/// caps of the same size, those in the middle of the order come first: they are rarely at the rim of a group.
Projection projected(const SphereDiagram& diagram, const Places& places) {
  const auto middle = static_cast<std::int32_t>(diagram.caps.size() / 2);
  const auto rank = [&](CircleIndex i) {
    return std::tuple(-diagram.caps[at(i)].r, std::abs(std::int32_t{i} - middle), std::int32_t{i});
  };
  std::vector<CircleIndex> candidates(diagram.caps.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i] = static_cast<std::int32_t>(i);
  const std::size_t count = std::min(kCandidates, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count), candidates.end(),
                    [&](CircleIndex i, CircleIndex j) { return rank(i) < rank(j); });
  Projection best;
  for (std::size_t k = 0; k < count && best.rounding > kGoodRounding; ++k) {
    auto projection = projectedFrom(candidates[k], diagram, places);
    if (projection && projection->rounding < best.rounding) best = *std::move(projection);
  }
  return best;
}

/// Returns the certified dual of projected circles, whose radii may be negative.
Result<State> constructed(const std::vector<Circle>& circles, int threads) {
  return guarded([&]() -> Result<State> {
    auto valid = validate(circles, true);
    if (!valid) return valid.error();
    Options options;
    options.threads = threads;
    Journal journal(options.progress);
    State state = construct(*std::move(valid), options, journal);
    if (!state.verdict.isRight()) {
      return Error{ErrorCode::notCertified, kNone, "No construction led to a certified diagram of the projected caps."};
    }
    return state;
  });
}

/// Fills edges, the caps of vertices, hidden caps and links from the dual of the plane, whose point at infinity is N.
void assemble(SphereDiagram& sphere, State plane, const Projection& projection, Threads threads) {
  const CircleIndex pole = projection.pole;
  const auto capOf = [&rest = projection.rest](CircleIndex circle) { return rest[at(circle)]; };
  for (const CircleIndex i : projection.hidden) sphere.hidden.push_back({i, pole});
  for (const auto& [circle, by] : plane.sites.hidden) sphere.hidden.push_back({capOf(circle), capOf(by)});
  std::ranges::sort(sphere.hidden, {}, [](const HiddenCircle& h) { return std::int32_t{h.circle}; });

  const std::vector<int>& circleOf = plane.sites.indices;
  if (circleOf.size() == 1) {
    const auto [first, second] = std::minmax({pole, capOf(circleOf[0])});
    sphere.edges.push_back({first, second, kNone, kNone});
    sphere.links.nextSide = {0, 1};
    sphere.links.firstSide.assign(sphere.caps.size(), kNone);
    sphere.links.firstSide[at(first)] = 0;
    sphere.links.firstSide[at(second)] = 1;
    return;
  }
  plane.verdict.proof = {};
  threads.forEach(plane.dual.origin.size(), [&](std::size_t h) {
    int& corner = plane.dual.origin[h];
    corner = corner == kPointAtInfinity ? pole : capOf(circleOf[at(corner)]);
  });
  const std::vector<VertexIndex> vertices = verticesOf(plane.dual, threads);
  Topology topology =
      topologyOf(std::move(plane.dual), vertices, static_cast<int>(sphere.caps.size()), sphere.links, threads);
  sphere.vertexCaps = std::move(topology.vertexCircles);
  sphere.edges = std::move(topology.edges);
}

/// Gives each cap of a diagram the index that is listed for it.
void renumber(SphereDiagram& sphere, std::span<const Cap> caps, const std::vector<int>& indices) {
  const auto rename = [&](CircleIndex& cap) { cap = indices[at(cap)]; };
  sphere.caps.assign(caps.begin(), caps.end());
  for (auto& triple : sphere.vertexCaps) std::for_each(triple.begin(), triple.end(), rename);
  for (Edge& e : sphere.edges) {
    rename(e.left);
    rename(e.right);
  }
  for (HiddenCircle& h : sphere.hidden) {
    rename(h.circle);
    rename(h.by);
  }
  std::sort(sphere.hidden.begin(), sphere.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  std::vector<SideIndex> firstSide(caps.size());
  for (std::size_t i = 0; i < caps.size(); ++i)
    firstSide[static_cast<std::size_t>(indices[i])] = sphere.links.firstSide[i];
  sphere.links.firstSide = std::move(firstSide);
}

/// Returns the caps in spatial order, so that neighbors are together in memory.
std::vector<int> orderOf(std::span<const Cap> caps, Threads threads) {
  std::vector<Point> points;
  points.reserve(caps.size());
  for (const Cap& cap : caps) {
    points.push_back({std::abs(cap.latitude) == 90 ? 0 : sphere::wrapped(cap.longitude), cap.latitude});
  }
  return spatialOrder(points, threads);
}

Result<SphereDiagram> computeValid(std::span<const Cap> caps, const SphereOptions& options) {
  const Threads threads(options.threads);
  SphereDiagram sphere;
  sphere.radius = options.radius;
  sphere.weights = options.weights;
  if (caps.empty()) return sphere;
  const std::vector<int> indices = orderOf(caps, threads);
  sphere.caps.reserve(caps.size());
  for (const int i : indices) sphere.caps.push_back(caps[static_cast<std::size_t>(i)]);
  const Places places(sphere);
  Projection projection = projected(sphere, places);
  auto plane = constructed(std::exchange(projection.circles, {}), options.threads);
  if (!plane) {
    Error error = plane.error();
    if (error.circle != kNone) error.circle = indices[at(projection.rest[static_cast<std::size_t>(error.circle)])];
    return error;
  }
  sphere.rounding = options.radius * projection.rounding;
  assemble(sphere, *std::move(plane), projection, threads);
  sphere.vertices.resize(sphere.vertexCaps.size());
  threads.forEach(sphere.vertices.size(), [&](std::size_t v) {
    const sphere::Touch touch = places.touch(sphere.vertexCaps[v]);
    const CircleIndex from = sphere.vertexCaps[v][touch.from];
    const Point p = pointAt(places[from], touch.direction, sphere::arcOf(touch.cotangent));
    const double angle = angleOf(1, touch.cotangent);
    sphere.vertices[v] = {p.x, p.y, options.radius * angle - sphere.caps[at(from)].r};
  });
  if (const auto checked = checkSphere(sphere); !checked) {
    Error error = checked.error();
    if (error.circle != kNone) error.circle = indices[static_cast<std::size_t>(error.circle)];
    return error;
  }
  renumber(sphere, caps, indices);
  return sphere;
}

}  // namespace

Result<SphereDiagram> computeSphere(std::span<const Cap> caps, const SphereOptions& options) {
  return guarded([&]() -> Result<SphereDiagram> {
    if (auto error = errorOf(caps, options)) return *std::move(error);
    return computeValid(caps, options);
  });
}

}  // namespace circle_voronoi
