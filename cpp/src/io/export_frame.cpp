// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cell_limits.h"
#include "checks.h"
#include "clip_parts.h"
#include "infinity.h"
#include "unbounded_cell.h"

namespace circle_voronoi {
namespace {

/// The smallest margin, as a share of the farthest coordinate.
constexpr double kLeastMargin = 0x1p-50;
constexpr double kMargin = 0.05;
constexpr double kTolerance = 1e-5;

double sizeOf(const Box& box) { return std::max(box.maxX - box.minX, box.maxY - box.minY); }

double toleranceOf(const Box& box, const ExportOptions& options) {
  return options.tolerance ? *options.tolerance : kTolerance * sizeOf(box);
}

Box boxOf(const Diagram& diagram, const ExportOptions& options) {
  if (options.region != nullptr) return options.region->bounds();
  return options.bounds ? *options.bounds : exportBox(diagram, options.maxDistance);
}

DecimalGrid gridOf(const Diagram& diagram, const ExportOptions& options) {
  if (options.digits) return DecimalGrid(options.digits);
  return DecimalGrid(kRoundingShare * toleranceOf(boxOf(diagram, options), options));
}

/// With digits the default box grows to points of the grid.
Box boxOf(const Diagram& diagram, const ExportOptions& options, const DecimalGrid& grid) {
  const Box box = boxOf(diagram, options);
  if (options.bounds || options.region != nullptr || !options.digits) return box;
  const double half = grid.error() / 2;
  return {grid.round(box.minX - half), grid.round(box.minY - half), grid.round(box.maxX + half),
          grid.round(box.maxY + half)};
}

}  // namespace

Box exportBox(std::span<const Circle> circles, std::optional<double> maxDistance) {
  if (circles.empty()) return {0, 0, 1, 1};
  const auto reach = [&](auto coordinate) { return std::ranges::max(circles, {}, coordinate); };
  // A circle of negative radius is drawn as a point.
  const auto size = [&](const Circle& c) { return std::max({c.r, c.r + maxDistance.value_or(0), 0.0}); };
  const auto right = [&](const Circle& c) { return c.x + size(c); };
  const auto left = [&](const Circle& c) { return -(c.x - size(c)); };
  const auto top = [&](const Circle& c) { return c.y + size(c); };
  const auto bottom = [&](const Circle& c) { return -(c.y - size(c)); };
  Box box = {-left(reach(left)), -bottom(reach(bottom)), right(reach(right)), top(reach(top))};
  const double farthest = std::max({-box.minX, -box.minY, box.maxX, box.maxY});
  // Large enough not to be lost in rounding.
  const double margin = std::max(sizeOf(box) > 0 ? kMargin * sizeOf(box) : 1, kLeastMargin * farthest);
  return {box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin};
}

Box exportBox(const Diagram& diagram, std::optional<double> maxDistance) {
  if (diagram.metric != Metric::power || !maxDistance) return exportBox(diagram.circles, maxDistance);
  std::vector<Circle> discs = diagram.circles;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    discs[i].r = std::max(discs[i].r, reachFrom(diagram, static_cast<std::int32_t>(i), *maxDistance));
  }
  return exportBox(discs);
}

Result<Region> exportRegion(const Diagram& diagram, const ExportOptions& options) {
  if (auto checked = checkVertices(diagram); !checked) return checked.error();
  if (!diagram.certificate.certified()) {
    return Error{ErrorCode::notCertified, diagram.certificate.circle,
                 "The diagram is not certified: " + diagram.certificate.message};
  }
  if (auto checked = checkDigits(options.digits); !checked) return checked.error();
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance))) {
    return errorWith(ErrorCode::badOption, "The tolerance must be finite and positive.");
  }
  if (auto checked = checkMaxDistance(options.maxDistance); !checked) return checked.error();
  if (options.attributes != nullptr) {
    if (auto checked = checkAttributes(*options.attributes, diagram.circles.size()); !checked) return checked.error();
  }
  if (options.region != nullptr && options.bounds) {
    return errorWith(ErrorCode::badOption, "Cells are clipped to a box or to a region, not to both.");
  }
  if (options.region != nullptr) return *options.region;
  return Region::from(boxOf(diagram, options, gridOf(diagram, options)));
}

ExportFrame::ExportFrame(const Diagram& its, const ExportOptions& options, ClippedDiagram itsClip)
    : diagram(its),
      hasDigits(options.digits.has_value()),
      grid(gridOf(its, options)),
      box(itsClip.region().bounds()),
      isBox(options.region == nullptr),
      isClipped(options.bounds || !isBox || options.maxDistance),
      clipped(std::move(itsClip)),
      place(options.place),
      attributes(options.attributes),
      tolerance(std::max(toleranceOf(box, options) - grid.error(), toleranceOf(box, options) / 2)) {}

Point ExportFrame::roundOnBoundary(Point p) const {
  if (!hasDigits || !isBox) return p;
  const auto rounded = [&](double value, double min, double max) {
    return value == min || value == max ? value : std::clamp(grid.round(value), min, max);
  };
  return {rounded(p.x, box.minX, box.maxX), rounded(p.y, box.minY, box.maxY)};
}

