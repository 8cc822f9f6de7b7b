// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/sphere.h"
#include "degree_rings.h"
#include "guarded.h"
#include "number_text.h"
#include "sphere_cell.h"

namespace circle_voronoi {
namespace {

using sphere::CellPart;
using sphere::CellSide;
using sphere::Place;
using sphere::Places;

/// Steps deviate by less than this part of their length, so that sides with a small angle between them do not cross.
constexpr double kStraightness = 64;
/// A piece of a border is split this many times, at most.
constexpr int kMostSplits = 48;

/// Bearings that differ by less are the same up to rounding.
constexpr double kSameBearing = 1e-13;

/// The place on a border, or on a circle, at a bearing as in CellSide.
struct BorderPoint {
  double bearing = 0;
  double angle = 0;
  Point degrees;
};

/// Follows borders and circles around a center in steps that are straight in degrees, within a tolerance.
class Sampler {
 public:
  Sampler(const Place& center, double tolerance) : center_(center), tolerance_(tolerance / kDegree) {}

  /// Appends the points after `from`, to `to`, of the curve whose cotangent at a bearing is `side.cotangentAt`.
  void follow(const CellSide& side, BorderPoint from, const BorderPoint& to, std::vector<Point>& points) const {
    // The curve is followed from one to the next of: its nearest and farthest points, the points between them, and the
    // bearings of the poles.
    std::vector<double> stops;
    const auto addEvery = [&](double step, double first) {
      for (double k = std::floor((from.bearing - first) / step) + 1; first + k * step < to.bearing; ++k) {
        stops.push_back(first + k * step);
      }
    };
    addEvery(kPi / 4, 0);
    addEvery(kPi, kPi / 2 - side.bearing);
    std::ranges::sort(stops);
    for (const double stop : stops) {
      if (stop - from.bearing < kSameBearing || to.bearing - stop < kSameBearing) continue;
      const BorderPoint next = pointOf(side, stop, side.cotangentAt(stop));
      refine(side, from, next, points, 0);
      from = next;
    }
    refine(side, from, to, points, 0);
  }

  BorderPoint pointOf(const CellSide& side, double bearing, double cotangent) const {
    const double east = side.bearing + bearing;
    SineCosine direction = sineCosine(east);
    // Toward a pole exactly, so that the curve meets it exactly.
    const double quarters = std::floor(east / (kPi / 2) + 0.5);
    if (std::abs(east - quarters * (kPi / 2)) < 4e-15) {
      direction = sineCosineOfDegrees(90 * quarters);
    }
    const Point p = sphere::pointAt(center_, {direction.cosine, direction.sine}, sphere::arcOf(cotangent));
    return {bearing, angleOf(1, cotangent), degrees::snapped(p)};
  }

 private:
  void refine(const CellSide& side, const BorderPoint& a, const BorderPoint& b, std::vector<Point>& points,
              int halvings) const {
    if (halvings < kMostSplits && !isNear(a, b)) {
      const BorderPoint middle = between(side, a, b);
      // Near the center the cell may be much smaller than the tolerance.
      const double tolerance = std::min(tolerance_, std::min(a.angle, b.angle) / (16 * kDegree));
      if (!isStraight(a, b, {between(side, a, middle), middle, between(side, middle, b)}, tolerance)) {
        refine(side, a, middle, points, halvings + 1);
        refine(side, middle, b, points, halvings + 1);
        return;
      }
    }
    points.push_back(b.degrees);
  }

  bool isNear(const BorderPoint& a, const BorderPoint& b) const {
    const double across = std::abs(b.bearing - a.bearing) * sineCosine(std::max(a.angle, b.angle)).sine;
    const double least = std::min(tolerance_, std::min(a.angle, b.angle) / (16 * kDegree));
    return (std::abs(b.angle - a.angle) + across) / kDegree <= least / 1024;
  }

