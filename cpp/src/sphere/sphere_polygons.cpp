// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/sphere.h"
#include "degree_rings.h"
#include "flatten.h"
#include "guarded.h"
#include "number_text.h"
#include "sphere_cell.h"
#include "valid_polygons.h"

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

/// Edges of cells whose polygons would cross themselves are followed more closely: within 2^-6 of the tolerance at
/// level 1, and so on, up to level 2, and no closer than a part of the distance from the center.
constexpr int kMostLevels = 2;
constexpr double kFinestPart = 0x1p-16;
constexpr int kLevelBits = 6;

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
  /// `share`: the part of the tolerance that is used, and of the usual deviation near the center.
  Sampler(const Place& center, double tolerance, double share)
      : center_(center), tolerance_(tolerance / kDegree), share_(share) {}

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
      if (!isStraight(a, b, {between(side, a, middle), middle, between(side, middle, b)})) {
        refine(side, a, middle, points, halvings + 1);
        refine(side, middle, b, points, halvings + 1);
        return;
      }
    }
    points.push_back(b.degrees);
  }

  /// The tolerance of a piece at level 0, in degrees: near the center the cell may be much smaller than the tolerance.
  double usualOf(const BorderPoint& a, const BorderPoint& b) const {
    return std::min(tolerance_, distanceOf(a, b) / 16);
  }

  double leastOf(const BorderPoint& a, const BorderPoint& b) const {
    const double usual = usualOf(a, b);
    return std::max(share_ * usual, std::min(usual, kFinestPart * distanceOf(a, b)));
  }

  /// The distance of a piece from the center, in degrees.
  static double distanceOf(const BorderPoint& a, const BorderPoint& b) { return std::min(a.angle, b.angle) / kDegree; }

  bool isNear(const BorderPoint& a, const BorderPoint& b) const {
    const double across = std::abs(b.bearing - a.bearing) * sineCosine(std::max(a.angle, b.angle)).sine;
    return (std::abs(b.angle - a.angle) + across) / kDegree <= usualOf(a, b) / 1024;
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

  /// Whether the points between lie near enough to the segment from a to b.
  bool isStraight(const BorderPoint& a, const BorderPoint& b, const std::array<BorderPoint, 3>& points) const {
    const double tolerance = leastOf(a, b);
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
  double share_;
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
        tolerance_(options.tolerance.value_or(kSphereTolerance * diagram.radius) / diagram.radius),
        maxDistance_(options.maxDistance),
        levels_(diagram.caps.size(), kUnknown),
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
    for (const degrees::Polygon& polygon : polygonsOf(cap)) {
      for (const degrees::Ring& ring : polygon) {
        result.points.insert(result.points.end(), ring.begin(), ring.end());
        result.pointOffsets.push_back(static_cast<std::int32_t>(result.points.size()));
      }
      result.ringOffsets.push_back(static_cast<std::int32_t>(result.pointOffsets.size() - 1));
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

  using Polygons = std::vector<degrees::Polygon>;

  /// Returns the polygons of a cell. If rounding alone makes rings cross, they are divided where they do.
  Polygons polygonsOf(CircleIndex cap) {
    const sphere::Reach reach = sphere::reachOf(diagram_, cap, maxDistance_);
    if (!diagram_.hasCell(cap) || (reach.angle && !(*reach.angle > 0))) return {};
    bool isRaised = levelOf(cap) > 0;
    for (const SideIndex side : diagram_.sides(cap)) isRaised = isRaised || levelOf(diagram_.neighborOf(side)) > 0;
    const degrees::Ring ring = ringOf(cap, reach, isRaised ? std::nullopt : std::optional<int>(0));
    if (auto polygons = validOf(cap, ring)) return *std::move(polygons);
    std::vector<degrees::Ring> rings;
    for (degrees::Polygon& polygon : degrees::polygonsOf(ring)) {
      for (degrees::Ring& outline : polygon) rings.push_back(std::move(outline));
    }
    // A ring that turns the wrong way around for rounding is no hole in the whole.
    if (rings.size() == 2 && degrees::isWhole(rings.front()) && !isInCell(cap, sphere::placeAt(-180, 0)))
      rings.erase(rings.begin());
    const auto united = Region::fromRings(rings, {.dissolve = true});
    return united ? rowsOf(*united) : Polygons();
  }

  /// Returns how closely the edges of a cell must be followed, so that its polygons do not cross themselves; 0 if no
  /// level is close enough. This depends on the cell alone, and edges are followed as closely as both their cells need.
  int levelOf(CircleIndex cap) {
    int& level = levels_[at(cap)];
    if (level != kUnknown) return level;
    const sphere::Reach reach = sphere::reachOf(diagram_, cap, maxDistance_);
    level = 0;
    if (reach.angle && !(*reach.angle > 0)) return level;
    while (level <= kMostLevels && !validOf(cap, ringOf(cap, reach, level))) ++level;
    if (level > kMostLevels) level = 0;
    return level;
  }

  /// Returns the polygons of a ring; nothing if they cross themselves, or are not those of the cell.
  std::optional<Polygons> validOf(CircleIndex cap, const degrees::Ring& ring) const {
    const Cap& c = diagram_.caps[at(cap)];
    Polygons polygons = degrees::polygonsOf(ring);
    const auto cutCount = polygons.size();
    if (cutCount == 0) return polygons;
    // Around both poles there is a hole.
    const bool hasHole = polygons.front().size() > 1;
    if (hasHole && !isInCell(cap, sphere::placeAt(-180, 0))) return std::nullopt;
    if (cutCount == 1 && !hasHole && isStarShaped(polygons[0][0], {sphere::wrapped(c.longitude), c.latitude})) {
      return polygons;
    }
    Polygons valid;
    for (degrees::Polygon& polygon : polygons) {
      std::vector<PointLoop> loops;
      for (degrees::Ring& outline : polygon) loops.push_back({std::move(outline), !loops.empty()});
      for (auto& part : validPolygons(std::move(loops))) valid.push_back(std::move(part));
    }
    if (!valid.empty() && !Region::fromPolygons(valid)) return std::nullopt;
    return valid;
  }

  /// Whether a ring turns left around a point everywhere, and once.
  static bool isStarShaped(const degrees::Ring& ring, Point center) {
    int crossings = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = ring[k];
      const Point q = ring[k + 1 == ring.size() ? 0 : k + 1];
      if (!isLeftTurn(center, p, q)) return false;
      crossings += p.y < center.y && q.y >= center.y ? 1 : 0;
    }
    return crossings == 1;
  }

  /// Whether a place is in a cell: no neighbor is nearer.
  bool isInCell(CircleIndex cap, const Place& place) const {
    const auto distance = [&](CircleIndex i) {
      return sphere::viewOf(places_[i], place).angle() - diagram_.caps[at(i)].r / diagram_.radius;
    };
    const auto isNearer = [&](CircleIndex neighbor) { return distance(neighbor) < distance(cap); };
    return std::ranges::none_of(neighbors(diagram_, cap), isNearer);
  }

  static Polygons rowsOf(const Region& region) {
    const auto index = [](std::int32_t i) { return static_cast<std::size_t>(i); };
    Polygons polygons;
    for (std::size_t p = 0; p < region.polygonCount(); ++p) {
      polygons.emplace_back();
      for (std::size_t ring = index(region.polygonOffsets()[p]); ring < index(region.polygonOffsets()[p + 1]); ++ring) {
        const auto points = region.points().subspan(index(region.ringOffsets()[ring]),
                                                    index(region.ringOffsets()[ring + 1] - region.ringOffsets()[ring]));
        polygons.back().emplace_back(points.begin(), points.end());
      }
    }
    return polygons;
  }

  /// Returns the outline of a cell in degrees, at a level, or at the level of each edge; no points if it is the whole
  /// sphere.
  degrees::Ring ringOf(CircleIndex cap, const sphere::Reach& reach, std::optional<int> level) {
    const Sampler sampler = samplerOf(cap, level ? *level : levelOf(cap));
    CellSide circle;
    circle.border.offset = reach.cotangent().value_or(0);
    degrees::Ring ring;
    const std::vector<Placed> pieces = placed(cap, reach, level);
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
  std::vector<Placed> placed(CircleIndex cap, const sphere::Reach& reach, std::optional<int> level) {
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
      const CircleIndex other = diagram_.neighborOf(side.side);
      const std::vector<Piece>& pieces =
          piecesOf(SphereDiagram::edgeOf(side.side), level ? *level : std::max(levelOf(cap), levelOf(other)));
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

  /// Returns the pieces of an edge. At level 0, all edges of its left cap are followed together.
  const std::vector<Piece>& piecesOf(EdgeIndex edge, int level) {
    const CircleIndex left = diagram_.edges[at(edge)].left;
    const Sampler sampler = samplerOf(left, level);
    const sphere::Reach reach = sphere::reachOf(diagram_, left, maxDistance_);
    if (level == 0) {
      if (!isFollowed_[at(left)]) {
        forEachEdgeOf(left,
                      [&](EdgeIndex its, const CellSide& side) { pieces_[at(its)] = followed(side, sampler, reach); });
      }
      isFollowed_[at(left)] = true;
      return pieces_[at(edge)];
    }
    const auto [pieces, isNew] = raised_.try_emplace({edge, level});
    if (isNew) pieces->second = followed(raisedSideOf(edge), sampler, reach);
    return pieces->second;
  }

  /// Calls use(edge, its side) for each edge with a cap on its left.
  template <class Use>
  void forEachEdgeOf(CircleIndex left, Use use) const {
    for (const CellSide& side : sphere::sidesOf(diagram_, places_, left)) {
      if (side.side % 2 == 0) use(SphereDiagram::edgeOf(side.side), side);
    }
  }

  /// Returns the left side of an edge. The sides of its cell are kept, for many edges of a large one may be raised.
  const CellSide& raisedSideOf(EdgeIndex edge) {
    if (!raisedSides_.contains(edge)) {
      forEachEdgeOf(diagram_.edges[at(edge)].left,
                    [&](EdgeIndex its, const CellSide& side) { raisedSides_[its] = side; });
    }
    return raisedSides_.at(edge);
  }

  std::vector<Piece> followed(const CellSide& side, const Sampler& sampler, const sphere::Reach& reach) const {
    const auto endOf = [&](double bearing, VertexIndex vertex) {
      const double cotangent = side.cotangentAt(bearing);
      if (vertex == kNone) return sampler.pointOf(side, bearing, cotangent);
      return BorderPoint{bearing, angleOf(1, cotangent), points_[at(vertex)]};
    };
    std::vector<Piece> pieces;
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
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  Sampler samplerOf(CircleIndex cap, int level) const {
    return {places_[cap], tolerance_, std::ldexp(1.0, -kLevelBits * level)};
  }

  static constexpr int kUnknown = -1;

  const SphereDiagram& diagram_;
  const Places places_;
  const double tolerance_;  ///< an angle
  const std::optional<double> maxDistance_;
  std::vector<int> levels_;  ///< of each cap, or kUnknown
  std::vector<bool> isFollowed_;
  std::vector<std::vector<Piece>> pieces_;                             ///< of each edge at level 0, in its direction
  std::map<std::pair<std::int32_t, int>, std::vector<Piece>> raised_;  ///< of some edges at other levels
  std::map<std::int32_t, CellSide> raisedSides_;                       ///< of these edges, and others of their cells
  std::vector<Point> points_;                                          ///< of each vertex, in degrees
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
