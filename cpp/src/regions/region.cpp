// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/region.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "arithmetic.h"
#include "at.h"
#include "compensated_sum.h"
#include "disjoint_sets.h"
#include "dissolve.h"
#include "guarded.h"
#include "in_circle.h"
#include "named_option.h"
#include "ring_sweep.h"
#include "scale.h"
#include "scaled_region.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// Sides of a run of the first level, and runs in one of the next.
constexpr std::size_t kSidesOfRun = 8;
constexpr std::size_t kRunsOfRun = 4;
/// Rounding of places along an axis, as a share of the largest coordinate and of the axis.
constexpr double kShadowRounding = 0x1p-48;

constexpr Box kNothing = {kInfinite, kInfinite, -kInfinite, -kInfinite};

bool doMeet(const Box& one, const Box& other) {
  return one.minX <= other.maxX && one.maxX >= other.minX && one.minY <= other.maxY && one.maxY >= other.minY;
}

Box boxAround(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

Vector leftOf(Vector v) { return {-v.y, v.x}; }

/// Returns the place of the shadow of a point on an axis.
double placeOn(Vector axis, Point p) { return axis.x * p.x + axis.y * p.y; }

void grow(Box& box, const Box& other) {
  box = {std::min(box.minX, other.minX), std::min(box.minY, other.minY), std::max(box.maxX, other.maxX),
         std::max(box.maxY, other.maxY)};
}

/// A run of sides (Region::Run) without a side.
template <class Run>
constexpr Run kEmptyRun = {kNothing, {}, kInfinite, -kInfinite, kInfinite, -kInfinite};

/// Lays a run along a side that is longer than those before.
template <class Run>
void lengthen(Run& run, Vector side) {
  if (dot(side, side) > dot(run.along, run.along)) run.along = side;
}

/// Widens a run so that it has a point.
template <class Run>
void include(Run& run, Point p) {
  const double along = placeOn(run.along, p);
  const double across = placeOn(leftOf(run.along), p);
  run.leastAlong = std::min(run.leastAlong, along);
  run.mostAlong = std::max(run.mostAlong, along);
  run.leastAcross = std::min(run.leastAcross, across);
  run.mostAcross = std::max(run.mostAcross, across);
}

/// Returns runs that each consist of a few in a row. `runAt` returns the k-th of them.
template <class Run, class RunAt>
std::vector<Run> runsOfRuns(std::size_t count, const RunAt& runAt) {
  std::vector<Run> runs((count + kRunsOfRun - 1) / kRunsOfRun, kEmptyRun<Run>);
  for (std::size_t k = 0; k < count; ++k) lengthen(runs[k / kRunsOfRun], runAt(k).along);
  for (std::size_t k = 0; k < count; ++k) {
    const Run& its = runAt(k);
    Run& run = runs[k / kRunsOfRun];
    grow(run.box, its.box);
    const Vector left = leftOf(its.along);
    const double square = dot(its.along, its.along);
    for (const double along : {its.leastAlong / square, its.mostAlong / square}) {
      for (const double across : {its.leastAcross / square, its.mostAcross / square}) {
        include(run, {along * its.along.x + across * left.x, along * its.along.y + across * left.y});
      }
    }
  }
  return runs;
}

/// Adds levels of runs of the runs of the last level, up to a single run.
template <class Run>
void addLevels(std::vector<std::vector<Run>>& levels) {
  while (levels.back().size() > 1) {
    const auto& below = levels.back();
    levels.push_back(runsOfRuns<Run>(below.size(), [&](std::size_t k) -> const Run& { return below[k]; }));
  }
}

[[noreturn]] void refuse(std::string message, ErrorCode code = ErrorCode::badOption) {
  throw ThrownError{{code, kNone, std::move(message)}};
}

/// Appends the way out of an error about several polygons.
void adviseDissolve(Error& error) { append(error, {" Set ", "`dissolve`", " to merge them.", "dissolve"}); }

/// The input from which a region is made.
struct Given {
  std::span<const Point> points;
  std::span<const std::int32_t> ringOffsets;
  std::span<const std::int32_t> polygonOffsets;
  double limit = kCoordinateLimit;  ///< of coordinates
};

bool areOffsets(std::span<const std::int32_t> offsets, std::size_t count) {
  return !offsets.empty() && offsets.front() == 0 && at(offsets.back()) == count && std::ranges::is_sorted(offsets);
}

void checkArrays(const Given& given) {
  if (!isArithmeticStandard()) {
    throw ThrownError{{ErrorCode::badArithmetic, kNone,
                       "Floating-point numbers are not rounded to nearest, or tiny numbers are taken for zero, as in a "
                       "program that is linked with -ffast-math."}};
  }
  if (given.points.size() > kMaxRegionSides) {
    throw ThrownError{{ErrorCode::tooManyCircles, kNone,
                       "The region has " + std::to_string(given.points.size()) + " points; at most " +
                           std::to_string(kMaxRegionSides) + " are possible."}};
  }
  if (!areOffsets(given.ringOffsets, given.points.size())) {
    refuse("The offsets of the region's rings must increase from 0 to the number of points.");
  }
  if (given.ringOffsets.size() == 1) refuse("The region has no ring.");
  if (given.polygonOffsets.empty()) return;
  if (!areOffsets(given.polygonOffsets, given.ringOffsets.size() - 1)) {
    refuse("The offsets of the region's polygons must increase from 0 to the number of rings.");
  }
  for (std::size_t k = 1; k < given.polygonOffsets.size(); ++k) {
    if (given.polygonOffsets[k - 1] == given.polygonOffsets[k]) {
      refuse("Polygon " + std::to_string(k - 1) + " of the region has no ring.");
    }
  }
}

/// Names rings and sides in messages: by their index in the input, from 0. If there are several polygons, rings are
/// counted within their polygon.
class Names {
 public:
  explicit Names(const Given& given) : given_(given) {}

  std::string ofRing(std::size_t ring) const {
    const auto& offsets = given_.polygonOffsets;
    if (offsets.empty()) return "ring " + std::to_string(ring);
    const auto polygon = polygonOf(ring);
    const std::string name = "ring " + std::to_string(ring - at(offsets[polygon]));
    return offsets.size() == 2 ? name : name + " of polygon " + std::to_string(polygon);
  }
  std::size_t polygonOf(std::size_t ring) const {
    const auto& offsets = given_.polygonOffsets;
    return static_cast<std::size_t>(std::ranges::upper_bound(offsets, static_cast<std::int32_t>(ring)) -
                                    offsets.begin()) -
           1;
  }

 private:
  const Given& given_;
};

/// The rings without repeated points, and which point of its ring each one was.
struct Cleaned {
  Rings rings;
  std::vector<std::int32_t> inputIndex;
  std::vector<std::size_t> inputRing;  ///< of each ring
};

/// `leavesOut`: rings of fewer than three points are left out, not refused.
Cleaned cleaned(const Given& given, const Names& names, bool leavesOut = false) {
  Cleaned result;
  auto& [points, offsets] = result.rings;
  points.reserve(given.points.size());
  result.inputIndex.reserve(given.points.size());
  offsets.push_back(0);
  double largest = 0;
  for (std::size_t r = 0; r + 1 < given.ringOffsets.size(); ++r) {
    const std::size_t first = points.size();
    const std::size_t begin = at(given.ringOffsets[r]);
    for (std::size_t k = begin; k < at(given.ringOffsets[r + 1]); ++k) {
      const Point exact = given.points[k];
      const auto who = [&] {
        return "Point " + std::to_string(k - begin) + " of " + names.ofRing(r) + " of the region ";
      };
      if (!std::isfinite(exact.x) || !std::isfinite(exact.y)) refuse(who() + "is not finite.");
      if (largestOf({exact.x, exact.y}) > given.limit) {
        refuse(who() + "has a coordinate beyond " + kCoordinateLimitText + ".", ErrorCode::coordinateTooLarge);
      }
      largest = std::max(largest, largestOf({exact.x, exact.y}));
      // Adding zero turns -0 into +0.
      const Point p = {rounded(exact.x) + 0.0, rounded(exact.y) + 0.0};
      const auto index = static_cast<std::int32_t>(k - begin);
      if (points.size() > first && points.back() == p) {
        result.inputIndex.back() = index;
        continue;
      }
      points.push_back(p);
      result.inputIndex.push_back(index);
    }
    while (points.size() > first + 1 && points.back() == points[first]) {
      points.pop_back();
      result.inputIndex.pop_back();
    }
    if (points.size() < first + 3 && leavesOut) {
      points.resize(first);
      result.inputIndex.resize(first);
      continue;
    }
    if (points.size() < first + 3) {
      std::string name = names.ofRing(r);
      name[0] = 'R';
      refuse(name + " of the region has fewer than three different points.");
    }
    offsets.push_back(static_cast<std::int32_t>(points.size()));
    result.inputRing.push_back(r);
  }
  // The coordinates of a box may be small.
  if (given.limit == kCoordinateLimit) {
    if (auto error = tooSmallError(largest, "The points of the region")) throw ThrownError{*std::move(error)};
  }
  return result;
}

/// Refuses holes outside their polygon, and rings that lie in another polygon or hole.
void checkNesting(const Given& given, const RingOrder& order, const Names& names) {
  const auto isOuter = [&](std::size_t ring) { return at(given.polygonOffsets[names.polygonOf(ring)]) == ring; };
  for (std::size_t ring = 0; ring < order.parent.size(); ++ring) {
    const std::int32_t parent = order.parent[ring];
    if (isOuter(ring)) {
      if (parent == -1 || !isOuter(at(parent))) continue;
      Error error = {ErrorCode::badOption, kNone,
                     "Polygons " + std::to_string(names.polygonOf(at(parent))) + " and " +
                         std::to_string(names.polygonOf(ring)) + " of the region overlap: one contains the other."};
      adviseDissolve(error);
      throw ThrownError{std::move(error)};
    }
    if (parent == given.polygonOffsets[names.polygonOf(ring)]) continue;
    std::string name = names.ofRing(ring);
    name[0] = 'R';
    const bool isInHole = parent != -1 && !isOuter(at(parent)) && names.polygonOf(at(parent)) == names.polygonOf(ring);
    refuse(isInHole ? name + " of the region is a hole inside another hole."
                    : name + " of the region is a hole, but lies outside its polygon.");
  }
}

/// Refuses polygons whose rings touch so that they cut the interior apart: then rings and the points where they touch
/// form a cycle.
void checkInteriors(const RingOrder& order, const std::vector<std::int32_t>& polygonOfRing) {
  DisjointSets sets(order.parent.size());
  for (std::size_t k = 0; k < order.touches.size();) {
    std::size_t end = k;
    while (end < order.touches.size() && order.touches[end].point == order.touches[k].point) ++end;
    std::vector<std::int32_t> rings;
    for (; k < end; ++k) rings.push_back(order.touches[k].ring);
    std::ranges::sort(rings, {}, [&](std::int32_t ring) { return polygonOfRing[at(ring)]; });
    std::int32_t polygon = -1;
    std::int32_t point = 0;
    for (const std::int32_t ring : rings) {
      if (polygonOfRing[at(ring)] != polygon) point = sets.add();
      polygon = polygonOfRing[at(ring)];
      if (!sets.join(ring, point)) {
        refuse("The rings of polygon " + std::to_string(polygon) +
               " of the region touch so that they cut its interior apart.");
      }
    }
  }
}

/// For each ring its polygon, and for each polygon its rings, the outer one first.
struct Grouping {
  std::vector<std::int32_t> polygonOfRing;
  std::vector<std::vector<std::int32_t>> rings;
};

Grouping grouped(const Given& given, const RingOrder& order) {
  Grouping result;
  const std::size_t count = order.parent.size();
  result.polygonOfRing.assign(count, -1);
  const auto add = [&](std::size_t ring, std::int32_t polygon) {
    result.polygonOfRing[ring] = polygon;
    result.rings[at(polygon)].push_back(static_cast<std::int32_t>(ring));
  };
  if (!given.polygonOffsets.empty()) {
    result.rings.resize(given.polygonOffsets.size() - 1);
    for (std::size_t polygon = 0; polygon < result.rings.size(); ++polygon) {
      for (std::int32_t ring = given.polygonOffsets[polygon]; ring < given.polygonOffsets[polygon + 1]; ++ring) {
        add(at(ring), static_cast<std::int32_t>(polygon));
      }
    }
    return result;
  }
  std::vector<std::int32_t> depth(count, -1);
  std::vector<std::size_t> path;
  for (std::size_t ring = 0; ring < count; ++ring) {
    path.clear();
    for (std::size_t r = ring; depth[r] == -1; r = at(order.parent[r])) {
      path.push_back(r);
      if (order.parent[r] == -1) break;
    }
    for (; !path.empty(); path.pop_back()) {
      const std::int32_t parent = order.parent[path.back()];
      depth[path.back()] = parent == -1 ? 0 : depth[at(parent)] + 1;
    }
  }
  for (std::size_t ring = 0; ring < count; ++ring) {
    if (depth[ring] % 2 != 0) continue;
    result.rings.emplace_back();
    add(ring, static_cast<std::int32_t>(result.rings.size()) - 1);
  }
  for (std::size_t ring = 0; ring < count; ++ring) {
    if (depth[ring] % 2 == 1) add(ring, result.polygonOfRing[at(order.parent[ring])]);
  }
  return result;
}

/// Flat arrays of lists of rings.
struct Flat {
  std::vector<Point> points;
  std::vector<std::int32_t> ringOffsets = {0};
  std::vector<std::int32_t> polygonOffsets = {0};

  void add(const Region::Ring& ring) {
    points.insert(points.end(), ring.begin(), ring.end());
    if (points.size() > kMaxRegionSides) return;
    ringOffsets.push_back(static_cast<std::int32_t>(points.size()));
  }
  void endPolygon() { polygonOffsets.push_back(static_cast<std::int32_t>(ringOffsets.size() - 1)); }
};

/// The rings around the union of polygons.
Rings ringsAround(const Given& given) {
  const Names names(given);
  const auto clean = cleaned(given, names, true);
  std::vector<std::int32_t> polygonOfRing;
  for (const std::size_t ring : clean.inputRing) {
    polygonOfRing.push_back(given.polygonOffsets.empty() ? 0 : static_cast<std::int32_t>(names.polygonOf(ring)));
  }
  return dissolved(clean.rings, polygonOfRing);
}

}  // namespace

