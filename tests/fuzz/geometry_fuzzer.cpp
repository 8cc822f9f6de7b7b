// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over queries of a finished diagram. Any bytes are an input: six say which metric, at which
// scale and in which box, the rest are circles (fuzz_input.h). For all inputs,
// - every call ends, under libFuzzer within a time, and its result is finite;
// - an arc is no shorter than its chord and no longer than its control polygon;
// - a nearest circle is found, and its cell contains the place, up to rounding;
// - the parts of the cells fill the box, and a convex polygon with corners nearly on lines of their neighbors, and each
//   cell alone has the same bits as among all;
// - where the box is not too small for rounding of the circles and vertices: the parts of the cells fill the box, lie
//   in it, and their polygons do not cross themselves; the largest empty discs are empty and inside.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cell_polygons.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/merged.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/region_queries.h"
#include "fuzz_input.h"

namespace circle_voronoi::fuzz {
namespace {

/// Limit of processor time for each call: a hundred times the usual time under sanitizers.
[[maybe_unused]] constexpr double kMostSeconds = 0.05;
/// Relative to the largest length involved.
constexpr double kRounding = 1e-9;
/// For lengths that are subnormal themselves.
constexpr double kLeastRounding = 4 * std::numeric_limits<double>::denorm_min();
/// Largest size relative to the box for which rounding does not show in the box.
constexpr double kMostRange = 0x1p16;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

/// The result of a call, which must not take long; nor the second time, if the machine was busy at the first. A replay
/// of the corpus has no limit: tests do not depend on speed.
template <class Call>
auto timed([[maybe_unused]] const char* name, Call call) {
#ifdef CIRCLE_VORONOI_FUZZING
  const auto secondsOf = [&](auto& result) {
    const std::clock_t begin = std::clock();
    result.emplace(call());
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  std::optional<decltype(call())> result;
  double seconds = secondsOf(result);
  if (seconds >= kMostSeconds) seconds = secondsOf(result);
  require(seconds < kMostSeconds, std::string(name) + " takes " + std::to_string(seconds) + " s");
  return *std::move(result);
#else
  return call();
#endif
}

bool isFinite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }
double distanceBetween(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

struct View {
  Metric metric;
  double scale;
  double size;    ///< of the box, as a share of the circles' extent
  double across;  ///< where its middle is, as a share of the extent
  double up;
};

View viewOf(std::span<const std::uint8_t> bytes) {
  const auto share = [&](std::size_t i) { return static_cast<std::int8_t>(bytes[i]) / 64.0; };
  return {static_cast<Metric>(bytes[0] % 3), std::ldexp(1.0, 8 * static_cast<std::int8_t>(bytes[1])),
          std::ldexp(1.0, static_cast<std::int8_t>(bytes[2]) / 4), share(3), share(4)};
}

class Checker {
 public:
  Checker(const Diagram& diagram, const Box& box, Region region)
      : circles_(diagram.circles), diagram_(diagram), box_(box), region_(std::move(region)) {
    size_ = std::max(box.maxX - box.minX, box.maxY - box.minY);
    double largest = std::max({std::abs(box.minX), std::abs(box.minY), std::abs(box.maxX), std::abs(box.maxY)});
    for (const auto& [x, y, r] : circles_) largest = std::max({largest, std::abs(x), std::abs(y), r});
    rounding_ = std::max(kRounding * largest, kLeastRounding);
    for (const auto& [x, y, radius] : diagram.vertices) largest = std::max({largest, std::abs(x), std::abs(y)});
    isLarge_ = largest < kMostRange * size_ && size_ > 1e-140 && isExact(diagram);
  }

  void run() {
    checkCurves();
    checkCells();
    checkPlaces();
    if (diagram_.metric == Metric::circles) checkQueries();
  }

 private:
  void checkCurves() const {
    const ClippedDiagram clipped = timed("clip", [&] { return ClippedDiagram::from(diagram_, region_).value(); });
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram_.edges.size()); ++e) {
      const EdgeCurve curve = edgeCurve(diagram_, e);
      require(curve.from <= curve.to, "the ends of an edge are out of order");
      for (const EdgeCurve& piece : timed("edgeParts", [&] { return clipped.edgeParts(e); })) {
        require(isFinite(piece.start) && isFinite(piece.end), "a piece does not end");
        const double chord = distanceBetween(piece.start, piece.end);
        const double length = timed("arcLength", [&] { return arcLength(piece); });
        const RationalBezier bezier = rationalBezier(piece);
        const double around = distanceBetween(piece.start, bezier.control) + distanceBetween(bezier.control, piece.end);
        require(length >= chord * (1 - kRounding), "an arc is shorter than its chord");
        require(length <= around * (1 + kRounding) + rounding_, "an arc is longer than its control polygon");
        const double tolerance = 1e-5 * size_;
        for (const Point& p : timed("polyline", [&] { return polyline(piece, tolerance); })) {
          require(isFinite(p) && depthOf(p) >= -rounding_ - 2 * tolerance, "a polyline leaves the box");
        }
        for (const CubicBezier& cubic : timed("cubicBeziers", [&] { return cubicBeziers(piece, tolerance); })) {
          require(isFinite(cubic.control1) && isFinite(cubic.control2), "a curve is not finite");
        }
      }
    }
  }

