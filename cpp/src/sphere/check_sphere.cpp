// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "at.h"
#include "circle_voronoi/sphere.h"
#include "guarded.h"
#include "place.h"

namespace circle_voronoi {
namespace {

using sphere::Places;

/// A reach into the disc of a vertex that is more than rounding, as a share of the sphere's radius: 6 mm on the Earth.
/// Vertices are right to a thousandth of this.
constexpr double kFar = 1e-9;

/// The position of a cap among those of a vertex; any position if it is not there.
std::size_t positionIn(const std::array<CircleIndex, 3>& caps, CircleIndex cap) {
  return caps[0] == cap ? 0 : caps[1] == cap ? 1 : 2;
}

/// Whether all numbers are numbers, all indices exist, and edges, vertices and links say the same of each other.
bool fits(const SphereDiagram& diagram) {
  const auto& [caps, radius, weights, vertices, vertexCaps, edges, hidden, links, rounding] = diagram;
  const auto isIn = [](std::int32_t index, std::size_t count) { return index >= 0 && at(index) < count; };
  const auto isCap = [&](CircleIndex cap) { return isIn(cap, diagram.caps.size()); };
  if (!(radius >= 1e-20 && radius <= 1e20 && rounding >= 0 && rounding <= radius)) return false;
  if (!std::ranges::all_of(caps, [&](const Cap& c) {
        return std::isfinite(c.longitude) && std::abs(c.latitude) <= 90 && std::abs(c.r) < kPi * diagram.radius;
      })) {
    return false;
  }
  if (!std::ranges::all_of(vertices, [&](const SphereVertex& v) {
        return std::isfinite(v.longitude) && std::abs(v.latitude) <= 90 &&
               std::abs(v.distance) <= 2 * (kPi + 1e-9) * diagram.radius;
      })) {
    return false;
  }
  if (vertexCaps.size() != vertices.size() || links.vertexSides.size() != vertices.size()) return false;
  if (links.nextSide.size() != 2 * edges.size() || links.firstSide.size() != caps.size()) return false;
  for (const auto& [i, j, k] : vertexCaps) {
    if (!isCap(i) || !isCap(j) || !isCap(k) || i == j || j == k || k == i) return false;
  }
  for (std::size_t h = 0; h < hidden.size(); ++h) {
    if (!isCap(hidden[h].circle) || !isCap(hidden[h].by)) return false;
    if (h > 0 && hidden[h].circle <= hidden[h - 1].circle) return false;
  }
  for (const Edge& e : edges) {
    if (!isCap(e.left) || !isCap(e.right) || e.left == e.right) return false;
    const bool isClosed = e.start == kNone && e.end == kNone;
    if (!isClosed && !(isIn(e.start, vertices.size()) && isIn(e.end, vertices.size()))) return false;
  }
  // Each side is the one that begins at its vertex in its cell, and so is the next one. So each is the next of one.
  std::vector<SideIndex> firstSide(caps.size(), kNone);
  for (auto side = static_cast<std::int32_t>(2 * edges.size()) - 1; side >= 0; --side) {
    const CircleIndex cap = diagram.circleOf(side);
    firstSide[at(cap)] = side;
    const SideIndex next = links.nextSide[at(side)];
    const VertexIndex start = diagram.originOf(side);
    const VertexIndex end = diagram.targetOf(side);
    if (start == kNone) {
      if (next != side) return false;
      continue;
    }
    const std::size_t atStart = positionIn(vertexCaps[at(start)], cap);
    const std::size_t atEnd = positionIn(vertexCaps[at(end)], cap);
    if (vertexCaps[at(start)][atStart] != cap || vertexCaps[at(end)][atEnd] != cap ||
        vertexCaps[at(start)][(atStart + 2) % 3] != diagram.neighborOf(side) ||
        vertexCaps[at(end)][(atEnd + 1) % 3] != diagram.neighborOf(side) ||
        links.vertexSides[at(start)][atStart] != side || links.vertexSides[at(end)][atEnd] != next) {
      return false;
    }
  }
  return firstSide == links.firstSide;
}

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The directions at a place. Unlike views (place.h), vectors of space have all digits of the sphere's radius only,
/// which suffices for the tolerance.
class Axes {
 public:
  Axes(double longitude, double latitude)
      : longitude_(sineCosineOfDegrees(sphere::wrapped(longitude))), latitude_(sineCosineOfDegrees(latitude)) {}