Region Region::valid(std::span<const Point> points, std::span<const std::int32_t> ringOffsets,
                     std::span<const std::int32_t> polygonOffsets, double limit) {
  const Given given = {points, ringOffsets, polygonOffsets, limit};
  const Names names(given);
  const auto clean = cleaned(given, names);
  // Clang 14 captures no structured bindings.
  const auto& rings = clean.rings;
  const auto& inputIndex = clean.inputIndex;
  const auto ringOfSide = [&](std::int32_t side) {
    return static_cast<std::size_t>(std::ranges::upper_bound(rings.offsets, side) - rings.offsets.begin()) - 1;
  };
  const auto nameOf = [&](std::int32_t side) {
    return "side " + std::to_string(inputIndex[at(side)]) + " of " + names.ofRing(ringOfSide(side)) + " of the region";
  };
  const auto advise = [&](Error& error, std::int32_t a, std::int32_t b) {
    const bool areTwo = !polygonOffsets.empty() && names.polygonOf(ringOfSide(a)) != names.polygonOf(ringOfSide(b));
    if (areTwo) adviseDissolve(error);
  };
  const RingOrder order = orderOf(rings, nameOf, advise);
  if (!polygonOffsets.empty()) checkNesting(given, order, names);
  const Grouping grouping = grouped(given, order);
  checkInteriors(order, grouping.polygonOfRing);

  Region region;
  region.points_.reserve(rings.points.size());
  region.ringOffsets_.push_back(0);
  region.polygonOffsets_.push_back(0);
  for (const auto& polygon : grouping.rings) {
    for (const std::int32_t ring : polygon) {
      const auto begin = rings.points.begin() + rings.offsets[at(ring)];
      const auto end = rings.points.begin() + rings.offsets[at(ring) + 1];
      const bool isOuter = ring == polygon.front();
      auto& its = region.points_;
      its.push_back(*begin);
      if (isOuter == (order.isCounterClockwise[at(ring)] != 0)) {
        its.insert(its.end(), begin + 1, end);
      } else {
        its.insert(its.end(), std::make_reverse_iterator(end), std::make_reverse_iterator(begin + 1));
      }
      region.ringOffsets_.push_back(static_cast<std::int32_t>(its.size()));
    }
    region.polygonOffsets_.push_back(static_cast<std::int32_t>(region.ringOffsets_.size() - 1));
  }
  region.index();
  return region;
}