  void checkCells() const {
    double sum = 0;
    const ClippedDiagram clipped = ClippedDiagram::from(diagram_, region_).value();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles_.size()); ++i) {
      const Outline parts = timed("outline", [&] { return clipped.outline(i); });
      const double share = timed("area", [&] { return area(parts); }) / size_ / size_;
      const double length = timed("perimeter", [&] { return perimeter(parts); });
      const Point middle = timed("centroid", [&] { return centroid(parts); });
      require(std::isfinite(share) || size_ < 1e-140, "an area is not finite");
      require(std::isfinite(length) && isFinite(middle), "a perimeter or a centroid is not finite");
      sum += share;
      for (const auto& loop : parts) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          require(loop[k].curve.end == loop[(k + 1) % loop.size()].curve.start, "an outline has a gap");
          require(depthOf(loop[k].curve.start) >= -rounding_, "an outline leaves the box");
        }
      }
      if (!isLarge_) continue;
      require(share > -1e-9, "an area is negative");
      require(parts.empty() || depthOf(middle) > -1e-3 * size_, "a centroid is outside the box");
    }
    const double whole = (box_.maxX - box_.minX) / size_ * ((box_.maxY - box_.minY) / size_);
    if (isLarge_ && !circles_.empty()) {
      require(std::abs(sum - whole) <= 1e-6, "the cells have " + std::to_string(sum / whole) + " of the box");
    }
  }

  void checkPlaces() const {
    if (circles_.empty()) return;
    const Finder finder = timed("Finder", [&] { return Finder(diagram_); });
    for (const double share : {0.0, 0.25, 0.5, 0.7, 1.0}) {
      const Point p = {box_.minX + share * (box_.maxX - box_.minX),
                       box_.minY + share * share * (box_.maxY - box_.minY)};
      const std::int32_t found = timed("find", [&] { return finder.find(p); });
      require(found != kNone && diagram_.hasCell(found), "no circle is found");
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles_.size()); ++i) {
        require(distanceDifference(diagram_, found, i, p) >= -rounding_, "another circle is nearer than the one found");
        if (contains(diagram_, i, p))
          require(distanceDifference(diagram_, i, found, p) >= -rounding_, "a cell contains what is not its");
      }
    }
  }

  void checkQueries() const {
    const Hull outer = timed("hull", [&] { return convexHull(diagram_); });
    double angle = 0;
    for (const HullArc& arc : outer.arcs) {
      require(isFinite(arc.start) && isFinite(arc.end) && arc.angle >= 0, "an arc of the hull is not finite");
      angle += arc.angle;
    }
    require(outer.arcs.empty() || std::abs(angle - 6.283185307179586) < 1e-9, "the hull does not turn once");
    require(std::isfinite(outer.length) && std::isfinite(outer.area), "the hull is not finite");
    const auto pair = timed("closestPair", [&] { return closestPair(diagram_); });
    require(!pair || std::isfinite(pair->gap), "a gap is not finite");
    (void)timed("mergeVertices", [&] { return mergeVertices(diagram_); });
    checkDisc(ClippedDiagram::from(diagram_, region_)->largestEmptyDisc(), false);
    if (isLarge_) checkDisc(largestEmptyDiscInside(diagram_, region_).value(), true);
    const auto inHull =
        timed("largestEmptyDiscCenteredInHull", [&] { return largestEmptyDiscCenteredInHull(diagram_); });
    require(inHull.has_value() == !circles_.empty(), "there is no disc in the hull");
    if (circles_.empty()) return;
    const ClearestPath path = timed("clearestPath", [&] {
      return clearestPath(diagram_, {box_.minX, box_.minY}, {box_.maxX, box_.maxY});
    });
    require(!std::isnan(path.clearance), "a clearance is no number");
    checkPolygons();
  }

  void checkDisc(const std::optional<EmptyDisc>& found, bool isInside) const {
    // Without circles only a disc inside has an end.
    require(found.has_value() == (isInside || !circles_.empty()), "there is no disc, or one without an end");
    if (!found) return;
    const auto& [x, y, radius] = found->disc;
    require(isFinite({x, y}) && std::isfinite(radius), "a disc is not finite");
    require(depthOf({x, y}) >= -rounding_, "the center of a disc is outside the box");
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      require(distance(Metric::circles, circles_[i], {x, y}) >= radius - rounding_, "a disc is not empty");
    }
    if (isInside && radius > 0) require(depthOf({x, y}) >= radius - rounding_, "a disc sticks out of the box");
  }

  void checkPolygons() const {
    if (!isLarge_) return;
    const ExportFrame frame(diagram_, {.bounds = box_}, ClippedDiagram::from(diagram_, region_).value());
    const CellPolygons polygons = timed("CellPolygons", [&] { return CellPolygons(frame); });
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles_.size()); ++i) {
      for (const auto& polygon : timed("polygons", [&] { return polygons.polygons(i); })) {
        const auto& ring = polygon.front();
        require(ring.size() > 2, "a polygon has no corners");
        if (ring.size() > 300) continue;
        for (std::size_t j = 0; j < ring.size(); ++j) {
          require(depthOf(ring[j]) >= -rounding_, "a polygon leaves the box");
          for (std::size_t k = 0; k < j; ++k) require(!cross(ring, j, k), "a polygon crosses itself");
        }
      }
    }
  }

  /// Whether two sides of a polygon cross by more than rounding.
  bool cross(const std::vector<Point>& ring, std::size_t j, std::size_t k) const {
    const Point p = ring[j];
    const Point q = ring[(j + 1) % ring.size()];
    const Point u = ring[k];
    const Point v = ring[(k + 1) % ring.size()];
    const auto height = [&](Point a, Point b, Point c) {
      const double length = distanceBetween(a, b);
      return length == 0 ? 0 : (b.x - a.x) / length * (c.y - a.y) - (b.y - a.y) / length * (c.x - a.x);
    };
    const auto apart = [&](double one, double other) {
      return (one > rounding_ && other < -rounding_) || (one < -rounding_ && other > rounding_);
    };
    return apart(height(p, q, u), height(p, q, v)) && apart(height(u, v, p), height(u, v, q));
  }

  /// The distance by which a point is inside the box.
  double depthOf(Point p) const {
    return std::min({p.x - box_.minX, p.y - box_.minY, box_.maxX - p.x, box_.maxY - p.y});
  }

  const std::vector<Circle>& circles_;
  const Diagram& diagram_;
  Box box_;
  Region region_;
  double size_ = 1;
  double rounding_ = 0;
  bool isLarge_ = true;
};