  Vector3 up() const {
    return {latitude_.cosine * longitude_.cosine, latitude_.cosine * longitude_.sine, latitude_.sine};
  }
  double east(const Vector3& v) const { return v.y * longitude_.cosine - v.x * longitude_.sine; }
  double north(const Vector3& v) const {
    return v.z * latitude_.cosine - (v.x * longitude_.cosine + v.y * longitude_.sine) * latitude_.sine;
  }

 private:
  SineCosine longitude_;
  SineCosine latitude_;
};

/// The check on the sphere. Regions that are star-shaped around their centers and fit together along their borders
/// cover the sphere once, if each vertex has its caps around it once: then they are a covering of the sphere, and the
/// sphere has none but itself. The distance is continuous across the borders, because these are where two caps are
/// equally far. So the regions are the cells, as in `judge.h`.
class SphereJudge {
 public:
  explicit SphereJudge(const SphereDiagram& diagram)
      : diagram_(diagram),
        places_(Places::ofFew(diagram)),
        tolerance_(sphere::toleranceOf(diagram)),
        angleTolerance_(tolerance_ / diagram.radius) {
    capAxes_.reserve(diagram.caps.size());
    halfRadii_.reserve(diagram.caps.size());
    for (const Cap& c : diagram.caps) {
      capAxes_.emplace_back(c.longitude, c.latitude);
      halfRadii_.push_back(sineCosine(c.r / diagram.radius / 2));
    }
  }

  std::optional<Error> run() {
    checkCounts();
    for (const HiddenCircle& h : diagram_.hidden) checkHidden(h);
    bearings_.resize(diagram_.vertices.size());
    isNearCenter_.resize(diagram_.vertices.size());
    for (std::size_t v = 0; v < diagram_.vertices.size() && !error_; ++v) {
      const Disc disc(diagram_, static_cast<std::int32_t>(v));
      checkVertex(disc);
      checkAround(disc);
    }
    if (diagram_.vertices.empty()) {
      for (const Edge& e : diagram_.edges) checkNeighbors(e);
    }
    if (!error_) checkCells();
    return std::move(error_);
  }

 private:
  /// The disc around a vertex.
  struct Disc {
    VertexIndex vertex;
    Axes axes;
    SineCosine halfDistance;  ///< as an angle

    Disc(const SphereDiagram& diagram, VertexIndex v)
        : vertex(v),
          axes(diagram.vertices[at(v)].longitude, diagram.vertices[at(v)].latitude),
          halfDistance(sineCosine(diagram.vertices[at(v)].distance / diagram.radius / 2)) {}
  };

  void refuse(CircleIndex cap, const char* why) {
    if (!error_) error_ = Error{ErrorCode::notCertified, cap, why};
  }

  const Cap& cap(CircleIndex i) const { return diagram_.caps[at(i)]; }

  /// Euler's formula.
  void checkCounts() {
    const std::size_t visible = diagram_.caps.size() - diagram_.hidden.size();
    const std::size_t vertices = visible < 3 ? 0 : 2 * visible - 4;
    const std::size_t edges = visible < 2 ? 0 : visible == 2 ? 1 : 3 * visible - 6;
    if (diagram_.vertices.size() != vertices || diagram_.edges.size() != edges) {
      refuse(0, "The numbers of vertices and edges contradict Euler's formula.");
    }
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < diagram_.caps.size(); ++i) {
      const auto index = static_cast<std::int32_t>(i);
      const bool isHidden = hidden < diagram_.hidden.size() && diagram_.hidden[hidden].circle == index;
      hidden += isHidden ? 1 : 0;
      const bool hasSides = diagram_.links.firstSide[i] != kNone;
      if (hasSides != (visible > 1 && !isHidden)) refuse(index, "A cap must be hidden or have sides.");
    }
  }

  void checkHidden(const HiddenCircle& hidden) {
    const double angle = sphere::viewOf(places_[hidden.circle], places_[hidden.by]).angle();
    const double reach = diagram_.radius * angle + cap(hidden.circle).r - cap(hidden.by).r;
    if (!diagram_.hasCell(hidden.by) || !(reach <= tolerance_)) refuse(hidden.circle, "A cap is not hidden as stated.");
  }