Result<Region> Region::fromArrays(std::span<const Point> points, std::span<const std::int32_t> ringOffsets,
                                  std::span<const std::int32_t> polygonOffsets, const RegionOptions& options) {
  return guarded([&]() -> Result<Region> {
    checkArrays({points, ringOffsets, polygonOffsets});
    auto asItIs = guarded([&]() -> Result<Region> { return valid(points, ringOffsets, polygonOffsets); });
    if (asItIs || !options.dissolve || asItIs.error().code != ErrorCode::badOption) return asItIs;
    const Rings rings = ringsAround({points, ringOffsets, polygonOffsets});
    if (rings.points.empty()) return errorWith(ErrorCode::badOption, "The region has no area.");
    auto merged = guarded([&]() -> Result<Region> { return valid(rings.points, rings.offsets, {}); });
    if (merged || merged.error().code != ErrorCode::badOption) return merged;
    return errorWith(ErrorCode::internal, ("The union of the polygons: " + merged.error().message).c_str());
  });
}

Result<Region> Region::fromPolygons(std::span<const std::vector<Ring>> polygons, const RegionOptions& options) {
  return guarded([&]() -> Result<Region> {
    Flat flat;
    for (const auto& polygon : polygons) {
      for (const Ring& ring : polygon) flat.add(ring);
      flat.endPolygon();
    }
    return fromArrays(flat.points, flat.ringOffsets, flat.polygonOffsets, options);
  });
}