std::vector<double> areasIn(const ExportFrame& frame) {
  if (frame.isClipped) return frame.clipped.areas();
  std::vector<double> areas(frame.diagram.circles.size());
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = cellArea(frame.diagram, static_cast<std::int32_t>(i));
  return areas;
}

CellMeasures measuresIn(const ExportFrame& frame) {
  if (frame.isClipped) return {frame.clipped.areas(), frame.clipped.perimeters()};
  CellMeasures result;
  for (std::size_t i = 0; i < frame.diagram.circles.size(); ++i) {
    const auto circle = static_cast<std::int32_t>(i);
    const Outline whole = outline(frame.diagram, circle);
    const bool isInfinite = isUnbounded(frame.diagram, circle, whole);
    result.areas.push_back(isInfinite ? kInfinite : area(whole));
    result.perimeters.push_back(isInfinite ? kInfinite : perimeter(whole));
  }
  return result;
}

std::vector<CircleIndex> hidersOf(std::span<const HiddenCircle> hidden, std::size_t circleCount) {
  std::vector<CircleIndex> hiders(circleCount);
  for (const auto& [circle, by] : hidden) hiders[static_cast<std::size_t>(circle)] = by;
  return hiders;
}

void writeCellColumns(Writer& out, double area, double perimeter, const std::vector<CircleIndex>& neighbors,
                      CircleIndex hider) {
  for (const double measure : {area, perimeter}) {
    if (std::isinf(measure)) {
      out << "inf,";
    } else {
      out << measure << ",";
    }
  }
  writeJoined(out, neighbors, " ");
  out << ",";
  if (hider != kNone) out << hider;
}

namespace {

/// Maps a segment and adds points between its ends as needed, and its end. A segment has the same points in both
/// directions.
void addPlaces(const ExportFrame& frame, Point from, Point to, Point fromPlace, Point toPlace, int depth,
               std::vector<Point>& places) {
  constexpr int kMostHalvings = 16;
  const Point middle = {(from.x + to.x) / 2, (from.y + to.y) / 2};
  const Point middlePlace = frame.place(middle);
  // The distance of the mapped middle from the segment between the mapped ends, in the unit of the plane.
  const double off =
      std::hypot(middlePlace.x - (fromPlace.x + toPlace.x) / 2, middlePlace.y - (fromPlace.y + toPlace.y) / 2);
  const double placeSize = std::hypot(toPlace.x - fromPlace.x, toPlace.y - fromPlace.y);
  const double size = std::hypot(to.x - from.x, to.y - from.y);
  if (depth < kMostHalvings && off * size > frame.tolerance * placeSize) {
    addPlaces(frame, from, middle, fromPlace, middlePlace, depth + 1, places);
    addPlaces(frame, middle, to, middlePlace, toPlace, depth + 1, places);
  } else if (places.empty() || !(places.back() == toPlace)) {
    places.push_back(toPlace);
  }
}

}  // namespace

std::vector<std::vector<std::vector<Point>>> mapped(const ExportFrame& frame,
                                                    std::vector<std::vector<std::vector<Point>>> polygons) {
  if (!frame.place) return polygons;
  for (auto& polygon : polygons) {
    for (auto& ring : polygon) {
      std::vector<Point> places;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point from = ring[(k + ring.size() - 1) % ring.size()];
        addPlaces(frame, from, ring[k], frame.place(from), frame.place(ring[k]), 0, places);
      }
      if (places.size() > 1 && places.front() == places.back()) places.pop_back();
      ring = std::move(places);
    }
  }
  return polygons;
}

std::vector<CircleIndex> neighborsIn(const ExportFrame& frame, CircleIndex circle) {
  if (frame.isClipped) return frame.clipped.neighbors(circle);
  return neighbors(frame.diagram, circle);
}

EdgeCurve edgeDirection(const Diagram& diagram, const OutlinePiece& piece) {
  const bool isAgainst = piece.side % 2 == 1;
  EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(piece.side));
  curve.start = isAgainst ? piece.curve.end : piece.curve.start;
  curve.end = isAgainst ? piece.curve.start : piece.curve.end;
  curve.from = parameterAt(curve.bisector, curve.start);
  curve.to = std::max(curve.from, parameterAt(curve.bisector, curve.end));
  return curve;
}

bool isInside(const ExportFrame& frame, const Edge& edge, const EdgeCurve& curve) {
  if (edge.start == kNone || edge.end == kNone) return false;
  // Along an edge the distance is largest at one of its ends.
  if (!frame.isWithin(edge.start) || !frame.isWithin(edge.end)) return false;
  // Corners of the region may be near the edges of cells that its boundary crosses.
  const auto isWhole = [&](CircleIndex circle) {
    return ClipParts::of(frame.clipped).placeOf(circle) == ClippedDiagram::Place::inside;
  };
  if (!frame.isBox && !(isWhole(edge.left) && isWhole(edge.right))) return false;
  const double margin = frame.grid.error();
  const auto& box = frame.box;
  const auto isIn = [&](Point p) {
    return p.x - margin > box.minX && p.x + margin < box.maxX && p.y - margin > box.minY && p.y + margin < box.maxY;
  };
  // An arc lies in the triangle of its ends and the point where its tangents meet.
  return isIn(curve.start) && isIn(curve.end) && (curve.isStraight() || isIn(rationalBezier(curve).control));
}

}  // namespace circle_voronoi