  /// Neither of two neighbors contains the other. If they have a vertex, they touch its disc in different directions.
  void checkNeighbors(const Edge& e) {
    const double angle = sphere::viewOf(places_[e.left], places_[e.right]).angle();
    if (!(diagram_.radius * angle - std::abs(cap(e.left).r - cap(e.right).r) >= -tolerance_)) {
      refuse(e.left, "One of two neighbors hides the other.");
    }
  }

  /// Returns the sine and the cosine of half the angle between a vertex and a cap that touches its disc.
  SineCosine halfTouch(CircleIndex i, const Disc& disc) const {
    const auto& [sine, cosine] = disc.halfDistance;
    const auto& [capSine, capCosine] = halfRadii_[at(i)];
    return {sine * capCosine + cosine * capSine, cosine * capCosine - sine * capSine};
  }

  /// Whether a cap reaches far into a disc.
  bool reachesFar(CircleIndex i, const Disc& disc) const {
    const SineCosine half = halfTouch(i, disc);
    const Vector3 toward = capAxes_[at(i)].up() - disc.axes.up();
    // In this range the chord, twice the sine of half the angle, grows at least half as fast as the angle.
    if (half.cosine >= 0.6 && std::sqrt(dot(toward, toward)) >= 2 * half.sine - kFar / 2) return false;
    return !(reach(i, disc.vertex) <= kFar * diagram_.radius);
  }

  /// Returns by how much a cap reaches into the disc of a vertex.
  double reach(CircleIndex i, VertexIndex v) const {
    const auto& [longitude, latitude, distance] = diagram_.vertices[at(v)];
    const double angle = sphere::viewOf(places_[i], sphere::placeAt(longitude, latitude)).angle();
    return distance + cap(i).r - diagram_.radius * angle;
  }