Result<Region> Region::fromRings(std::span<const Ring> rings, const RegionOptions& options) {
  return guarded([&]() -> Result<Region> {
    Flat flat;
    for (const Ring& ring : rings) flat.add(ring);
    return fromArrays(flat.points, flat.ringOffsets, {}, options);
  });
}

Result<Region> Region::from(const Box& box) {
  return guarded([&]() -> Result<Region> {
    const auto isInRange = [](Point p) { return std::abs(p.x) <= kRegionLimit && std::abs(p.y) <= kRegionLimit; };
    if (!isInRange({box.minX, box.minY}) || !isInRange({box.maxX, box.maxY})) {
      refuse(std::string("A coordinate of the box is not finite, or beyond ") + kRegionLimitText + ".");
    }
    const auto [minX, minY] = rounded(Point{box.minX, box.minY});
    const auto [maxX, maxY] = rounded(Point{box.maxX, box.maxY});
    if (!(minX < maxX && minY < maxY)) refuse("The box is empty.");
    const std::array<Point, 4> corners = {Point{minX, minY}, {maxX, minY}, {maxX, maxY}, {minX, maxY}};
    constexpr std::array<std::int32_t, 2> kOneRing = {0, 4};
    checkArrays({corners, kOneRing, {}});
    return valid(corners, kOneRing, {}, kRegionLimit);
  });
}