  /// A point of a curve between two: half way by bearing, or by angle where this changes faster.
  BorderPoint between(const CellSide& side, const BorderPoint& a, const BorderPoint& b) const {
    const double least = std::min(sineCosine(a.angle).sine, sineCosine(b.angle).sine);
    if (std::abs(a.angle - b.angle) > 2 * std::abs(a.bearing - b.bearing) * least && side.amplitude > 0) {
      const SineCosine arc = sineCosine((a.angle + b.angle) / 2);
      const double cotangent = arc.cosine / arc.sine;
      const double cosine = std::clamp((cotangent - side.border.offset) / side.amplitude, -1.0, 1.0);
      const double size = angleOf(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
      // The bearings are on one side of the nearest point.
      const double middle = (a.bearing + b.bearing) / 2;
      const double turns = std::floor(middle / (2 * kPi) + 0.5);
      const double bearing = 2 * kPi * turns + (middle < 2 * kPi * turns ? -size : size);
      if ((bearing - a.bearing) * (b.bearing - bearing) > 0) return pointOf(side, bearing, cotangent);
    }
    const double bearing = (a.bearing + b.bearing) / 2;
    return pointOf(side, bearing, side.cotangentAt(bearing));
  }

  /// Whether the points between lie within a tolerance of the segment from a to b.
  static bool isStraight(const BorderPoint& a, const BorderPoint& b, const std::array<BorderPoint, 3>& points,
                         double tolerance) {
    const auto step = [&](Point p, Point q) {
      const double turn = degrees::isPole(p) || degrees::isPole(q) ? 0 : degrees::turn(p.x, q.x);
      return Vector{turn, q.y - p.y};
    };
    const Vector whole = step(a.degrees, b.degrees);
    return std::ranges::all_of(points, [&](const BorderPoint& point) {
      const Vector part = step(a.degrees, point.degrees);
      const double scale = sineCosineOfDegrees(point.degrees.y).cosine;
      const Vector along = {whole.x * scale, whole.y};
      const Vector toPoint = {part.x * scale, part.y};
      const double square = dot(along, along);
      const double share = square > 0 ? std::clamp(dot(along, toPoint) / square, 0.0, 1.0) : 0;
      return length({toPoint.x - share * along.x, toPoint.y - share * along.y}) <=
             std::min(tolerance, std::sqrt(square) / kStraightness);
    });
  }

  Place center_;
  double tolerance_;  ///< in degrees
};

/// A part of an edge that a maximum distance leaves, with its ends.
struct Piece {
  std::vector<Point> points;
  bool startsAtVertex = true;
  bool endsAtVertex = true;
};

Piece reversed(const Piece& piece) {
  return {{piece.points.rbegin(), piece.points.rend()}, piece.endsAtVertex, piece.startsAtVertex};
}

class CellPolygons {
 public:
  CellPolygons(const SphereDiagram& diagram, const SpherePolygonOptions& options)
      : diagram_(diagram),
        places_(diagram),
        tolerance_(options.tolerance.value_or(diagram.radius * 1e-5) / diagram.radius),
        maxDistance_(options.maxDistance),
        isFollowed_(diagram.caps.size()),
        pieces_(diagram.edges.size()) {
    // Vertices of one place are one point, for rounding could turn the edges between them.
    points_.reserve(diagram.vertices.size());
    for (const SphereVertex& v : diagram.vertices) points_.push_back(degrees::snapped({v.longitude, v.latitude}));
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      for (const Edge& e : diagram.edges) {
        if (e.start == kNone) continue;
        Point& p = points_[at(e.start)];
        Point& q = points_[at(e.end)];
        if (p == q || !degrees::isSame(p, q)) continue;
        const bool isFirst = std::pair(p.x, p.y) < std::pair(q.x, q.y);
        (isFirst ? q : p) = isFirst ? p : q;
        isChanged = true;
      }
    }
  }

  /// Appends the row of a cell.
  void add(CircleIndex cap, ClippedPolygons& result) {
    const sphere::Reach reach = sphere::reachOf(diagram_, cap, maxDistance_);
    if (diagram_.hasCell(cap) && !(reach.angle && !(*reach.angle > 0))) {
      for (const degrees::Polygon& polygon : degrees::polygonsOf(ringOf(cap, reach))) {
        for (const degrees::Ring& ring : polygon) {
          result.points.insert(result.points.end(), ring.begin(), ring.end());
          result.pointOffsets.push_back(static_cast<std::int32_t>(result.points.size()));
        }
        result.ringOffsets.push_back(static_cast<std::int32_t>(result.pointOffsets.size() - 1));
      }
    }
    result.polygonOffsets.push_back(static_cast<std::int32_t>(result.ringOffsets.size() - 1));
  }

 private:
  /// A piece of the outline of a cell, with the bearings of its ends.
  struct Placed {
    Piece piece;
    BorderPoint start;
    BorderPoint end;
  };

  /// Returns the outline of a cell in degrees; no points if it is the whole sphere.
  degrees::Ring ringOf(CircleIndex cap, const sphere::Reach& reach) {
    const Sampler sampler(places_[cap], tolerance_);
    CellSide circle;
    circle.border.offset = reach.cotangent().value_or(0);
    degrees::Ring ring;
    const std::vector<Placed> pieces = placed(cap, reach);
    if (pieces.empty()) {
      if (!reach.angle) return ring;
      const BorderPoint start = sampler.pointOf(circle, 0, circle.border.offset);
      sampler.follow(circle, start, {2 * kPi, start.angle, start.degrees}, ring);
      return ring;
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto& [piece, start, end] = pieces[k];
      ring.insert(ring.end(), piece.points.begin(), piece.points.end());
      const bool isLast = k + 1 == pieces.size();
      Placed next = pieces[isLast ? 0 : k + 1];
      if (piece.endsAtVertex && next.piece.startsAtVertex) continue;
      if (isLast) next.start.bearing += 2 * kPi;
      sampler.follow(circle, end, next.start, ring);
    }
    return ring;
  }

