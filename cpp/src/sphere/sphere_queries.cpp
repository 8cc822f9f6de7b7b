// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

#include "at.h"
#include "bucket_grid.h"
#include "circle_voronoi/sphere.h"
#include "hidden_sentence.h"
#include "place.h"

namespace circle_voronoi {
namespace {

using sphere::Place;
using sphere::Places;

double distanceTo(const SphereDiagram& diagram, const Places& places, CircleIndex cap, const Place& place) {
  return diagram.radius * sphere::viewOf(places[cap], place).angle() - diagram.caps[at(cap)].r;
}

/// Whether a point where two caps are equally far lies on an edge between them: at a bearing between those of its ends,
/// and no nearer to the caps beyond the ends.
bool isBetween(const SphereDiagram& diagram, const Places& places, const Edge& edge, Point p) {
  const Place place = sphere::placeAt(p.x, p.y);
  const double distance = distanceTo(diagram, places, edge.left, place);
  for (const VertexIndex v : {edge.start, edge.end}) {
    for (const CircleIndex cap : diagram.vertexCaps[at(v)]) {
      if (distanceTo(diagram, places, cap, place) < distance - sphere::toleranceOf(diagram)) return false;
    }
  }
  const auto bearingOf = [&](double longitude, double latitude) {
    return pseudoAngle(sphere::viewOf(places[edge.left], sphere::placeAt(longitude, latitude)).vector);
  };
  const auto bearingOfVertex = [&](VertexIndex v) {
    return bearingOf(diagram.vertices[at(v)].longitude, diagram.vertices[at(v)].latitude);
  };
  const auto from = bearingOfVertex(edge.start);
  const auto turn = [&](double bearing) { return bearing < from ? bearing - from + 4 : bearing - from; };
  return turn(bearingOf(p.x, p.y)) <= turn(bearingOfVertex(edge.end));
}

}  // namespace

std::vector<CircleIndex> neighbors(const SphereDiagram& diagram, CircleIndex cap) {
  std::vector<CircleIndex> result;
  for (const SideIndex side : diagram.sides(cap)) result.push_back(diagram.neighborOf(side));
  return result;
}

double distanceFrom(const SphereDiagram& diagram, CircleIndex cap, double longitude, double latitude) {
  const Cap& c = diagram.caps[at(cap)];
  const Place center = sphere::placeAt(c.longitude, c.latitude);
  return diagram.radius * sphere::viewOf(center, sphere::placeAt(longitude, latitude)).angle() - c.r;
}

class SphereFinder::Walker {
 public:
  explicit Walker(const SphereDiagram& diagram) : diagram_(diagram), places_(diagram) {
    std::vector<BucketGrid::Item> starts;
    for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
      const auto cap = static_cast<std::int32_t>(i);
      if (diagram.hasCell(cap)) starts.push_back({{places_[cap].longitude, places_[cap].latitude}, cap});
    }
    if (!starts.empty()) starts_ = BucketGrid(starts);
  }

  CircleIndex find(double longitude, double latitude) const {
    const Place place = sphere::placeAt(longitude, latitude);
    const CircleIndex start = starts_.near({place.longitude, place.latitude}, 0, [](CircleIndex) { return true; });
    if (start == kNone) return kNone;
    Near nearest = {start, distanceTo(diagram_, places_, start, place)};
    const double tolerance = sphere::toleranceOf(diagram_);
    for (;;) {
      // The distance decreases with each step, so that the walk ends.
      const Near next = nearestAround(nearest, tolerance, place);
      const bool isDone = next.distance >= nearest.distance - tolerance;
      nearest = next;
      if (isDone) return nearest.cap;
    }
  }

 private:
  struct Near {
    CircleIndex cap;
    double distance;
  };