RegionRingIndex Region::ringOf(RegionSideIndex side) const {
  const std::int32_t index = side;
  return static_cast<std::int32_t>(std::ranges::upper_bound(ringOffsets_, index) - ringOffsets_.begin()) - 1;
}

std::int32_t Region::polygonOf(RegionRingIndex ring) const {
  const std::int32_t index = ring;
  return static_cast<std::int32_t>(std::ranges::upper_bound(polygonOffsets_, index) - polygonOffsets_.begin()) - 1;
}

void Region::index() {
  runs_ = {runsOf(kSidesOfRun)};
  addLevels(runs_);
  const auto& runs = runs_.front();
  runsByPlace_.resize(runs.size());
  std::iota(runsByPlace_.begin(), runsByPlace_.end(), 0);
  orderRuns(0, runs.size());
  groups_ = {runsOfRuns<Run>(runs.size(), [&](std::size_t k) -> const Run& { return runs[at(runsByPlace_[k])]; })};
  addLevels(groups_);
  ringBoxes_.clear();
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < ringCount(); ++r) {
    const Point p = points_[at(ringOffsets_[r])];
    boxes.push_back({p.x, p.y, p.x, p.y});
  }
  do {
    std::vector<Box> above((boxes.size() + kRunsOfRun - 1) / kRunsOfRun, kNothing);
    for (std::size_t k = 0; k < boxes.size(); ++k) grow(above[k / kRunsOfRun], boxes[k]);
    boxes = above;
    ringBoxes_.push_back(std::move(above));
  } while (boxes.size() > 1);
}

