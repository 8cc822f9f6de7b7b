// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over clearest paths and largest discs in small regions full of ties. Any bytes are an input: both
// ends of the path, the number of rings, the corners of each ring and then circles, all on a grid of integers. A bit of
// each corner moves it by a unit of rounding. For all inputs,
// - there is a path between two points of the same part of the region, and no path between different parts;
// - the curves of the path stay in the region, and have its clearance;
// - the largest disc has its center in the region and overlaps neither sides nor circles.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/region_queries.h"
#include "path_checks.h"

namespace circle_voronoi::fuzz {
namespace {

constexpr double kTolerance = 1e-9;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

/// The bytes that are left.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool isEmpty() const { return bytes_.empty(); }
  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  /// A point of the grid from 0 to 7, perhaps moved by a unit of rounding.
  Point point(bool isExact) {
    const std::uint8_t byte = next();
    Point p = {static_cast<double>(byte & 7), static_cast<double>(byte >> 3 & 7)};
    if (!isExact && (byte & 64) != 0) p.x = std::nextafter(p.x, 8.0);
    if (!isExact && (byte & 128) != 0) p.y = std::nextafter(p.y, 8.0);
    return p;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

void check(std::span<const std::uint8_t> given) {
  Bytes bytes(given);
  const Point p = bytes.point(true);
  const Point q = bytes.point(true);
  const std::uint8_t form = bytes.next();
  std::vector<Region::Ring> rings(1 + form % 5);
  for (Region::Ring& ring : rings) {
    for (std::size_t corners = 3 + bytes.next() % 6; corners > 0; --corners) ring.push_back(bytes.point(false));
  }
  std::vector<Circle> circles;
  while (!bytes.isEmpty() && circles.size() < 8) {
    const Point center = bytes.point(true);
    circles.push_back({center.x, center.y, 0.25 * (bytes.next() % 8)});
  }
  const auto region = Region::fromRings(rings, {.dissolve = (form & 128) != 0});
  if (!region || circles.empty()) return;
  const Diagram diagram = compute(circles).value();

  const auto disc = largestEmptyDiscInside(diagram, *region);
  if (disc && *disc && (*disc)->disc.r > 0) {
    const auto& [x, y, r] = (*disc)->disc;
    require(region->contains({x, y}), "The center of the largest disc lies outside.");
    const Circle center = {x, y, 0};
    for (const auto& [from, to] : test::sidesOf(*region)) {
      require(test::clearanceAlong(std::span(&center, 1), from, to) >= r - kTolerance, "The largest disc sticks out.");
    }
    require(test::clearanceAlong(circles, {x, y}, {x, y}) >= r - kTolerance, "The largest disc overlaps a circle.");
  }

  const auto path = clearestPath(diagram, p, q, *region);
  if (!region->contains(p) || !region->contains(q)) {
    require(!path, "A path leads from or to a point outside the region.");
    return;
  }
  require(path.ok(), path ? "" : path.error().message);
  test::PartsOfRegion parts(*region);
  require(path->has_value() == parts.areTogether(p, q), "A path does not lead through the parts of the region.");
  if (!*path) return;
  const std::string fault = test::faultOf(*region, circles, p, q, **path, kTolerance);
  require(fault.empty(), fault);
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circle_voronoi::fuzz::check({data, size});
  return 0;
}