  /// Returns the nearest among a cap and its neighbors. If none is nearer by more than the tolerance, this goes on with
  /// neighbors that are as near: one of two caps at nearly the same place may be the only way to the other's neighbors,
  /// and no nearer up to rounding.
  Near nearestAround(const Near& from, double tolerance, const Place& place) const {
    Near nearest = from;
    std::vector<CircleIndex> tied = {from.cap};
    std::unordered_set<std::int32_t> known;
    for (std::size_t k = 0; k < tied.size() && nearest.distance >= from.distance - tolerance; ++k) {
      const CircleIndex around = tied[k];
      for (const SideIndex side : diagram_.sides(around)) {
        const CircleIndex cap = diagram_.neighborOf(side);
        const double distance = distanceTo(diagram_, places_, cap, place);
        if (distance < nearest.distance) nearest = {cap, distance};
        if (std::abs(distance - from.distance) > tolerance || cap == from.cap) continue;
        if (known.insert(cap).second) tied.push_back(cap);
      }
    }
    return nearest;
  }

  const SphereDiagram& diagram_;
  Places places_;
  BucketGrid starts_;  ///< by degrees
};

SphereFinder::SphereFinder(const SphereDiagram& diagram) : walker_(std::make_unique<Walker>(diagram)) {}
SphereFinder::SphereFinder(SphereFinder&&) noexcept = default;
SphereFinder& SphereFinder::operator=(SphereFinder&&) noexcept = default;
SphereFinder::~SphereFinder() = default;

CircleIndex SphereFinder::find(double longitude, double latitude) const { return walker_->find(longitude, latitude); }

std::optional<FarthestPlace> farthestPlace(const SphereDiagram& diagram) {
  if (diagram.caps.empty()) return std::nullopt;
  const Places places(diagram);
  std::optional<FarthestPlace> best;
  const auto offer = [&](const SphereVertex& place, const std::array<CircleIndex, 3>& caps) {
    if (!best || place.distance > best->place.distance) best = FarthestPlace{place, caps};
  };
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) offer(diagram.vertices[v], diagram.vertexCaps[v]);
  if (diagram.edges.empty()) {
    CircleIndex only = 0;
    while (!diagram.hasCell(only)) ++only;
    const Place& center = places[only];
    offer({sphere::wrapped(center.longitude + 180), -center.latitude, diagram.radius * kPi - diagram.caps[at(only)].r},
          {only, kNone, kNone});
  }
  // The distance along an edge grows from its point between the caps to the opposite point.
  for (const Edge& edge : diagram.edges) {
    const auto& [left, right, start, end] = edge;
    const sphere::Border border = places.border(left, right);
    const double amplitude = length(border.vector);
    const double angle = angleOf(1, border.offset - amplitude);
    const double distance = diagram.radius * angle - diagram.caps[at(left)].r;
    if (distance <= (best ? best->place.distance : -4 * diagram.radius)) continue;
    const Vector direction =
        amplitude > 0 ? Vector{-border.vector.x / amplitude, -border.vector.y / amplitude} : Vector{1, 0};
    const Point p = sphere::pointAt(places[left], direction, sphere::arcOf(border.offset - amplitude));
    if (start != kNone && !isBetween(diagram, places, edge, p)) continue;
    offer({p.x, p.y, distance}, {edge.left, edge.right, kNone});
  }
  return best;
}

std::optional<ClosestPair> closestPair(const SphereDiagram& diagram) {
  const Places places(diagram);
  std::optional<ClosestPair> best;
  for (const Edge& e : diagram.edges) {
    const double angle = sphere::viewOf(places[e.left], places[e.right]).angle();
    const double gap = diagram.radius * angle - diagram.caps[at(e.left)].r - diagram.caps[at(e.right)].r;
    if (!best || gap < best->gap) best = ClosestPair{std::min(e.left, e.right), std::max(e.left, e.right), gap};
  }
  return best;
}

std::string hiddenWarning(const SphereDiagram& diagram) {
  return hiddenSentence(diagram.hidden.size(), diagram.caps.size(), "another unit than the radius of the sphere");
}

}  // namespace circle_voronoi