/// Orders a part of the runs of the first level so that groups are near each other: divides them in the middle of their
/// longer axis, again and again, into numbers that are powers of two where possible, as groups are.
void Region::orderRuns(std::size_t begin, std::size_t end) {
  if (end - begin <= kRunsOfRun) return;
  const auto middleOf = [&](std::int32_t run, bool isTall) {
    const Box& box = runs_.front()[at(run)].box;
    return isTall ? box.minY / 2 + box.maxY / 2 : box.minX / 2 + box.maxX / 2;
  };
  Box box = kNothing;
  for (std::size_t k = begin; k < end; ++k) {
    const Point middle = {middleOf(runsByPlace_[k], false), middleOf(runsByPlace_[k], true)};
    grow(box, boxAround(middle, middle));
  }
  const bool isTall = box.maxY - box.minY > box.maxX - box.minX;
  const std::size_t half = std::bit_ceil(end - begin) / 2;
  const auto first = runsByPlace_.begin() + static_cast<std::ptrdiff_t>(begin);
  std::nth_element(first, first + static_cast<std::ptrdiff_t>(half), first + static_cast<std::ptrdiff_t>(end - begin),
                   [&](std::int32_t one, std::int32_t other) {
                     return std::pair(middleOf(one, isTall), one) < std::pair(middleOf(other, isTall), other);
                   });
  orderRuns(begin, begin + half);
  orderRuns(begin + half, end);
}

/// Returns the runs of so many sides.
std::vector<Region::Run> Region::runsOf(std::size_t size) const {
  std::vector<Run> runs((points_.size() + size - 1) / size, kEmptyRun<Run>);
  const auto forEachSide = [&](auto visit) {
    for (std::size_t r = 0; r < ringCount(); ++r) {
      const std::size_t begin = at(ringOffsets_[r]);
      const std::size_t end = at(ringOffsets_[r + 1]);
      for (std::size_t k = begin; k < end; ++k) {
        visit(runs[k / size], points_[k], points_[k + 1 == end ? begin : k + 1]);
      }
    }
  };
  forEachSide([](Run& run, Point from, Point to) { lengthen(run, vectorTo(from, to)); });
  forEachSide([](Run& run, Point from, Point to) {
    grow(run.box, boxAround(from, to));
    include(run, from);
    include(run, to);
  });
  return runs;
}

/// A convex polygon, widened by a margin. It lies apart from a thing if there is an axis on which their shadows do.
class Region::Polygon {
 public:
  Polygon(std::span<const Point> corners, double margin, const Box& bounds) : corners_(corners) {
    for (const Point& p : corners) grow(box_, {p.x, p.y, p.x, p.y});
    double size = 0;
    for (const Box& box : {box_, bounds}) size = std::max({size, -box.minX, -box.minY, box.maxX, box.maxY});
    slack_ = margin + kShadowRounding * size;
    box_ = {box_.minX - slack_, box_.minY - slack_, box_.maxX + slack_, box_.maxY + slack_};
  }

  bool meets(const Run& run) const {
    if (!doMeet(run.box, box_)) return false;
    if (isApart(run.along, run.leastAlong, run.mostAlong) ||
        isApart(leftOf(run.along), run.leastAcross, run.mostAcross)) {
      return false;
    }
    const Vector size = {run.box.maxX - run.box.minX, run.box.maxY - run.box.minY};
    const Point middle = {run.box.minX + size.x / 2, run.box.minY + size.y / 2};
    return !isApartAlongSides([&](Vector axis) {
      const double half = (std::abs(axis.x) * size.x + std::abs(axis.y) * size.y) / 2;
      return std::pair(placeOn(axis, middle) - half, placeOn(axis, middle) + half);
    });
  }

  bool meets(Point from, Point to) const {
    const auto shadow = [&](Vector axis) { return std::minmax({placeOn(axis, from), placeOn(axis, to)}); };
    if (!doMeet(boxAround(from, to), box_)) return false;
    const Vector across = leftOf(vectorTo(from, to));
    const auto its = shadow(across);
    return !isApart(across, its.first, its.second) && !isApartAlongSides(shadow);
  }

 private:
  /// Returns whether all corners lie beyond a shadow on an axis, and farther than rounding and margin.
  bool isApart(Vector axis, double low, double high) const {
    double least = kInfinite;
    double most = -kInfinite;
    for (const Point& p : corners_) {
      least = std::min(least, placeOn(axis, p));
      most = std::max(most, placeOn(axis, p));
    }
    const double slack = slack_ * (std::abs(axis.x) + std::abs(axis.y));
    return least - high > slack || low - most > slack;
  }