/// Checks that the cells in a convex region are accepted by the judge, and that each is the same alone, to the bit.
void checkClip(const Diagram& diagram, const Region& region) {
  const auto all = ClippedDiagram::from(diagram, region);
  require(all.ok(), "a clip is refused");
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
    const auto alone = ClippedDiagram::ofCells(diagram, region, std::array{CircleIndex(i)});
    require(alone.ok(), "a cell is refused alone");
    const Outline its = alone->outline(i);
    const Outline theirs = all->outline(i);
    require(alone->area(i) == all->area(i) && alone->perimeter(i) == all->perimeter(i), "a cell differs alone");
    require(its.size() == theirs.size(), "a cell has other loops alone");
    for (std::size_t k = 0; k < its.size(); ++k) {
      require(its[k].size() == theirs[k].size(), "a loop has other pieces alone");
      for (std::size_t p = 0; p < its[k].size(); ++p) {
        require(its[k][p].curve.start == theirs[k][p].curve.start, "a piece begins elsewhere alone");
      }
    }
  }
}

/// A box with points on its sides, moved outward by some of the smallest steps of a double: by 0 to 15 steps each.
std::vector<Point> nearlyBox(const Box& box, std::span<const std::uint8_t> bytes) {
  const auto moved = [&](double value, double to, std::size_t k) {
    for (int step = 0; step < bytes[k % bytes.size()] % 16; ++step) value = std::nextafter(value, to);
    return value;
  };
  const double x = box.minX + (box.maxX - box.minX) * 0.375;
  const double y = box.minY + (box.maxY - box.minY) * 0.625;
  constexpr double kFar = std::numeric_limits<double>::max();
  return {{box.minX, box.minY}, {x, moved(box.minY, -kFar, 0)}, {box.maxX, box.minY}, {moved(box.maxX, kFar, 1), y},
          {box.maxX, box.maxY}, {x, moved(box.maxY, kFar, 2)},  {box.minX, box.maxY}, {moved(box.minX, -kFar, 3), y}};
}

void run(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kViewBytes = 6;
  if (bytes.size() < kViewBytes) return;
  const View view = viewOf(bytes);
  std::vector<Circle> circles = decode(bytes.subspan(kViewBytes)).circles;
  for (auto& [x, y, r] : circles) {
    x *= view.scale;
    y *= view.scale;
    r *= view.scale;
  }
  const auto diagram = compute(circles, {.metric = view.metric});
  if (!diagram) return;
  const Box whole = exportBox(circles);
  const double extent = std::max(whole.maxX - whole.minX, whole.maxY - whole.minY);
  const Point middle = {whole.minX + (whole.maxX - whole.minX) * view.across,
                        whole.minY + (whole.maxY - whole.minY) * view.up};
  const double half = extent * view.size / 2;
  const Box box = {middle.x - half, middle.y - half / (1 + bytes[5] % 4), middle.x + half, middle.y + half};
  auto region = Region::from(box);
  if (!region) return;
  checkClip(*diagram, *region);
  if (const auto nearly = Region::fromRings(std::array{nearlyBox(box, bytes)})) checkClip(*diagram, *nearly);
  Checker(*diagram, box, *std::move(region)).run();
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circle_voronoi::fuzz::run({data, size});
  return 0;
}