  /// Returns the pieces of all sides of a cell, in order.
  std::vector<Placed> placed(CircleIndex cap, const sphere::Reach& reach) {
    std::vector<Placed> result;
    double toEast = 0;
    double before = 0;
    const std::vector<CellSide> sides = sphere::sidesOf(diagram_, places_, cap);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const CellSide& side = sides[s];
      // From side to side, bearings go on.
      toEast = s == 0 ? side.bearing : before - side.from;
      before = toEast + side.to;
      std::vector<CellPart> parts = sphere::partsOf(side, reach.cotangent());
      std::erase_if(parts, [](const CellPart& part) { return part.isOnCircle; });
      const CircleIndex left = diagram_.circleOf(side.side - side.side % 2);
      if (!isFollowed_[at(left)]) follow(left);
      const std::vector<Piece>& pieces = pieces_[at(SphereDiagram::edgeOf(side.side))];
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Piece piece = side.side % 2 == 0 ? pieces[k] : reversed(pieces[pieces.size() - 1 - k]);
        // By rounding alone, a piece may have a length from one side only.
        const CellPart part = k < parts.size() ? parts[k] : CellPart{};
        const double angle = reach.angle.value_or(0);
        result.push_back({piece,
                          {toEast + (piece.startsAtVertex ? side.from : part.from), angle, piece.points.front()},
                          {toEast + (piece.endsAtVertex ? side.to : part.to), angle, piece.points.back()}});
      }
    }
    return result;
  }

  /// Finds the pieces of the edges that have a cap to their left.
  void follow(CircleIndex cap) {
    isFollowed_[at(cap)] = true;
    const Sampler sampler(places_[cap], tolerance_);
    const sphere::Reach reach = sphere::reachOf(diagram_, cap, maxDistance_);
    for (const CellSide& side : sphere::sidesOf(diagram_, places_, cap)) {
      if (side.side % 2 == 1) continue;
      const auto endOf = [&](double bearing, VertexIndex vertex) {
        const double cotangent = side.cotangentAt(bearing);
        if (vertex == kNone) return sampler.pointOf(side, bearing, cotangent);
        return BorderPoint{bearing, angleOf(1, cotangent), points_[at(vertex)]};
      };
      for (const CellPart& part : sphere::partsOf(side, reach.cotangent())) {
        if (part.isOnCircle) continue;
        Piece piece;
        piece.startsAtVertex = part.from == side.from;
        piece.endsAtVertex = part.to == side.to;
        const BorderPoint start =
            endOf(part.from, piece.startsAtVertex ? diagram_.originOf(side.side) : VertexIndex(kNone));
        BorderPoint end = endOf(part.to, piece.endsAtVertex ? diagram_.targetOf(side.side) : VertexIndex(kNone));
        // A border without vertices ends where it starts.
        if (part.to - part.from == 2 * kPi) end.degrees = start.degrees;
        piece.points.push_back(start.degrees);
        sampler.follow(side, start, end, piece.points);
        pieces_[at(SphereDiagram::edgeOf(side.side))].push_back(std::move(piece));
      }
    }
  }

  const SphereDiagram& diagram_;
  const Places places_;
  const double tolerance_;  ///< an angle
  const std::optional<double> maxDistance_;
  std::vector<bool> isFollowed_;
  std::vector<std::vector<Piece>> pieces_;  ///< of each edge, in its direction
  std::vector<Point> points_;               ///< of each vertex, in degrees
};

}  // namespace

Result<ClippedPolygons> cellPolygons(const SphereDiagram& diagram, std::span<const CircleIndex> caps,
                                     const SpherePolygonOptions& options) {
  return guarded([&]() -> Result<ClippedPolygons> {
    const double tolerance = options.tolerance.value_or(diagram.radius);
    if (!(tolerance > 0 && std::isfinite(tolerance))) {
      return Error{ErrorCode::badOption, kNone,
                   "The tolerance must be a positive number (got " + numberText(tolerance) + ")."};
    }
    if (!std::isfinite(options.maxDistance.value_or(0))) {
      return Error{ErrorCode::badOption, kNone, "The maximum distance must be a finite number."};
    }
    CellPolygons polygons(diagram, options);
    ClippedPolygons result;
    for (const CircleIndex cap : caps) polygons.add(cap, result);
    return result;
  });
}

Result<ClippedPolygons> cellPolygons(const SphereDiagram& diagram, const SpherePolygonOptions& options) {
  return guarded([&] {
    std::vector<CircleIndex> all(diagram.caps.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
    return cellPolygons(diagram, all, options);
  });
}

}  // namespace circle_voronoi