  void checkVertex(const Disc& disc) {
    const VertexIndex v = disc.vertex;
    const Axes& axes = disc.axes;
    const Vector3 place = axes.up();
    std::array<Vector3, 3> toward;
    std::array<double, 3> sizes{};
    bool isAtCenter = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const CircleIndex i = diagram_.vertexCaps[at(v)][k];
      const Axes& center = capAxes_[at(i)];
      const Vector3 up = center.up();
      toward[k] = up - place;
      const double chord = dot(toward[k], toward[k]);
      const Vector3 sum = up + place;
      // The sine of the angle, which is twice the product of the sine and the cosine of its half.
      sizes[k] = std::sqrt(chord * dot(sum, sum)) / 2;
      const SineCosine half = halfTouch(i, disc);
      // Beyond a right angle, half of it is known better from its cosine.
      const double miss = chord < 2 ? (std::sqrt(chord) - 2 * half.sine) / half.cosine
                                    : (std::sqrt(dot(sum, sum)) - 2 * half.cosine) / half.sine;
      if (!(std::abs(miss) <= angleTolerance_)) return refuse(i, "A vertex does not touch one of its caps.");
      // At the center of a cap, and opposite to it, all directions are equally right.
      if (!(sizes[k] > 4 * angleTolerance_)) isNearCenter_[at(v)][k] = isAtCenter = true;
      bearings_[at(v)][k] = pseudoAngle({-center.east(toward[k]), -center.north(toward[k])});
    }
    if (isAtCenter) return;
    std::array<Vector, 3> directions;
    for (std::size_t k = 0; k < 3; ++k) {
      directions[k] = {axes.east(toward[k]) / sizes[k], axes.north(toward[k]) / sizes[k]};
    }
    const auto& [a, b, c] = directions;
    if (cross({b.x - a.x, b.y - a.y}, {c.x - a.x, c.y - a.y}) >= 0) return;
    // Two caps in nearly the same direction nearly touch each other from inside: if they are moved by the tolerance,
    // they do.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const Vector step = {directions[l].x - directions[k].x, directions[l].y - directions[k].y};
      if (dot(step, step) * std::min(sizes[k], sizes[l]) <= 8 * angleTolerance_) return;
    }
    refuse(diagram_.vertexCaps[at(v)][0], "The caps of a vertex do not go around it counter-clockwise.");
  }

  /// No cap across an edge of a vertex reaches far into its disc. This follows from the other checks, but for vertices
  /// that depend on the last bits of their caps: what is right within the tolerance may be far from right there.
  void checkAround(const Disc& disc) {
    for (const SideIndex side : diagram_.links.vertexSides[at(disc.vertex)]) {
      const VertexIndex other = diagram_.targetOf(side);
      // The other vertex gives the same answer.
      if (other < disc.vertex) continue;
      const CircleIndex i = diagram_.circleOf(side);
      const CircleIndex beyond = thirdOf(other, i, diagram_.neighborOf(side));
      if (reachesFar(beyond, disc)) return refuse(i, "A cap reaches into the disc of a vertex.");
    }
  }

  /// Returns the position of a cap among those of a vertex.
  std::size_t positionOf(CircleIndex i, VertexIndex v) const { return positionIn(diagram_.vertexCaps[at(v)], i); }

  /// Returns the cap of a vertex that is not one of two.
  CircleIndex thirdOf(VertexIndex v, CircleIndex i, CircleIndex j) const {
    const auto& caps = diagram_.vertexCaps[at(v)];
    return *std::ranges::find_if(caps, [&](CircleIndex cap) { return cap != i && cap != j; });
  }

  void checkCells() {
    struct Turns {
      std::int32_t count = 0;
      std::int32_t ties = 0;
    };
    std::vector<Turns> turns(diagram_.caps.size());
    if (diagram_.vertices.empty()) return;
    for (SideIndex side = 0; side < static_cast<std::int32_t>(2 * diagram_.edges.size()); ++side) {
      const CircleIndex i = diagram_.circleOf(side);
      const VertexIndex start = diagram_.originOf(side);
      const VertexIndex end = diagram_.targetOf(side);
      const std::size_t atStart = positionOf(i, start);
      const std::size_t atEnd = positionOf(i, end);
      const double turn = bearings_[at(end)][atEnd] - bearings_[at(start)][atStart];
      const bool isWrapped = turn < 0;
      turns[at(i)].count += isWrapped ? 1 : 0;
      // More than half a turn forward, or a step back, which is right within the tolerance.
      if (turn + (isWrapped ? 4 : 0) <= 2) continue;
      const CircleIndex before = thirdOf(start, i, diagram_.neighborOf(side));
      const bool isNearCenter = isNearCenter_[at(start)][atStart] || isNearCenter_[at(end)][atEnd];
      if (isNearCenter || std::abs(reach(before, end)) <= tolerance_) ++turns[at(i)].ties;
    }
    for (std::size_t i = 0; i < turns.size(); ++i) {
      if (diagram_.links.firstSide[i] == kNone) continue;
      if (turns[i].count < 1 || turns[i].count - turns[i].ties > 1) {
        refuse(static_cast<std::int32_t>(i), "The sides of a cell do not go around its center once.");
      }
    }
  }

  const SphereDiagram& diagram_;
  const Places places_;
  const double tolerance_;
  const double angleTolerance_;
  /// The bearing of each vertex from its caps, in their order. It grows from 0 to 4 for a full turn.
  std::vector<std::array<double, 3>> bearings_;
  std::vector<std::array<bool, 3>> isNearCenter_;  ///< whether this bearing may be any
  std::vector<Axes> capAxes_;
  std::vector<SineCosine> halfRadii_;  ///< of the caps, as angles
  std::optional<Error> error_;
};

}  // namespace

bool SphereDiagram::hasCell(CircleIndex cap) const {
  const auto found = std::ranges::lower_bound(hidden, std::int32_t{cap}, {},
                                              [](const HiddenCircle& h) { return std::int32_t{h.circle}; });
  return found == hidden.end() || found->circle != cap;
}

Result<void> checkSphere(const SphereDiagram& diagram) {
  return guarded([&]() -> Result<void> {
    if (!fits(diagram)) return Error{ErrorCode::badInput, kNone, "The parts of the diagram do not fit together."};
    if (auto error = SphereJudge(diagram).run()) return *std::move(error);
    return {};
  });
}

}  // namespace circle_voronoi