  template <class Shadow>
  bool isApartAlongSides(Shadow shadow) const {
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Vector axis = leftOf(vectorTo(corners_[k], corners_[k + 1 == corners_.size() ? 0 : k + 1]));
      const auto its = shadow(axis);
      if (isApart(axis, its.first, its.second)) return true;
    }
    return false;
  }

  std::span<const Point> corners_;
  double slack_ = 0;  ///< of the margin and rounding, for an axis of length 1
  Box box_ = kNothing;
};

/// Whether a ray from the point to the right crosses an odd number of sides of a run.
bool Region::isInRun(std::size_t level, std::size_t run, Point p, bool& isOnBoundary) const {
  const Run& its = runs_[level][run];
  const Box& box = its.box;
  if (p.y < box.minY || p.y > box.maxY || p.x > box.maxX) return false;
  // The part of the run at the height of the point lies beyond a line beside the point if all of the run does.
  const double largest =
      std::max({largestOf({p.x, p.y}), largestOf({box.minX, box.minY}), largestOf({box.maxX, box.maxY})});
  const double slack = kShadowRounding * largest * (std::abs(its.along.x) + std::abs(its.along.y));
  const auto isPast = [&](double place, double direction, double least, double most) {
    return direction > 0 ? place - most > slack : least - place > slack;
  };
  const double along = placeOn(its.along, p);
  const double across = placeOn(leftOf(its.along), p);
  if (isPast(along, its.along.x, its.leastAlong, its.mostAlong)) return false;
  if (isPast(across, -its.along.y, its.leastAcross, its.mostAcross)) return false;
  const bool isLeft = p.x < box.minX || isPast(along, -its.along.x, its.leastAlong, its.mostAlong) ||
                      isPast(across, its.along.y, its.leastAcross, its.mostAcross);
  std::size_t size = kSidesOfRun;
  for (std::size_t k = 0; k < level; ++k) size *= kRunsOfRun;
  const std::size_t first = run * size;
  const std::size_t last = std::min(first + size, points_.size()) - 1;
  const auto ring = at(ringOf(static_cast<std::int32_t>(first)));
  const auto begin = ringOffsets_[ring];
  const auto endOf = [&](std::size_t side, std::int32_t ringBegin, std::int32_t ringEnd) {
    return points_[side + 1 == at(ringEnd) ? at(ringBegin) : side + 1];
  };
  if (isLeft) {
    // A ring is crossed as often up as down. Of the first and the last one, the run may have a part only.
    const auto isAbove = [&](Point q) { return q.y > p.y; };
    const auto lastRing = at(ringOf(static_cast<std::int32_t>(last)));
    const Point after = endOf(last, ringOffsets_[lastRing], ringOffsets_[lastRing + 1]);
    if (lastRing == ring) return isAbove(points_[first]) != isAbove(after);
    const bool isFirstCrossed = isAbove(points_[first]) != isAbove(points_[at(begin)]);
    return isFirstCrossed != (isAbove(points_[at(ringOffsets_[lastRing])]) != isAbove(after));
  }
  bool isOdd = false;
  if (level > 0) {
    const std::size_t runEnd = std::min((run + 1) * kRunsOfRun, runs_[level - 1].size());
    for (std::size_t k = run * kRunsOfRun; k < runEnd && !isOnBoundary; ++k) {
      isOdd ^= isInRun(level - 1, k, p, isOnBoundary);
    }
    return isOdd;
  }
  std::size_t r = ring;
  for (std::size_t side = first; side <= last; ++side) {
    while (static_cast<std::int32_t>(side) >= ringOffsets_[r + 1]) ++r;
    const Point a = points_[side];
    const Point b = endOf(side, ringOffsets_[r], ringOffsets_[r + 1]);
    const bool isUp = b.y > p.y;
    if (std::min(a.y, b.y) > p.y || std::max(a.y, b.y) < p.y) continue;
    const int turn = orientation(a, b, p);
    if (turn == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) {
      isOnBoundary = true;
      return true;
    }
    if ((a.y > p.y) != isUp) isOdd ^= isUp ? turn > 0 : turn < 0;
  }
  return isOdd;
}

bool Region::contains(Point given) const {
  const Point p = rounded(given);
  bool isOnBoundary = false;
  const bool isInside = isInRun(runs_.size() - 1, 0, p, isOnBoundary);
  return isInside || isOnBoundary;
}

Region scaledRegion(const Region& region, double factor) {
  Region result = region;
  for (Point& p : result.points_) p = {factor * p.x, factor * p.y};
  result.index();
  return result;
}

std::vector<RegionSideIndex> Region::sidesIn(const Box& box) const {
  return sidesThat([&](const Run& run) { return doMeet(run.box, box); },
                   [&](Point a, Point b) { return doMeet(boxAround(a, b), box); });
}

std::vector<RegionSideIndex> Region::sidesNear(std::span<const Point> polygon, double margin) const {
  const Polygon its(polygon, margin, bounds());
  return sidesThat([&](const Run& run) { return its.meets(run); }, [&](Point a, Point b) { return its.meets(a, b); });
}

template <class MeetsRun, class MeetsSide>
std::vector<RegionSideIndex> Region::sidesThat(const MeetsRun& meetsRun, const MeetsSide& meetsSide) const {
  std::vector<RegionSideIndex> sides;
  addSides(groups_.size(), 0, meetsRun, meetsSide, sides);
  std::ranges::sort(sides);
  return sides;
}

/// Adds sides of a group of runs, or at level 0 of a run.
template <class MeetsRun, class MeetsSide>
void Region::addSides(std::size_t level, std::size_t group, const MeetsRun& meetsRun, const MeetsSide& meetsSide,
                      std::vector<RegionSideIndex>& sides) const {
  const std::size_t run = level > 0 ? group : at(runsByPlace_[group]);
  if (!meetsRun(level > 0 ? groups_[level - 1][run] : runs_.front()[run])) return;
  if (level > 0) {
    const std::size_t count = level > 1 ? groups_[level - 2].size() : runsByPlace_.size();
    const std::size_t end = std::min((group + 1) * kRunsOfRun, count);
    for (std::size_t k = group * kRunsOfRun; k < end; ++k) addSides(level - 1, k, meetsRun, meetsSide, sides);
    return;
  }
  std::size_t ring = at(ringOf(static_cast<std::int32_t>(run * kSidesOfRun)));
  for (std::size_t side = run * kSidesOfRun; side < std::min((run + 1) * kSidesOfRun, points_.size()); ++side) {
    while (static_cast<std::int32_t>(side) >= ringOffsets_[ring + 1]) ++ring;
    const std::size_t end = at(ringOffsets_[ring + 1]);
    if (meetsSide(points_[side], points_[side + 1 == end ? at(ringOffsets_[ring]) : side + 1])) {
      sides.push_back(static_cast<std::int32_t>(side));
    }
  }
}

std::vector<RegionRingIndex> Region::ringsNotIn(
    const std::function<bool(const Box&, RegionRingIndex)>& isLeftOut) const {
  std::vector<RegionRingIndex> rings;
  const auto add = [&](const auto& self, std::size_t level, std::size_t run) -> void {
    std::size_t size = kRunsOfRun;
    for (std::size_t k = 0; k < level; ++k) size *= kRunsOfRun;
    if (isLeftOut(ringBoxes_[level][run], static_cast<std::int32_t>(run * size))) return;
    const std::size_t count = level > 0 ? ringBoxes_[level - 1].size() : ringCount();
    for (std::size_t k = run * kRunsOfRun; k < std::min((run + 1) * kRunsOfRun, count); ++k) {
      if (level > 0) {
        self(self, level - 1, k);
      } else {
        rings.push_back(static_cast<std::int32_t>(k));
      }
    }
  };
  add(add, ringBoxes_.size() - 1, 0);
  return rings;
}

double Region::area() const {
  CompensatedSum twice;
  for (std::size_t r = 0; r < ringCount(); ++r) {
    const std::size_t begin = at(ringOffsets_[r]);
    const std::size_t end = at(ringOffsets_[r + 1]);
    for (std::size_t k = begin + 1; k + 1 < end; ++k) {
      twice += cross(vectorTo(points_[begin], points_[k]), vectorTo(points_[begin], points_[k + 1]));
    }
  }
  return twice.value() / 2;
}

double Region::perimeter() const {
  CompensatedSum sum;
  for (std::size_t r = 0; r < ringCount(); ++r) {
    const std::size_t begin = at(ringOffsets_[r]);
    const std::size_t end = at(ringOffsets_[r + 1]);
    for (std::size_t k = begin; k < end; ++k) {
      sum += lengthOf(vectorTo(points_[k], points_[k + 1 == end ? begin : k + 1]));
    }
  }
  return sum.value();
}

Box Region::bounds() const { return runs_.back().front().box; }

}  // namespace circle_voronoi
